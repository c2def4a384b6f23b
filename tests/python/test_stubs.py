# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is made from the code and kept in the tree is not stale: `make stubs` writes it anew."""

import subprocess
import sys
from pathlib import Path

import pytest

import survtrack

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    ("script", "kept"),
    [
        ("make_stubs.py", "python/survtrack/_core.pyi"),
        ("make_reference.py", "docs/reference/options.md"),
    ],
)
def test_kept_file_is_what_the_code_makes_now(script: str, kept: str, tmp_path: Path) -> None:
    made = tmp_path / "made"
    subprocess.run([sys.executable, ROOT / "scripts" / script, made], check=True)
    assert (ROOT / kept).read_text() == made.read_text(), f"{kept} is stale: run make stubs"


def test_package_says_that_it_is_typed() -> None:
    assert (Path(survtrack.__file__).parent / "py.typed").is_file()
