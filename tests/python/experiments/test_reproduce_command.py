# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack reproduce`: what it leaves, that it is the same each time, and what it refuses."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import cv2
import pytest

from clips import walking_square, write_images
from survtrack.cli.main import main
from survtrack.experiments.narayana2007.measured import runs
from survtrack.experiments.narayana2007.variants import (
    CORRESPONDENCES,
    FORMS,
    PRESETS,
    SCALED,
    cells,
    mergings,
)

WIDTH, HEIGHT, SIDE, STILL, COUNT = 128, 96, 10, 50, 90
KEYS = ("HOTA", "MOTA", "IDF1", "number_of_blobs_errors", "index_errors", "swap_errors")


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with in/ (a square that walks) and gt.txt."""
    folder = tmp_path_factory.mktemp("clip")
    frames = walking_square(COUNT, width=WIDTH, height=HEIGHT, side=SIDE, still=STILL)
    write_images(folder / "in", frames)
    rows = [
        f"{k + 1},7,{4 + 2 * (k - STILL)},{HEIGHT // 3},{SIDE},{SIDE},1,-1,-1,-1\n"
        for k in range(STILL, COUNT)
    ]
    (folder / "gt.txt").write_text("".join(rows))
    return folder


def reproduce(clip: Path, out: Path, *more: object) -> int:
    given = ("--source", clip / "in", "--truth", clip / "gt.txt", "--resize", f"{WIDTH}x{HEIGHT}")
    return main(["reproduce", "narayana2007", *map(str, given), "--out", str(out), *map(str, more)])


@pytest.fixture(scope="module")
def made(clip: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of one report."""
    folder = tmp_path_factory.mktemp("made") / "out"
    assert reproduce(clip, folder, "-q") == 0
    return folder


def results_of(folder: Path) -> Any:
    return json.loads((folder / "results.json").read_text())


def test_results_hold_every_run_with_what_makes_it_again(made: Path) -> None:
    results = results_of(made)
    assert results["experiment"] == "narayana2007"
    assert set(results["versions"]) == {"survtrack", "python", "numpy", "opencv", "matplotlib"}
    assert results["size"] == [WIDTH, HEIGHT]
    [one] = results["sets"]
    assert (one["name"], one["fps"], one["frames"], one["offset"]) == ("in", 25, COUNT, 0)
    assert (one["objects"], one["instances"]) == (1, COUNT - STILL)
    assert [run["name"] for run in one["presets"]] == list(PRESETS)
    assert len(one["combinations"]) == len(cells()) == 24
    assert [grid["form"] for grid in one["vicinity"]] == list(FORMS)
    by_merging = [(grid["correspondence"], grid["merging"]) for grid in one["vicinity_by_merging"]]
    assert by_merging == [(name, key) for name in CORRESPONDENCES for key in SCALED]
    swept = {(run["correspondence"], run["scaled"]) for run in one["threshold_sweep"]}
    assert swept == {(name, how) for name in CORRESPONDENCES for how in (False, True)}
    sweeps = one["break_point_sweep"] + one["threshold_sweep"]
    every = one["presets"] + one["combinations"] + sweeps
    for run in every:
        assert set(run) >= {"preset", "set", "instances", "ids", "frames_per_s", *KEYS}
    published = [run for run in every if run["preset"] != "survtrack"]
    assert all(run["set"][0] == "time_unit_s=0.04" for run in published)
    assert one["presets"][1]["HOTA"] > 80


def test_the_report_mentions_every_variant_and_claim(made: Path) -> None:
    report = (made / "report.md").read_text()
    [one] = results_of(made)["sets"]
    for cell in cells():
        row = f"| {cell.correspondence} | {cell.merging.label} | {'on' if cell.velocity else 'off'}"
        assert row in report
    for words in [*PRESETS, *FORMS, *(way.label for way in mergings())]:
        assert words in report
    for statement in one["statements"]:
        assert statement["claim"] in report
        assert ("**yes**" if statement["holds"] else "no") + f", {statement['short']}" in report
    assert all(reason in report for reason in one["reasons"])
    assert "45 (15.4 %) [13.3 %]" in report


def test_the_files_are_whole_and_listed_and_nothing_else_is_there(made: Path) -> None:
    listed = results_of(made)["outputs"]
    found = [str(path.relative_to(made)) for path in made.rglob("*") if path.is_file()]
    assert sorted(found) == sorted([*listed, "results.json"])
    report = (made / "report.md").read_text()
    plots = [name for name in listed if name.endswith(".png")]
    assert len(plots) == 4
    for name in plots:
        assert f"]({name})" in report
        picture = cv2.imread(str(made / name))
        assert picture is not None and picture.shape[1] == 880


def without_times(results: Any) -> Any:
    if isinstance(results, dict):
        return {k: without_times(v) for k, v in results.items() if k != "frames_per_s"}
    return [without_times(one) for one in results] if isinstance(results, list) else results


