# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Small footage made on the spot: a bright square that walks over a dim, noisy ground."""

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np
import numpy.typing as npt

Image = npt.NDArray[np.uint8]


def walking_square(
    count: int, *, width: int = 96, height: int = 64, side: int = 14, still: int = 0
) -> list[Image]:
    """Colour frames; after `still` empty ones a square moves 2 px a frame to the right."""
    random = np.random.default_rng(1)
    ground = random.integers(40, 60, (height, width, 3), dtype=np.uint8)
    frames = []
    for k in range(count):
        noise = random.integers(0, 4, ground.shape, dtype=np.uint8)
        frame = ground + noise
        if k >= still:
            left, top = 4 + 2 * (k - still), height // 3
            frame[top : top + side, left : left + side] = (40, 200, 230)
        frames.append(frame)
    return frames


def write_video(
    path: Path,
    frames: Sequence[Image],
    *,
    fps: int = 10,
    codec: str = "libx264",
    format_name: str | None = None,
    times: Sequence[int] | None = None,
    b_frames: int = 0,
) -> Path:
    """Encode frames; `times` are presentation times in frame periods, 0, 1, 2, ... unless given."""
    with av.open(str(path), "w", format=format_name) as container:
        stream = container.add_stream(codec, rate=fps)
        stream.height, stream.width = frames[0].shape[:2]
        stream.pix_fmt = "yuv420p"
        stream.codec_context.gop_size = 12
        stream.codec_context.max_b_frames = b_frames
        for k, frame in enumerate(frames):
            picture = av.VideoFrame.from_ndarray(frame, format="bgr24")
            picture.pts = k if times is None else times[k]
            picture.time_base = Fraction(1, fps)
            container.mux(stream.encode(picture))
        container.mux(stream.encode(None))
    return path


def write_images(
    folder: Path, frames: Sequence[Image], *, first: int = 1, pattern: str = "in{:06d}.png"
) -> Path:
    """Write frames as numbered images."""
    folder.mkdir(parents=True, exist_ok=True)
    for k, frame in enumerate(frames):
        assert cv2.imwrite(str(folder / pattern.format(first + k)), frame)
    return folder


def cut_short(path: Path, share: float) -> Path:
    """Drop the end of a file; `share` of its bytes stay."""
    data = path.read_bytes()
    path.write_bytes(data[: int(share * len(data))])
    return path
