# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Errors in words, and the exit codes they end with."""

import sys

from survtrack.errors import UsageError

FAILURE = 1
MISUSE = 2


def one_line(error: BaseException) -> str:
    """What an error says, on one line and without the number of an OSError."""
    if isinstance(error, KeyboardInterrupt):
        return "interrupted"
    if isinstance(error, OSError) and error.filename is not None:
        text = f"{error.filename}: {error.strerror}"
    else:
        text = str(error) or type(error).__name__
    return "; ".join(line.strip() for line in text.splitlines() if line.strip())


def exit_code(error: BaseException) -> int:
    """2 when the caller asked for something that is not there, 1 when something failed."""
    return MISUSE if isinstance(error, UsageError) else FAILURE


def print_error(message: str) -> None:
    """Tell it on stderr."""
    print(f"survtrack: error: {message}", file=sys.stderr)
