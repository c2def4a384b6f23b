# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From pixels to places on the ground, by four points that are known in both."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath, read_bytes

Points = npt.NDArray[np.float64]
KEYS = ("image_points", "ground_points", "unit")
# Of a triangle, in parts of the square of the points' extent: with less, three are on a line.
LEAST_AREA = 1e-6
# Of the extent, in parts of the largest coordinate: with less, digits are lost.
LEAST_EXTENT = 1e-6
MOST_COORDINATE = 1e9
MOST_UNIT_CHARACTERS = 12


@dataclass(frozen=True, eq=False)
class GroundMap:
    """The plane homography of four pairs of points.

    Attributes:
        image_points, ground_points: 4x2; px, and units of the ground.
        unit: what the ground's coordinates are measured in.
        y_up: whether the ground's second coordinate is drawn upwards.
        matrix: 3x3; positive third coordinates are before the horizon.
    """

    image_points: Points
    ground_points: Points
    unit: str
    y_up: bool
    matrix: Points

    @staticmethod
    def of_points(
        image_points: Any, ground_points: Any, unit: str = "m", *, y_up: bool = True
    ) -> "GroundMap":
        """The map that takes each image point to its ground point.

        Args:
            image_points: 4x2, px; no three on a line.
            ground_points: 4x2, of the same places on the ground; no three on a line.
            unit: of the ground's coordinates; at most 12 characters.
            y_up: whether the second coordinate grows upwards in a plan.

        Raises:
            InputError: points of another shape, not finite, three on a line, or in an order that no
                camera sees.
        """
        image, ground = _four(image_points, KEYS[0]), _four(ground_points, KEYS[1])
        if not isinstance(unit, str) or not 0 < len(unit) <= MOST_UNIT_CHARACTERS:
            raise InputError(
                f'"unit" is {unit!r}; 1 to {MOST_UNIT_CHARACTERS} characters are allowed'
            )
        # In coordinates from 0 to 1 the equations are well conditioned.
        first, second = _to_unit_square(image), _to_unit_square(ground)
        inner = _solve(_applied(first, image), _applied(second, ground))
        matrix = np.linalg.inv(second) @ inner @ first
        depths = _homogeneous(image) @ matrix[2]
        if not (np.isfinite(matrix).all() and (depths * depths[0] > 0).all()):
            raise InputError(
                '"image_points" and "ground_points" do not go round in the same order, or one of '
                "the points is beyond the horizon of the others"
            )
        return GroundMap(image, ground, unit, y_up, matrix / depths[0])

    @staticmethod
    def of_pixels(width_px: int, height_px: int) -> "GroundMap":
        """The image as its own plan, in px."""
        corners = [[0, 0], [width_px, 0], [width_px, height_px], [0, height_px]]
        return GroundMap.of_points(corners, corners, "px", y_up=False)

    def to_ground(self, points: Any) -> Points:
        """Nx2 points of the image on the ground; NaN for those on the horizon or beyond."""
        # So near to the horizon that it overflows is on it.
        with np.errstate(all="ignore"):
            moved = _homogeneous(np.asarray(points, float).reshape(-1, 2)) @ self.matrix.T
            places = moved[:, :2] / np.where(moved[:, 2:] > 0, moved[:, 2:], np.nan)
        places[~np.isfinite(places).all(axis=1)] = np.nan
        return places

    def spread_on_ground(self, point: tuple[float, float], covariance_px2: Points) -> Points:
        """2x2 covariance on the ground of one in the image at `point`, to first order.

        The derivative of the map is J = (A - g c^T) / w, with the matrix's upper left part A, its
        last row (c, .), the point's ground place g and depth w; the result is J P J^T.
        """
        ground = self.to_ground([point])[0]
        depth = float(_homogeneous(np.array([point]))[0] @ self.matrix[2])
        jacobian = (self.matrix[:2, :2] - np.outer(ground, self.matrix[2, :2])) / depth
        spread: Points = jacobian @ covariance_px2 @ jacobian.T
        return spread


def read_ground(path: StrPath) -> GroundMap:
    """The map of a JSON file.

        {"image_points": [[x, y], ...], "ground_points": [[X, Y], ...], "unit": "m"}

    Four points each, in the same order; "unit" may be missing: "m".

    Raises:
        InputError: the file cannot be read or does not say that; it is named, and what is wrong.
    """
    path = Path(path)
    try:
        said = json.loads(read_bytes(path).decode("utf-8"))
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    except (json.JSONDecodeError, RecursionError) as error:
        raise InputError(f"{path}: is not JSON: {error}") from error
    try:
        if not isinstance(said, dict) or not set(KEYS[:2]) <= set(said) <= set(KEYS):
            raise InputError(f"expected an object with {', '.join(KEYS)}, and nothing else")
        return GroundMap.of_points(said[KEYS[0]], said[KEYS[1]], said.get(KEYS[2], "m"))
    except InputError as error:
        raise InputError(f"{path}: {error}") from error


def _four(points: Any, name: str) -> Points:
    problem = InputError(
        f'"{name}" must be four points [x, y] of finite numbers up to {MOST_COORDINATE:g}'
    )
    try:
        array = np.array(points, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise problem from error
    if array.shape != (4, 2) or not (np.abs(array) <= MOST_COORDINATE).all():
        raise problem
    extent = float(np.ptp(array, axis=0).max())
    if not extent > LEAST_EXTENT * float(np.abs(array).max()) or _has_three_on_a_line(
        array / extent
    ):
        raise InputError(f'"{name}" has three points on a line, or two that are the same')
    return array


def _has_three_on_a_line(points: Points) -> bool:
    for left_out in range(4):
        a, b, c = np.delete(points, left_out, axis=0)
        if not abs(np.linalg.det(np.stack((b - a, c - a)))) > LEAST_AREA:
            return True
    return False


def _homogeneous(points: Points) -> Points:
    return np.column_stack((points, np.ones(len(points))))


def _applied(matrix: Points, points: Points) -> Points:
    """By a matrix whose last row is (0, 0, 1)."""
    return _homogeneous(points) @ matrix[:2].T


def _to_unit_square(points: Points) -> Points:
    low, scale = points.min(axis=0), 1 / np.ptp(points, axis=0).max()
    return np.array([[scale, 0, -scale * low[0]], [0, scale, -scale * low[1]], [0, 0, 1]])


def _solve(image: Points, ground: Points) -> Points:
    """The homography of four pairs, up to its scale and sign."""
    rows = []
    for (x, y), (gx, gy) in zip(image, ground, strict=True):
        rows.append([x, y, 1, 0, 0, 0, -gx * x, -gx * y, -gx])
        rows.append([0, 0, 0, x, y, 1, -gy * x, -gy * y, -gy])
    # The one direction that all eight equations leave free.
    matrix: Points = np.linalg.svd(np.array(rows))[2][-1].reshape(3, 3)
    return matrix
