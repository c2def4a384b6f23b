# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`import survtrack` stays light: heavy packages are imported when they are used."""

import subprocess
import sys

HEAVY = {"av", "cv2", "matplotlib", "pandas", "rich", "scipy", "typer"}


def test_import_survtrack_imports_nothing_heavy() -> None:
    program = "import survtrack, sys; print(*sys.modules)"
    printed = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout
    assert "survtrack" in printed.split()
    assert HEAVY & set(printed.split()) == set()
