# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Frames: every uint8 array of grey or BGR is used as it is, all else is refused by name."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import survtrack
from clips import Image
from scenes import PRESETS, answer, run, scene
from survtrack import InputError, Pipeline

Layout = Callable[[Image], Image]


def wider(frame: Image, *step: int) -> Image:
    """An array of which every step-th value is the frame's."""
    whole = np.zeros([n * s for n, s in zip(frame.shape, step, strict=True)], np.uint8)
    return whole[tuple(slice(None, None, s) for s in step)]


def strided(*step: int) -> Layout:
    def lay(frame: Image) -> Image:
        view = wider(frame, *step)
        view[...] = frame
        return view

    return lay


def padded(frame: Image) -> Image:
    """A window in a larger picture, as numpy crops it."""
    whole = np.full((frame.shape[0] + 9, frame.shape[1] + 7, 3), 200, np.uint8)
    view = whole[4:-5, 3:-4]
    view[...] = frame
    return view


def reversed_axes(*axes: int) -> Layout:
    """The same pixels, stored backwards: strides are negative."""
    return lambda frame: np.flip(np.flip(frame, axes).copy(), axes)


LAYOUTS: dict[str, Layout] = {
    "crop": padded,
    "every second row": strided(2, 1, 1),
    "every third column": strided(1, 3, 1),
    "every second channel": strided(1, 1, 2),
    "RGB seen as BGR": reversed_axes(2),
    "upside down": reversed_axes(0),
    "mirrored": reversed_axes(1),
    "all reversed": reversed_axes(0, 1, 2),
    "Fortran order": np.asfortranarray,
    "planes": lambda frame: np.ascontiguousarray(frame.transpose(2, 0, 1)).transpose(1, 2, 0),
    "columns first": lambda frame: np.ascontiguousarray(frame.transpose(1, 0, 2)).transpose(
        1, 0, 2
    ),
    "read only": lambda frame: np.frombuffer(frame.tobytes(), np.uint8).reshape(frame.shape),
    "unaligned": lambda frame: np.frombuffer(b"x" + frame.tobytes(), np.uint8, offset=1).reshape(
        frame.shape
    ),
    "subclass": lambda frame: frame.view(type("Picture", (np.ndarray,), {})),
}


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
@pytest.mark.parametrize("grey", [False, True], ids=["colour", "grey"])
def test_only_the_pixels_count_not_their_layout(layout: Layout, grey: bool) -> None:
    plain = scene(24)
    laid = [layout(frame) for frame in plain]
    if grey:
        plain, laid = ([frame[..., 1] for frame in frames] for frames in (plain, laid))
        plain = [np.ascontiguousarray(frame) for frame in plain]
    before = [frame.copy() for frame in laid]
    results = run(Pipeline(), laid)
    assert answer(results) == answer(run(Pipeline(), plain))
    assert any(result.tracks for result in results)
    for result, frame, kept in zip(results, laid, before, strict=True):
        assert result.frame is frame, "a result's frame is the array that was given"
        assert np.array_equal(frame, kept), "the frame was written to"


@pytest.mark.parametrize("preset", PRESETS)
def test_grey_frames_are_like_colour_frames_of_three_equal_channels(preset: str) -> None:
    config = survtrack.preset(preset)
    if preset == "survtrack":
        config.set("segmenter.remove_shadows=false")  # looks at colour
    grey = [frame[..., 1] for frame in scene(30)]
    color = [np.repeat(frame[..., None], 3, axis=2) for frame in grey]
    one, three = (run(Pipeline(config), frames) for frames in (grey, color))
    assert answer(one) == answer(three)
    assert any(len(result.detections) for result in one)


def test_a_frame_of_one_value_is_read_in_place() -> None:
    frame = np.broadcast_to(np.uint8(7), (40, 60, 3))
    result = Pipeline().process(frame, 0.0)
    assert result.frame is frame and not result.mask.any()


