# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Folders and globs of images: their order, numbering, and every broken one named."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from clips import cut_short, walking_square, write_images
from survtrack.errors import InputError, UsageError
from survtrack.sources import ImageSource, open_source
from survtrack.sources.images import is_cut_jpeg


def test_a_folder_is_read_in_the_order_of_its_numbers(tmp_path: Path) -> None:
    frames = walking_square(12)
    write_images(tmp_path, frames, pattern="frame{}.png")
    source = open_source(tmp_path, fps=5)
    items = list(source)
    assert [source.file_name(index) for index, _, _ in items] == [
        f"frame{k}.png" for k in range(1, 13)
    ]
    assert [time_s for _, time_s, _ in items] == [k / 5 for k in range(12)]
    assert all(np.array_equal(frame, frames[index]) for index, _, frame in items)
    assert (source.frame_count_declared, source.size) == (12, (96, 64))


def test_selection_keeps_position_time_and_name(tmp_path: Path) -> None:
    write_images(tmp_path, walking_square(10), first=700)
    source = open_source(tmp_path, fps=10, start=2, step=3, limit=2)
    assert [(index, time_s) for index, time_s, _ in source] == [(2, 0.2), (5, 0.5)]
    assert source.file_name(5) == "in000705.png"


def test_a_glob_chooses_files(tmp_path: Path) -> None:
    write_images(tmp_path, walking_square(3))
    write_images(tmp_path, walking_square(2), pattern="other{}.png")
    assert len(list(open_source(str(tmp_path / "in*.png")))) == 3


def test_a_folder_whose_name_looks_like_a_glob_is_a_folder(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "cam[1]", walking_square(2))
    assert len(list(open_source(folder))) == 2


def test_other_files_and_hidden_ones_do_not_count(tmp_path: Path) -> None:
    write_images(tmp_path, walking_square(2))
    (tmp_path / "notes.txt").write_text("sunny")
    (tmp_path / "._in000001.png").write_bytes(b"\0")
    assert len(list(open_source(tmp_path))) == 2


def test_grey_images_stay_grey_and_transparency_is_ignored(tmp_path: Path) -> None:
    frames = walking_square(1)
    write_images(tmp_path / "grey", [frames[0][:, :, 1]])
    clear = np.dstack([frames[0], np.zeros((64, 96), np.uint8)])
    write_images(tmp_path / "clear", [clear])
    assert next(iter(open_source(tmp_path / "grey")))[2].shape == (64, 96)
    assert np.array_equal(next(iter(open_source(tmp_path / "clear")))[2], frames[0])


def test_a_single_image_is_a_source_of_one_frame(tmp_path: Path) -> None:
    folder = write_images(tmp_path, walking_square(2))
    assert len(list(open_source(folder / "in000002.png"))) == 1


def read_until_error(folder: Path) -> tuple[int, str]:
    """Frames read, and what ended it."""
    count = 0
    with pytest.raises(InputError) as caught:
        for _ in open_source(folder):
            count += 1
    return count, str(caught.value)


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".bmp", ".tif"])
def test_an_image_cut_short_is_named(tmp_path: Path, suffix: str) -> None:
    write_images(tmp_path, walking_square(5), pattern="in{:06d}" + suffix)
    broken = cut_short(tmp_path / f"in000004{suffix}", 0.6)
    count, message = read_until_error(tmp_path)
    assert (count, message) == (
        3,
        f"{broken}: is not an image, or a broken one ({broken.stat().st_size} bytes)",
    )


def test_a_jpeg_without_its_end_is_told_from_a_whole_one() -> None:
    data = cv2.imencode(".jpg", walking_square(1)[0])[1].tobytes()
    assert not is_cut_jpeg(data)
    assert not is_cut_jpeg(data + b"something after the end")
    assert is_cut_jpeg(data[:-2])
    thumbnail_then_cut = data[:2] + data + data[2:-40]
    assert is_cut_jpeg(thumbnail_then_cut)


@pytest.mark.parametrize("content", [b"", b"this is no image"])
def test_a_file_that_is_no_image_is_named(tmp_path: Path, content: bytes) -> None:
    write_images(tmp_path, walking_square(3))
    (tmp_path / "in000002.png").write_bytes(content)
    count, message = read_until_error(tmp_path)
    assert count == 1
    assert "in000002.png: is not an image, or a broken one" in message


@pytest.mark.parametrize(
    ("image", "words"),
    [
        (np.zeros((32, 96, 3), np.uint8), "is 96x32 colour, but the frames before are 96x64"),
        (np.zeros((64, 96), np.uint8), "is 96x64 grey, but the frames before are 96x64 colour"),
        (np.zeros((64, 96, 3), np.uint16), "has uint16 pixels; only uint8"),
    ],
)
def test_a_change_of_size_or_type_is_named(tmp_path: Path, image: np.ndarray, words: str) -> None:
    write_images(tmp_path, walking_square(4))
    assert cv2.imwrite(str(tmp_path / "in000003.png"), image)
    count, message = read_until_error(tmp_path)
    assert count == 2
    assert f"in000003.png: {words}" in message


def test_nothing_to_read(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no images in this folder"):
        open_source(tmp_path)
    with pytest.raises(InputError, match="no file matches this pattern"):
        open_source(str(tmp_path / "*.png"))
    with pytest.raises(InputError, match="no such file or folder"):
        open_source(tmp_path / "missing.png")
    with pytest.raises(InputError, match="empty name"):
        open_source("")


def test_a_folder_of_several_kinds_asks_for_a_glob(tmp_path: Path) -> None:
    write_images(tmp_path, walking_square(3), pattern="in{}.jpg")
    write_images(tmp_path, walking_square(1), pattern="region{}.bmp")
    with pytest.raises(InputError, match=r"several kinds \(1 \.bmp, 3 \.jpg\).*'.*\*\.jpg'"):
        open_source(tmp_path)


def test_start_after_the_end_is_misuse(tmp_path: Path) -> None:
    write_images(tmp_path, walking_square(3))
    with pytest.raises(UsageError, match="start: 3 skips all 3 frames"):
        open_source(tmp_path, start=3)


def test_public_folders_are_numbered_as_they_are(data: Path) -> None:
    for folder, count, first in (
        ("sbi/IBMtest2/input", 90, "in000000.png"),
        ("cdnet/canoe/input", 490, "in000700.jpg"),
        ("caviar/Walk1/input", 276, "Walk10236.jpg"),
    ):
        source = open_source(data / folder, limit=1)
        assert isinstance(source, ImageSource)
        assert (source.frame_count_declared, source.file_name(0)) == (count, first)
