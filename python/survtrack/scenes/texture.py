# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Smooth random grey, known at every point of the plane.

Value noise: random values on a square lattice, joined by cubic steps; two lattices, a coarse one
and one four times as fine, are added. Since it can be evaluated anywhere, a texture moves with its
object by any fraction of a pixel without being resampled.
"""

import numpy as np
from numpy.typing import NDArray

LATTICE = 64  # cells until it repeats
SHARES = ((1.0, 2 / 3), (0.25, 1 / 3))  # cell size in parts of the coarse one, and weight


class Texture:
    """Values from -1 to 1 with structure of the size of cell_px and down to a quarter of it."""

    def __init__(self, random: np.random.Generator, cell_px: float) -> None:
        """Draws its lattices from `random`; cell_px above 0."""
        self._layers = [
            (cell_px * size, weight * random.uniform(-1, 1, (LATTICE, LATTICE)))
            for size, weight in SHARES
        ]

    def at(self, xs: NDArray[np.float64], ys: NDArray[np.float64]) -> NDArray[np.float32]:
        """(H, W) values at all points (x, y) of W xs and H ys, px."""
        total = np.zeros((len(ys), len(xs)))
        for cell, lattice in self._layers:
            left, right = _steps(xs / cell)
            top, bottom = _steps(ys / cell)
            rows = lattice[:, left[0]] * left[1] + lattice[:, right[0]] * right[1]
            total += rows[top[0]] * top[1][:, None] + rows[bottom[0]] * bottom[1][:, None]
        return total.astype(np.float32)


Step = tuple[NDArray[np.int64], NDArray[np.float64]]


def _steps(points: NDArray[np.float64]) -> tuple[Step, Step]:
    """Lattice points before and after each point, and their weights."""
    before = np.floor(points)
    rest = points - before
    weight = rest * rest * (3 - 2 * rest)
    first = before.astype(np.int64) % LATTICE
    return (first, 1 - weight), ((first + 1) % LATTICE, weight)
