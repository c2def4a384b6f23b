# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The installed C++ library, as an outside project finds and uses it."""

from pathlib import Path

import pytest

import outside_project
import survtrack

MAJOR, MINOR, PATCH = (int(part) for part in survtrack.__version__.split("."))


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prefix")
    outside_project.install(folder)
    return folder


def test_an_outside_project_builds_and_tracks(prefix: Path, tmp_path: Path) -> None:
    program = outside_project.build(prefix, tmp_path, wanted=f"{MAJOR}.{MINOR}") / "app"
    version, track_id, x, y = outside_project.run(program).split()
    assert version == survtrack.__version__
    assert int(track_id) == 1
    # The square's centre in the last frame: left 2 * 49 px, top 50 px, side 16 px.
    assert float(x) == pytest.approx(98 + 7.5, abs=4)
    assert float(y) == pytest.approx(50 + 7.5, abs=4)


@pytest.mark.parametrize(
    "wanted", [f"{MAJOR}.{MINOR + 1}", f"{MAJOR + 1}.0", f"{MAJOR}.{MINOR}.{PATCH + 1}"]
)
def test_a_version_that_does_not_fit_is_refused(prefix: Path, tmp_path: Path, wanted: str) -> None:
    configured = outside_project.configure(prefix, tmp_path, wanted=wanted)
    assert configured.returncode != 0
    assert f'compatible with requested version "{wanted}"' in " ".join(configured.stderr.split())


def test_the_package_holds_no_python_and_no_private_headers(prefix: Path) -> None:
    files = {path.relative_to(prefix) for path in prefix.rglob("*") if path.is_file()}
    headers = {path for path in files if path.parts[0] == "include"}
    public = outside_project.ROOT / "cpp" / "include"
    assert headers == {Path("include") / path.relative_to(public) for path in public.rglob("*.hpp")}
    assert not [path for path in files if "_core" in path.name]
