# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Which parts of a frame were read, and why."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from survtrack.drawing.boxes import corners
from survtrack.drawing.colors import BLACK, Color
from survtrack.drawing.scene import Scene, Style, draw_label

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Region

# Predicted regions are magenta as in O'Malley 2000.
COLORS: dict[str, Color] = {
    "predicted": (255, 0, 255),
    "acquisition": (0, 200, 255),
    "refresh": (160, 160, 160),
}
UNREAD = 0.35  # brightness of what was not read


class RegionRenderer:
    """What was not read is darkened; around the rest are frames in the colour of its reason.

    Magenta: where a track is expected; orange: where newcomers are looked for; grey: the strip
    that is read in turn. The label says what part of the frame's pixels was read.
    """

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        regions = [region for region in result.regions if region.kind.name != "whole_frame"]
        height, width = scene.shape[:2]
        if len(regions) == len(result.regions):
            unread = np.ones((height, width), dtype=bool)
            for region in regions:
                (left, top), (right, bottom) = corners(region.box, scene)
                unread[max(top, 0) : bottom, max(left, 0) : right] = False
            scene[unread] = (scene[unread] * UNREAD).astype(np.uint8)
        outline(scene, regions, ("refresh", "acquisition", "predicted"), Style.of(scene).line)
        part = result.pixels_read / (height * width)
        draw_label(scene, f"read: {100 * part:.0f} %", (0, height), BLACK)
        return scene


def outline(scene: Scene, regions: "Sequence[Region]", kinds: Iterable[str], line_px: int) -> None:
    """Frames around the regions of some kinds, the last kind on top, in the colours of COLORS."""
    import cv2

    height, width = scene.shape[:2]
    for kind in kinds:
        for region in regions:
            if region.kind.name == kind:
                (left, top), (right, bottom) = corners(region.box, scene)
                last = (min(right, width) - 1, min(bottom, height) - 1)
                cv2.rectangle(scene, (left, top), last, COLORS[kind], line_px)
