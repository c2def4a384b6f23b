# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Footage, read alike on both sides."""

from collections.abc import Iterator

import cv2
import numpy as np
import numpy.typing as npt

Frame = npt.NDArray[np.uint8]
Size = tuple[int, int]  # width, height


def frames_of(video: str, size: Size | None = None, count: int | None = None) -> Iterator[Frame]:
    """The first frames of a video, scaled; raises OSError when there are fewer than `count`."""
    capture, read = cv2.VideoCapture(video), 0
    while count is None or read < count:
        there, frame = capture.read()
        if not there:
            break
        read += 1
        same = size is None or frame.shape[1::-1] == size
        yield frame if same else cv2.resize(frame, size, interpolation=cv2.INTER_AREA)
    if read == 0 or (count is not None and read < count):
        raise OSError(f"{video}: has {read} frames; at least {count or 1} are needed")
