# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A scene made again of tracked states, from above."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import BLACK, Color, color_of_id
from survtrack.drawing.markers import unit_ellipse
from survtrack.drawing.paper import (
    INK,
    LINE,
    PAPER,
    lines_between,
    nice_step,
    text_width_px,
    write_small,
)
from survtrack.drawing.replay import (
    DISTANCE,
    FILTERED,
    MEASURED,
    SHIFT,
    Trails,
    draw_captions,
    draw_line,
    draw_outline,
    fixed,
    is_guessed,
    label_of,
    next_measured,
)
from survtrack.drawing.scene import Scene, Style, draw_label

if TYPE_CHECKING:
    from survtrack.replay.filling import Shown
    from survtrack.replay.ground import GroundMap
    from survtrack.replay.values import StreamFrame

Points = npt.NDArray[np.float64]
LONGEST_PX, LEAST_PX, MARGIN_PX = 720, 240, 48
ROUND = 0.05  # of the ground's extent is left free on each side
BEYOND = 1.0  # tracks widen a plan by its own size at most, on each side
FRAME: Color = (110, 110, 110)


class Extent:
    """The part of the ground that a plan shows: the four known points, and the feet of tracks."""

    def __init__(self, ground: "GroundMap") -> None:
        self._ground = ground
        self._low = ground.ground_points.min(axis=0)
        self._high = ground.ground_points.max(axis=0)
        size = self._high - self._low
        self._least, self._most = self._low - BEYOND * size, self._high + BEYOND * size

    def add(self, frame: "StreamFrame") -> None:
        """Take in the feet of a frame's tracks."""
        if not frame.tracks:
            return
        feet = self._ground.to_ground([track.foot for track in frame.tracks])
        feet = np.clip(feet[~np.isnan(feet[:, 0])], self._least, self._most)
        self._low = np.minimum(self._low, feet.min(axis=0, initial=np.inf))
        self._high = np.maximum(self._high, feet.max(axis=0, initial=-np.inf))

    def box(self) -> tuple[Points, Points]:
        """Lowest and highest coordinates, with some room."""
        room = ROUND * (self._high - self._low).max()
        return self._low - room, self._high + room


