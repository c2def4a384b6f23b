# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack patterns`: what it writes, prints and refuses."""

import csv
import json
import os
import tomllib
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import survtrack
from clips import walking_square, write_video
from runs import write_run
from streets import EAST, JAYWALKER, SIZE, USUAL, write_streets
from survtrack.cli.main import main
from survtrack.drawing.colors import color_of_id
from survtrack.offline import read_patterns

OUTPUTS = [
    "activities.csv",
    "config.toml",
    "paths.json",
    "patterns.json",
    "patterns.png",
    "run.json",
]


@pytest.fixture
def run_dir(tmp_path: Path) -> Path:
    return write_streets(tmp_path / "run", USUAL)


def patterns(*args: object) -> int:
    return main(["patterns", *map(str, args)])


def error_of(code: int, capsys: pytest.CaptureFixture[str], *args: object) -> str:
    assert patterns(*args) == code
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("survtrack: error: ") and err.count("\n") == 1
    return err.removeprefix("survtrack: error: ").rstrip("\n")


def facts_of(folder: Path) -> Any:
    return json.loads((folder / "run.json").read_text())


def rows_of(folder: Path) -> list[dict[str, str]]:
    with (folder / "activities.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_writes_patterns_beside_the_run(run_dir: Path) -> None:
    before = {path.name: path.read_bytes() for path in run_dir.iterdir()}
    assert patterns(run_dir) == 0
    assert sorted(os.listdir(run_dir / "patterns")) == OUTPUTS
    assert {path.name: path.read_bytes() for path in run_dir.iterdir() if path.is_file()} == before
    learned = read_patterns(run_dir / "patterns" / "patterns.json")
    assert [pattern.count for pattern in learned.patterns] == [6, 5, 4, 3]
    assert learned.frame_size == SIZE
    first = rows_of(run_dir / "patterns")[0]
    assert first == {
        "id": "1",
        "first_frame": "1",
        "last_frame": "101",
        "kind": "usual",
        "unusual": "0",
        "pattern": "1",
        "partial": "0",
        "distance": "0.000",
        "angle_deg": "0.000",
        "speed_px_per_s": "40.000",
        "speed_ratio": "1.000",
    }
    assert [row["pattern"] for row in rows_of(run_dir / "patterns")] == list("111111222223333444")
    facts = facts_of(run_dir / "patterns")
    assert (facts["command"], facts["tracks"], facts["patterns"]) == ("patterns", 18, 4)
    assert facts["kinds"] == {
        "usual": 18,
        "standing": 0,
        "other_way": 0,
        "too_fast": 0,
        "too_slow": 0,
    }
    assert sorted([*facts["outputs"], "config.toml", "run.json"]) == OUTPUTS


def test_a_later_run_is_judged_by_the_patterns_of_an_earlier_one(
    run_dir: Path, tmp_path: Path
) -> None:
    assert patterns(run_dir, "--set", "points=12") == 0
    known = run_dir / "patterns" / "patterns.json"
    later = write_streets(tmp_path / "later", [EAST, JAYWALKER, EAST], [40, 40, 80])
    assert patterns(later, "--known", known) == 0
    rows = rows_of(later / "patterns")
    assert [(row["kind"], row["unusual"], row["pattern"]) for row in rows] == [
        ("usual", "0", "1"),
        ("other_way", "1", ""),
        ("too_fast", "1", "1"),
    ]
    assert rows[1]["speed_ratio"] == ""
    assert rows[2]["speed_ratio"] == "2.000"
    # What judged is kept: the same patterns with their options.
    assert (later / "patterns" / "patterns.json").read_bytes() == known.read_bytes()
    assert tomllib.loads((later / "patterns" / "config.toml").read_text())["points"] == 12
    assert facts_of(later / "patterns")["known"] == str(known)
    # Options on top are in force, and kept.
    assert patterns(later, "--known", known, "--set", "max_speed_deviations=20") == 0
    assert [row["kind"] for row in rows_of(later / "patterns")] == ["usual", "other_way", "usual"]
    kept = read_patterns(later / "patterns" / "patterns.json")
    assert kept.options == survtrack.PatternOptions(points=12, max_speed_deviations=20)


def test_the_picture_has_an_arrow_of_each_pattern(run_dir: Path) -> None:
    assert patterns(run_dir) == 0
    picture = cv2.imread(str(run_dir / "patterns" / "patterns.png"))
    assert picture.shape == (SIZE[1], SIZE[0], 3)
    for x, y, pattern in ((300, 200, (1, 2)), (240, 300, (3, 4))):
        assert tuple(picture[y, x].tolist()) in {color_of_id(each) for each in pattern}
    # The source, clip.mp4, is not there.
    assert picture[20, 20].tolist() == [96, 96, 96]


def test_the_picture_is_over_a_frame_of_the_source(tmp_path: Path) -> None:
    frames = walking_square(60, width=256)
    clip = write_video(tmp_path / "clip.mp4", frames)
    out = tmp_path / "out"
    assert main(["run", str(clip), "--out", str(out), "-q", "--resize", "128x32"]) == 0
    assert patterns(out, "--set", "min_tracks=1") == 0
    picture = cv2.imread(str(out / "patterns" / "patterns.png"))
    assert picture.shape == (32, 128, 3)
    assert len(np.unique(picture[:8])) > 2


def test_without_a_size_there_is_no_picture(tmp_path: Path) -> None:
    run = write_run(tmp_path, walks=(), size=None)
    assert patterns(run) == 0
    assert "patterns.png" not in os.listdir(run / "patterns")
    assert facts_of(run / "patterns")["outputs"] == ["patterns.json", "activities.csv"]


def test_linked_tracks_have_patterns_too(run_dir: Path) -> None:
    assert main(["link", str(run_dir), "-q"]) == 0
    assert patterns(run_dir / "linked") == 0
    assert facts_of(run_dir / "linked" / "patterns")["patterns"] == 4


def test_prints_a_summary(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert patterns(run_dir) == 0
    out = capsys.readouterr().out.splitlines()
    assert out[0] == "pattern 1: 6 tracks from (40, 200) to (440, 200), 40 px/s, 10.0 s"
    assert out[4] == "tracks: 18; usual: 18, standing: 0, other_way: 0, too_fast: 0, too_slow: 0"
    names = "patterns.json, activities.csv, paths.json, patterns.png, config.toml, run.json"
    assert out[5:] == [f"{run_dir / 'patterns'}: {names}"]
    assert patterns(run_dir, "-q") == 0
    assert capsys.readouterr() == ("", "")


def test_json_is_all_there_is_on_stdout(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert patterns(run_dir, "--json", "--out", run_dir / "out") == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == {**facts_of(run_dir / "out"), "out": str(run_dir / "out")}


def test_a_run_that_was_cut_short_is_taken_as_far_as_it_goes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run = write_streets(tmp_path, USUAL, complete=False, error="interrupted")
    assert patterns(run) == 0
    assert capsys.readouterr().out.startswith("the run is not complete (interrupted); taken as far")
    assert facts_of(run / "patterns")["complete"] is False


def test_options_come_from_file_then_set_left_to_right(run_dir: Path) -> None:
    config = run_dir / "my.toml"
    config.write_text("min_tracks = 4\nmin_travel = 1.5\n")
    args = ("--config", config, "--set", "min_tracks=6", "--set", " min_tracks = 5 ")
    assert patterns(run_dir, *args) == 0
    written = tomllib.loads((run_dir / "patterns" / "config.toml").read_text())
    assert written == survtrack.PatternOptions(min_tracks=5, min_travel=1.5).to_dict()
    assert facts_of(run_dir / "patterns")["patterns"] == 2


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--set", "min_track=2"], "min_track: unknown option; one of: points, min_travel"),
        (["--set", "points=2"], "points: 2 is not allowed; expected between 4 and 256"),
        (["--set", "points"], '--set "points" is not allowed; expected option=value'),
        (["--set", "points=many"], 'points: "many" is not allowed'),
        (["--nonesuch"], "--nonesuch"),
    ],
)
def test_misuse_ends_with_2_and_names_what_is_wrong(
    run_dir: Path, options: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert words in error_of(2, capsys, run_dir, *options)
    assert not (run_dir / "patterns").exists()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "no such file"),
        (b"\xff\xfe", "is not UTF-8 text"),
        (b"{", "is not JSON, at byte"),
        (b"[]", 'has no "options"'),
        (b'{"options": {"points": 2}, "patterns": []}', ".options.points: 2 is not allowed"),
        (b'{"options": {}, "patterns": [1]}', '.patterns[0]: has no "id"'),
        (
            b'{"options": {}, "frame_size": [640, 480], "patterns": []}',
            "was learned from frames of 640x480, the run's are 480x400",
        ),
    ],
)
def test_known_patterns_that_cannot_be_used_are_named(
    run_dir: Path, content: bytes | None, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    known = run_dir / "known.json"
    if content is not None:
        known.write_bytes(content)
    error = error_of(1, capsys, run_dir, "--known", known)
    assert error.startswith(str(known)) and words in error
    assert not (run_dir / "patterns").exists()


def test_a_folder_that_is_no_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "no such folder" in error_of(1, capsys, tmp_path / "missing")
    assert "has no run.json" in error_of(1, capsys, tmp_path)
    run = write_streets(tmp_path, USUAL)
    table = run / "tracks.csv"
    table.write_text(table.read_text() + "25,3\n")
    assert f"{table}, line " in error_of(1, capsys, run)
    for size in ("[0, 4]", "[4]", '"4x4"', "[1e3, 4]"):
        (run / "run.json").write_text('{"outputs": ["tracks.csv"], "size": ' + size + "}")
        assert 'run.json: "size" is ' in error_of(1, capsys, run)
    assert not (run / "patterns").exists()


def test_the_runs_own_folder_is_never_written_to(
    run_dir: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = {path.name: path.read_bytes() for path in run_dir.iterdir()}
    for out in (run_dir, run_dir / "."):
        assert "is the run's own folder" in error_of(2, capsys, run_dir, "--out", out)
    assert {path.name: path.read_bytes() for path in run_dir.iterdir()} == before


def test_outputs_of_an_earlier_command_in_the_folder_do_not_pose_as_this_ones(
    run_dir: Path,
) -> None:
    out = run_dir / "out"
    assert main(["link", str(run_dir), "-q", "--out", str(out)]) == 0
    assert patterns(run_dir, "--out", out) == 0
    assert sorted(os.listdir(out)) == OUTPUTS
    assert main(["link", str(run_dir), "-q", "--out", str(out)]) == 0
    assert "patterns.png" not in os.listdir(out)


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_full_disk_is_told_and_leaves_no_run_json(
    run_dir: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    assert patterns(run_dir, "-q") == 0
    (run_dir / "patterns" / f"{name}.part").symlink_to("/dev/full")
    error = error_of(1, capsys, run_dir)
    assert error == f"{run_dir / 'patterns' / name}: No space left on device"
    assert not (run_dir / "patterns" / "run.json").exists()


def test_public_footage(data: Path, tmp_path: Path) -> None:
    """On a motorway the cars' ways are the lanes, and all of them lead towards the camera."""
    out = tmp_path / "out"
    source = data / "cdnet" / "highway" / "input"
    assert main(["run", str(source), "--out", str(out), "-q"]) == 0
    assert patterns(out, "-q") == 0
    lanes = read_patterns(out / "patterns" / "patterns.json").patterns
    assert len(lanes) == 2
    for lane in lanes:
        assert lane.leaves[1] > lane.enters[1] + 150
        assert lane.leaves[0] < lane.enters[0]
    assert facts_of(out / "patterns")["kinds"]["usual"] >= 13
