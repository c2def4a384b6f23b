# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where tracks were lost."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from survtrack.drawing.colors import Color, color_of_id
from survtrack.drawing.scene import Point, Scene, Style, draw_label
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult

WORDS = {"border": "left", "behind_object": "hidden", "open": "stopped"}


@dataclass(frozen=True)
class _End:
    until_s: float
    position: tuple[float, float]
    track_id: int
    word: str


class LostContactRenderer:
    """A cross where a track that ended was measured last, with its id and what became of it.

    "left": at the frame's border; "hidden": beside or behind another track; "stopped": in the open.
    It remembers ends from call to call.
    """

    def __init__(self, show_s: float = 2.0) -> None:
        """Args:
        show_s: how long an end is shown, in seconds; above 0. 2 s are the 50 frames of Semko
            2007, IV.C.3.
        """
        if not show_s > 0:
            raise UsageError(f"show_s: {show_s} is not allowed; above 0")
        self._show_s = show_s
        self._ends: list[_End] = []

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        self._ends = [end for end in self._ends if result.time_s < end.until_s]
        for event in result.events:
            word = WORDS.get(event.place.name)
            if word is not None:
                until_s = event.time_s + self._show_s
                self._ends.append(_End(until_s, event.position, event.track_id, word))
        for end in self._ends:
            _draw(scene, end)
        return scene


def _draw(scene: Scene, end: _End) -> None:
    import cv2

    style = Style.of(scene)
    color: Color = color_of_id(end.track_id)
    height, width = scene.shape[:2]
    center: Point = (
        round(min(max(end.position[0], 0), width - 1)),
        round(min(max(end.position[1], 0), height - 1)),
    )
    size = 12 * style.line
    cv2.drawMarker(scene, center, color, cv2.MARKER_TILTED_CROSS, size, style.line + 1)
    draw_label(scene, f"{end.track_id} {end.word}", (center[0] + size // 2, center[1]), color)
