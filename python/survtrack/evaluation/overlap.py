# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How well boxes fit each other, and the best one-to-one matching between them."""

import numpy as np
from numpy.typing import NDArray

# Thresholds are met within one rounding error, as TrackEval has it; an area or a score below it
# counts as none.
EPSILON = float(np.finfo(np.float64).eps)


def iou_matrix(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Intersection over union (Jaccard index) of every box of `a` with every box of `b`.

    Args:
        a: (N, 4) left, top, width, height.
        b: (M, 4) likewise.

    Returns:
        (N, M) values from 0 to 1.
    """
    area_a, area_b, shared = _areas(a, b)
    union = area_a[:, None] + area_b[None] - shared
    valid = (area_a > EPSILON)[:, None] & (area_b > EPSILON)[None] & (union > EPSILON)
    return np.asarray(np.divide(shared, union, out=np.zeros_like(shared), where=valid))


def coverage_matrix(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of every box of `b` that every box of `a` covers: intersection over area of `b`.

    Args:
        a: (N, 4) left, top, width, height.
        b: (M, 4) likewise.

    Returns:
        (N, M) values from 0 to 1.
    """
    _, area_b, shared = _areas(a, b)
    valid = np.broadcast_to(area_b > EPSILON, shared.shape)
    return np.asarray(np.divide(shared, area_b, out=np.zeros_like(shared), where=valid))


def _areas(
    a: NDArray[np.float64], b: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The areas of `a` (N,), of `b` (M,) and of their intersections (N, M)."""
    # Areas come from the corners, not from width * height: the two differ in the last bit, and a
    # fit of exactly 0.5 must fall on the same side as in TrackEval.
    a_low, a_high = a[:, :2], a[:, :2] + a[:, 2:]
    b_low, b_high = b[:, :2], b[:, :2] + b[:, 2:]
    low = np.maximum(a_low[:, None], b_low[None])
    high = np.minimum(a_high[:, None], b_high[None])
    return (
        np.prod(a_high - a_low, axis=1),
        np.prod(b_high - b_low, axis=1),
        np.prod(np.maximum(high - low, 0.0), axis=2),
    )


def best_matching(score: NDArray[np.float64]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The one-to-one matching of rows to columns with the highest sum of scores.

    Pairs of score 0 are left out: they are what the matching had over.

    Returns:
        The rows, in ascending order, and the column of each.
    """
    from scipy.optimize import linear_sum_assignment

    rows, columns = linear_sum_assignment(score, maximize=True)
    matched = score[rows, columns] > EPSILON
    return rows[matched], columns[matched]