class PlanView:
    """Where tracks stand on the ground, at scale: blue dots with ids, trails and covariances.

    Blue: the foot of the filtered box, the middle of its lower edge; a ring when it is lost or
    predicted. Red: the foot of the box measured in the next frame. Thin: the ellipse that holds the
    position with 95 %, brought to the ground at the foot.
    """

    def __init__(self, ground: "GroundMap", extent: Extent) -> None:
        """Args:
        ground: from pixels to the ground.
        extent: what of the ground is shown.
        """
        self._map = ground
        self._low, self._high = extent.box()
        size = self._high - self._low
        self._scale = (LONGEST_PX - 2 * MARGIN_PX) / size.max()  # px a unit
        width, height = (
            max(LEAST_PX, math.ceil(side * self._scale) + 2 * MARGIN_PX) for side in size
        )
        self._paper = self._drawn_paper(width, height)
        self._trails = Trails()

    def __call__(self, shown: "Shown") -> Scene:
        """The next picture, HxWx3 BGR, always of the same size."""
        scene, frame = self._paper.copy(), shown.frame
        feet = {track.id: self._foot(track.foot) for track in frame.tracks}
        seen = {track_id: foot for track_id, foot in feet.items() if foot is not None}
        for track_id, line in self._trails.lines(frame, seen).items():
            draw_line(scene, np.array(line), color_of_id(track_id))
        tracks = [track for track in frame.tracks if track.id in seen]
        for track in tracks:
            ellipse = self._ellipse(track.foot, track.position_covariance_px2)
            draw_outline(scene, ellipse, color_of_id(track.id))
        radius = 2 + 2 * Style.of(scene).line
        for track in tracks:
            _dot(scene, seen[track.id], FILTERED, radius, filled=not is_guessed(track, frame))
        for box in next_measured(shown).values():
            foot = self._foot((box.x + box.width / 2, box.y + box.height))
            if foot is not None:
                _dot(scene, foot, MEASURED, radius // 2, filled=True)
        for track in tracks:
            x, y = seen[track.id]
            corner = (round(x) + radius + 2, round(y) - radius)
            draw_label(scene, label_of(track), corner, color_of_id(track.id))
        draw_captions(scene, frame)
        return scene

    def _foot(self, point: tuple[float, float]) -> tuple[float, float] | None:
        """Where a point of the image is in the picture; None when it is not in it."""
        place = self._map.to_ground([point])[0]
        if not ((self._low <= place) & (place <= self._high)).all():
            return None
        x, y = self._on_paper(place[np.newaxis])[0].tolist()
        return x, y

    def _on_paper(self, places: Points) -> Points:
        """Nx2 places of the ground in px of the picture."""
        x = (places[:, 0] - self._low[0]) * self._scale
        from_low = (places[:, 1] - self._low[1]) * self._scale
        height = (self._high[1] - self._low[1]) * self._scale
        y = height - from_low if self._map.y_up else from_low
        return np.stack((x, y), axis=-1) + MARGIN_PX

    def _ellipse(self, foot: tuple[float, float], covariance: Points) -> Points:
        place = self._map.to_ground([foot])
        spread = self._map.spread_on_ground(foot, covariance)
        return self._on_paper(place + DISTANCE * unit_ellipse(spread))

    def _drawn_paper(self, width: int, height: int) -> Scene:
        """Grid, coordinates, the four known points and a bar of one step."""
        scene = np.empty((height, width, 3), np.uint8)
        scene[:] = PAPER
        step = nice_step(float((self._high - self._low).max()))
        for axis in (0, 1):
            for place in lines_between(float(self._low[axis]), float(self._high[axis]), step):
                self._draw_grid_line(scene, axis, place)
        if self._map.unit != "px":
            draw_outline(scene, self._on_paper(self._map.ground_points), FRAME)
        _draw_bar(scene, step * self._scale, f"{step:g} {self._map.unit}")
        return scene

    def _draw_grid_line(self, scene: Scene, axis: int, place: float) -> None:
        ends = np.stack((self._low, self._high))
        ends[:, axis] = place
        (x, y), (other_x, other_y) = self._on_paper(ends).tolist()
        draw_outline(scene, np.array([[x, y], [other_x, other_y]]), LINE)
        text = f"{place:g}"
        if axis == 0:
            origin = (round(x - text_width_px(text) / 2), round(max(y, other_y)) + 14)
        else:
            origin = (round(min(x, other_x)) - text_width_px(text) - 4, round(y) + 4)
        write_small(scene, text, origin)


def _dot(
    scene: Scene, center: tuple[float, float], color: Color, radius: int, *, filled: bool
) -> None:
    import cv2

    x, y = fixed(scene, np.array([center]))[0, 0].tolist()
    for ink, more, line in ((BLACK, 1, cv2.FILLED), (color, 0, cv2.FILLED if filled else 2)):
        if filled or ink is color:
            cv2.circle(scene, (x, y), (radius + more) << SHIFT, ink, line, cv2.LINE_AA, SHIFT)


def _draw_bar(scene: Scene, length_px: float, text: str) -> None:
    """A bar as long as the text says, in the upper right corner."""
    right, y = scene.shape[1] - MARGIN_PX / 2, MARGIN_PX / 2
    left = right - length_px
    for line in (
        [[left, y], [right, y]],
        [[left, y - 4], [left, y + 4]],
        [[right, y - 4], [right, y + 4]],
    ):
        draw_outline(scene, np.array(line), INK)
    write_small(scene, text, (round((left + right - text_width_px(text)) / 2), round(y) - 6))
