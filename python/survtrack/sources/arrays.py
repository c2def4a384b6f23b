# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Frames that are already in memory, or made by the caller's own loop."""

from collections.abc import Iterable, Iterator, Sized

import numpy as np

from survtrack.errors import UsageError
from survtrack.sources.base import (
    DEFAULT_FPS,
    Frame,
    Size,
    check_fps,
    check_frame,
    check_resize,
    resized,
)
from survtrack.sources.selection import Selection


class ArraySource:
    """An iterable of uint8 arrays, HxW or HxWx3 BGR; frame k has the time k / fps.

    Strided views are fine. Frames are not copied: an iterable that fills the same array again
    and again must not be read ahead, so do not wrap it in a Prefetch.
    """

    endless = False

    def __init__(
        self,
        frames: Iterable[Frame],
        *,
        fps: float | None = None,
        selection: Selection | None = None,
        resize: Size | None = None,
        name: str = "arrays",
    ) -> None:
        """Raises UsageError for a bad option or a single image where many are expected."""
        if isinstance(frames, np.ndarray) and (frames.ndim < 3 or frames.shape[2:] == (3,)):
            raise UsageError(
                f"frames: one array of shape {frames.shape} looks like a single image; "
                "give an iterable of images"
            )
        self._frames = frames
        self._resize = check_resize(resize)
        self.fps_origin = "default" if fps is None else "given"
        self.fps = check_fps(fps) or DEFAULT_FPS
        self.selection = selection or Selection()
        self.size = resize
        self.original_size: Size | None = None
        self.name = name
        self.frame_count_declared = len(frames) if isinstance(frames, Sized) else None

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
        """Raises InputError for a frame that is no image or differs from the first."""
        expected: tuple[int, ...] | None = None
        count = taken = 0
        for index, array in enumerate(self._frames):
            count = index + 1
            frame = check_frame(array, f"{self.name}: frame {index}", expected)
            expected = frame.shape
            if not self.selection.wants(index):
                continue
            self.original_size = (frame.shape[1], frame.shape[0])
            frame = resized(frame, self._resize)
            self.size = (frame.shape[1], frame.shape[0])
            yield index, index / self.fps, frame
            taken += 1
            if taken == self.selection.limit:
                return
        self.selection.refuse_nothing(self.name, count)

    def file_name(self, index: int) -> str | None:
        """None: arrays have no files."""
        return None