def test_a_second_run_is_the_same_but_for_times(
    made: Path, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert reproduce(clip, tmp_path, "--quiet") == 0
    assert capsys.readouterr() == ("", "")
    assert without_times(results_of(tmp_path)) == without_times(results_of(made))
    for name in results_of(made)["outputs"]:
        if name.endswith(".png"):
            assert (tmp_path / name).read_bytes() == (made / name).read_bytes()


def test_run_and_evaluate_give_the_same_scores(
    made: Path, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What results.json says of a run is enough to make it again."""
    [one] = results_of(made)["sets"]
    for told in (one["presets"][0], one["combinations"][0]):
        sets = [word for assignment in told["set"] for word in ("--set", assignment)]
        given = [str(clip / "in"), "--preset", told["preset"], *sets, "--out", str(tmp_path), "-q"]
        assert main(["run", *given]) == 0
        capsys.readouterr()
        tracks = str(tmp_path / "tracks.txt")
        assert main(["evaluate", str(clip / "gt.txt"), tracks, "--json"]) == 0
        scores = json.loads(capsys.readouterr().out)
        assert [scores[key] for key in KEYS] == pytest.approx([told[key] for key in KEYS])


def test_it_tells_how_far_it_is(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("survtrack.cli.progress.LINE_EVERY_S", 0.0)
    assert reproduce(clip, tmp_path) == 0
    told = capsys.readouterr()
    assert "survtrack: in, set 1 of 1" in told.err
    assert f"{runs() * COUNT} of {runs() * COUNT} frames" in told.err
    assert told.out.endswith("report.md, results.json, 4 plots\n")


def refusal(capsys: pytest.CaptureFixture[str], *args: object) -> tuple[int, str]:
    code = main(["reproduce", *map(str, args)])
    return code, capsys.readouterr().err


@pytest.mark.parametrize(
    ("args", "code", "message"),
    [
        (("semko2020", "--out", "o"), 2, "unknown experiment 'semko2020'; one of: narayana2007"),
        (("narayana2007", "--out", "o"), 2, "no footage: give --source and --truth, or --data"),
        (("narayana2007", "--truth", "t", "--out", "o"), 2, "--truth t: belongs to --source"),
        (("narayana2007", "--fps", 5, "--out", "o"), 2, "--fps 5.0: belongs to --source"),
        (("narayana2007", "--offset", 0, "--out", "o"), 2, "--offset 0: belongs to --source"),
        (("narayana2007", "--source", "s", "--out", "o"), 2, "--source s: needs --truth"),
        (
            ("narayana2007", "--source", "s", "--truth", "t", "--data", ".", "--out", "o"),
            2,
            "--data: --source names the footage already",
        ),
        (("narayana2007", "--data", "none", "--out", "o"), 1, "none: no such folder"),
        (("narayana2007", "--data", ".", "--out", "o"), 2, ".: holds none of these sets: video/"),
        (("narayana2007", "--data", ".", "--resize", "9", "--out", "o"), 2, "--resize 9: width x"),
        (("narayana2007", "--source", "s", "--truth", "t", "--out", "o"), 1, "t: no such file"),
        (("narayana2007", "--source", "s"), 2, "--out"),
    ],
)
def test_refusals(
    args: tuple[object, ...],
    code: int,
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("SURVTRACK_DATA", raising=False)
    ended, told = refusal(capsys, *args)
    assert ended == code
    assert message in told


def test_refusals_of_what_is_there(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file"
    file.touch()
    assert reproduce(clip, file) == 2
    assert f"--out {file}: is a file, a folder is needed" in capsys.readouterr().err
    assert reproduce(clip, tmp_path / "out", "--offset", 500) == 2
    assert "has no box to score in the 90 frames" in capsys.readouterr().err
    missing = ["--source", str(tmp_path / "no.mp4"), "--truth", str(clip / "gt.txt")]
    code, told = refusal(capsys, "narayana2007", *missing, "--out", tmp_path / "out")
    assert (code, "no.mp4: no such file" in told) == (1, True)
    assert os.listdir(tmp_path / "out") == []


def test_the_data_folder_can_come_from_the_environment(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SURVTRACK_DATA", str(tmp_path / "away"))
    code, told = refusal(capsys, "narayana2007", "--out", tmp_path / "out")
    assert (code, "away: no such folder" in told) == (1, True)


def test_without_matplotlib_it_says_what_to_install(
    clip: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.delitem(sys.modules, "matplotlib.figure", raising=False)
    assert reproduce(clip, tmp_path / "out") == 1
    assert "pip install survtrack[plot]" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_the_command_line_starts_without_matplotlib() -> None:
    program = "import survtrack.cli.main, sys; print('matplotlib' in sys.modules)"
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert ran.stdout == "False\n"
