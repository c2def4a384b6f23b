# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Masks: their names, their values, and never two runs in one folder."""

import os
from pathlib import Path

import cv2
import numpy as np
import pytest

from clips import walking_square
from fakes import result_of
from survtrack.errors import InputError
from survtrack.sinks import MaskFolder
from survtrack.sinks.masks import mask_name


@pytest.mark.parametrize(
    ("index", "file_name", "expected"),
    [
        (0, None, "bin000001.png"),
        (1_000_000, None, "bin1000001.png"),
        (0, "in000470.jpg", "bin000470.png"),
        (0, "Walk10236.jpg", "bin010236.png"),
        (0, "7.png", "bin000007.png"),
        (0, "cam2_20240131123456.png", "bin123456.png"),
    ],
)
def test_names(index: int, file_name: str | None, expected: str) -> None:
    assert mask_name(index, file_name) == expected


def test_a_name_without_a_number_is_refused() -> None:
    with pytest.raises(InputError, match=r"still\.png: its mask is named by a number"):
        mask_name(0, "still.png")


def test_masks_are_8_bit_0_and_255(tmp_path: Path) -> None:
    results = [result_of(frame, k) for k, frame in enumerate(walking_square(3, still=1))]
    with MaskFolder(tmp_path) as sink:
        for result in results:
            sink.write(result.frame, result)
    assert sorted(os.listdir(tmp_path)) == [f"bin00000{k}.png" for k in (1, 2, 3)]
    for result in results:
        image = cv2.imread(str(tmp_path / f"bin00000{result.index + 1}.png"), cv2.IMREAD_UNCHANGED)
        assert image is not None
        assert np.array_equal(image, result.mask)
    assert np.unique(results[2].mask).tolist() == [0, 255]
    assert sink.outputs == ["bin*.png"]


def test_old_masks_stay_until_the_new_ones_are_whole_and_then_go(tmp_path: Path) -> None:
    frame = walking_square(1)[0]
    for name in ("bin000001.png", "bin000099.png", "binoculars.png", "photo.png"):
        (tmp_path / name).write_text("old")
    (tmp_path / "masks.part").mkdir()
    (tmp_path / "masks.part" / "bin000050.png").write_text("of a run that was killed")
    with MaskFolder(tmp_path) as sink:
        sink.write(frame, result_of(frame, 0))
        assert (tmp_path / "bin000001.png").read_text() == "old"
        assert sink.outputs == []
    assert sorted(os.listdir(tmp_path)) == ["bin000001.png", "binoculars.png", "photo.png"]
    assert (tmp_path / "bin000001.png").read_bytes().startswith(b"\x89PNG")


def test_two_images_that_would_share_a_mask_are_named(tmp_path: Path) -> None:
    frame = walking_square(1)[0]
    names = ["a000001.png", "b000001.png"]
    with (
        pytest.raises(InputError, match=r"b000001\.png: its mask .* as that of a000001\.png"),
        MaskFolder(tmp_path, names.__getitem__) as sink,
    ):
        sink.write(frame, result_of(frame, 0))
        sink.write(frame, result_of(frame, 1))
    assert os.listdir(tmp_path) == ["bin000001.png"]


def test_a_mask_that_cannot_be_written_leaves_no_part(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frame = walking_square(1)[0]

    def write_some(path: Path, data: bytes) -> int:
        with path.open("wb") as file:
            file.write(data[:10])
        raise OSError(28, "No space left on device")

    with (
        pytest.raises(OSError, match=r"No space left on device: '.*bin000002\.png'"),
        MaskFolder(tmp_path) as sink,
    ):
        sink.write(frame, result_of(frame, 0))
        monkeypatch.setattr(Path, "write_bytes", write_some)
        sink.write(frame, result_of(frame, 1))
    assert os.listdir(tmp_path) == ["bin000001.png"]
