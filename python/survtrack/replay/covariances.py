# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Covariances as whole numbers: standard deviations on a logarithmic scale, and correlations."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from survtrack.errors import InputError
from survtrack.replay.values import StreamHeader

# Standard deviations, in octaves from 1 (px, px/s, px/s^1.5): the least stands for none at all.
LEAST_OCTAVE, MOST_OCTAVE = -16, 40

Spread = tuple[int, int, int]
Cross = tuple[int, int, int, int]
Numbers3 = tuple[float, float, float]
Numbers4 = tuple[float, float, float, float]


def spread_of(matrix: npt.NDArray[np.float64], header: StreamHeader) -> Spread:
    """Steps of both standard deviations and of the correlation of a 2x2 covariance.

    A variance below 0, which only a filter with numbers as published has, is none.
    """
    deviations = [_deviation(float(matrix[k, k]), header.steps_per_octave) for k in (0, 1)]
    if _none(header) in deviations:
        return deviations[0], deviations[1], 0
    correlation = _correlation(float(matrix[0, 1]), float(matrix[0, 0]), float(matrix[1, 1]))
    return deviations[0], deviations[1], _correlation_steps(correlation, header)


def covariance_of(spread: Spread, header: StreamHeader) -> Numbers3:
    """(xx, xy, yy) of a spread."""
    sx, sy = deviations_of(spread, header)
    return sx * sx, spread[2] / header.steps_of_correlation * sx * sy, sy * sy


def cross_of(
    matrix: npt.NDArray[np.float64],
    of: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]],
    spreads: tuple[Spread, Spread],
    header: StreamHeader,
) -> Cross:
    """Steps of the four correlations of a 2x2 cross covariance, row by row.

    Args:
        matrix: rows of the first, columns of the second.
        of: the covariances of both.
        spreads: theirs.
        header: the stream's steps.
    """
    steps = []
    for row in (0, 1):
        for column in (0, 1):
            if _none(header) in (spreads[0][row], spreads[1][column]):
                steps.append(0)
                continue
            variances = float(of[0][row, row]), float(of[1][column, column])
            correlation = _correlation(float(matrix[row, column]), *variances)
            steps.append(_correlation_steps(correlation, header))
    return steps[0], steps[1], steps[2], steps[3]


def cross_covariance_of(
    cross: Cross, spreads: tuple[Spread, Spread], header: StreamHeader
) -> Numbers4:
    """(xx, xy, yx, yy) of four correlations."""
    first, second = (deviations_of(spread, header) for spread in spreads)
    xx, xy, yx, yy = (steps / header.steps_of_correlation for steps in cross)
    return (
        xx * first[0] * second[0],
        xy * first[0] * second[1],
        yx * first[1] * second[0],
        yy * first[1] * second[1],
    )


def deviations_of(spread: Spread, header: StreamHeader) -> tuple[float, float]:
    """Both standard deviations of a spread."""
    sx, sy = (
        0.0 if steps <= _none(header) else 2.0 ** (steps / header.steps_per_octave)
        for steps in spread[:2]
    )
    return sx, sy


def is_spread(spread: Spread, header: StreamHeader) -> bool:
    """True for a spread within its bounds."""
    least, most = (header.steps_per_octave * octave for octave in (LEAST_OCTAVE, MOST_OCTAVE))
    in_range = all(least <= deviation <= most for deviation in spread[:2])
    return in_range and abs(spread[2]) <= header.steps_of_correlation


def matrix_named(track: Any, name: str) -> npt.NDArray[np.float64]:
    """A 2x2 matrix of a track.

    Raises:
        InputError: it holds a number that is not finite.
    """
    matrix: npt.NDArray[np.float64] = getattr(track, name)
    if not np.isfinite(matrix).all():
        raise InputError(
            f"track {track.id}: its {name} is {matrix.tolist()}; finite numbers are needed"
        )
    return matrix


def _none(header: StreamHeader) -> int:
    return LEAST_OCTAVE * header.steps_per_octave


def _correlation(covariance: float, first: float, second: float) -> float:
    # Divided one after the other: a product of variances could be beyond all numbers.
    return covariance / math.sqrt(first) / math.sqrt(second)


def _correlation_steps(correlation: float, header: StreamHeader) -> int:
    bounded = min(max(correlation, -1.0), 1.0)
    return math.floor(bounded * header.steps_of_correlation + 0.5)


def _deviation(variance: float, steps_per_octave: int) -> int:
    """Steps of the standard deviation whose square this is."""
    least, most = LEAST_OCTAVE * steps_per_octave, MOST_OCTAVE * steps_per_octave
    if variance <= 0:
        return least
    steps = math.floor(0.5 * steps_per_octave * math.log2(variance) + 0.5)
    return min(max(steps, least), most)
