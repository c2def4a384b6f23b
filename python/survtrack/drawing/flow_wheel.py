# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Optical flow in the colours of a wheel."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import BLACK
from survtrack.drawing.flow_field import (
    THRESHOLD_PX,
    FlowScale,
    check_full_px,
    draw_no_flow,
    flow_of,
    known_flow,
)
from survtrack.drawing.scene import Scene, Style, draw_label
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult

# Smaller pictures have no room for the wheel.
LEAST_SIDE_PX = 48


class FlowColorRenderer:
    """Every pixel in the colour of its movement: the hue says where to, the saturation how far.

    The wheel in the lower right corner has the colours of all directions, and beside it the
    magnitude of its rim; what stands still is white. Without a field the scene says "no flow
    yet": the first frames have none, nor has a result without outputs.flow.
    """

    def __init__(self, threshold_px: float = THRESHOLD_PX, full_px: float | None = None) -> None:
        """Args:
        threshold_px: what moved by no more does not count for the scale, px; 0 or more.
        full_px: the magnitude that has the full colour, px, 1e-9 to 1e9; None: 1, 2 or 5 times a
            power of ten that at most a tenth of what moves exceeds, kept while it suits.

        Raises:
            UsageError: a number out of its range.
        """
        self._scale = FlowScale(full_px, threshold_px)

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw over the whole scene, HxWx3 BGR, in place; return it.

        Raises:
            UsageError: the field is not of the scene's size.
        """
        flow = flow_of(scene, result)
        if flow is None:
            return draw_no_flow(scene)
        full_px = self._scale.full_px(np.hypot(flow[..., 0], flow[..., 1]))
        scene[:] = flow_colors(flow, full_px)
        if min(scene.shape[:2]) >= LEAST_SIDE_PX:
            _draw_wheel(scene, full_px)
        return scene


def flow_colors(flow: npt.NDArray[np.floating], full_px: float) -> Scene:
    """The colour of every vector, HxWx3 BGR.

    To the right is red, down a yellowish green, to the left cyan, up violet: the hue goes clockwise
    round the picture. No movement is white; `full_px` and more have the full saturation.

    Args:
        flow: HxWx2, px to the right and down; what is no number, or above 1e9 px, is
            unknown and drawn as no movement.
        full_px: 1e-9 to 1e9, px.

    Raises:
        UsageError: the field has another shape, or full_px is out of its range.
    """
    if flow.ndim != 3 or flow.shape[2] != 2:
        raise UsageError(f"flow: has shape {flow.shape}; expected HxWx2")
    check_full_px(full_px)
    u, v = np.moveaxis(known_flow(flow), 2, 0)
    saturation = np.minimum(np.hypot(u, v) / np.float32(full_px), 1)
    hue = np.arctan2(v, u) * np.float32(3 / np.pi)
    colors = np.empty((*flow.shape[:2], 3), np.uint8)
    for channel, center in enumerate((-2, 2, 0)):
        # A channel of HSV at full value is full up to 60 degrees from its hue, and falls over 60.
        distance = np.abs(hue - center)
        distance = np.minimum(distance, 6 - distance)
        level = 1 - saturation * np.clip(distance - 1, 0, 1)
        colors[..., channel] = 255 * level + 0.5
    return colors


def _draw_wheel(scene: Scene, full_px: float) -> None:
    """A disc of all directions; its rim is full_px."""
    import cv2

    style = Style.of(scene)
    height, width = scene.shape[:2]
    radius = min(height, width) // 10
    offsets = np.arange(-radius, radius + 1, dtype=np.float64)
    vectors = np.stack(np.meshgrid(offsets, offsets), axis=-1)
    inside = np.hypot(vectors[..., 0], vectors[..., 1]) <= radius
    x, y = width - 1 - radius - 2 * style.margin, height - 1 - radius - 2 * style.margin
    place = scene[y - radius : y + radius + 1, x - radius : x + radius + 1]
    place[inside] = flow_colors(vectors, radius)[inside]
    cv2.circle(scene, (x, y), radius + 1, BLACK, style.line, cv2.LINE_AA)
    text = f"{full_px:g} px"
    (size, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, style.font_scale, style.line)
    left = x - radius - size - 5 * style.margin
    draw_label(scene, text, (left, height - style.margin), BLACK)
