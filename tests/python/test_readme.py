# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Every code block of README.md, CONTRIBUTING.md and docs/ works as it stands."""

import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import outside_project
import survtrack
from documents import DOCUMENTS, Block, blocks
from workspace import make_workspace

# What tests do elsewhere, at length, and what a document may therefore say without being run here.
NOT_RUN = ("pip install ", "cmake ", "ctest ")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    folder = tmp_path / "workspace"
    make_workspace(folder)
    return folder


def test_there_are_only_languages_that_are_tested() -> None:
    languages = {block.language for block in blocks()}
    assert languages <= {"bash", "python", "cpp", "cmake", "toml", "json", "text"}
    assert {"bash", "python", "cpp", "cmake", "toml"} <= languages


def run_bash(block: Block, workspace: Path) -> None:
    for line in block.text.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if not words or line.startswith(NOT_RUN):
            continue
        if words[0] == "make":
            outside_project.run("make", "--dry-run", *words[1:], cwd=outside_project.ROOT)
        else:
            assert words[0] == "survtrack", f"{line!r} is not tested"
            outside_project.run(sys.executable, "-m", *words, cwd=workspace)


def run_python(block: Block, workspace: Path) -> None:
    printed = outside_project.run(sys.executable, "-W", "error", "-c", block.text, cwd=workspace)
    assert printed or "print(" not in block.text


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_what_a_document_does_works_in_its_order(document: Path, workspace: Path) -> None:
    """A document's blocks may use what the ones above have made, and nothing else."""
    for block in blocks():
        if block.document != document:
            continue
        try:
            if block.language == "bash":
                run_bash(block, workspace)
            elif block.language == "python":
                run_python(block, workspace)
        except AssertionError as error:
            raise AssertionError(f"{block}: {error}") from error


@pytest.mark.parametrize("block", blocks("toml"), ids=str)
def test_toml(block: Block) -> None:
    assert tomllib.loads(block.text)
    survtrack.Config.from_toml(block.text)


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_cpp(document: Path, workspace: Path, tmp_path: Path) -> None:
    programs = [block for block in blocks("cpp") if block.document == document]
    projects = [block for block in blocks("cmake") if block.document == document]
    assert len(programs) == len(projects), "a program comes with its CMakeLists.txt"
    if not programs:
        return
    prefix = tmp_path / "prefix"
    outside_project.install(prefix)
    for program, project in zip(programs, projects, strict=True):
        folder = tmp_path / f"line{program.line}"
        folder.mkdir()
        (folder / "main.cpp").write_text(program.text)
        (folder / "CMakeLists.txt").write_text(project.text)
        built = outside_project.build(prefix, folder / "build", source=folder)
        assert outside_project.run(built / "app", cwd=workspace)


def test_the_example_of_the_package_and_the_readme_agree() -> None:
    """The loop that README, package docstring and quick start show is one loop."""
    [readme] = [block for block in blocks("python") if block.document == DOCUMENTS[0]]
    loop = readme.text.split("\n\n", 1)[1].splitlines()[0]
    assert loop in (survtrack.__doc__ or "")


def test_links_to_files_lead_somewhere() -> None:
    for document in DOCUMENTS:
        for part in document.read_text().split("](")[1:]:
            target = part.split(")")[0].split("#")[0]
            if target and "://" not in target:
                assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_make_help_names_every_target() -> None:
    printed = subprocess.run(
        ["make", "help"], cwd=outside_project.ROOT, capture_output=True, text=True, check=True
    ).stdout
    for target in ("demo", "test", "bench", "docs", "stubs", "lint", "clean"):
        assert f"{target} " in printed


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_paths_that_documents_name_exist(document: Path) -> None:
    top = "cmake|cpp|docs|examples|benchmarks|presets|python|scripts|tests"
    for path in re.findall(rf"`((?:{top})/[^`\s<*{{]*)`", document.read_text()):
        assert (outside_project.ROOT / path).exists(), f"{document.name}: {path}"
