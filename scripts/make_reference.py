# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Writes the reference page of all options from the library's own description of them.

usage: make_reference.py [FILE]    (docs/reference/options.md)
"""

import sys
from pathlib import Path

import survtrack

ROOT = Path(__file__).parents[1]


def make_reference() -> str:
    """The text of docs/reference/options.md."""
    return survtrack.options_reference().rstrip("\n") + "\n"


if __name__ == "__main__":
    target = Path(sys.argv[1]) if sys.argv[1:] else ROOT / "docs" / "reference" / "options.md"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(make_reference())
