# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How long a step of many Kalman filters takes: constant velocity in x and y, positions measured.

The contenders compute the same: a bank, numpy over all tracks, a filter object a track.
"""

import warnings
from collections.abc import Callable
from statistics import median
from time import thread_time
from typing import Any

import numpy as np

import survtrack

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import filterpy.kalman

TRACKS = 1000
OURS = "survtrack.KalmanBank"
COMPONENTS = "numpy, component by component"
ROWS = "numpy, by rows, not in Joseph's form"
MATRICES = "numpy, stacked matrices"
OBJECTS = "survtrack.KalmanFilter, a loop"
FILTERPY = "filterpy, a loop"
# Steps a round: each contender takes some tens of milliseconds.
STEPS = {OURS: 500, COMPONENTS: 50, ROWS: 50, MATRICES: 20, OBJECTS: 5, FILTERPY: 1}

Numbers = np.ndarray[Any, np.dtype[np.float64]]
Step = Callable[[Numbers], Numbers]

F = np.eye(4) + np.eye(4, k=2)
H = np.eye(2, 4)
Q = survtrack.continuous_white_noise(2, 1.0, 0.1, axes=2, order="by_derivative")
R = np.array([[2.0, 0.5], [0.5, 1.0]])
P0 = 10 * np.eye(4)


def our_bank() -> Step:
    bank = survtrack.KalmanBank(F, H, Q, R, np.zeros((TRACKS, 4)), P0)

    def step(z: Numbers) -> Numbers:
        bank.predict()
        bank.update(z)
        return bank.states

    return step


def numpy_components() -> Step:
    """The same by hand for this model, an array a component: what F and H leave out is left out."""
    x, y, vx, vy = (np.zeros(TRACKS) for _ in range(4))
    P = {(i, j): np.full(TRACKS, P0[i, j]) for i in range(4) for j in range(i, 4)}

    def step(z: Numbers) -> Numbers:
        nonlocal x, y, vx, vy, P
        x, y = x + vx, y + vy
        p = {
            (0, 0): P[0, 0] + 2 * P[0, 2] + P[2, 2] + Q[0, 0],
            (0, 1): P[0, 1] + P[0, 3] + P[1, 2] + P[2, 3],
            (0, 2): P[0, 2] + P[2, 2] + Q[0, 2],
            (0, 3): P[0, 3] + P[2, 3],
            (1, 1): P[1, 1] + 2 * P[1, 3] + P[3, 3] + Q[1, 1],
            (1, 2): P[1, 2] + P[2, 3],
            (1, 3): P[1, 3] + P[3, 3] + Q[1, 3],
            (2, 2): P[2, 2] + Q[2, 2],
            (2, 3): P[2, 3],
            (3, 3): P[3, 3] + Q[3, 3],
        }
        a, b, c = p[0, 0] + R[0, 0], p[0, 1] + R[0, 1], p[1, 1] + R[1, 1]  # S
        scale = 1 / (a * c - b * b)
        a, b, c = c * scale, -b * scale, a * scale  # S^-1
        across = {(i, j): p[min(i, j), max(i, j)] for i in range(4) for j in range(4)}
        k = [
            (across[i, 0] * a + across[i, 1] * b, across[i, 0] * b + across[i, 1] * c)
            for i in range(4)
        ]
        y0, y1 = z[:, 0] - x, z[:, 1] - y
        nis = y0 * (a * y0 + b * y1) + y1 * (b * y0 + c * y1)
        x, y = x + k[0][0] * y0 + k[0][1] * y1, y + k[1][0] * y0 + k[1][1] * y1
        vx, vy = vx + k[2][0] * y0 + k[2][1] * y1, vy + k[3][0] * y0 + k[3][1] * y1
        # Joseph's form: (I - K H) P (I - K H)' + K R K'.
        left = {
            (i, j): across[i, j] - k[i][0] * across[0, j] - k[i][1] * across[1, j]
            for i in range(4)
            for j in range(4)
        }
        kr = [(k0 * R[0, 0] + k1 * R[1, 0], k0 * R[0, 1] + k1 * R[1, 1]) for k0, k1 in k]
        P = {
            (i, j): left[i, j]
            + (kr[i][0] - left[i, 0]) * k[j][0]
            + (kr[i][1] - left[i, 1]) * k[j][1]
            for i in range(4)
            for j in range(i, 4)
        }
        assert len(nis) == TRACKS
        return np.stack([x, y, vx, vy], axis=1)

    return step


def numpy_rows() -> Step:
    """Fewer and longer operations, and less work: no Joseph's form, no NIS."""
    x = np.zeros((4, TRACKS))
    P = np.repeat(P0[:, :, None], TRACKS, axis=2)

    def step(z: Numbers) -> Numbers:
        x[:2] += x[2:]
        P[:2] += P[2:]  # F P
        P[:, :2] += P[:, 2:]  # (F P) F'
        for i, j in np.argwhere(Q):
            P[i, j] += Q[i, j]
        a, b, c = P[0, 0] + R[0, 0], P[0, 1] + R[0, 1], P[1, 1] + R[1, 1]  # S
        determinant = a * c - b * b
        k0 = (P[:, 0] * c - P[:, 1] * b) / determinant
        k1 = (P[:, 1] * a - P[:, 0] * b) / determinant
        x[:] += k0 * (z[:, 0] - x[0]) + k1 * (z[:, 1] - x[1])
        P[:] -= k0[:, None] * P[0] + k1[:, None] * P[1]  # (I - K H) P
        return x.T

    return step


