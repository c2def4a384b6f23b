# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the filter. Each function answers (the print's figure, ours)."""

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.following import rms
from survtrack.experiments.nashenda2011 import filters, gaps, listing, matrices, published, targets
from survtrack.experiments.nashenda2011.listing import ListingFilter
from survtrack.experiments.nashenda2011.sweep import SETTLED

Floats = NDArray[np.float64]

RUNS = 50
STILL = np.array([200.0, 100.0])  # a person who stands, px
SETTLE = 60  # frames until a filter has settled


def smallest_eigenvalue_of_r() -> tuple[float, float]:
    """Of R; below 0 it is no covariance."""
    return _eigenvalues(published.R)[0], _eigenvalues(filters.RIGHT_R)[0]


def largest_eigenvalue_of_r() -> tuple[float, float]:
    """Of R."""
    return _eigenvalues(published.R)[1], _eigenvalues(filters.RIGHT_R)[1]


def _eigenvalues(R: Floats) -> tuple[float, float]:
    low, high = np.linalg.eigvalsh(R)
    return float(low), float(high)


def refusal_of_r() -> str:
    """What the library says to the printed R."""
    try:
        survtrack.KalmanFilter(
            F=filters.transition(), H=filters.H, Q=np.eye(4), R=published.R, x=4 * [0], P=np.eye(4)
        )
    except survtrack.InputError as error:
        return str(error)
    raise AssertionError("R is no covariance, and was not refused")


def indefinite_innovations() -> tuple[float, float]:
    """Frames of 121 in which the innovation covariance at q = 1 has an eigenvalue below 0."""
    each = [matrices.smallest_eigenvalues(1.0, R) for R in (published.R, filters.RIGHT_R)]
    return float((each[0] < 0).sum()), float((each[1] < 0).sum())


def rms_of_q_1() -> tuple[float, float]:
    """Rms error of a coordinate at q = 1, steady target, no B u: only R differs, px."""
    truth = targets.steady(published.FRAMES)
    z = targets.measured(truth, RUNS, targets.SIGMA_PX, seed=11)
    port = ListingFilter(filters.MIDDLE, 1.0, runs=RUNS, R=published.R)
    answers = np.stack([port.step(row) for row in z]), filters.estimates(z, 1.0, "corrected")
    return rms((answers[0] - truth)[SETTLED:]), rms((answers[1] - truth)[SETTLED:])


def input_at_q_0() -> tuple[float, float]:
    """Error of y of one who stands, without noise, q = 0: after 121 frames, px."""
    return _off_by_input(0.0, published.FRAMES)


def input_at_q_10() -> tuple[float, float]:
    """The same at q = 10."""
    return _off_by_input(10.0, published.FRAMES)


def input_in_y() -> tuple[float, float]:
    """Prediction of one who goes along x by the printed step, settled at q = 10: off in y, px."""
    port = ListingFilter(filters.MIDDLE, 10.0, control=published.INPUT)
    ours = filters.one(10.0, "corrected")
    for frame in range(SETTLE):
        x, y = published.ENTERS - (frame * published.STEP_PX, 0.0)
        at = port.predict()
        ours.predict([1.0])
        off = abs(float(at[0, 1] - y)), abs(float(ours.x[1] - y))
        port.update(np.array([[x, y]]))
        ours.update([x, y])
    return off


def _off_by_input(q: float, frames: int) -> tuple[float, float]:
    port = ListingFilter(filters.MIDDLE, q, control=published.INPUT)
    z = np.tile(STILL, (frames, 1, 1))
    for row in z:
        at = port.step(row)
    ours = filters.estimates(z, q, "corrected")[-1, 0]
    return abs(float(at[0, 1] - STILL[1])), abs(float(ours[1] - STILL[1]))


def skipped_at_q_0() -> tuple[float, float]:
    """Distance in the first frame after a gap of 2 at frame 93, without noise, q = 0, px."""
    return _skipped(0.0)


def skipped_at_q_100() -> tuple[float, float]:
    """The same at q = 100, which hides it."""
    return _skipped(100.0)


def _skipped(q: float) -> tuple[float, float]:
    row = gaps.HIDDEN_FROM - 1 + len(targets.WALK_HIDDEN)
    truth = targets.steady(row + 1)
    seen = gaps.hidden(truth, len(targets.WALK_HIDDEN))
    answers = gaps.skipping(seen, q)[row, 0], filters.estimates(seen, q, "corrected")[row, 0]
    off = [float(np.hypot(*(at - truth[row, 0]))) for at in answers]
    return off[0], off[1]


def start() -> tuple[float, float]:
    """Distance of the start from the middle of the frame, px."""
    at = listing.swapped_start(published.SIZE)
    return float(np.hypot(*np.subtract(at, filters.MIDDLE))), 0.0


def start_outside() -> tuple[float, float]:
    """How far below a frame of 1280x480 it is, px."""
    width, height = 1280, 480
    _, y = listing.swapped_start((width, height))
    return max(y - height, 0.0), max(height / 2 - height, 0.0)


def update_with_a_plus() -> tuple[float, float]:
    """Eq. 22's sign, with the gain put back: x of one who stands, from the truth, 5 frames on."""
    port = ListingFilter(filters.MIDDLE, 10.0, plus_sign=True)
    z = np.tile(STILL, (5, 1, 1))
    for row in z:
        at = port.step(row)
    ours = filters.estimates(z, 10.0, "corrected")[-1, 0]
    return abs(float(at[0, 0] - STILL[0])), abs(float(ours[0] - STILL[0]))


def refusal_of_eq_22() -> str:
    """What numpy says to eq. 22 as it is printed."""
    try:
        listing.printed_update(np.zeros(4), np.zeros(2))
    except ValueError as error:
        return str(error)
    raise AssertionError("4 numbers by 2 have no product, and it was not refused")


def ekf_ahead() -> tuple[float, float]:
    """Prediction of the extended filter from the true state, at the printed step: off by, px."""
    speed = published.STEP_PX / published.PERIOD_S
    state = np.array([*published.ENTERS, -speed, 0.0])

    def f(x: Floats) -> Floats:
        return np.asarray(filters.transition() @ x)

    ours = survtrack.ExtendedKalmanFilter(
        f=f, h=lambda x: x[:2], Q=np.eye(4), R=filters.RIGHT_R, x=state, P=np.eye(4)
    )
    ours.predict()
    true = state[0] - published.STEP_PX
    return abs(float(listing.printed_ekf_prediction(f, state)[0] - true)), abs(ours.x[0] - true)


def misprint() -> tuple[float, float]:
    """Row 4, column 1 of P- at q = 10."""
    [one] = [each for each in matrices.compare() if each.misprint is not None]
    assert one.misprint is not None
    return one.misprint


def truth_is_the_measurement() -> tuple[float, float]:
    """Rms of a coordinate at q = 100, in parts of that at q = 0: to the measurement, to the truth.

    Below 1 the higher q is better.
    """
    truth = targets.steady(published.FRAMES)
    z = targets.measured(truth, RUNS, targets.SIGMA_PX, seed=12)
    low, high = (filters.estimates(z, q, "corrected") for q in (0.0, 100.0))
    parts = [rms((high - to)[SETTLED:]) / rms((low - to)[SETTLED:]) for to in (z, truth)]
    return parts[0], parts[1]
