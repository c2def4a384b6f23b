# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A simulated race: one car in its slot on a closed track, measured in the image."""

import math
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


@dataclass(frozen=True)
class Drive:
    """Where a car starts and how fast it goes; without arguments as printed.

    Attributes:
        start: S, in the track's unit.
        speed: units/s, about which it is faster and slower twice a lap.
        swing: by which part of its speed.
        phase: of that, at S = 0; rad.
    """

    start: float = float(published.START[0])
    speed: float = float(published.START[2])
    swing: float = SWING
    phase: float = 0.0

    def speed_at(self, s: Floats | float) -> Floats:
        """Units/s at S."""
        turns = 4 * np.pi * np.asarray(s) / published.LENGTH
        return np.asarray(self.speed * (1 + self.swing * np.sin(turns + self.phase)))


PRINTED = Drive()


def drawn(seed: int) -> Drive:
    """A drive by its seed alone.

    It starts anywhere, goes the printed speed give or take a fifth, and swings by half to all of
    SWING, with its fastest place anywhere.
    """
    start, speed, swing, phase = np.random.default_rng(seed).uniform(size=4).tolist()
    return Drive(
        start * published.LENGTH,
        PRINTED.speed * (0.8 + 0.4 * speed),
        SWING * (0.5 + 0.5 * swing),
        2 * math.pi * phase,
    )


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


def race(frames: int = published.DATAPOINTS, seed: int = 0, drive: Drive = PRINTED) -> Race:
    """Made from its values and the seed of the noise alone.

    The car stays in its slot, T = 1.83. True places are put into the image, measured there with
    Gaussian noise, and put back on the path: S and T have the noise that an image gives them.
    """
    path = track()
    unit_px = path.length_px / published.LENGTH
    s, speed = _driven(frames, drive)
    t = np.full(frames, published.START[1])
    noise = np.random.default_rng(seed).standard_normal((frames, 2))
    places = path.to_image(unit_px * np.stack([s, t], axis=1)) + SIGMA_PX * noise
    measured = path.to_path(places) / unit_px
    truth = np.stack([s, t, speed, np.zeros(frames)], axis=1)
    times_s = np.arange(1, frames + 1, dtype=np.float64) * published.PERIOD_S
    return Race(times_s, truth, measured, unit_px)


def _driven(frames: int, drive: Drive) -> tuple[Floats, Floats]:
    """(N,) S in [0, l) and its rate, from a frame after the start; midpoint rule."""
    step_s = published.PERIOD_S / STEPS
    s = drive.start
    places = np.empty(frames)
    for frame in range(frames):
        for _ in range(STEPS):
            middle = s + step_s / 2 * float(drive.speed_at(s))
            s += step_s * float(drive.speed_at(middle))
        places[frame] = s
    return np.mod(places, published.LENGTH), drive.speed_at(places)
