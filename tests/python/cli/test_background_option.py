# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`--background FILE` of `run` and `segment`."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from clips import walking_square, write_images
from survtrack.cli.main import main

FRAMES = walking_square(12, width=128, height=96, side=20)
STATIC = ["--set", "segmenter.model=static_reference"]
PICTURE = [*STATIC, "--set", "segmenter.source=picture"]


@pytest.fixture
def footage(tmp_path: Path) -> Path:
    """A square from the first frame on, and ground.png without it."""
    write_images(tmp_path / "in", FRAMES)
    empty = walking_square(1, width=128, height=96, still=1)[0]
    assert cv2.imwrite(str(tmp_path / "ground.png"), empty)
    return tmp_path


def call(command: str, footage: Path, *args: object) -> int:
    return main([command, str(footage / "in"), "--out", str(footage / "out"), *map(str, args)])


def test_the_first_mask_is_found_with_a_picture(footage: Path) -> None:
    assert call("segment", footage, *PICTURE, "--background", footage / "ground.png") == 0
    mask = cv2.imread(str(footage / "out" / "bin000001.png"), cv2.IMREAD_UNCHANGED)
    assert mask is not None and 380 <= np.count_nonzero(mask) <= 400
    facts = json.loads((footage / "out" / "run.json").read_text())
    assert facts["background"] == str(footage / "ground.png")
    assert call("run", footage, *PICTURE, "--background", footage / "ground.png") == 0
    facts = json.loads((footage / "out" / "run.json").read_text())
    assert (facts["complete"], facts["background"]) == (True, str(footage / "ground.png"))


@pytest.mark.parametrize("command", ["run", "segment"])
def test_what_does_not_fit_is_told_before_the_first_frame(
    footage: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (footage / "text.png").write_text("no picture")
    assert cv2.imwrite(str(footage / "small.png"), FRAMES[0][:40])
    assert cv2.imwrite(str(footage / "deep.png"), FRAMES[0].astype(np.uint16))
    for args, code, words in (
        (PICTURE, 2, "segmenter.source: picture needs one; add --background FILE"),
        ([*STATIC, "--background", footage / "ground.png"], 2, "this config takes no picture"),
        (["--background", footage / "ground.png"], 2, "this config takes no picture"),
        ([*PICTURE, "--background", footage / "none.png"], 1, "none.png: No such file"),
        ([*PICTURE, "--background", footage / "text.png"], 1, "text.png: is not an image"),
        ([*PICTURE, "--background", footage / "deep.png"], 1, "deep.png: "),
        (
            [*PICTURE, "--background", footage / "small.png"],
            1,
            "background: the picture is 40x128x3, the frame 96x128x3",
        ),
    ):
        assert call(command, footage, *args) == code, words
        assert words in capsys.readouterr().err
        assert not (footage / "out").exists()


def test_too_few_frames_to_take_a_background_from(
    footage: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("run", footage, *STATIC, "--set", "segmenter.frames=12") == 1
    words = "segmenter.frames: 12 is not allowed with the 12 frame(s) of"
    assert words in capsys.readouterr().err
    assert call("run", footage, *STATIC, "--set", "segmenter.frames=11") == 0
    difference = ["--set", "segmenter.model=normalized_difference"]
    assert call("run", footage, *difference, "--set", "segmenter.frames_back=100") == 0
    previous = [*difference, "--set", "segmenter.reference=previous"]
    assert call("run", footage, *previous, "--set", "segmenter.frames_back=12") == 1
    assert "segmenter.frames_back: 12 is not allowed" in capsys.readouterr().err
