# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The commands print what the functions score: a table for people, JSON for programs."""

import json
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from survtrack.cli.evaluate import evaluate, evaluate_masks
from survtrack.errors import InputError, UsageError

app = typer.Typer()
app.command("evaluate")(evaluate)
app.command("evaluate-masks")(evaluate_masks)


def run(*arguments: object) -> str:
    result = CliRunner().invoke(app, [str(argument) for argument in arguments])
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert result.exit_code == 0, result.output
    return result.stdout


@pytest.fixture
def truth(tmp_path: Path) -> Path:
    path = tmp_path / "gt.txt"
    path.write_text("".join(f"{k},1,0,0,30,10,1,-1,-1,-1\n" for k in range(1, 9)), "ascii")
    return path


@pytest.fixture
def tracks(tmp_path: Path) -> Path:
    """The truth with another identity from frame 5 on, and a third of a width to the right."""
    path = tmp_path / "tracks.txt"
    path.write_text("".join(f"{k},{k // 5},10,0,30,10,1,-1,-1,-1\n" for k in range(1, 9)), "ascii")
    return path


def test_evaluate_prints_json(truth: Path, tracks: Path) -> None:
    scores = json.loads(run("evaluate", truth, tracks, "--json"))
    assert scores["DetA"] == pytest.approx(100 * 10 / 19)
    assert scores["MOTA"] == 100 * 7 / 8
    assert (scores["IDF1"], scores["switches"], scores["frames"]) == (50, 1, 8)
    errors = ("number_of_blobs_errors", "index_errors", "swap_errors", "truth_boxes")
    assert [scores[name] for name in errors] == [0, 4, 1, 8]


def test_evaluate_passes_its_options_on(truth: Path, tracks: Path) -> None:
    options = ("--frames", "2-7", "--offset", 2, "--iou", 0.6, "--json")
    scores = json.loads(run("evaluate", truth, tracks, *options))
    assert (scores["frames"], scores["first_frame"], scores["last_frame"]) == (6, 2, 7)
    assert (scores["truth_boxes"], scores["output_boxes"]) == (5, 6)
    assert (scores["offset"], scores["iou"], scores["MOTA"]) == (2, 0.6, -120)


def test_evaluate_prints_a_table(truth: Path, tracks: Path) -> None:
    lines = run("evaluate", truth, tracks).splitlines()
    row = {line.split("│")[1].strip(): line.split("│")[2].strip() for line in lines if "│" in line}
    assert (row["HOTA"], row["MOTA"], row["IDF1"]) == ("37.2 %", "87.5 %", "50.0 %")
    assert (row["switches"], row["false positives"]) == ("1", "0")
    assert (row["number of blobs errors"], row["index errors"], row["swap errors"]) == (
        ("0", "4", "1")
    )


def test_evaluate_masks_prints_both(tmp_path: Path) -> None:
    sequence, masks = tmp_path / "sequence", tmp_path / "masks"
    (sequence / "groundtruth").mkdir(parents=True)
    masks.mkdir()
    (sequence / "temporalROI.txt").write_text("0 1", "ascii")
    for number in (0, 1):
        image = np.array([[0, 170, 255, 255]], np.uint8)
        cv2.imwrite(str(sequence / "groundtruth" / f"gt{number:06d}.png"), image)
        cv2.imwrite(str(masks / f"bin{number:06d}.png"), image // 255 * 255 * (number == 0))
    scores = json.loads(run("evaluate-masks", sequence, masks, "--json"))
    assert (scores["Re"], scores["Pr"], scores["frames"]) == (0.5, 1, 2)
    assert "0.6667" in run("evaluate-masks", sequence, masks)
    only = json.loads(run("evaluate-masks", sequence, masks, "--frames", "1-1", "--json"))
    assert (only["Re"], only["Pr"]) == (0, None)
    table = run("evaluate-masks", sequence, masks, "--frames", "1-1")
    assert [line.split("│")[2].strip() for line in table.splitlines() if "│ Pr" in line] == ["-"]


@pytest.mark.parametrize("text", ["5", "a-b", "-3-4", "1-2-3", "1:5", ""])
def test_frames_that_cannot_be_read(truth: Path, tracks: Path, text: str) -> None:
    with pytest.raises(UsageError, match=r"--frames .*: two frame numbers expected"):
        run("evaluate", truth, tracks, f"--frames={text}")


def test_errors_pass_through(truth: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        run("evaluate", truth, tmp_path / "missing.txt")
    with pytest.raises(UsageError, match="frames 8-2"):
        run("evaluate", truth, truth, "--frames", "8-2")


def test_importing_the_judge_is_light() -> None:
    code = "import sys, survtrack.evaluation; print(sorted({'cv2', 'scipy'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
