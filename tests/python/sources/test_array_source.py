# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Arrays as a source: times, selection, and every kind of array that is no image."""

import numpy as np
import pytest

from clips import walking_square
from survtrack.errors import InputError, UsageError
from survtrack.sources import ArraySource, Selection, open_source


def test_yields_index_time_and_the_very_frame() -> None:
    frames = walking_square(5)
    items = list(open_source(frames, fps=10))
    assert [(index, time_s) for index, time_s, _ in items] == [
        (k, pytest.approx(k / 10)) for k in range(5)
    ]
    assert all(frame is frames[index] for index, _, frame in items)


def test_without_fps_frames_are_25_a_second() -> None:
    source = ArraySource(walking_square(3))
    assert [time_s for _, time_s, _ in source] == [0.0, 0.04, 0.08]
    assert (source.fps, source.fps_origin) == (25.0, "default")


def test_an_iterator_is_read_only_as_far_as_needed() -> None:
    frames = iter(walking_square(10))
    source = ArraySource(frames, selection=Selection(start=1, step=2, limit=2))
    assert [index for index, _, _ in source] == [1, 3]
    assert len(list(frames)) == 6


def test_grey_and_strided_frames_pass_as_they_are() -> None:
    grey = [frame[:, ::2, 0] for frame in walking_square(2)]
    assert not grey[0].flags.c_contiguous
    assert [frame.shape for _, _, frame in ArraySource(grey)] == [(64, 48)] * 2


def test_resize_scales_and_is_known_as_size() -> None:
    source = open_source(walking_square(2), resize=(48, 32))
    assert [frame.shape for _, _, frame in source] == [(32, 48, 3)] * 2
    assert source.size == (48, 32)


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (np.zeros((4, 4, 4), np.uint8), r"frame 1: has shape \(4, 4, 4\)"),
        (np.zeros((4, 4), np.uint16), "frame 1: has uint16 pixels"),
        (np.zeros((4, 4, 3), np.float32), "frame 1: has float32 pixels"),
        (np.zeros((0, 4), np.uint8), r"frame 1: is empty, shape \(0, 4\)"),
        (np.zeros(4, np.uint8), r"frame 1: has shape \(4,\)"),
        ("picture.png", "frame 1: is a str, not a numpy array"),
        (np.zeros((4, 5, 3), np.uint8), "frame 1: is 5x4 colour, but .* 4x4 colour"),
        (np.zeros((4, 4), np.uint8), "frame 1: is 4x4 grey, but .* 4x4 colour"),
    ],
)
def test_a_bad_frame_is_named_after_the_good_ones(frame: object, message: str) -> None:
    seen = []
    with pytest.raises(InputError, match=message):
        for index, _, _ in ArraySource([np.zeros((4, 4, 3), np.uint8), frame]):  # type: ignore[list-item]
            seen.append(index)
    assert seen == [0]


@pytest.mark.parametrize("shape", [(8, 9, 3), (8, 9)])
def test_a_single_image_is_not_taken_for_many(shape: tuple[int, ...]) -> None:
    with pytest.raises(UsageError, match="looks like a single image"):
        open_source(np.zeros(shape, np.uint8))


def test_no_frames_at_all() -> None:
    with pytest.raises(InputError, match="arrays: holds no frames"):
        list(ArraySource([]))


@pytest.mark.parametrize("fps", [0.0, -1.0, float("nan"), float("inf")])
def test_refuses_a_frame_rate_that_is_none(fps: float) -> None:
    with pytest.raises(UsageError, match=r"fps: .* is not allowed; a number above 0"):
        ArraySource([], fps=fps)


@pytest.mark.parametrize("size", [(0, 4), (4, -1)])
def test_refuses_a_size_that_is_none(size: tuple[int, int]) -> None:
    with pytest.raises(UsageError, match=r"resize: .* is not allowed"):
        ArraySource([], resize=size)
