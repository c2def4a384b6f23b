# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Horn and Schunck's equations in float64, one after the other: what the core is judged by."""

from typing import Any

import numpy as np

from clips import Image

Field = np.ndarray[Any, np.dtype[np.float64]]


def neighbour(values: Field, right: int, down: int) -> Field:
    """The values so many columns to the right and rows down; the edges are repeated."""
    height, width = values.shape
    rows = np.clip(np.arange(height) + down, 0, height - 1)
    columns = np.clip(np.arange(width) + right, 0, width - 1)
    return values[np.ix_(rows, columns)]


def cube_derivatives(previous: Field, current: Field) -> tuple[Field, Field, Field]:
    """Horn and Schunck 1981, section 7: means of four differences in a cube of 2x2x2."""
    corners = [(right, down) for right in (0, 1) for down in (0, 1)]
    frames = (previous, current)
    at = {
        (*corner, time): neighbour(frames[time], *corner) for corner in corners for time in (0, 1)
    }

    def mean_difference(axis: int) -> Field:
        ends = ([at[key] for key in at if key[axis] == side] for side in (0, 1))
        near, far = (np.mean(values, axis=0) for values in ends)
        return np.asarray(far - near)

    return mean_difference(0), mean_difference(1), mean_difference(2)


def sobel_derivatives(previous: Field, current: Field) -> tuple[Field, Field, Field]:
    mean = (previous + current) / 2
    weights = {-1: 1, 0: 2, 1: 1}
    ix = sum(w * (neighbour(mean, 1, k) - neighbour(mean, -1, k)) for k, w in weights.items()) / 8
    iy = sum(w * (neighbour(mean, k, 1) - neighbour(mean, k, -1)) for k, w in weights.items()) / 8
    return np.asarray(ix), np.asarray(iy), current - previous


def neighbourhood_mean(values: Field) -> Field:
    """Section 8: the four next to the pixel weigh 1/6 each, the four at the corners 1/12."""
    edges = sum(neighbour(values, *to) for to in ((1, 0), (-1, 0), (0, 1), (0, -1)))
    corners = sum(neighbour(values, *to) for to in ((1, 1), (1, -1), (-1, 1), (-1, -1)))
    return np.asarray(edges / 6 + corners / 12)


def horn_schunck(
    previous: Image,
    current: Image,
    *,
    smoothness: float,
    sweeps: int,
    derivatives: str = "hs1981",
    initial: tuple[Any, Any] | None = None,
) -> tuple[Field, Field]:
    """Grey frames; the flow after `sweeps` iterations of section 12."""
    derive = {"hs1981": cube_derivatives, "sobel": sobel_derivatives}[derivatives]
    ix, iy, it = derive(previous / 255, current / 255)
    start = initial if initial is not None else (np.zeros(ix.shape), np.zeros(ix.shape))
    u, v = (np.asarray(field, np.float64) for field in start)
    for _ in range(sweeps):
        mean_u, mean_v = neighbourhood_mean(u), neighbourhood_mean(v)
        error = (ix * mean_u + iy * mean_v + it) / (smoothness**2 + ix**2 + iy**2)
        u, v = mean_u - ix * error, mean_v - iy * error
    return u, v