def numpy_matrices() -> Step:
    x = np.zeros((TRACKS, 4, 1))
    P = np.repeat(P0[None], TRACKS, axis=0)

    def step(z: Numbers) -> Numbers:
        nonlocal x, P
        x = F @ x
        P = F @ P @ F.T + Q
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        x = x + K @ (z[:, :, None] - H @ x)
        P = P - K @ H @ P
        return x[:, :, 0]

    return step


def filter_objects() -> Step:
    model = {"F": F, "H": H, "Q": Q, "R": R, "x": np.zeros(4), "P": P0}
    filters = [survtrack.KalmanFilter(**model) for _ in range(TRACKS)]

    def step(z: Numbers) -> Numbers:
        for one, measured in zip(filters, z, strict=True):
            one.predict()
            one.update(measured)
        return np.array([one.x for one in filters])

    return step


def filterpy_objects() -> Step:
    filters = []
    for _ in range(TRACKS):
        one = filterpy.kalman.KalmanFilter(dim_x=4, dim_z=2)
        one.x, one.F, one.H, one.Q, one.R, one.P = np.zeros(4), F, H, Q, R, P0.copy()
        filters.append(one)

    def step(z: Numbers) -> Numbers:
        for one, measured in zip(filters, z, strict=True):
            one.predict()
            one.update(measured)
        return np.array([one.x for one in filters])

    return step


CONTENDERS = {
    OURS: our_bank,
    COMPONENTS: numpy_components,
    ROWS: numpy_rows,
    MATRICES: numpy_matrices,
    OBJECTS: filter_objects,
    FILTERPY: filterpy_objects,
}


def measurements(steps: int) -> Numbers:
    """steps x TRACKS x 2: every track with a velocity of its own."""
    random = np.random.default_rng(8)
    velocities = random.normal(size=(TRACKS, 2))
    times = np.arange(1, steps + 1)[:, None, None]
    return times * velocities + random.normal(size=(steps, TRACKS, 2))


def check() -> None:
    """Refuses contenders that do not compute the same."""
    first = our_bank()
    others = [make() for name, make in CONTENDERS.items() if name != OURS]
    for z in measurements(5):
        states = first(z)
        for other in others:
            assert np.abs(other(z) - states).max() < 1e-9, "the contenders do not compute the same"


def measure(rounds: int) -> list[dict[str, Any]]:
    """A row a contender: median processor times of a step of all tracks, and ratios to ours."""
    check()
    taken: dict[str, list[float]] = {name: [] for name in CONTENDERS}
    film = measurements(max(STEPS.values()))
    for done in range(rounds + 1):
        for name, make in CONTENDERS.items():
            step = make()
            began = thread_time()
            for z in film[: STEPS[name]]:
                step(z)
            if done > 0:  # the first round warms up
                taken[name].append((thread_time() - began) / STEPS[name])
    return [
        {
            "what": name,
            "us_a_step": 1e6 * median(seconds),
            "us_fastest_round": 1e6 * min(seconds),
            "ns_a_track": 1e9 * median(seconds) / TRACKS,
            "ratio_to_ours": median(seconds) / median(taken[OURS]),
        }
        for name, seconds in taken.items()
    ]
