# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where tracks came from."""

from collections import deque
from typing import TYPE_CHECKING

import numpy as np

from survtrack.drawing.colors import color_of_id
from survtrack.drawing.scene import Scene, Style
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult

FARTHEST_PX = 1e6  # in 16ths it still fits OpenCV's 32 bits, and their differences too


class TrailRenderer:
    """A line through the last positions of every reported track, thinner where it is older.

    It remembers positions from call to call; a track that is no longer reported is forgotten.
    """

    def __init__(self, length: int = 50) -> None:
        """Args:
        length: most positions in a trail, one a frame; 2 or more.
        """
        if length < 2:
            raise UsageError(f"length: {length} positions is not allowed; 2 or more")
        self._length = length
        self._positions: dict[int, deque[tuple[float, float]]] = {}

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        reported = {track.id: track for track in result.tracks if track.reported}
        self._positions = {
            track_id: self._positions.get(track_id, deque(maxlen=self._length))
            for track_id in reported
        }
        for track_id, positions in self._positions.items():
            x, y = reported[track_id].position
            positions.append((float(x), float(y)))
            _draw_trail(scene, positions, track_id)
        return scene


def _draw_trail(scene: Scene, positions: "deque[tuple[float, float]]", track_id: int) -> None:
    import cv2

    line = Style.of(scene).line
    # Four bits below the pixel: a slow track's trail is smooth. A prediction can be anywhere.
    points = (
        (np.clip(positions, -FARTHEST_PX, FARTHEST_PX) * 16)
        .round()
        .astype(np.int32)
        .reshape(-1, 1, 2)
    )
    older, newer = points[: len(points) // 2 + 1], points[len(points) // 2 :]
    color = color_of_id(track_id)
    cv2.polylines(scene, [older], False, color, max(1, line // 2), cv2.LINE_AA, 4)
    cv2.polylines(scene, [newer], False, color, line, cv2.LINE_AA, 4)
