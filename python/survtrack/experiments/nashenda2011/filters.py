# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The library's filter with the printed numbers, and with a covariance for R."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.nashenda2011 import published

Floats = NDArray[np.float64]
Way = Literal["published", "corrected"]

WAYS: tuple[Way, ...] = ("published", "corrected")
MIDDLE = (published.SIZE[0] / 2, published.SIZE[1] / 2)
H = np.eye(2, 4)
RIGHT_R = np.diag(np.diag(published.R))


def transition(period_s: float = published.PERIOD_S) -> Floats:
    """(4, 4) of (x, y, vx, vy), velocities in px/s."""
    return np.asarray(np.eye(4) + period_s * np.eye(4, k=2))


def one(q: float, way: Way, start: Sequence[float] = MIDDLE) -> survtrack.KalmanFilter:
    """A filter before its first prediction; predict([1]) adds the way's B u, predict() none."""
    printed = way == "published"
    return survtrack.KalmanFilter(
        F=transition(),
        H=H,
        Q=q * np.eye(4),
        R=published.R if printed else RIGHT_R,
        x=[*start, 0.0, 0.0],
        P=published.START_VARIANCE * np.eye(4),
        B=(published.INPUT if printed else 0 * published.INPUT)[:, None],
        validate=not printed,
    )


def estimates(
    z: Floats,
    q: float,
    way: Way,
    start: Sequence[float] = MIDDLE,
    period_s: float = published.PERIOD_S,
) -> Floats:
    """Filter many runs at once: text 4.2.3, a missing measurement is predicted.

    The start is the first a priori state, so that B u is not in it, but Q is.

    Args:
        z: (T, N, 2) measurements of N runs, px; NaN where one is missing. Frames before the first
            measurement of any run are not to be in it.
        q: of Q = q I.
        way: "published" with the printed R and B u, unvalidated; "corrected" with neither.
        start: (x, y), px.
        period_s: between two frames.

    Returns:
        (T, N, 2) positions, px.
    """
    printed = way == "published"
    frames, runs, _ = z.shape
    bank = survtrack.KalmanBank(
        transition(period_s),
        H,
        q * np.eye(4),
        published.R if printed else RIGHT_R,
        np.tile([*start, 0.0, 0.0], (runs, 1)),
        published.START_VARIANCE * np.eye(4),
        B=published.INPUT[:, None],
        validate=not printed,
    )
    positions = np.empty((frames, runs, 2))
    for frame in range(frames):
        bank.predict([1.0] if printed and frame > 0 else [0.0])
        bank.update(z[frame])
        positions[frame] = bank.states[:, :2]
    return positions
