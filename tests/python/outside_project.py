# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Installs the C++ library and builds a program against it as an outside project would."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
BUILD = ROOT / "build" / "release"


def run(*command: object, cwd: Path | None = None) -> str:
    """Runs a command and returns what it printed; fails with all of it."""
    result = subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert result.returncode == 0, f"{command} gave {result.returncode}:\n{result.stdout}"
    return result.stdout


def install(prefix: Path) -> None:
    """Installs headers, library and package files from the build that scripts/setup.sh made."""
    assert (BUILD / "CMakeCache.txt").exists(), f"no build in {BUILD}: run make setup"
    run("cmake", "--build", BUILD, "--target", "survtrack")
    run("cmake", "--install", BUILD, "--prefix", prefix, "--component", "development")


def configure(
    prefix: Path, folder: Path, source: Path = ROOT / "tests" / "package", wanted: str = ""
) -> subprocess.CompletedProcess[str]:
    """Configures the project `source` in `folder`, asking for version `wanted` of survtrack."""
    command = ["cmake", "-G", "Ninja", "-S", str(source), "-B", str(folder), f"-DWANTED={wanted}"]
    command += [f"-DCMAKE_PREFIX_PATH={prefix}", "--no-warn-unused-cli"]
    return subprocess.run(command, capture_output=True, text=True)


def build(
    prefix: Path, folder: Path, source: Path = ROOT / "tests" / "package", wanted: str = ""
) -> Path:
    """Configures and builds the project `source` in `folder`; returns `folder`."""
    configured = configure(prefix, folder, source, wanted)
    assert configured.returncode == 0, configured.stdout + configured.stderr
    run("cmake", "--build", folder)
    return folder
