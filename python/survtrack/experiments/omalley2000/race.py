# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A simulated race: one car in its slot on a closed track, measured in the image."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import published

Floats = NDArray[np.float64]

SIZE = (640, 480)
POINTS = (
    (120, 100), (320, 70), (520, 100), (580, 240), (520, 380), (320, 410), (120, 380), (60, 240),
)  # fmt: skip
SIGMA_PX = 2.0  # of each image coordinate of a measurement
SWING = 0.4  # the car is faster and slower by this part of its speed
STEPS = 100  # of the integration, a frame


@dataclass(frozen=True, eq=False)
class Race:
    """Where the car is and where it is measured, in the track's unit.

    Attributes:
        times_s: (N,).
        truth: (N, 4) S in [0, l), T, vS, vT.
        measured: (N, 2) S in [0, l) and T.
        unit_px: the track's unit in px.
    """

    times_s: Floats
    truth: Floats
    measured: Floats
    unit_px: float


def track() -> survtrack.Path:
    """The middle of the track in the image."""
    return survtrack.Path(POINTS, closed=True, kind="curve")


def race(frames: int = published.DATAPOINTS, seed: int = 0) -> Race:
    """Made from its values and the seed alone.

    The car stays in its slot, T = 1.83. True places are put into the image, measured there with
    Gaussian noise, and put back on the path: S and T have the noise that an image gives them.
    """
    path = track()
    unit_px = path.length_px / published.LENGTH
    s, speed = _driven(frames)
    t = np.full(frames, published.START[1])
    noise = np.random.default_rng(seed).standard_normal((frames, 2))
    places = path.to_image(unit_px * np.stack([s, t], axis=1)) + SIGMA_PX * noise
    measured = path.to_path(places) / unit_px
    truth = np.stack([s, t, speed, np.zeros(frames)], axis=1)
    times_s = np.arange(1, frames + 1, dtype=np.float64) * published.PERIOD_S
    return Race(times_s, truth, measured, unit_px)


def speed_at(s: Floats | float) -> Floats:
    """The printed 77 units/s at the start, faster and slower twice a lap."""
    turns = 4 * np.pi * np.asarray(s) / published.LENGTH
    return np.asarray(published.START[2] * (1 + SWING * np.sin(turns)))


def _driven(frames: int) -> tuple[Floats, Floats]:
    """(N,) S in [0, l) and its rate, from a frame after the printed start; midpoint rule."""
    step_s = published.PERIOD_S / STEPS
    s = float(published.START[0])
    places = np.empty(frames)
    for frame in range(frames):
        for _ in range(STEPS):
            middle = s + step_s / 2 * float(speed_at(s))
            s += step_s * float(speed_at(middle))
        places[frame] = s
    return np.mod(places, published.LENGTH), speed_at(places)
