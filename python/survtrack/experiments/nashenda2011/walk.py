# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The simulated walk of figures 14 to 22, filtered with each q."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.nashenda2011 import filters, gaps, published, targets
from survtrack.experiments.nashenda2011.filters import WAYS, Way

Floats = NDArray[np.float64]

SEED = 21


@dataclass(frozen=True, eq=False)
class Walk:
    """One run.

    Attributes:
        frames: (T,) from 6, when the person comes in, to 121.
        truth, measured: (T, 2) px; NaN where the person is hidden.
        estimates: (T, 2) by way and q.
        skipping: (T, 2) by q, of a loop that is right but for the listing's `continue`.
    """

    frames: NDArray[np.int64]
    truth: Floats
    measured: Floats
    estimates: dict[Way, dict[float, Floats]]
    skipping: dict[float, Floats]

    def row(self, frame: int) -> int:
        """Of the arrays."""
        return int(np.flatnonzero(self.frames == frame)[0])


def frames() -> int:
    """Of all runs, for the progress."""
    return (len(WAYS) + 1) * len(published.SWEEP) * len(targets.walk()[0])


def measure(tick: Callable[[int], None]) -> Walk:
    """Filter it; `tick` gets the number of frames of each run."""
    numbers, truth = targets.walk()
    z = targets.measured(truth[:, None], 1, targets.SIGMA_PX, SEED)
    z[np.isin(numbers, targets.WALK_HIDDEN)] = np.nan
    estimates: dict[Way, dict[float, Floats]] = {}
    for way in WAYS:
        estimates[way] = {}
        for q in published.SWEEP:
            estimates[way][q] = filters.estimates(z, q, way)[:, 0]
            tick(len(numbers))
    skipping = {}
    for q in published.SWEEP:
        skipping[q] = gaps.skipping(z, q)[:, 0]
        tick(len(numbers))
    return Walk(numbers, truth, z[:, 0], estimates, skipping)
