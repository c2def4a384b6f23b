# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Every example of examples/python runs and prints something; those in C++ run as ctests."""

import subprocess
import sys
from pathlib import Path

import pytest

from clips import walking_square, write_video

EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "python").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs_and_prints(example: Path, tmp_path: Path) -> None:
    arguments = (
        [str(write_video(tmp_path / "clip.mp4", walking_square(60, still=20)))]
        if example.stem == "01_video"
        else []
    )
    command = [sys.executable, "-W", "error", str(example), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert done.stdout.strip()


def test_there_are_examples() -> None:
    assert len(EXAMPLES) == 3
