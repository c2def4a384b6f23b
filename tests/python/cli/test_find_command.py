# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack find`: tracks of several runs by their ways."""

import json
from pathlib import Path

import pytest

from streets import EAST, JAYWALKER, USUAL, write_streets
from survtrack.cli.main import main
from survtrack.offline import find_tracks, read_patterns


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Patterns of one run, and two later runs."""
    folder = tmp_path_factory.mktemp("archive")
    write_streets(folder / "learned", USUAL)
    assert main(["patterns", str(folder / "learned"), "--out", str(folder / "ways"), "-q"]) == 0
    write_streets(folder / "monday", [EAST, JAYWALKER])
    write_streets(folder / "tuesday", [JAYWALKER, EAST, EAST])
    return folder


def find(archive: Path, *args: str) -> int:
    runs = [str(archive / day) for day in ("monday", "tuesday")]
    return main(["find", *runs, "--known", str(archive / "ways" / "patterns.json"), *args])


def found(archive: Path, capsys: pytest.CaptureFixture[str], *args: str) -> list[tuple[str, int]]:
    assert find(archive, "--json", *args) == 0
    rows = json.loads(capsys.readouterr().out)
    return [(Path(row["run"]).name, row["id"]) for row in rows]


def test_tracks_that_go_a_way_are_found_in_all_runs(
    archive: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    every = [("monday", 1), ("monday", 2), ("tuesday", 1), ("tuesday", 2), ("tuesday", 3)]
    assert found(archive, capsys) == every
    known = read_patterns(archive / "ways" / "patterns.json")
    east = find_tracks([archive / "monday"], known)[0]
    assert east.pattern is not None and east.kind == "usual" and east.speed_px_per_s > 0
    assert (east.first_frame, east.first_s) == (1, 0.0) and east.last_s > 1
    going = found(archive, capsys, "--pattern", str(east.pattern))
    assert going == [("monday", 1), ("tuesday", 2), ("tuesday", 3)]
    assert found(archive, capsys, "--kind", "other_way") == [("monday", 2), ("tuesday", 1)]
    assert found(archive, capsys, "--kind", "other_way", "--pattern", str(east.pattern)) == []


def test_a_line_a_track(archive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert find(archive, "--kind", "other_way") == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3 and lines[-1] == "tracks found: 2 in 2 runs"
    assert "monday: track 2, frames 1 to " in lines[0] and "other_way, no pattern" in lines[0]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--pattern", "99"], "pattern 99: is not there; one of: [1"),
        (["--kind", "flying"], 'kind: unknown "flying"; one of: usual, standing'),
    ],
)
def test_what_is_not_there_is_told(
    options: list[str], message: str, archive: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert find(archive, *options) == 2
    assert message in capsys.readouterr().err


def test_runs_that_cannot_be_searched(
    archive: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known = str(archive / "ways" / "patterns.json")
    assert main(["find", str(tmp_path), "--known", known]) == 1
    assert "run.json" in capsys.readouterr().err
    other = write_streets(tmp_path / "other", [EAST])
    facts = json.loads((other / "run.json").read_text())
    (other / "run.json").write_text(json.dumps({**facts, "size": [64, 48]}))
    assert main(["find", str(other), "--known", known]) == 1
    assert "other: was learned from frames of 480x400, the run's are 64x48" in (
        capsys.readouterr().err
    )
