# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A target that is hidden: predicted as the text says (4.2), or skipped as the listing does."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.following import rms
from survtrack.experiments.nashenda2011 import filters, published, sweep, targets
from survtrack.experiments.nashenda2011.listing import ListingFilter

Floats = NDArray[np.float64]

HIDDEN_FROM = 93  # the frame, from 1, of figure 21
LENGTHS = tuple(range(1, 11))
RUNS, SHOWN_AFTER = 100, 20


@dataclass(frozen=True)
class Bridged:
    """Errors about one gap; root mean squares of the distance over all runs, px.

    Attributes:
        before, during, after: in the frame before the gap, in its last, in the first one after it.
        settled: SHOWN_AFTER frames after that.
    """

    before: float
    during: float
    after: float
    settled: float


Gaps = dict[str, dict[str, dict[float, dict[int, Bridged]]]]  # by target, way, q and length


def last_frame() -> int:
    """How many frames a run needs."""
    return HIDDEN_FROM + max(LENGTHS) + SHOWN_AFTER


def frames() -> int:
    """Of all runs, for the progress."""
    return len(sweep.TARGETS) * 2 * len(published.SWEEP) * len(LENGTHS) * last_frame() * RUNS


def measure(tick: Callable[[int], None]) -> Gaps:
    """All gaps; `tick` gets the number of frames of each run."""
    every: Gaps = {}
    for name in sweep.TARGETS:
        acceleration = sweep.ACCELERATION if name == "manoeuvring" else 0.0
        truth = targets.manoeuvring(last_frame(), RUNS, acceleration, seed=5)
        z = targets.measured(truth, RUNS, targets.SIGMA_PX, seed=6)
        every[name] = {"ours": {}, "listing": {}}
        for q in published.SWEEP:
            every[name]["ours"][q], every[name]["listing"][q] = {}, {}
            for length in LENGTHS:
                seen = hidden(z, length)
                ours = filters.estimates(seen, q, "corrected")
                tick(seen.shape[0] * seen.shape[1])
                listing = skipping(seen, q)
                tick(seen.shape[0] * seen.shape[1])
                every[name]["ours"][q][length] = _about(ours - truth, length)
                every[name]["listing"][q][length] = _about(listing - truth, length)
    return every


def hidden(z: Floats, length: int) -> Floats:
    """The measurements without those of the gap."""
    seen = z.copy()
    seen[HIDDEN_FROM - 1 : HIDDEN_FROM - 1 + length] = np.nan
    return seen


def skipping(z: Floats, q: float) -> Floats:
    """(T, N, 2) positions of the listing's loop, right but for `continue`; z as for estimates()."""
    filter = ListingFilter(filters.MIDDLE, q, runs=z.shape[1])
    return np.stack([filter.skip() if np.isnan(row).all() else filter.step(row) for row in z])


def _about(errors: Floats, length: int) -> Bridged:
    first = HIDDEN_FROM - 1
    rows = (first - 1, first + length - 1, first + length, first + length + SHOWN_AFTER)
    return Bridged(*(rms(np.hypot(*errors[row].T)) for row in rows))
