# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is drawn on where there is no picture: a plain ground with a grid."""

import math

import numpy as np

from survtrack.drawing.colors import Color
from survtrack.drawing.scene import Scene

PAPER: Color = (44, 44, 44)
LINE: Color = (70, 70, 70)
INK: Color = (170, 170, 170)
TEXT_SCALE = 0.4
CELLS = 8  # at least, along the longer side


def nice_step(extent: float) -> float:
    """1, 2 or 5 times a power of ten: the largest that divides `extent` into 8 cells or more."""
    rough = extent / CELLS
    power = 10.0 ** math.floor(math.log10(rough))
    return next(k * power for k in (5, 2, 1) if k * power <= rough * (1 + 1e-9))


def lines_between(low: float, high: float, step: float) -> list[float]:
    """The multiples of `step` from low to high."""
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def write_small(scene: Scene, text: str, origin: tuple[int, int], color: Color = INK) -> None:
    """Small text whose lower left corner is `origin`."""
    import cv2

    cv2.putText(scene, text, origin, cv2.FONT_HERSHEY_SIMPLEX, TEXT_SCALE, color, 1, cv2.LINE_AA)


def text_width_px(text: str) -> int:
    """Of what write_small() writes."""
    import cv2

    width: int = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, TEXT_SCALE, 1)[0][0]
    return width


def plain_ground(size: tuple[int, int]) -> Scene:
    """HxWx3 BGR of (width, height) with a grid and its places in px along two sides."""
    width, height = size
    scene = np.empty((height, width, 3), np.uint8)
    scene[:] = PAPER
    step = max(nice_step(max(size)), 1.0)
    columns, rows = ([round(place) for place in lines_between(0, side - 1, step)] for side in size)
    scene[:, columns] = LINE
    scene[rows] = LINE
    for x in columns[1:]:
        write_small(scene, f"{x}", (x + 3, height - 4))
    for y in rows[1:]:
        text = f"{y}"
        write_small(scene, text, (width - text_width_px(text) - 3, y - 3))
    return scene
