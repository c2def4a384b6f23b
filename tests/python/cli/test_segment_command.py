# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack segment`: masks named as CDnet names them."""

import json
import os
from pathlib import Path

import cv2
import numpy as np
import pytest

import survtrack
from clips import cut_short, walking_square, write_images, write_video
from survtrack.cli.main import main

FRAMES = walking_square(12, width=128, height=96, side=20, still=5)


def masks(folder: Path) -> list[str]:
    return sorted(name for name in os.listdir(folder) if name.endswith(".png"))


def segment(*args: object) -> int:
    return main(["segment", *map(str, args)])


def test_a_folders_masks_have_its_numbers_and_the_pipelines_values(tmp_path: Path) -> None:
    write_images(tmp_path / "in", FRAMES, first=700)
    assert segment(tmp_path / "in", "--out", tmp_path / "out") == 0
    assert masks(tmp_path / "out") == [f"bin{k:06d}.png" for k in range(700, 712)]
    for (_, result), name in zip(
        survtrack.track(tmp_path / "in"), masks(tmp_path / "out"), strict=True
    ):
        image = cv2.imread(str(tmp_path / "out" / name), cv2.IMREAD_UNCHANGED)
        assert image is not None
        assert np.array_equal(image, result.mask)
    facts = json.loads((tmp_path / "out" / "run.json").read_text())
    assert (facts["command"], facts["complete"]) == ("segment", True)
    assert sorted(os.listdir(tmp_path / "out"))[-2:] == ["config.toml", "run.json"]


def test_a_videos_masks_count_from_1_whatever_start_and_step(tmp_path: Path) -> None:
    clip = write_video(tmp_path / "clip.mp4", FRAMES)
    assert segment(clip, "--out", tmp_path / "out", "--start", 2, "--step", 3) == 0
    assert masks(tmp_path / "out") == [f"bin{k:06d}.png" for k in (3, 6, 9, 12)]


def test_a_shorter_run_leaves_no_masks_of_a_longer_one(tmp_path: Path) -> None:
    write_images(tmp_path / "in", FRAMES)
    assert segment(tmp_path / "in", "--out", tmp_path / "out") == 0
    assert segment(tmp_path / "in", "--out", tmp_path / "out", "--limit", 2) == 0
    assert masks(tmp_path / "out") == ["bin000001.png", "bin000002.png"]


def test_masks_of_something_else_are_not_touched(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_images(tmp_path / "in", FRAMES)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "bin000099.png").write_text("precious")
    assert segment(tmp_path / "in", "--out", tmp_path / "out") == 2
    assert os.listdir(tmp_path / "out") == ["bin000099.png"]
    assert "holds 1 masks (bin000099.png, ...)" in capsys.readouterr().err


def test_a_broken_image_keeps_the_masks_before_it(tmp_path: Path) -> None:
    write_images(tmp_path / "in", FRAMES)
    cut_short(tmp_path / "in" / "in000005.png", 0.5)
    assert segment(tmp_path / "in", "--out", tmp_path / "out") == 1
    assert masks(tmp_path / "out") == [f"bin{k:06d}.png" for k in (1, 2, 3, 4)]
    assert json.loads((tmp_path / "out" / "run.json").read_text())["complete"] is False


def test_names_without_numbers_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_images(tmp_path / "in", FRAMES[:1], pattern="still.png")
    assert segment(tmp_path / "in", "--out", tmp_path / "out") == 1
    assert "still.png: its mask is named by a number" in capsys.readouterr().err


def test_public_masks_can_be_scored(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sequence = data / "sbi" / "IBMtest2"
    assert segment(sequence / "input", "--out", tmp_path, "--quiet") == 0
    assert masks(tmp_path)[0] == "bin000000.png"
    assert len(masks(tmp_path)) == 90
    assert main(["evaluate-masks", str(sequence), str(tmp_path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["F"] > 0.3
