# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The ways that tracks go, as arrows."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import BLACK, Color, color_of_id
from survtrack.drawing.scene import Scene, Style, as_scene, draw_label

if TYPE_CHECKING:
    from survtrack._core import Pattern, Patterns

PAPER_GREY = 96
FADED = 0.55  # what is left of the frame's contrast under the arrows
SHIFT = 4  # bits below the pixel, so that lines are smooth
Line = npt.NDArray[np.float64]


def paper(frame: Scene | None, size: tuple[int, int]) -> Scene:
    """What arrows are drawn on, HxWx3: a faded frame, or plain grey of (width, height) without."""
    if frame is None:
        return np.full((size[1], size[0], 3), PAPER_GREY, np.uint8)
    faded = FADED * as_scene(frame).astype(np.float32) + (1 - FADED) * PAPER_GREY
    return faded.round().astype(np.uint8)


def draw_patterns(scene: Scene, patterns: "Patterns") -> Scene:
    """Draw each pattern's way on scene, HxWx3 BGR, in place; return it.

    An arrow is the wider, the more tracks go its way, and begins at a label "id: tracks".
    """
    drawn = sorted(patterns.patterns, key=lambda pattern: pattern.count)
    most = max((pattern.count for pattern in drawn), default=1)
    for pattern in drawn:
        _draw_arrow(scene, _on_scene(scene, pattern), _width(scene, pattern, most), pattern.id)
    for pattern in drawn:
        start = _on_scene(scene, pattern)[0].round().astype(int).tolist()
        text = f"{pattern.id}: {pattern.count}"
        draw_label(scene, text, (start[0], start[1]), color_of_id(pattern.id))
    return scene


def _width(scene: Scene, pattern: "Pattern", most: int) -> int:
    """Pixels; the area of an arrow's cross-section goes with the count."""
    return Style.of(scene).line * (1 + round(3 * math.sqrt(pattern.count / most)))


def _on_scene(scene: Scene, pattern: "Pattern") -> Line:
    """The way, with what is far outside of the picture brought near, where nobody sees it."""
    sides = np.array([scene.shape[1], scene.shape[0]])
    return np.clip(pattern.way, -sides, 2 * sides)


def _draw_arrow(scene: Scene, way: Line, width: int, pattern_id: int) -> None:
    """A line with a head, on a black rim that parts it from the picture and other arrows."""
    color = color_of_id(pattern_id)
    head = _head(way, 3.5 * width + 4)
    # The line ends inside of the head, so that the head stays pointed.
    shaft = _without_end(way, 2.0 * width)
    for ink, rim in ((BLACK, 2), (color, 0)):
        _draw_shaft(scene, shaft, ink, width + rim)
        _draw_head(scene, head, ink, rim)


def _draw_shaft(scene: Scene, line: Line, color: Color, width: int) -> None:
    import cv2

    cv2.polylines(scene, [_fixed(line)], False, color, width, cv2.LINE_AA, SHIFT)


def _draw_head(scene: Scene, corners: Line, color: Color, rim: int) -> None:
    import cv2

    cv2.fillPoly(scene, [_fixed(corners)], color, cv2.LINE_AA, SHIFT)
    if rim:
        cv2.polylines(scene, [_fixed(corners)], True, color, rim, cv2.LINE_AA, SHIFT)


def _fixed(points: Line) -> npt.NDArray[np.int32]:
    return (points * (1 << SHIFT)).round().astype(np.int32).reshape(-1, 1, 2)


def _without_end(way: Line, length: float) -> Line:
    """The way up to where it comes within `length` px of its end; at least its first point."""
    far = np.flatnonzero(np.hypot(*(way - way[-1]).T) > length)
    return way[: far[-1] + 2] if len(far) else way[:1]


def _head(way: Line, length: float) -> Line:
    """Tip and two corners of a triangle that points where the way's last stretch goes."""
    far = np.flatnonzero(np.hypot(*(way - way[-1]).T) > length)
    step = way[-1] - way[far[-1] if len(far) else 0]
    px = float(np.hypot(*step))
    along = step / px if px > 0 else np.array([1.0, 0.0])
    across = np.array([-along[1], along[0]])
    back = way[-1] - length * along
    return np.array([way[-1], back + 0.45 * length * across, back - 0.45 * length * across])
