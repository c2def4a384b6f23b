# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A folder with the files that the documents' examples name, small and synthetic."""

from pathlib import Path

import av
import cv2
import numpy as np
import numpy.typing as npt

WIDTH, HEIGHT, SIDE, FRAMES = 160, 120, 20, 60
FIRST = 25  # the frame, from 0, in which the square comes in

# As in docs/paths.md.
LANES = """\
{"frame_size": [160, 120],
 "paths": [{"name": "lane", "kind": "curve", "max_distance_px": 30,
            "points": [[0, 40], [80, 60], [159, 60]]}]}
"""

Image = npt.NDArray[np.uint8]


def left_of_square(index: int) -> int:
    """Where the square is in a frame, px; only from FIRST on."""
    return 3 * (index - FIRST)


def frame_and_mask(index: int) -> tuple[Image, Image]:
    """A bright square crosses a noisy grey scene: BGR frame and true mask (0 or 255)."""
    noise = np.random.default_rng(index).integers(-2, 3, (HEIGHT, WIDTH, 3))
    frame = (90 + noise).astype(np.uint8)
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    if index >= FIRST:
        left = left_of_square(index)
        frame[50 : 50 + SIDE, left : left + SIDE] = 220
        mask[50 : 50 + SIDE, left : left + SIDE] = 255
    return frame, mask


def make_workspace(folder: Path) -> None:
    """Writes video.mp4, frames/, gt.txt (MOT), lanes.json and sequence/ (CDnet's) into `folder`."""
    for name in ("frames", "sequence/input", "sequence/groundtruth"):
        (folder / name).mkdir(parents=True)
    with av.open(folder / "video.mp4", "w") as video:
        stream = video.add_stream("libx264", rate=10)
        stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, "yuv420p"
        for index in range(FRAMES):
            frame, mask = frame_and_mask(index)
            video.mux(stream.encode(av.VideoFrame.from_ndarray(frame, format="bgr24")))
            cv2.imwrite(str(folder / f"frames/in{index + 1:06d}.png"), frame)
            cv2.imwrite(str(folder / f"sequence/input/in{index + 1:06d}.png"), frame)
            cv2.imwrite(str(folder / f"sequence/groundtruth/gt{index + 1:06d}.png"), mask)
        video.mux(stream.encode())
    (folder / "sequence/temporalROI.txt").write_text(f"1 {FRAMES}\n")
    rows = [
        f"{index + 1},1,{left_of_square(index)},50,{SIDE},{SIDE},1,-1,-1,-1\n"
        for index in range(FIRST, FRAMES)
    ]
    (folder / "gt.txt").write_text("".join(rows))
    (folder / "lanes.json").write_text(LANES)
