# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The published trials, and each erratum: the fault in a port of the listing, and not in ours."""

import math

import numpy as np
import pytest

import survtrack
from survtrack.experiments.semko2007 import artificial, listing
from survtrack.experiments.semko2007.claims import event_after
from survtrack.experiments.semko2007.errata import ERRATA, Erratum, measure_errata
from survtrack.experiments.semko2007.trials import hidden, removed, trials


@pytest.fixture(scope="module")
def errata() -> dict[str, Erratum]:
    return {one.key: one for one in measure_errata()}


# What the listing's figure must be, and what ours: (lowest, highest) each.
EXPECTED = {
    # P doubles in every frame; the fixed point of the right recursion is near 9.
    "plus_sign_trace": ((1e30, math.inf), (5, 15)),
    # HK is I: the error is that of the measurement, the root of 2; seeds make it 2 % uncertain.
    "plus_sign_rms": ((1.38, 1.44), (1.2, 1.3)),
    "folded_exact": ((0, 1e-9), (0, 1e-3)),
    "folded_noise": ((1e-6, 0.1), (0, 1e-9)),
    # 12 frames at 2 px: it stands still.
    "own_estimate": ((20, 25), (0, 1e-6)),
    "own_estimate_variance": ((0, 1), (1000, math.inf)),
    "start": ((3, math.inf), (0, 0.1)),
    "start_rate": ((1e-4, 0.1), (0, 1e-9)),
    "twice": ((100, 250), (0, 2)),
    "stale": ((1, 1), (0, 0)),
    "newcomer": ((100, 200), (0, 0.1)),
    "newcomer_after": ((2, 2), (0, 0)),
    "not_permuted": ((100, math.inf), (1, 1.001)),
    "not_reset": ((0, 1), (9, 9)),
    "sums": ((0, 0), (2, 2)),
    "gained": ((0, 0), (2, 2)),
    "successive": ((2, 2), (0, 0)),
    "summed_marker": ((100, 150), (0, 0)),
    "more_than_13": ((14, 14), (13, 13)),
    "row_order": ((2, 2), (0, 0)),
    "markers": ((10, 10), (3, 3)),
}


def test_every_erratum_has_its_test() -> None:
    assert [key for key, *_ in ERRATA] == list(EXPECTED)


@pytest.mark.parametrize("key", EXPECTED)
def test_the_fault_is_in_the_port_and_not_in_ours(key: str, errata: dict[str, Erratum]) -> None:
    (low, high), (our_low, our_high) = EXPECTED[key]
    assert low <= errata[key].listing <= high
    assert our_low <= errata[key].ours <= our_high


def test_the_port_is_right_but_for_its_fault() -> None:
    """Without a fault it is the library's filter."""
    right = listing.ListingFilter((10.0, 20.0))
    options = survtrack.preset("semko2007").filter
    assert isinstance(options, survtrack.KalmanCaOptions)
    bank = survtrack.FilterBank(options)
    bank.add(10.0, 20.0)
    np.testing.assert_allclose(bank.state_covariance(0), right.P)
    for k, z in enumerate(np.random.default_rng(3).normal(50, 9, (20, 2))):
        missing = k % 5 == 4
        right.step(None if missing else z)
        bank.predict(1.0)
        bank.correct(np.full((1, 2), np.nan) if missing else z[None])
        np.testing.assert_allclose(bank.state(0), right.x, atol=1e-9)
        np.testing.assert_allclose(bank.state_covariance(0), right.P, atol=1e-9)


def test_the_index_loop_by_hand() -> None:
    filters = np.array([(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)])
    near = np.array([(1.0, 0.0), (2.0, 1.0), (1.0, 2.0)])
    # The second may not have the first's filter, the third may again.
    assert listing.nearest_not_successive(filters, near) == [0, 1, 0]
    given = listing.permuted_twice([2, 0, 1], near)
    assert {k: z.tolist() for k, z in given.items()} == {2: [2, 1], 0: [1, 2], 1: [1, 0]}
    assert listing.lost_by_sums(4, [1, 2, 4]) == 3
    assert listing.lost_by_sums(4, [1, 4]) == 5
    assert listing.frames_until_lost(20 * [1], 2, more_than=12) == 13
    assert listing.frames_until_lost(12 * [1] + 20 * [2], 2, more_than=12) is None
    losses = [(0, (1.0, 2.0)), (30, (10.0, 20.0))]
    assert listing.summed_marker(losses, 40).tolist() == [11, 22]
    assert listing.summed_marker(losses, 60).tolist() == [10, 20]


def test_trials_are_those_of_the_thesis() -> None:
    every = trials()
    assert [len(trial.scene.objects) for trial in every] == [1, 1, 1, 3, 3, 3]
    for trial in every:
        truth = trial.scene.truth()
        assert truth.outside.max() == 0
        speeds = np.hypot(*truth.velocities_px_per_s.T)
        headings = np.arctan2(*truth.velocities_px_per_s.T)
        turns = max(np.ptp(headings[truth.ids == id]) for id in set(truth.ids.tolist()))
        assert (np.ptp(speeds) > 1) == trial.key.endswith("speed")
        assert (turns > 0.1) == trial.key.endswith("direction")


@pytest.mark.parametrize("trial", trials(), ids=lambda trial: trial.key)
def test_the_norm_is_under_1_px_within_25_frames(trial: artificial.Trial) -> None:
    run = artificial.run_trial(trial, "masks")
    assert run.settled_after is not None and run.settled_after <= 25
    assert run.largest_px < 0.2
    assert run.ended == []
    noisy = artificial.run_trial(trial, "noise")
    assert 1.1 < noisy.rms_px < math.sqrt(2)
    assert noisy.ended == []


def test_a_removed_contact_raises_the_event_in_the_13th_frame_and_at_its_place() -> None:
    run = artificial.run_trial(removed(), "masks")
    assert event_after(run) == 13
    [event] = run.ended
    [gone] = [one for one in run.followed if one.id == 2]
    assert event.track_id == gone.track_id
    assert np.add(event.position, 0.5) == pytest.approx(gone.truth[-1], abs=0.2)
    assert event.place == survtrack.LostPlace.open
    # Until then it is predicted.
    assert run.paths[event.track_id][-1, 0] == event.index - 1


def test_twelve_frames_away_raise_none() -> None:
    assert artificial.run_trial(hidden(), "masks").ended == []


def test_through_the_flow_the_estimate_is_six_frames_late() -> None:
    run = artificial.run_trial(trials()[0], "flow")
    delay, bias, rest = run.lag
    assert delay == pytest.approx(6.0, abs=0.5)  # half of 10 frames, and one of the median of 3
    assert abs(bias) < 1
    assert rest < 3
    assert run.ended == []
