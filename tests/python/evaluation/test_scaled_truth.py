# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Tracks of scaled frames are scored at their size."""

import json
from pathlib import Path

import pytest

from survtrack.cli.main import main
from survtrack.errors import InputError, UsageError
from survtrack.evaluation import evaluate_tracks

TRUTH = "1,1,100,40,20,60,1\n2,1,104,40,20,60,1\n"
TRACKS = "1,7,50,10,10,15,1,-1,-1,-1\n2,7,52,10,10,15,1,-1,-1,-1\n"  # half as wide, a quarter high


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    truth, tracks = tmp_path / "gt.txt", tmp_path / "out" / "tracks.txt"
    tracks.parent.mkdir()
    truth.write_text(TRUTH)
    tracks.write_text(TRACKS)
    return truth, tracks


def tell(tracks: Path, **facts: object) -> None:
    frames = {"first": 1, "last": 2, "step": 1, "count": 2}
    (tracks.parent / "run.json").write_text(json.dumps({"frames": frames, **facts}))


def test_the_run_says_how_its_frames_were_scaled(files: tuple[Path, Path]) -> None:
    truth, tracks = files
    assert evaluate_tracks(truth, tracks).hota < 10
    tell(tracks, size=[320, 60], original_size=[640, 240])
    scores = evaluate_tracks(truth, tracks)
    assert (scores.hota, scores.mota, scores.number_of_blobs_errors) == (100, 100, 0)
    assert (scores.scale_x, scores.scale_y) == (0.5, 0.25)


def test_a_given_scale_counts_more(files: tuple[Path, Path]) -> None:
    truth, tracks = files
    tell(tracks, size=[640, 240], original_size=[640, 240])
    assert evaluate_tracks(truth, tracks).hota < 10
    assert evaluate_tracks(truth, tracks, scale=(0.5, 0.25)).hota == 100


def test_a_run_that_does_not_tell_was_not_scaled(files: tuple[Path, Path]) -> None:
    truth, tracks = files
    tell(tracks, size=[640, 240])
    assert evaluate_tracks(truth, tracks).scale_x == 1


@pytest.mark.parametrize("size", [[0, 5], "x", [1], [None, 2], {"a": 1}, [1, -2]])
def test_sizes_that_are_none_are_refused(files: tuple[Path, Path], size: object) -> None:
    truth, tracks = files
    tell(tracks, size=[320, 240], original_size=size)
    with pytest.raises(InputError, match=r'run\.json: "size" and "original_size"'):
        evaluate_tracks(truth, tracks)


@pytest.mark.parametrize("scale", [(0.0, 1.0), (1.0, -1.0), (float("nan"), 1.0)])
def test_scales_that_are_none_are_refused(
    files: tuple[Path, Path], scale: tuple[float, float]
) -> None:
    with pytest.raises(UsageError, match=r"scale .*: both must be finite and above 0"):
        evaluate_tracks(*files, scale=scale)


def test_the_command_takes_a_scale(
    files: tuple[Path, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["evaluate", *map(str, files), "--json", "--scale"]
    assert main([*arguments, "0.5,0.25"]) == 0
    assert json.loads(capsys.readouterr().out)["HOTA"] == 100
    assert main([*arguments, "0.5"]) == 0
    assert json.loads(capsys.readouterr().out)["scale_y"] == 0.5
    for wrong in ("a", "1,2,3", "nan", "0"):
        assert main([*arguments, wrong]) == 2
        assert "scale" in capsys.readouterr().err
