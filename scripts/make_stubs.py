# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Writes the type stubs of the compiled module.

usage: make_stubs.py [FILE]    (python/survtrack/_core.pyi)
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import survtrack._core

ROOT = Path(__file__).parents[1]
HEADER = """\
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Made by scripts/make_stubs.py from the compiled module; change cpp/bindings instead.
"""


def python_module(*command: str, text: str | None = None) -> str:
    """Runs `python -m COMMAND` with `text` as its input; returns what it printed."""
    return subprocess.run(
        [sys.executable, "-m", *command],
        cwd=ROOT,
        input=text,
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    ).stdout


def repair(stubs: str) -> str:
    """Puts right what the generator does not write as type checkers want it."""

    def member(match: re.Match[str]) -> str:
        value = getattr(survtrack._core, match[2])[match[1]].value
        return f"    {match[1]} = {value!r}\n"

    stubs = re.sub(r"    (\w+): typing\.ClassVar\[(\w+)\]\n", member, stubs)
    stubs = stubs.replace("    @classmethod\n    def __new__(cls, value):\n        ...\n", "")
    unhashable = "__hash__: typing.ClassVar[None] = None"
    return stubs.replace(unhashable, f"{unhashable}  # type: ignore[assignment]")


def make_stubs() -> str:
    """The text of _core.pyi, formatted; raises CalledProcessError where a type is unknown."""
    with tempfile.TemporaryDirectory() as folder:
        python_module("pybind11_stubgen", "--exit-code", "-o", folder, "survtrack._core")
        stubs = HEADER + repair((Path(folder) / "survtrack" / "_core.pyi").read_text())
    file = ("--quiet", "--stdin-filename", "_core.pyi", "-")
    stubs = python_module("ruff", "check", "--fix-only", "--select", "I,F401,UP", *file, text=stubs)
    return python_module("ruff", "format", *file, text=stubs)


if __name__ == "__main__":
    target = Path(sys.argv[1]) if sys.argv[1:] else ROOT / "python" / "survtrack" / "_core.pyi"
    target.write_text(make_stubs())
