# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Simulated targets, whose truth is known: a steady one, one that manoeuvres, a walk in a room."""

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.nashenda2011 import published

Floats = NDArray[np.float64]

START = np.array([374.0, 274.0])  # px; about where the dissertation's person is judged
VELOCITY = np.array([-8.0, -1.5])  # px/s: some 300 px in 121 frames
HOLD_FRAMES = 8  # that an acceleration lasts, about 2 s
SIGMA_PX = 2.0  # of each coordinate

# The walk: x and y (px) at these frames, straight between them. It turns at frame 11 and then goes
# by the printed step, as in figures 14 to 18; it comes in at frame 6 and is hidden at 93 and 94.
WALK_FROM, WALK_TURN, WALK_HIDDEN = 6, 11, (93, 94)
_FRAMES = (6, 11, 23, 45, 70, 90, 121)
_X = (334.6, 374.4, 374.4 - 12 * published.STEP_PX, 200.0, 150.0, 210.0, 330.0)
_Y = (282.0, 275.0, 262.0, 235.0, 190.0, 160.0, 175.0)


def steady(frames: int) -> Floats:
    """(frames, 1, 2) positions at constant velocity, px; one truth for all runs."""
    times = published.PERIOD_S * np.arange(frames)[:, None]
    return np.asarray((START + times * VELOCITY)[:, None])


def manoeuvring(frames: int, runs: int, acceleration: float, seed: int) -> Floats:
    """(frames, runs, 2) positions, px: the steady target, pushed to and fro.

    Four pushes of HOLD_FRAMES each, along d, -d, -d and d, leave place and velocity as they were,
    so that it stays about the steady one's way; then another d is drawn.

    Args:
        frames, runs: how many.
        acceleration: px/s^2.
        seed: of the directions, and of where in its four pushes a run begins; the same whatever the
            acceleration.
    """
    dt, cycle = published.PERIOD_S, 4 * HOLD_FRAMES
    random = np.random.default_rng(seed)
    angles = random.uniform(0, 2 * np.pi, (frames // cycle + 2, runs))
    begun = random.integers(0, cycle, runs)
    each = acceleration * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    signs = np.repeat((1.0, -1.0, -1.0, 1.0), HOLD_FRAMES)
    held = np.concatenate([signs[:, None, None] * direction for direction in each])
    gained = np.cumsum(held * dt, axis=0)  # the velocity at the end of each frame
    moved = np.cumsum(gained * dt - held * dt * dt / 2, axis=0)
    away = np.stack([moved[first : first + frames, run] for run, first in enumerate(begun)], axis=1)
    return np.asarray(steady(frames) + away - away[:1])


def measured(truth: Floats, runs: int, sigma_px: float, seed: int) -> Floats:
    """(T, runs, 2) the truth with Gaussian noise in each coordinate, px."""
    noise = np.random.default_rng(seed).standard_normal((len(truth), runs, 2))
    return np.asarray(truth + sigma_px * noise)


def walk() -> tuple[NDArray[np.int64], Floats]:
    """Frames WALK_FROM to 121, and (T, 2) the true positions in them, px."""
    frames = np.arange(WALK_FROM, published.FRAMES + 1)
    return frames, np.stack([np.interp(frames, _FRAMES, each) for each in (_X, _Y)], axis=1)
