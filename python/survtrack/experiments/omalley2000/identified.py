# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Q identified from data: the densities of white acceleration that make a race likeliest.

R is that of the noise with which the race is measured in the picture.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import filters, published, race
from survtrack.experiments.omalley2000.published import Noises

Floats = NDArray[np.float64]

SEED = 1  # of the race that they are identified from; another than the one that is filtered
DENSITIES = tuple(float(value) for value in np.round(np.geomspace(1e-3, 1e5, 25), 6))
AXES = ((0, 2), (1, 3))  # S with vS, T with vT


def noises(density_s: float, density_t: float) -> Noises:
    """Continuous white accelerations of S and T (units^2/s^3), and the image's noise."""
    Q = np.zeros((4, 4))
    for axis, density in zip(AXES, (density_s, density_t), strict=True):
        Q[np.ix_(axis, axis)] = survtrack.continuous_white_noise(2, published.PERIOD_S, density)
    sigma = race.SIGMA_PX * published.LENGTH / race.track().length_px
    return Noises(Q, sigma**2 * np.eye(2))


def log_likelihood(measured: Floats, values: Noises) -> float:
    """Of all innovations."""
    filter = filters.one(values)
    total = 0.0
    for z in measured:
        filter.predict()
        filter.update(z)
        total += filter.log_likelihood
    return total


@cache
def identify() -> tuple[float, float]:
    """The densities of S and T of the grid; one axis says nothing of the other."""
    measured = race.race(seed=SEED).measured
    of_s = [log_likelihood(measured, noises(density, 1.0)) for density in DENSITIES]
    of_t = [log_likelihood(measured, noises(1.0, density)) for density in DENSITIES]
    return DENSITIES[int(np.argmax(of_s))], DENSITIES[int(np.argmax(of_t))]
