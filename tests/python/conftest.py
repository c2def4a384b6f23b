# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Fixtures that all tests share."""

import os
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def data() -> Path:
    """The folder of public footage with ground truth, named by SURVTRACK_DATA.

    Tests that need it are skipped without it, unless SURVTRACK_REQUIRE_DATA=1 makes that a failure.
    """
    named = os.environ.get("SURVTRACK_DATA", "")
    folder = Path(named)
    if named and folder.is_dir():
        return folder
    problem = f"SURVTRACK_DATA ({named!r}) names no folder of footage"
    if os.environ.get("SURVTRACK_REQUIRE_DATA") == "1":
        pytest.fail(problem)
    pytest.skip(problem)
