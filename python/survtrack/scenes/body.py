# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What an object looks like from the camera: an upright ellipse or rectangle, as pixels.

Coordinates are continuous: the pixel of column c and row r is the square [c, c + 1) x [r, r + 1),
and its centre is (c + 0.5, r + 0.5). A pixel is set when its centre is inside the shape.
"""

from dataclasses import dataclass
from math import ceil, floor

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import UsageError
from survtrack.scenes.checks import check_number

SHAPES = ("ellipse", "rectangle")
LEAST_SIDE_PX = 2.0  # so that a shape holds a pixel's centre wherever it is
MOST_SIDE_PX = 4096.0
EDGE_SAMPLES = 4  # each way, in a pixel


@dataclass(frozen=True)
class Patch:
    """A part of the picture plane, which may lie outside of the frame.

    left, top: its first column and row.
    values: (height, width), bool or float32.
    """

    left: int
    top: int
    values: NDArray[np.bool_] | NDArray[np.float32]

    def box(self) -> tuple[int, int, int, int]:
        """Left, top, width and height of the smallest box of all values that are not 0."""
        rows = np.flatnonzero(self.values.any(axis=1))
        columns = np.flatnonzero(self.values.any(axis=0))
        if rows.size == 0:
            return self.left, self.top, 0, 0
        first_row, first_column = int(rows[0]), int(columns[0])
        width = int(columns[-1]) - first_column + 1
        return self.left + first_column, self.top + first_row, width, int(rows[-1]) - first_row + 1

    def clipped(self, size: tuple[int, int]) -> "Patch":
        """What of it is in a frame of size (width, height); may be empty."""
        width, height = size
        left, top = max(self.left, 0), max(self.top, 0)
        right = max(min(self.left + self.values.shape[1], width), left)
        bottom = max(min(self.top + self.values.shape[0], height), top)
        values = self.values[top - self.top : bottom - self.top, left - self.left :]
        return Patch(left, top, values[:, : right - left])

    @property
    def area(self) -> tuple[slice, slice]:
        """Its rows and columns in a picture; only of a clipped patch."""
        height, width = self.values.shape
        return slice(self.top, self.top + height), slice(self.left, self.left + width)


@dataclass(frozen=True)
class Body:
    """Shape and size at a scale of 1.

    shape: "ellipse" or "rectangle", upright; a rectangle has its left and top edges inside, its
        right and bottom edges outside, an ellipse all of its edge inside.
    width_px, height_px: 2 or more.
    """

    shape: str = "ellipse"
    width_px: float = 24.0
    height_px: float = 40.0

    def __post_init__(self) -> None:
        """Raises UsageError."""
        if self.shape not in SHAPES:
            raise UsageError(f'shape: unknown "{self.shape}"; one of: {", ".join(SHAPES)}')
        for name in ("width_px", "height_px"):
            check_number(name, getattr(self, name), least=LEAST_SIDE_PX, most=MOST_SIDE_PX)

    def silhouette(self, center: tuple[float, float], scale: float = 1.0) -> Patch:
        """The pixels whose centre is inside, as bool; center is (x, y) in px."""
        sides = (self.width_px * scale, self.height_px * scale)
        return rasterize(self.shape, center, sides)

    def coverage(self, center: tuple[float, float], scale: float = 1.0) -> Patch:
        """The part of each pixel that is inside, 0 to 1 in steps of 1/16, as float32."""
        sides = (self.width_px * scale, self.height_px * scale)
        fine = rasterize(self.shape, center, sides, EDGE_SAMPLES)
        height, width = (side // EDGE_SAMPLES for side in fine.values.shape)
        squares = fine.values.reshape(height, EDGE_SAMPLES, width, EDGE_SAMPLES)
        return Patch(fine.left, fine.top, squares.mean(axis=(1, 3), dtype=np.float32))


def rasterize(
    shape: str, center: tuple[float, float], sides: tuple[float, float], samples: int = 1
) -> Patch:
    """Which points are inside a shape: samples x samples of each pixel, evenly spaced.

    Args:
        shape: one of SHAPES.
        center: (x, y) in px.
        sides: (width, height) in px, above 0.
        samples: 1 for the pixels' centres.
    """
    left, dx = _offsets(center[0], sides[0] / 2, samples)
    top, dy = _offsets(center[1], sides[1] / 2, samples)
    if shape == "ellipse":
        return Patch(left, top, (dx * dx)[None] + (dy * dy)[:, None] <= 1)
    inside_x, inside_y = (dx >= -1) & (dx < 1), (dy >= -1) & (dy < 1)
    return Patch(left, top, inside_x[None] & inside_y[:, None])


def _offsets(center: float, radius: float, samples: int) -> tuple[int, NDArray[np.float64]]:
    """First pixel that the shape may touch, and its sample points in radii from the centre."""
    first, end = floor(center - radius), ceil(center + radius)
    points = first + (np.arange((end - first) * samples) + 0.5) / samples
    return first, (points - center) / radius
