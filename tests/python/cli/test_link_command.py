# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack link`: what it writes, prints and refuses."""

import csv
import json
import os
import tomllib
from pathlib import Path
from typing import Any

import pytest

import survtrack
from clips import walking_square, write_video
from runs import Walk, write_run
from survtrack.cli.main import main
from survtrack.evaluation import evaluate_tracks

OUTPUTS = ["config.toml", "link.jsonl", "run.json", "tracks.csv", "tracks.txt"]


@pytest.fixture
def run_dir(tmp_path: Path) -> Path:
    return write_run(tmp_path / "run")


def link(*args: object) -> int:
    return main(["link", *map(str, args)])


def error_of(code: int, capsys: pytest.CaptureFixture[str], *args: object) -> str:
    assert link(*args) == code
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("survtrack: error: ") and err.count("\n") == 1
    return err.removeprefix("survtrack: error: ").rstrip("\n")


def facts_of(folder: Path) -> Any:
    return json.loads((folder / "run.json").read_text())


def rows_of(folder: Path) -> list[dict[str, str]]:
    with (folder / "tracks.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_writes_the_linked_tracks_beside_the_run(run_dir: Path) -> None:
    before = {path.name: path.read_bytes() for path in run_dir.iterdir()}
    assert link(run_dir) == 0
    assert sorted(os.listdir(run_dir / "linked")) == OUTPUTS
    assert {path.name: path.read_bytes() for path in run_dir.iterdir() if path.is_file()} == before
    rows = rows_of(run_dir / "linked")
    frames = [*range(1, 11), *range(16, 26)]
    assert [(row["frame"], row["id"]) for row in rows] == [(str(frame), "1") for frame in frames]
    # Nothing but the id is changed.
    given = [row for row in rows_of(run_dir) if row["id"] != "3"]
    assert rows == [{**row, "id": "1"} for row in given]
    assert (run_dir / "linked" / "tracks.txt").read_text().splitlines() == [
        f"{row['frame']},1,{row['left_px']},{row['top_px']},20.000,80.000,1,-1,-1,-1"
        for row in rows
    ]


def test_link_jsonl_says_what_decided(run_dir: Path) -> None:
    assert link(run_dir) == 0
    lines = (run_dir / "linked" / "link.jsonl").read_text().splitlines()
    assert [json.loads(line) for line in lines] == [
        {
            "kind": "joined",
            "earlier_id": 1,
            "later_id": 2,
            "gap_s": 0.6,
            "distance": 0,
            "speed_difference": 0,
            "color_difference": 0,
            "cost": 0.05,
        },
        {"kind": "dropped", "id": 3, "frames": 1, "duration_s": 0, "travel": 0},
    ]


def test_run_json_is_that_of_the_run_and_what_was_done(run_dir: Path) -> None:
    assert link(run_dir) == 0
    facts = facts_of(run_dir / "linked")
    assert (facts["command"], facts["run"]) == ("link", str(run_dir))
    assert facts["survtrack"] == survtrack.__version__
    original = facts_of(run_dir)
    for name in ("source", "preset", "complete", "error", "frames", "fps", "size"):
        assert facts[name] == original[name]
    assert (facts["tracks_before"], facts["joined"], facts["dropped"], facts["tracks"]) == (
        3,
        1,
        1,
        1,
    )
    assert sorted([*facts["outputs"], "config.toml", "run.json"]) == OUTPUTS


def test_rows_are_by_frame_and_then_by_id(tmp_path: Path) -> None:
    # Track 9 starts, is joined by 2, and walks beside 5 all the time.
    walks = (Walk(9, 0, 9), Walk(2, 15, 24, left=60), Walk(5, 0, 24, top=400))
    assert link(write_run(tmp_path, walks), "--out", tmp_path / "out") == 0
    keys = [(int(row["frame"]), int(row["id"])) for row in rows_of(tmp_path / "out")]
    assert keys == sorted(keys)
    assert {identity for _, identity in keys} == {5, 9}


def test_chains_have_one_id(tmp_path: Path) -> None:
    walks = (Walk(7, 0, 9), Walk(8, 15, 24, left=60), Walk(3, 30, 39, left=120))
    assert link(write_run(tmp_path, walks, count=40)) == 0
    assert {row["id"] for row in rows_of(tmp_path / "linked")} == {"7"}


def test_what_was_linked_links_to_itself(run_dir: Path) -> None:
    assert link(run_dir) == 0
    assert link(run_dir / "linked", "--out", run_dir / "again") == 0
    for name in ("tracks.txt", "tracks.csv", "config.toml"):
        assert (run_dir / "again" / name).read_bytes() == (run_dir / "linked" / name).read_bytes()
    assert (run_dir / "again" / "link.jsonl").read_text() == ""


def test_options_come_from_file_then_set_left_to_right(run_dir: Path) -> None:
    config = run_dir / "my.toml"
    config.write_text("max_gap_s = 0.1\nmin_travel = 0.25\n")
    args = (run_dir, "--config", config, "--set", "max_gap_s=9", "--set", " max_gap_s = 0.5 ")
    assert link(*args) == 0
    written = tomllib.loads((run_dir / "linked" / "config.toml").read_text())
    assert (written["max_gap_s"], written["min_travel"]) == (0.5, 0.25)
    assert written == survtrack.LinkOptions(max_gap_s=0.5, min_travel=0.25).to_dict()
    assert facts_of(run_dir / "linked")["joined"] == 0


def test_the_options_in_force_link_again_to_the_same(run_dir: Path) -> None:
    assert link(run_dir, "--set", "min_frames=1", "--set", "min_s=0", "--set", "min_travel=0") == 0
    config = run_dir / "linked" / "config.toml"
    assert link(run_dir, "--config", config, "--out", run_dir / "b") == 0
    for name in ("tracks.txt", "tracks.csv", "link.jsonl", "config.toml"):
        assert (run_dir / "b" / name).read_bytes() == (run_dir / "linked" / name).read_bytes()
    assert facts_of(run_dir / "b")["tracks"] == 2


def test_prints_a_summary(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert link(run_dir) == 0
    assert capsys.readouterr() == (
        "tracks: 3; joins: 1, dropped: 1; left: 1\n"
        f"{run_dir / 'linked'}: tracks.txt, tracks.csv, link.jsonl, config.toml, run.json\n",
        "",
    )
    assert link(run_dir, "-q") == 0
    assert capsys.readouterr() == ("", "")


def test_json_is_all_there_is_on_stdout(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert link(run_dir, "--json", "--out", run_dir / "out") == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == {**facts_of(run_dir / "out"), "out": str(run_dir / "out")}


def test_a_run_that_was_cut_short_is_linked_as_far_as_it_goes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run_dir = write_run(tmp_path, complete=False, error="interrupted")
    assert link(run_dir) == 0
    out = capsys.readouterr().out
    assert out.startswith("the run is not complete (interrupted); linked as far as it goes\n")
    facts = facts_of(run_dir / "linked")
    assert (facts["complete"], facts["error"], facts["joined"]) == (False, "interrupted", 1)


def test_a_run_without_tracks(tmp_path: Path) -> None:
    assert link(write_run(tmp_path, walks=())) == 0
    assert rows_of(tmp_path / "linked") == []
    assert facts_of(tmp_path / "linked")["tracks"] == 0


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--set", "max_gap=2"], "max_gap: unknown option; one of: max_gap_s, max_distance"),
        (["--set", "max_gap_s=-1"], "max_gap_s: -1 is not allowed; expected between 0 and"),
        (["--set", "max_gap_s=long"], 'max_gap_s: "long" is not allowed; expected a number'),
        (["--set", "max_gap_s=nan"], "max_gap_s: nan is not allowed"),
        (["--set", "max_gap_s=[1]"], "max_gap_s: "),
        (["--set", "max_gap_s="], 'max_gap_s: "" is not allowed'),
        (["--set", "min_frames=2.5"], "min_frames: 2.5 is not allowed; expected an integer"),
        (["--set", "max_gap_s"], '"max_gap_s" is not allowed; expected option=value'),
        (["--set", "=3"], '"=3" is not allowed; expected option=value'),
        (["--nonesuch"], "--nonesuch"),
        (["another folder"], "another folder"),
    ],
)
def test_misuse_ends_with_2_and_names_what_is_wrong(
    run_dir: Path, options: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert words in error_of(2, capsys, run_dir, *options)
    assert not (run_dir / "linked").exists()


@pytest.mark.parametrize(
    ("content", "code", "words"),
    [
        (b"max_gap_s = 'x'", 2, 'max_gap_s: "x" is not allowed'),
        (b"max_gap_s = [", 2, "my.toml: "),
        (b"[filter]\nmodel = 'kalman_cv'", 2, "filter: unknown option"),
        (b"\xff\xfe", 1, "is not UTF-8 text"),
        (None, 1, "no such file"),
    ],
)
def test_a_config_file_that_is_wrong_is_named(
    run_dir: Path,
    content: bytes | None,
    code: int,
    words: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    config = run_dir / "my.toml"
    if content is not None:
        config.write_bytes(content)
    error = error_of(code, capsys, run_dir, "--config", config)
    assert error.startswith(f"{config}: ") and words in error


def test_a_folder_that_is_no_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    missing = tmp_path / "missing"
    assert error_of(1, capsys, missing) == f"{missing}: no such folder"
    assert "has no run.json" in error_of(1, capsys, tmp_path)
    for text in ("", "[]", '{"outputs": 5}', "{}", "\xff"):
        (tmp_path / "run.json").write_text(text, encoding="latin-1")
        assert f"{tmp_path / 'run.json'}: is not that of a run" in error_of(1, capsys, tmp_path)
    (tmp_path / "run.json").write_text('{"outputs": ["bin*.png"]}')
    assert "the run left no tracks.csv" in error_of(1, capsys, tmp_path)
    (tmp_path / "run.json").write_text('{"outputs": ["tracks.csv"]}')
    assert f"{tmp_path / 'tracks.csv'}: no such file" in error_of(1, capsys, tmp_path)
    assert not (tmp_path / "linked").exists()


def test_a_broken_table_names_the_line_and_leaves_nothing(
    run_dir: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = run_dir / "tracks.csv"
    table.write_text(table.read_text() + "25,3\n")
    assert f"{table}, line 23: 2 cell(s)" in error_of(1, capsys, run_dir)
    assert not (run_dir / "linked").exists()


def test_the_runs_own_folder_is_never_written_to(
    run_dir: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = {path.name: path.read_bytes() for path in run_dir.iterdir()}
    for out in (run_dir, run_dir / ".", run_dir.parent / "x" / ".." / "run"):
        assert "is the run's own folder" in error_of(2, capsys, run_dir, "--out", out)
    assert {path.name: path.read_bytes() for path in run_dir.iterdir()} == before


def test_a_later_link_replaces_an_earlier_one(run_dir: Path) -> None:
    assert link(run_dir) == 0
    assert link(run_dir, "--set", "max_gap_s=0") == 0
    assert sorted(os.listdir(run_dir / "linked")) == OUTPUTS
    assert facts_of(run_dir / "linked")["joined"] == 0


def test_outputs_of_a_run_in_the_folder_do_not_pose_as_this_ones(run_dir: Path) -> None:
    out = write_run(run_dir / "out", outputs=["tracks.txt", "tracks.csv", "events.jsonl"])
    (out / "events.jsonl").write_text("{}\n")
    assert link(run_dir, "--out", out) == 0
    assert sorted(os.listdir(out)) == OUTPUTS


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_full_disk_is_told_and_leaves_no_run_json(
    run_dir: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    assert link(run_dir, "-q") == 0
    (run_dir / "linked" / f"{name}.part").symlink_to("/dev/full")
    error = error_of(1, capsys, run_dir)
    assert error == f"{run_dir / 'linked' / name}: No space left on device"
    assert not (run_dir / "linked" / "run.json").exists()


def test_an_output_folder_that_cannot_be_made(
    run_dir: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (run_dir / "file").write_text("")
    error = error_of(1, capsys, run_dir, "--out", run_dir / "file")
    assert error == f"{run_dir / 'file'}: File exists"


def test_from_footage_to_scores(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A square is hidden for a second; linked, it scores as one."""
    frames = walking_square(90, width=256, still=10)
    frames[50:60] = [frames[0]] * 10
    clip = write_video(tmp_path / "clip.mp4", frames)
    truth = tmp_path / "gt.txt"
    truth.write_text(
        "".join(f"{k + 1},1,{4 + 2 * (k - 10)},21,14,14,1,-1,-1,-1\n" for k in range(10, 90))
    )
    out = tmp_path / "out"
    run = ["run", str(clip), "--out", str(out), "-q", "--set", "lifecycle.max_lost_s=0.2"]
    assert main(run) == 0
    assert link(out) == 0
    capsys.readouterr()
    scores = []
    for tracks in (out / "tracks.txt", out / "linked" / "tracks.txt"):
        assert main(["evaluate", str(truth), str(tracks), "--json"]) == 0
        scores.append(json.loads(capsys.readouterr().out))
    assert [score["output_ids"] for score in scores] == [2, 1]
    assert [score["switches"] for score in scores] == [1, 0]
    assert [score["frames"] for score in scores] == [90, 90]
    assert scores[1]["IDF1"] > scores[0]["IDF1"] + 20
    assert scores[1]["DetA"] == pytest.approx(scores[0]["DetA"])


def test_public_footage(data: Path, tmp_path: Path) -> None:
    """Linking does not make the default worse, and mends tracks that are given up too early."""
    source = data / "video" / "vtest.avi"
    truth = data / "mot" / "PETS09-S2L1" / "gt" / "gt.txt"
    for name, options in {"default": [], "short": ["--set", "lifecycle.max_lost_s=0.3"]}.items():
        out = tmp_path / name
        assert main(["run", str(source), "--fps", "7", "--out", str(out), "-q", *options]) == 0
        assert link(out, "-q") == 0
        before = evaluate_tracks(truth, out / "tracks.txt")
        after = evaluate_tracks(truth, out / "linked" / "tracks.txt")
        assert after.hota > before.hota + (2 if options else -0.1)
        assert after.id_switches <= before.id_switches - (3 if options else 0)
