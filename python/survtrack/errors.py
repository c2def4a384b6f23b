# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The exceptions of survtrack's Python side.

The command line ends with exit code 1 on an InputError and 2 on a UsageError. Both are also
ValueErrors, so a program that knows nothing of survtrack's own types still catches them.
"""


class SurvtrackError(Exception):
    """Root of every exception that survtrack raises on purpose."""


class InputError(SurvtrackError, ValueError):
    """A file, folder, image or array that was given cannot be used; the message names it."""


class UsageError(SurvtrackError, ValueError):
    """An option or argument has a value outside of what it allows; the message names it."""


class ConfigError(UsageError):
    """An option, preset or option file that cannot be used; the message has its full path."""
