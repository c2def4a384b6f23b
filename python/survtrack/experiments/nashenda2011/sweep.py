# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The sweep of Q in simulation, and the best q of a manoeuvre and a noise."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.following import rms
from survtrack.experiments.nashenda2011 import filters, published, targets
from survtrack.experiments.nashenda2011.filters import WAYS, Way

Floats = NDArray[np.float64]

RUNS, LONG_FRAMES = 200, 300
SETTLED, LATE = 60, 200  # frames before the errors of the first 121, and of all 300, count
ACCELERATION = 20.0  # px/s^2, of the target that manoeuvres
TARGETS = ("steady", "manoeuvring")

GRID_RUNS = 50
GRID_Q = (0.0, *(float(q) for q in np.round(np.geomspace(1e-4, 1e4, 33), 7)))
GRID_ACCELERATIONS = (0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
GRID_SIGMAS_PX = (0.5, 1.0, 2.0, 4.0)


@dataclass(frozen=True)
class Errors:
    """Of one filter on one target; root mean squares of a coordinate over all runs, px.

    Attributes:
        truth_px: to the truth, frames 61 to 121.
        late_px: to the truth, frames 201 to 300.
        measured_px: to the measurement, frames 61 to 121: what the dissertation calls the error.
    """

    truth_px: float
    late_px: float
    measured_px: float


Sweep = dict[str, dict[Way, dict[float, Errors]]]
Best = dict[float, dict[float, dict[float, float]]]


def frames() -> int:
    """Of all runs, for the progress."""
    return len(TARGETS) * len(WAYS) * len(published.SWEEP) * LONG_FRAMES * RUNS + (
        len(GRID_SIGMAS_PX) * len(GRID_ACCELERATIONS) * len(GRID_Q) * published.FRAMES * GRID_RUNS
    )


def measure_sweep(tick: Callable[[int], None]) -> Sweep:
    """Errors by target, way and q; `tick` gets the number of frames of each run."""
    every: Sweep = {}
    for name in TARGETS:
        acceleration = ACCELERATION if name == "manoeuvring" else 0.0
        truth = targets.manoeuvring(LONG_FRAMES, RUNS, acceleration, seed=1)
        z = targets.measured(truth, RUNS, targets.SIGMA_PX, seed=2)
        every[name] = {}
        for way in WAYS:
            every[name][way] = {}
            for q in published.SWEEP:
                every[name][way][q] = _errors(filters.estimates(z, q, way), truth, z)
                tick(z.shape[0] * z.shape[1])
    return every


def _errors(estimates: Floats, truth: Floats, z: Floats) -> Errors:
    short = slice(SETTLED, published.FRAMES)
    return Errors(
        rms((estimates - truth)[short]),
        rms((estimates - truth)[LATE:]),
        rms((estimates - z)[short]),
    )


def measure_best(tick: Callable[[int], None]) -> Best:
    """Rms error to the truth, px, by noise (px), acceleration (px/s^2) and q: corrected filter."""
    every: Best = {}
    for sigma_px in GRID_SIGMAS_PX:
        every[sigma_px] = {}
        for acceleration in GRID_ACCELERATIONS:
            truth = targets.manoeuvring(published.FRAMES, GRID_RUNS, acceleration, seed=3)
            z = targets.measured(truth, GRID_RUNS, sigma_px, seed=4)
            by_q = {}
            for q in GRID_Q:
                away = filters.estimates(z, q, "corrected") - truth
                by_q[q] = rms(away[SETTLED:])
                tick(z.shape[0] * z.shape[1])
            every[sigma_px][acceleration] = by_q
    return every


def best_q(by_q: dict[float, float]) -> float:
    """The q of the smallest error; of equals the smallest."""
    return min(by_q, key=lambda q: (by_q[q], q))
