# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What was detected, with the numbers that the matrix's columns have."""

from typing import TYPE_CHECKING

from survtrack.drawing.boxes import corners
from survtrack.drawing.colors import BLACK, WHITE
from survtrack.drawing.scene import Scene, Style, draw_label

if TYPE_CHECKING:
    from survtrack._core import FrameResult


class BlobRenderer:
    """A white box and a number for every detection, from 1 in the order of the result."""

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        import cv2

        detections = list(result.detections)
        for detection in detections:
            cv2.rectangle(scene, *corners(detection.box, scene), WHITE, Style.of(scene).line)
        for number, detection in enumerate(detections, start=1):
            draw_label(scene, str(number), corners(detection.box, scene)[0], BLACK)
        return scene