@pytest.mark.parametrize("shape", [(1, 1), (1, 1, 3), (1, 200), (200, 1, 3), (3, 2, 3), (65, 1)])
@pytest.mark.parametrize("preset", PRESETS)
def test_the_smallest_frames(shape: tuple[int, ...], preset: str) -> None:
    random = np.random.default_rng(0)
    frames = [random.integers(0, 256, shape, dtype=np.uint8) for _ in range(12)]
    config = survtrack.preset(preset)
    if config.vicinity.model == "grid":
        config.set("vicinity.cell_px=1")  # no larger than the frame
    config.set("cleanup.tiling.model=none")  # a frame smaller than its tiles is refused
    results = run(Pipeline(config), frames)
    assert [result.index for result in results] == list(range(12))
    for result in results:
        assert result.mask.shape == shape[:2]
        assert set(np.unique(result.mask)) <= {0, 255}


def test_an_8k_frame() -> None:
    frame = np.full((4320, 7680, 3), 60, np.uint8)
    pipeline = Pipeline(survtrack.Config(blobs=survtrack.BlobOptions(min_area_fraction=0)))
    pipeline.process(frame, 0.0)
    frame[4000:4300, 7300:7679] = 220
    result = pipeline.process(frame, 0.1)
    assert result.mask.shape == (4320, 7680)
    (box,) = (detection.box for detection in result.detections)
    assert list(box) == pytest.approx([7300, 4000, 379, 300], abs=2)


NO_FRAMES: dict[str, tuple[Any, str]] = {
    "list": ([[1, 2], [3, 4]], "is list"),
    "None": (None, "is NoneType"),
    "number": (3, "is int"),
    "bytes": (b"abc", "is bytes"),
    "path": ("frame.png", "is str"),
    "BGRA": (np.zeros((4, 5, 4), np.uint8), r"is \(4, 5, 4\) uint8"),
    "two channels": (np.zeros((4, 5, 2), np.uint8), r"is \(4, 5, 2\) uint8"),
    "one channel in three axes": (np.zeros((4, 5, 1), np.uint8), r"is \(4, 5, 1\) uint8"),
    "channels first": (np.zeros((3, 4, 5), np.uint8), r"is \(3, 4, 5\) uint8"),
    "16 bit": (np.zeros((4, 5), np.uint16), r"is \(4, 5\) uint16"),
    "signed": (np.zeros((4, 5), np.int8), r"is \(4, 5\) int8"),
    "integers": (np.zeros((4, 5, 3), int), r"is \(4, 5, 3\) int64"),
    "float32": (np.zeros((4, 5, 3), np.float32), r"is \(4, 5, 3\) float32"),
    "float64": (np.zeros((4, 5)), r"is \(4, 5\) float64"),
    "bool": (np.zeros((4, 5), bool), r"is \(4, 5\) bool"),
    "objects": (np.zeros((4, 5), object), r"is \(4, 5\) object"),
    "structured": (np.zeros((4, 5), [("a", "u1")]), r"is \(4, 5\) \["),
    "bytes of one": (np.zeros((4, 5), "S1"), r"is \(4, 5\) \|S1"),
    "no rows": (np.zeros((0, 5), np.uint8), r"is \(0, 5\) uint8; .*at least one pixel$"),
    "no columns": (np.zeros((4, 0, 3), np.uint8), r"is \(4, 0, 3\) uint8; .*at least one pixel$"),
    "0 axes": (np.zeros((), np.uint8), r"is \(\) uint8"),
    "1 axis": (np.zeros(5, np.uint8), r"is \(5,\) uint8"),
    "4 axes": (np.zeros((1, 4, 5, 3), np.uint8), r"is \(1, 4, 5, 3\) uint8"),
    "too high": (
        np.broadcast_to(np.uint8(3), (2**20 + 1, 4)),
        r"is \(1048577, 4\) uint8; expected at most 1048576 pixels a side",
    ),
    "too wide": (
        np.broadcast_to(np.uint8(3), (4, 2**31, 3)),
        r"is .*; expected at most 1048576 pixels a side",
    ),
}


@pytest.mark.parametrize(("frame", "message"), NO_FRAMES.values(), ids=NO_FRAMES)
def test_what_is_no_frame_is_refused_with_what_it_is(frame: Any, message: str) -> None:
    for refuse in (
        lambda: Pipeline().process(frame, 0.0),
        lambda: survtrack.Detector().process(frame, 0.0),
        lambda: survtrack.Segmenter().segment(frame, 0.0),
    ):
        with pytest.raises(InputError, match=f"^frame: {message}") as caught:
            refuse()
        assert "; expected " in str(caught.value)
