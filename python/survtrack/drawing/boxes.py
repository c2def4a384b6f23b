# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Boxes and ids of tracks."""

from typing import TYPE_CHECKING

import numpy as np

from survtrack.drawing.colors import Color, color_of_id
from survtrack.drawing.scene import Point, Scene, Style, draw_dashed_line, draw_label

if TYPE_CHECKING:
    from survtrack._core import Box, FrameResult, Track

# Boxes end this far outside of the picture at most: OpenCV's coordinates are 32-bit integers, and
# what cannot be seen costs time.
OUTSIDE_PX = 100


class BoxRenderer:
    """A box and a label with the id for every reported track; dashed, and "?", when it is lost."""

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        reported = [track for track in result.tracks if track.reported]
        for track in reported:
            _draw_box(scene, track.box, color_of_id(track.id), lost=_is_lost(track))
        for track in reported:
            text = f"{track.id}?" if _is_lost(track) else f"{track.id}"
            draw_label(scene, text, corners(track.box, scene)[0], color_of_id(track.id))
        return scene


def _is_lost(track: "Track") -> bool:
    return bool(track.status.name == "lost")


def corners(box: "Box", scene: Scene) -> tuple[Point, Point]:
    """Upper left and lower right pixel of the box."""
    height, width = scene.shape[:2]
    ends = np.nan_to_num((box.x, box.y, box.x + box.width, box.y + box.height))
    most = np.array((width, height, width, height)) + OUTSIDE_PX
    left, top, right, bottom = np.clip(ends, -OUTSIDE_PX, most).round().astype(int).tolist()
    return (left, top), (right, bottom)


def _draw_box(scene: Scene, box: "Box", color: Color, *, lost: bool) -> None:
    import cv2

    (left, top), (right, bottom) = corners(box, scene)
    if not lost:
        cv2.rectangle(scene, (left, top), (right, bottom), color, Style.of(scene).line)
        return
    for start, end in (
        ((left, top), (right, top)),
        ((right, top), (right, bottom)),
        ((left, bottom), (right, bottom)),
        ((left, top), (left, bottom)),
    ):
        draw_dashed_line(scene, start, end, color)
