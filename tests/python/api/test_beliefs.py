# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The belief matrix (Narayana 2007, 8) as results show it."""

from typing import Any

import numpy as np
import pytest

import survtrack
from survtrack import BeliefOptions, ConfigError, Detections, EventKind, InputError, Tracker

Boxes = list[list[float]]


def tracker_of(**options: Any) -> Tracker:
    """A track a blob at once, matched by beliefs."""
    config = survtrack.Config(
        time_unit_s=0.1,
        filter=survtrack.MeanVelocityOptions(),
        measurement=survtrack.CentroidOptions(),
        cost=BeliefOptions(**options),
        assignment=survtrack.OldestFirstOptions(),
        lifecycle=survtrack.LostCountOptions(),
        outputs=survtrack.OutputOptions(cost_matrix=True),
    )
    return Tracker(config)


def fed(tracker: Tracker, frames: list[Boxes]) -> list[survtrack.TrackingResult]:
    return [
        tracker.process(Detections(boxes, k / 10, index=k, frame_size=(320, 240)))
        for k, boxes in enumerate(frames)
    ]


def boxes_at(*lefts: float) -> Boxes:
    return [[left, 100, 12, 12] for left in lefts]


def test_beliefs_are_tracks_by_detections_and_lost() -> None:
    first, second, empty = fed(tracker_of(), [boxes_at(50, 150), boxes_at(52, 148, 250), []])
    assert first.matrix_track_ids == []
    assert second.matrix_track_ids == [1, 2]
    assert second.beliefs is not None and second.costs is not None
    assert second.beliefs.shape == (2, 4) and second.beliefs.dtype == np.float64
    assert second.costs.shape == (2, 3)
    assert second.beliefs.argmax(axis=1).tolist() == [0, 1]
    accepted = np.isfinite(second.costs)
    assert np.array_equal(accepted, second.beliefs[:, :-1] > second.beliefs[:, -1:])
    assert second.costs[accepted] == pytest.approx(1 - second.beliefs[:, :-1][accepted])
    assert empty.matrix_track_ids == [1, 2, 3]
    assert empty.beliefs is not None and np.array_equal(empty.beliefs, np.ones((3, 1)))


@pytest.mark.parametrize("order", ["free", "published"])
@pytest.mark.parametrize("color_space", ["bgr", "hsv", "lab"])
def test_rows_sum_to_one(order: str, color_space: str) -> None:
    random = np.random.default_rng(4)
    frames = [
        np.column_stack([random.uniform(0, 300, (n, 2)), random.uniform(1, 40, (n, 2))]).tolist()
        for n in random.integers(0, 7, 40)
    ]
    tracker = tracker_of(
        order=order,
        color_space=color_space,
        velocity_break_point=10.0,
        size_weight=30.0,
        learn_after=20,
    )
    for boxes, result in zip(frames, fed(tracker, frames), strict=True):
        if result.beliefs is None:
            assert not result.matrix_track_ids
            continue
        assert result.beliefs.shape == (len(result.matrix_track_ids), len(boxes) + 1)
        assert (result.beliefs >= 0).all() and (result.beliefs <= 1).all()
        assert result.beliefs.sum(axis=1) == pytest.approx(1, abs=1e-12)


def test_other_costs_have_no_beliefs() -> None:
    config = survtrack.Config(outputs=survtrack.OutputOptions(cost_matrix=True))
    for result in fed(Tracker(config), [boxes_at(50 + 3 * k) for k in range(10)]):
        assert result.beliefs is None
    assert result.costs is not None and result.matrix_track_ids == [1]


def test_tracks_that_walk_into_one_blob_converge_once() -> None:
    apart = [boxes_at(150 - d, 150 + d) for d in (22, 16, 10)]
    results = fed(tracker_of(), [*apart, boxes_at(150), boxes_at(150)])
    met = [event for one in results for event in one.events if event.kind == EventKind.converged]
    (event,) = met
    assert (event.index, event.track_id, event.other_track_ids) == (3, 1, [2])
    assert event.text == "tracks 1 and 2 met in one blob"
    assert event.position == (156, 106)


def test_a_frame_of_unknown_size_is_refused_and_keeps_the_state() -> None:
    tracker, quiet = tracker_of(), tracker_of()
    with pytest.raises(InputError, match=r"^detections\.frame_size: is not known.*expected"):
        tracker.process(boxes_at(50), 0.0)
    frames = [boxes_at(50 + k) for k in range(5)]
    for one, other in zip(fed(tracker, frames), fed(quiet, frames), strict=True):
        assert [track.position for track in one.tracks] == [t.position for t in other.tracks]


def test_wrong_options_are_named() -> None:
    for option, value, allowed in (
        ("order", "first", "free, published"),
        ("color_space", "rgb", "bgr, hsv, lab"),
    ):
        with pytest.raises(ConfigError, match=f'{option}: "{value}" .*one of: {allowed}'):
            BeliefOptions(**{option: value})
    with pytest.raises(ConfigError, match=r"color_weight: -1.* is not allowed; expected between"):
        BeliefOptions(color_weight=-1)
