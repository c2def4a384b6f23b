# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The contract of a source, and the checks that all sources share."""

from collections.abc import Iterator
from typing import Any, Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt

from survtrack.errors import InputError, UsageError
from survtrack.sources.selection import Selection

Frame = npt.NDArray[np.uint8]
Size = tuple[int, int]

# Images carry no time. 25 frames/s (PAL, CAVIAR, most of CDnet) is assumed unless told otherwise.
DEFAULT_FPS = 25.0


@runtime_checkable
class Source(Protocol):
    """Yields (index, time_s, frame) for each selected frame.

    index: position in the whole source, from 0, whatever start and step.
    time_s: seconds, strictly increasing.
    frame: uint8 array, HxW grey or HxWx3 BGR; the same shape throughout; never written again.

    A source that ends before its time or meets something it cannot read raises InputError after
    the frames before it.
    """

    @property
    def name(self) -> str:
        """What the user called it; used in messages and in run.json."""

    @property
    def size(self) -> Size | None:
        """(width, height) of the yielded frames in pixels; None until known."""

    @property
    def original_size(self) -> Size | None:
        """The same before they are scaled."""

    @property
    def fps(self) -> float:
        """Nominal frames per second of the whole source (before step)."""

    @property
    def fps_origin(self) -> str:
        """Where fps comes from: "given", "container" or "default"."""

    @property
    def frame_count_declared(self) -> int | None:
        """Frames in the whole source as far as it says so before it is read."""

    @property
    def endless(self) -> bool:
        """True for a live stream."""

    @property
    def selection(self) -> Selection:
        """Which frames of the source are yielded."""

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]: ...

    def file_name(self, index: int) -> str | None:
        """Name of the image file that holds frame `index`; None when the source is not files."""


def check_fps(fps: float | None) -> float | None:
    """Return fps; raise UsageError unless it is None or a positive number."""
    if fps is not None and not (np.isfinite(fps) and fps > 0):
        raise UsageError(f"fps: {fps} frames/s is not allowed; a number above 0")
    return fps


def check_resize(size: Size | None) -> Size | None:
    """Return size; raise UsageError unless it is None or (width, height) above 0."""
    if size is not None and (len(size) != 2 or min(size) < 1):
        raise UsageError(f"resize: {size} is not allowed; (width, height), both 1 or more")
    return size


def check_frame(frame: Any, what: str, expected: tuple[int, ...] | None = None) -> Frame:
    """Return frame if a pipeline can take it, else raise InputError that starts with `what`.

    Args:
        frame: anything that is meant to be an image.
        what: names the frame in the message.
        expected: shape of the frames before; None for the first.
    """
    if not isinstance(frame, np.ndarray):
        raise InputError(f"{what}: is a {type(frame).__name__}, not a numpy array")
    if frame.dtype != np.uint8:
        raise InputError(f"{what}: has {frame.dtype} pixels; only uint8 (0 to 255) is allowed")
    if frame.ndim != 2 and not (frame.ndim == 3 and frame.shape[2] == 3):
        raise InputError(f"{what}: has shape {frame.shape}; allowed are HxW (grey) and HxWx3 (BGR)")
    if frame.size == 0:
        raise InputError(f"{what}: is empty, shape {frame.shape}")
    if expected is not None and frame.shape != expected:
        raise InputError(
            f"{what}: is {describe_shape(frame.shape)}, "
            f"but the frames before are {describe_shape(expected)}"
        )
    return frame


def describe_shape(shape: tuple[int, ...]) -> str:
    """Words for an image shape: "768x576 colour"."""
    return f"{shape[1]}x{shape[0]} {'colour' if len(shape) == 3 else 'grey'}"


def resized(frame: Frame, size: Size | None) -> Frame:
    """Frame scaled to size (width, height): area average down, linear up; itself when None."""
    if size is None or (frame.shape[1], frame.shape[0]) == size:
        return frame
    import cv2

    shrinks = size[0] * size[1] < frame.shape[0] * frame.shape[1]
    how = cv2.INTER_AREA if shrinks else cv2.INTER_LINEAR
    return cv2.resize(frame, size, interpolation=how).astype(np.uint8, copy=False)
