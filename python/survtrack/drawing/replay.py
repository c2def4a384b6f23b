# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A scene made again of tracked states, as the camera saw it."""

from collections import deque
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.boxes import OUTSIDE_PX, corners
from survtrack.drawing.colors import BLACK, Color, color_of_id
from survtrack.drawing.markers import RED, unit_ellipse
from survtrack.drawing.paper import plain_ground
from survtrack.drawing.paths import draw_paths
from survtrack.drawing.regions import COLORS, outline
from survtrack.drawing.scene import (
    Point,
    Scene,
    Style,
    as_scene,
    draw_dashed_line,
    draw_label,
    label_size,
)
from survtrack.errors import InputError

if TYPE_CHECKING:
    from survtrack._core import Box, Paths
    from survtrack.replay.filling import Shown
    from survtrack.replay.values import StreamFrame, StreamTrack

Points = npt.NDArray[np.float64]
# As O'Malley 2000 draws them; the blue is one that can be told from black.
FILTERED: Color = (255, 112, 24)
MEASURED: Color = RED
DISTANCE = 2.4477468306808166  # holds 95 %: the root of -2 ln 0.05
NEXT_MEASURED = "next measured"
TRAIL_FRAMES = 60
SHIFT = 4
FADED = 0.6  # what is left of a background under what is drawn
SAME_FORM = 0.01
# Of the regions that are drawn; the strip that is read in turn says nothing of the scene.
REGION_KINDS = ("acquisition", "predicted")


class Trails:
    """The last recorded places of each track, and where it is now."""

    def __init__(self) -> None:
        self._places: dict[int, deque[tuple[float, float]]] = {}

    def lines(
        self, frame: "StreamFrame", places: dict[int, tuple[float, float]]
    ) -> dict[int, list[tuple[float, float]]]:
        """By id. A track without a place in this frame is forgotten; predictions are not kept."""
        self._places = {
            track_id: self._places.get(track_id, deque(maxlen=TRAIL_FRAMES)) for track_id in places
        }
        for track_id, place in places.items():
            if frame.predicted_s == 0 and place not in list(self._places[track_id])[-1:]:
                self._places[track_id].append(place)
        return {track_id: [*self._places[track_id], place] for track_id, place in places.items()}


class OverView:
    """Boxes, ids, trails and covariances over a background, or over plain ground.

    Blue: filtered; dashed when it is lost or predicted. Red: measured in the next frame. Thin: the
    ellipse that holds the position with 95 %; magenta the regions where tracks were expected in the
    next frame, orange those where newcomers were looked for in it.
    """

    def __init__(
        self, size: tuple[int, int], background: Scene | None = None, paths: "Paths | None" = None
    ) -> None:
        """Args:
        size: (width, height) of the stream's frames in px.
        background: HxW or HxWx3 uint8, of any size with the same ratio of its sides.
        paths: drawn on the background.

        Raises:
            InputError: the background has another ratio of sides.
        """
        self._ground = plain_ground(size) if background is None else _fitted(background, size)
        if paths is not None:
            draw_paths(self._ground, paths)
        self._trails = Trails()

    def __call__(self, shown: "Shown") -> Scene:
        """The next picture, HxWx3 BGR of the frames' size."""
        scene, frame = self._ground.copy(), shown.frame
        places = {track.id: track.position for track in frame.tracks}
        for track_id, line in self._trails.lines(frame, places).items():
            draw_line(scene, np.array(line), color_of_id(track_id))
        regions = () if shown.following is None else shown.following.regions
        outline(scene, regions, REGION_KINDS, 1)
        for box in next_measured(shown).values():
            _draw_box(scene, box, MEASURED, dashed=False)
        for track in frame.tracks:
            _draw_box(scene, track.box, FILTERED, dashed=is_guessed(track, frame))
            ellipse = DISTANCE * unit_ellipse(track.position_covariance_px2)
            draw_outline(scene, ellipse + track.position, color_of_id(track.id))
        for track in frame.tracks:
            draw_label(scene, label_of(track), corners(track.box, scene)[0], color_of_id(track.id))
        draw_captions(scene, frame)
        if regions:
            above = scene.shape[0] - label_size(scene, NEXT_MEASURED)[1]
            draw_label(scene, "looked at next", (scene.shape[1], above), COLORS["predicted"])
        return scene


def next_measured(shown: "Shown") -> "dict[int, Box]":
    """What the next recorded frame measured of the tracks that are shown, by id."""
    ids = {track.id for track in shown.frame.tracks}
    following = () if shown.following is None else shown.following.tracks
    return {
        track.id: track.measured
        for track in following
        if track.id in ids and track.measured is not None
    }


def is_guessed(track: "StreamTrack", frame: "StreamFrame") -> bool:
    """True for a place that nothing was measured for."""
    return frame.predicted_s > 0 or track.status.name == "lost"


def label_of(track: "StreamTrack") -> str:
    """The id, and "?" for one that is lost."""
    return f"{track.id}?" if track.status.name == "lost" else f"{track.id}"


def draw_line(scene: Scene, points: Points, color: Color) -> None:
    """A smooth line through points (x, y), px."""
    import cv2

    line = Style.of(scene).line
    cv2.polylines(scene, [fixed(scene, points)], False, color, line, cv2.LINE_AA, SHIFT)


def draw_outline(scene: Scene, points: Points, color: Color) -> None:
    """The same from the last point to the first too, one px wide."""
    import cv2

    cv2.polylines(scene, [fixed(scene, points)], True, color, 1, cv2.LINE_AA, SHIFT)


def fixed(scene: Scene, points: Points) -> npt.NDArray[np.int32]:
    """Points (x, y) with SHIFT bits below the pixel, none farther away than is worth drawing."""
    height, width = scene.shape[:2]
    far = OUTSIDE_PX + 10 * max(height, width)
    near = np.clip(points, -far, far)
    bits: npt.NDArray[np.int32] = (near * 2**SHIFT).round().astype(np.int32)
    return bits.reshape(-1, 1, 2)


def draw_captions(scene: Scene, frame: "StreamFrame") -> None:
    """Which frame it is, above; what the colours say, below."""
    when = f"frame {frame.index + 1}, {frame.time_s:.2f} s"
    if frame.predicted_s > 0:
        when += f" (predicted for {frame.predicted_s:.2f} s)"
    draw_label(scene, when, (0, 0), BLACK)
    height, width = scene.shape[:2]
    draw_label(scene, "filtered", (0, height), FILTERED)
    draw_label(scene, NEXT_MEASURED, (width, height), MEASURED)


def _draw_box(scene: Scene, box: "Box", color: Color, *, dashed: bool) -> None:
    import cv2

    (left, top), (right, bottom) = corners(box, scene)
    line = Style.of(scene).line
    if not dashed:
        cv2.rectangle(scene, (left, top), (right, bottom), color, line)
        return
    ends: list[Point] = [(left, top), (right, top), (right, bottom), (left, bottom)]
    for start, end in zip(ends, [*ends[1:], ends[0]], strict=True):
        draw_dashed_line(scene, start, end, color)


def _fitted(background: Scene, size: tuple[int, int]) -> Scene:
    """The background at the frames' size, darker, so that what is drawn stands out."""
    from survtrack.sources.base import resized

    height, width = background.shape[:2]
    if abs(width * size[1] - height * size[0]) > SAME_FORM * width * size[1]:
        raise InputError(
            f"the background is {width}x{height} px, the stream's frames are {size[0]}x{size[1]}: "
            "another ratio of sides"
        )
    faded = FADED * as_scene(resized(background, size)).astype(np.float32)
    return faded.round().astype(np.uint8)
