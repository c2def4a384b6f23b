# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where the filters say that the tracks are."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.boxes import OUTSIDE_PX
from survtrack.drawing.colors import Color, color_of_id
from survtrack.drawing.scene import Scene, Style, draw_label
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Track

Points = npt.NDArray[np.float64]
RED: Color = (0, 0, 255)
# Bits below the pixel.
SHIFT = 4
CORNERS = 72  # of an ellipse
MOST_VARIANCE_PX2 = 1e12  # an ellipse that is larger is out of every picture


class MarkerRenderer:
    """A red circle at the estimate of every reported track, with its id, and "?" when it is lost.

    Filters without a track have none; an estimate outside of the picture has no id.
    """

    def __init__(self, coverage: float = 0.0) -> None:
        """Args:
        coverage: also draw the ellipse that holds the true position with this probability, by
            the covariance of the estimate; 0 or more and below 1; 0: none.
        """
        if not 0 <= coverage < 1:
            raise UsageError(f"coverage: {coverage} is not allowed; 0 or more and below 1")
        # The squared Mahalanobis distance in the plane is exponential with mean 2.
        self._distance = math.sqrt(-2 * math.log1p(-coverage))

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""
        reported = [track for track in result.tracks if track.reported]
        for track in reported:
            center = _near(scene, np.array(track.position, float))
            if self._distance > 0:
                _draw_ellipse(scene, track, center, self._distance)
            _draw_circle(scene, center)
        for track in reported:
            _draw_id(scene, track)
        return scene


def _radius_px(scene: Scene) -> int:
    radius: int = min(scene.shape[:2]) // 40
    return max(3, radius)


def _draw_circle(scene: Scene, center: Points) -> None:
    import cv2

    radius = _radius_px(scene)
    line = min(Style.of(scene).line + 1, radius // 3)  # what is inside stays visible
    cv2.circle(scene, _bits(center).tolist(), radius << SHIFT, RED, line, cv2.LINE_AA, SHIFT)


def _draw_ellipse(scene: Scene, track: "Track", center: Points, distance: float) -> None:
    import cv2

    corners = _bits(_near(scene, center + distance * unit_ellipse(track.position_covariance_px2)))
    line = Style.of(scene).line
    cv2.polylines(scene, [corners], True, color_of_id(track.id), line, cv2.LINE_AA, SHIFT)


def _draw_id(scene: Scene, track: "Track") -> None:
    x, y = _near(scene, np.array(track.position, float)).round().astype(int).tolist()
    if 0 <= x < scene.shape[1] and 0 <= y < scene.shape[0]:
        radius = _radius_px(scene)
        text = f"{track.id}?" if track.status.name == "lost" else f"{track.id}"
        draw_label(scene, text, (x + radius + 2, y - radius), color_of_id(track.id))


def _near(scene: Scene, points: Points) -> Points:
    """Points (x, y) no farther outside of the picture than is worth drawing."""
    height, width = scene.shape[:2]
    # An ellipse that is larger than the picture keeps its form where it can be seen.
    far = OUTSIDE_PX + 10 * max(height, width)
    return np.clip(np.nan_to_num(points), -far, far)


def _bits(points: Points) -> npt.NDArray[np.int32]:
    bits: npt.NDArray[np.int32] = (2**SHIFT * points).round().astype(np.int32)
    return bits


def unit_ellipse(covariance: Points) -> Points:
    """Points of one standard deviation round an estimate with this 2x2 covariance, Nx2."""
    covariance = np.asarray(covariance, float)
    covariance = np.clip(np.nan_to_num(covariance), -MOST_VARIANCE_PX2, MOST_VARIANCE_PX2)
    # A root of the covariance, [[a, 0], [b, c]], makes the ellipse of the unit circle.
    a, most = (math.sqrt(max(float(variance), 0.0)) for variance in np.diag(covariance))
    b = min(max(float(covariance[0, 1]) / a, -most), most) if a > 0 else 0.0
    c = math.sqrt(most * most - b * b)
    angles = np.linspace(0, 2 * np.pi, CORNERS, endpoint=False)
    x, y = np.cos(angles), np.sin(angles)
    return np.stack((a * x, b * x + c * y), axis=-1)
