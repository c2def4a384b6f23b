# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The configuration that finds the person in footage."""

import survtrack
from survtrack import Config


def preset_config() -> Config:
    """The dissertation's background and largest blob."""
    return survtrack.preset("nashenda2011")
