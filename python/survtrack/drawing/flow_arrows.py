# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Optical flow as arrows."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import BLACK, Color
from survtrack.drawing.flow_field import THRESHOLD_PX, FlowScale, draw_no_flow, flow_of
from survtrack.drawing.scene import Scene, Style, draw_label

if TYPE_CHECKING:
    from survtrack._core import FrameResult

Points = npt.NDArray[np.float64]
ARROW: Color = (0, 255, 255)
MOST_ARROWS = 2000
LEAST_SPACING_PX = 4
# A shorter one is a dot that points nowhere.
LEAST_LENGTH_LINES = 3
# Bits below the pixel.
SHIFT = 4


class FlowRenderer:
    """Arrows from pixels of a grid, at most 2000: where each moves, longer where it moves farther.

    A sample arrow in the lower left corner has the full length, thrice the grid's spacing, and the
    magnitude it stands for; longer ones are cut. What moved no farther than the threshold, and
    what would be shorter than three times the line's width, has no arrow. Without a field the scene
    says "no flow yet": the first frames have none, nor has a result without outputs.flow.
    """

    def __init__(self, threshold_px: float = THRESHOLD_PX, full_px: float | None = None) -> None:
        """Args:
        threshold_px: no arrow for what moved by no more, px a frame pair; 0 or more.
        full_px: the magnitude that has the full length, px, 1e-9 to 1e9; None: 1, 2 or 5 times a
            power of ten that at most a tenth of what moves exceeds, kept while it suits.

        Raises:
            UsageError: a number out of its range.
        """
        self._scale = FlowScale(full_px, threshold_px)

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it.

        Raises:
            UsageError: the field is not of the scene's size.
        """
        flow = flow_of(scene, result)
        if flow is None:
            return draw_no_flow(scene)
        full_px = self._scale.full_px(np.hypot(flow[..., 0], flow[..., 1]))
        feet, vectors = _samples(flow)
        length = 3 * _spacing(flow.shape[:2])
        magnitudes = np.hypot(vectors[:, 0], vectors[:, 1])
        drawn = np.minimum(magnitudes / full_px, 1) * length
        least = LEAST_LENGTH_LINES * Style.of(scene).line
        shown = (magnitudes > self._scale.threshold_px) & (drawn >= least)
        heads = feet[shown] + vectors[shown] * (drawn[shown] / magnitudes[shown])[:, None]
        _draw_arrows(scene, feet[shown], heads)
        _draw_sample(scene, length, full_px)
        return scene


def _spacing(size: tuple[int, ...]) -> int:
    """The least distance of the grid's pixels, px, with no more than MOST_ARROWS of them."""
    height, width = size
    spacing = LEAST_SPACING_PX
    while -(-height // spacing) * -(-width // spacing) > MOST_ARROWS:
        spacing += 1
    return spacing


def _samples(flow: npt.NDArray[np.float32]) -> tuple[Points, Points]:
    """Pixels (x, y) of the grid and their vectors, both Nx2."""
    height, width = flow.shape[:2]
    spacing = _spacing((height, width))
    rows = np.arange(min(spacing // 2, height // 2), height, spacing)
    columns = np.arange(min(spacing // 2, width // 2), width, spacing)
    x, y = np.meshgrid(columns, rows)
    vectors = flow[y, x].reshape(-1, 2).astype(np.float64)
    return np.stack((x, y), axis=-1).reshape(-1, 2).astype(np.float64), vectors


def _draw_arrows(scene: Scene, feet: Points, heads: Points) -> None:
    """First the shadows, a pixel below and to the right: yellow is hard to see on white."""
    import cv2

    line = Style.of(scene).line
    for color, shift_px in ((BLACK, line), (ARROW, 0)):
        starts, ends = (
            (2**SHIFT * (points + shift_px)).round().astype(int).tolist()
            for points in (feet, heads)
        )
        for start, end in zip(starts, ends, strict=True):
            cv2.arrowedLine(scene, start, end, color, line, cv2.LINE_AA, SHIFT, 0.3)


def _draw_sample(scene: Scene, length: int, full_px: float) -> None:
    """An arrow of full length and what it stands for, where there is room."""
    import cv2

    margin = 2 * Style.of(scene).margin
    height, width = scene.shape[:2]
    if width < 6 * length:
        return
    right = length + 2 * margin
    draw_label(scene, f"{full_px:g} px", (right, height), BLACK)
    top = height - 3 * margin
    cv2.rectangle(scene, (0, top), (right, height), BLACK, cv2.FILLED)
    y = height - 3 * margin // 2
    _draw_arrows(scene, np.array([(margin, y)], float), np.array([(margin + length, y)], float))
