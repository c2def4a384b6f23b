# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of both listings (appendices A and B), each written down alone, to be measured.

Nothing here is used to track. S wraps at the length l.
"""

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.omalley2000 import filters, published
from survtrack.experiments.omalley2000.published import Noises

Floats = NDArray[np.float64]


class ListingFilter:
    """The filter of TEST.M; right but for the fault that is asked for.

    x: (4,) S, T, vS, vT. P: (4, 4). K: (4, 2) of the last step. innovation: (2,) of it.
    predicted_P: (4, 4) before it.
    """

    def __init__(
        self, noises: Noises, *, gain_of_p: bool = False, wrap: bool = False, start: Floats
    ) -> None:
        """Args:
        noises: Q and R.
        gain_of_p: K = P H' S^-1 with the P before the prediction.
        wrap: l is taken off the state when it is more than 200 from the measurement, on whichever
            side; otherwise the difference is that of the shorter way round.
        start: (4,) state.
        """
        self.x: Floats = np.array(start, np.float64)
        self.P: Floats = np.eye(4)
        self.predicted_P: Floats = self.P
        self.K: Floats = np.zeros((4, 2))
        self.innovation: Floats = np.zeros(2)
        self._noises, self._gain_of_p, self._wrap = noises, gain_of_p, wrap

    def step(self, z: Floats) -> None:
        """One frame on, with (2,) S and T."""
        F, H = filters.transition(), filters.H
        if self._wrap and abs(z[0] - self.x[0]) > published.WRAP_OVER:
            self.x[0] -= published.LENGTH
        predicted = F @ self.x
        self.predicted_P = F @ self.P @ F.T + self._noises.Q
        S = H @ self.predicted_P @ H.T + self._noises.R
        of = self.P if self._gain_of_p else self.predicted_P
        self.K = of @ H.T @ np.linalg.inv(S)
        away = z - H @ predicted if self._wrap else filters.difference(z, predicted[:2])
        self.innovation = np.asarray(away)
        self.x = predicted + self.K @ self.innovation
        self.P = (np.eye(4) - self.K @ H) @ self.predicted_P


def wrapped_innovation(z: float, s: float) -> float:
    """What the listing's two lines about the wrap leave of measured less state, at rest."""
    if abs(z - s) > published.WRAP_OVER:
        s -= published.LENGTH
    return z - s


def raw_velocities(s: Floats) -> Floats:
    """(N,) of (N,) S: any step back counts as one over the start line; the first is copied."""
    steps = np.diff(s)
    forward = np.where(steps < 0, steps + published.LENGTH, steps) / published.PERIOD_S
    return np.concatenate([forward[:1], forward])
