# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the dissertation's equations and listing, each written down alone, to be measured.

Nothing here is used to track. Positions are (x, y), px; images are (rows, columns, channels).
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.nashenda2011 import filters, published

Floats = NDArray[np.float64]
Image = NDArray[np.uint8]
Mask = NDArray[np.bool_]


class ListingFilter:
    """The filter of kalman.m for many runs at once; right but for the fault that is asked for.

    x: (N, 4) states, velocities in px/s. P: (4, 4), the same for all runs.
    """

    def __init__(
        self,
        start: Sequence[float],
        q: float,
        *,
        runs: int = 1,
        R: Floats = filters.RIGHT_R,
        control: Floats | None = None,
        plus_sign: bool = False,
    ) -> None:
        """Args:
        start: (x, y) of the first a priori state.
        q: of Q = q I.
        runs: N.
        R: (2, 2) of the measurement noise.
        control: (4,) B u of each prediction; none unless given.
        plus_sign: the innovation is z + H x-, as in eq. 22 of 4.2.3.4, but with the gain.
        """
        self.x: Floats = np.tile([*start, 0.0, 0.0], (runs, 1))
        self.P: Floats = published.START_VARIANCE * np.eye(4)
        self._Q, self._R = q * np.eye(4), R
        self._control = np.zeros(4) if control is None else control
        self._sign = 1.0 if plus_sign else -1.0
        self._started = False

    def step(self, z: Floats) -> Floats:
        """One frame on, with (N, 2) measurements; returns (N, 2) positions."""
        self.predict()
        return self.update(z)

    def update(self, z: Floats) -> Floats:
        """The second half of a step."""
        S = filters.H @ self.P @ filters.H.T + self._R
        K = self.P @ filters.H.T @ np.linalg.inv(S)
        self.x = self.x + (z + self._sign * self.x[:, :2]) @ K.T
        self.P = (np.eye(4) - K @ filters.H) @ self.P
        return self.x[:, :2].copy()

    def predict(self) -> Floats:
        """What is right for a frame without a measurement; returns (N, 2) positions."""
        F = filters.transition()
        if self._started:
            self.x = self.x @ F.T + self._control
        self._started = True
        self.P = F @ self.P @ F.T + self._Q
        return self.x[:, :2].copy()

    def skip(self) -> Floats:
        """`continue`: that frame's row of x stays zero, and the next prediction starts from it."""
        self.x = np.zeros_like(self.x)
        return self.x[:, :2].copy()


def swapped_start(size: tuple[int, int]) -> tuple[float, float]:
    """(rows / 2, columns / 2), taken for x and y; size is (width, height), px."""
    return size[1] / 2, size[0] / 2


def printed_update(x: Floats, z: Floats) -> Floats:
    """Eq. 22 of 4.2.3.4 to the letter: x- (z + H x-). Raises ValueError: 4 numbers by 2."""
    return np.asarray(x @ (z + filters.H @ x))


def printed_ekf_prediction(f: Callable[[Floats], Floats], previous: Floats) -> Floats:
    """Eqs. 26 and 28: f of the estimate of frame k, to get that of frame k.

    The only estimate of frame k before its measurement is f of the previous one, so that f is
    applied twice.
    """
    return f(f(previous))


def first_channel_one_sided(frame: Image, background: Image) -> Mask:
    """4.3's test: in the first channel abs() is of the comparison, not of the difference."""
    away = frame.astype(np.int64) - background.astype(np.int64)
    over = np.abs(away) > published.THRESHOLD
    over[..., 0] = away[..., 0] > published.THRESHOLD
    return np.asarray(over.any(axis=-1))


def at_least(frame: Image, background: Image) -> Mask:
    """Eq. 26 of 4.3: foreground from T on, where eq. 2 and the listing have more than T."""
    away = frame.astype(np.int64) - background.astype(np.int64)
    return np.asarray((np.abs(away) >= published.THRESHOLD).any(axis=-1))


def more_than(frame: Image, background: Image) -> Mask:
    """The listing's test."""
    away = frame.astype(np.int64) - background.astype(np.int64)
    return np.asarray((np.abs(away) > published.THRESHOLD).any(axis=-1))


def eroded_twice(mask: Mask) -> Mask:
    """Two erosions by 3x3 pixels; what is beyond the border counts as background."""
    rows, columns = mask.shape
    framed = np.pad(mask, 2)
    kept = np.ones_like(mask)
    for row in range(5):
        for column in range(5):
            kept &= framed[row : row + rows, column : column + columns]
    return kept
