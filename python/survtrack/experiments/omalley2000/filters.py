# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The library's filter with the printed values: state (S, T, vS, vT), S wraps at the length."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import published
from survtrack.experiments.omalley2000.published import Noises

Floats = NDArray[np.float64]

H = np.eye(2, 4)


def transition() -> Floats:
    """(4, 4), between two frames."""
    return np.asarray(np.eye(4) + published.PERIOD_S * np.eye(4, k=2))


def difference(z: Floats, predicted: Floats) -> Floats:
    """(2,) z - predicted, in S the shorter way round: ((d + l/2) mod l) - l/2."""
    s = survtrack.wrapped_difference(float(z[0] - predicted[0]), published.LENGTH)
    return np.array([s, z[1] - predicted[1]])


def one(noises: Noises, start: Floats = published.START) -> survtrack.KalmanFilter:
    """A filter before its first prediction, P0 = I."""
    return survtrack.KalmanFilter(
        F=transition(),
        H=H,
        Q=noises.Q,
        R=noises.R,
        x=start,
        P=np.eye(4),
        residual=difference,
    )


@dataclass(frozen=True, eq=False)
class Filtered:
    """One run.

    Attributes:
        predicted, updated: (N, 4) states of each frame; S goes on over the laps.
        innovations: (N, 2) measured less predicted, the shorter way round.
        nis: (N,) normalised innovations squared; 2 on average if the model fits.
        sigmas: (N, 2) roots of the predicted variances of S and T.
    """

    predicted: Floats
    updated: Floats
    innovations: Floats
    nis: Floats
    sigmas: Floats


def run(measured: Floats, noises: Noises) -> Filtered:
    """Filter (N, 2) measurements of S and T, the first one after one step from the start."""
    filter = one(noises)
    predicted, updated, innovations, nis, sigmas = [], [], [], [], []
    for z in measured:
        filter.predict()
        predicted.append(filter.x)
        sigmas.append(np.sqrt(np.diag(filter.P)[:2]))
        filter.update(z)
        updated.append(filter.x)
        innovations.append(filter.y)
        nis.append(filter.nis)
    return Filtered(*(np.array(each) for each in (predicted, updated, innovations, nis, sigmas)))


def steady_sigma_s(noises: Noises, frames: int = 500) -> float:
    """Root of the predicted variance of S once it has settled."""
    return float(run(np.tile(published.START[:2], (frames, 1)), noises).sigmas[-1, 0])


def steady_gain_s(noises: Noises, frames: int = 500) -> float:
    """The gain of S on S once it has settled."""
    filter = one(noises)
    for _ in range(frames):
        filter.predict()
        filter.update(published.START[:2])
    return float(filter.K[0, 0])
