# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Paths with their scale, and where tracks are by them."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.boxes import corners
from survtrack.drawing.colors import BLACK, WHITE, Color, color_of_id
from survtrack.drawing.scene import Scene, Style, draw_label, label_size
from survtrack.drawing.trails import FARTHEST_PX
from survtrack.path_file import TrackPlace, foot_of, nearest_place

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Path, Paths, Track

Points = npt.NDArray[np.float64]
PATH: Color = (255, 255, 0)
MOST_TICKS = 12
STEP_PX = 2.0  # between drawn points of a curve
MOST_STEPS = 5000
SHIFT = 4  # bits below the pixel, so that lines are smooth


class PathRenderer:
    """Paths as lines, with ticks at round lengths and arrowheads, and tracks by the nearest one.

    Ticks stand to the side where T is positive and say S in px; arrowheads between them point
    where S grows. Each reported track has a line to its path and a label "S, T" under its box;
    one that is too far from all paths has none. Without paths the scene says "no path".
    """

    def __init__(self, paths: "Paths | None" = None) -> None:
        """Args:
        paths: the paths to draw.
        """
        self._paths = paths

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        if self._paths is None or not len(self._paths):
            draw_label(scene, "no path", (0, scene.shape[0]), BLACK)
            return scene
        draw_paths(scene, self._paths)
        placed = [
            (track, place)
            for track in result.tracks
            if track.reported and (place := nearest_place(track, self._paths)) is not None
        ]
        for track, place in placed:
            _draw_foot(scene, track, foot_of(place, self._paths[place.path]))
        for track, place in placed:
            _draw_place(scene, track, place)
        return scene


def draw_paths(scene: Scene, paths: "Paths") -> Scene:
    """Draw the paths, with their names when there are several, on scene in place; return it."""
    for name in paths.names:
        path = paths[name]
        tick_px = tick_distance_px(path.length_px)
        ticks = _ticks(scene, path, tick_px)
        # All rims first: no tick's rim cuts the line.
        for ink, rim in ((BLACK, 2), (PATH, 0)):
            _draw_lines(scene, [_line(path)], path.closed, ink, rim)
            _draw_lines(scene, list(ticks), False, ink, rim)
        for number, (foot, end) in enumerate(ticks):
            _draw_number(scene, f"{number * tick_px:g}", end, (end - foot) / _tick_size(scene))
        _draw_heads(scene, path, tick_px)
    for name in paths.names if len(paths) > 1 else ():
        start = _shown(paths[name].points[0]).round().astype(int).tolist()
        draw_label(scene, name, (start[0], start[1]), PATH)
    return scene


def tick_distance_px(length_px: float) -> float:
    """1, 2 or 5 times a power of ten: the least that makes no more than 12 ticks on a path."""
    least = length_px / MOST_TICKS
    power = 10.0 ** math.floor(math.log10(least))
    return next(step * power for step in (1, 2, 5, 10) if step * power >= least)


def _line(path: "Path") -> Points:
    """The points of a path that are drawn."""
    if path.kind == "line":
        return np.asarray(path.points)
    steps = min(max(math.ceil(path.length_px / STEP_PX), 2), MOST_STEPS)
    s = np.linspace(0.0, path.length_px, steps + 1)[: -1 if path.closed else None]
    return np.asarray(path.to_image(np.column_stack([s, np.zeros_like(s)])))


def _ticks(scene: Scene, path: "Path", tick_px: float) -> Points:
    """Nx2x2: foot and end of the ticks; a closed path's end is its start, with none nearby."""
    end = path.length_px - (0.3 * tick_px if path.closed else 0.0)
    lengths = np.arange(0.0, end + 1e-9 * tick_px, tick_px)
    feet = path.to_image(np.column_stack([lengths, np.zeros_like(lengths)]))
    return np.stack([feet, feet + _tick_size(scene) * path.normals(lengths)], axis=1)


def _draw_number(scene: Scene, text: str, end: Points, normal: Points) -> None:
    """A label beyond a tick's end, away from the path; none outside of the picture."""
    half = np.array(label_size(scene, text)) / 2
    x, y = _shown(end + normal * (1 + np.abs(normal) @ half)).tolist()
    if 0 <= x < scene.shape[1] and 0 <= y < scene.shape[0]:
        draw_label(scene, text, (round(x - half[0]), round(y + half[1])), BLACK)


def _draw_heads(scene: Scene, path: "Path", tick_px: float) -> None:
    """An arrowhead in the middle of each second stretch between ticks, of a short path of one."""
    import cv2

    size = _tick_size(scene)
    lengths = np.arange(tick_px / 2, path.length_px, 2 * tick_px)
    tips = path.to_image(np.column_stack([lengths, np.zeros_like(lengths)]))
    for tip, along, across in zip(tips, path.tangents(lengths), path.normals(lengths), strict=True):
        outline = np.array([0.8 * along, 0.7 * across - 0.8 * along, -0.7 * across - 0.8 * along])
        head = _fixed(_shown(tip + size * outline))
        cv2.polylines(scene, [head], True, BLACK, 2, cv2.LINE_AA, SHIFT)
        cv2.fillPoly(scene, [head], PATH, cv2.LINE_AA, SHIFT)


def _draw_lines(scene: Scene, lines: list[Points], closed: bool, color: Color, rim: int) -> None:
    import cv2

    fixed = [_fixed(_shown(line)) for line in lines]
    width = Style.of(scene).line + rim
    cv2.polylines(scene, fixed, closed, color, width, cv2.LINE_AA, SHIFT)


def _draw_foot(scene: Scene, track: "Track", foot: Points) -> None:
    """A line from the track's position to the path."""
    import cv2

    center = np.array(track.position, float)
    line = _fixed(_shown(np.array([center, foot])))
    cv2.polylines(scene, [line], False, WHITE, Style.of(scene).line, cv2.LINE_AA, SHIFT)


def _draw_place(scene: Scene, track: "Track", place: TrackPlace) -> None:
    """ "S, T" under the track's box."""
    (left, _), (_, bottom) = corners(track.box, scene)
    text = f"{place.s_px:.0f}, {place.t_px:+.0f}"
    draw_label(scene, text, (left, bottom + label_size(scene, text)[1]), color_of_id(track.id))


def _tick_size(scene: Scene) -> int:
    return max(6, 5 * Style.of(scene).line)


def _shown(points: Points) -> Points:
    """What is too far outside of the picture for OpenCV brought nearer."""
    return np.clip(points, -FARTHEST_PX, FARTHEST_PX)


def _fixed(points: Points) -> npt.NDArray[np.int32]:
    return (points * (1 << SHIFT)).round().astype(np.int32).reshape(-1, 1, 2)
