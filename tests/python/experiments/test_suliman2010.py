# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The marker that waits (figure 7), the centroid beside the estimate, and eq. 6."""

import numpy as np
import pytest

import survtrack
from survtrack.experiments.following import of_masks, of_video
from survtrack.experiments.suliman2010 import scenes
from survtrack.experiments.suliman2010.errata import measure_eq6


@pytest.mark.parametrize("run", [of_masks, of_video])
def test_the_marker_is_given_to_the_contact_again(run) -> None:  # type: ignore[no-untyped-def]
    scene = scenes.reentry_scene()
    one = scenes.reenter(scene, run(scene, survtrack.preset("suliman2010")))
    assert one.track_ids == {1}
    assert one.back - one.left == 53
    assert one.given_again_after is not None and one.given_again_after <= 5
    assert one.share(after=False) > 0.8
    assert one.share(after=True) > 0.9
    # Kept while it is away, and not reported where it cannot be.
    away = (one.indices >= one.left) & (one.indices < one.back)
    assert not np.isfinite(one.markers[away][-1]).any()


def test_a_contact_that_ends_for_good_is_given_to_nobody() -> None:
    """The same by semko2007: its contact ends, and what comes back is another."""
    scene = scenes.reentry_scene()
    one = scenes.reenter(scene, of_masks(scene, survtrack.preset("semko2007")))
    assert len(one.track_ids) == 2


def test_the_centroid_and_the_estimate_are_compared_in_the_same_frames() -> None:
    [trial, *_] = scenes.scenes()
    figures, errors = scenes.compare(
        trial.scene, of_video(trial.scene, survtrack.preset("suliman2010"))
    )
    assert figures.frames == len(errors) > 100
    assert figures.centroid_px == pytest.approx(np.sqrt(np.mean(errors[:, 1] ** 2)))
    assert figures.estimate_px == pytest.approx(np.sqrt(np.mean(errors[:, 2] ** 2)))
    # Half a frame of the flow, and one of the median of three masks.
    assert figures.centroid_lag == pytest.approx(1.5, abs=0.2)
    assert figures.estimate_lag == pytest.approx(figures.centroid_lag, abs=0.1)


def test_eq_6_has_seven_rows_for_six_states_and_the_library_six() -> None:
    eq6 = measure_eq6()
    assert (eq6.printed_shape, eq6.printed_states) == ((7, 6), 5)
    assert "mismatch" in eq6.refusal
    assert (eq6.states, eq6.covariance_shape) == (6, (6, 6))
