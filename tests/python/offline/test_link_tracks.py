# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Linking in memory: options, histories, results. What is joined is tested in C++."""

import copy
import pickle

import numpy as np
import pytest

import scenes
import survtrack
from clips import walking_square


def history_of(*spans: tuple[int, int, int], **more: object) -> survtrack.History:
    """Tracks (id, first, last) of one object that walks 4 px a frame, at ten frames a second."""
    ids = [track for track, first, last in spans for _ in range(first, last + 1)]
    frames = np.array([k for _, first, last in spans for k in range(first, last + 1)])
    boxes = np.array([[4.0 * k, 10, 20, 80] for k in frames]).reshape(-1, 4)
    return survtrack.History.from_columns(
        ids=ids, indices=frames, times_s=frames / 10, boxes=boxes, **more
    )


def test_joins_and_says_why() -> None:
    linked = survtrack.link_tracks(history_of((4, 0, 9), (2, 15, 24), (3, 60, 61)))
    [link] = linked.links
    assert (link.earlier_id, link.later_id) == (4, 2)
    assert link.gap_s == pytest.approx(0.6)
    assert link.distance == pytest.approx(0, abs=1e-9)
    assert link.speed_difference == pytest.approx(0, abs=1e-9)
    assert link.color_difference == 0
    assert link.cost == pytest.approx(0.05)
    [dropped] = linked.dropped
    assert (dropped.id, dropped.frames) == (3, 2)
    assert (dropped.duration_s, dropped.travel) == (pytest.approx(0.1), pytest.approx(0.1))
    assert len(linked.history) == 1
    assert set(linked.history.array["id"]) == {4}
    assert linked.history.array["index"].tolist() == [*range(10), *range(15, 25)]
    assert repr(link) == "Link(earlier_id=4, later_id=2, cost=0.05)"
    assert repr(dropped) == "DroppedTrack(id=3, frames=2)"


def test_options_are_those_given() -> None:
    history = history_of((1, 0, 9), (2, 15, 24))
    for options in (
        survtrack.LinkOptions(max_gap_s=0.5),
        survtrack.LinkOptions().replace(max_cost=0.01),
    ):
        assert survtrack.link_tracks(history, options).links == []
    nothing = survtrack.link_tracks(history, survtrack.LinkOptions(min_s=2.5))
    assert len(nothing.history) == 0
    assert [track.id for track in nothing.dropped] == [1]


def test_options_are_values() -> None:
    options = survtrack.LinkOptions(max_gap_s=2, min_frames=5)
    assert options.to_dict()["max_gap_s"] == 2.0
    assert options.min_frames == 5
    assert options == copy.deepcopy(options) == pickle.loads(pickle.dumps(options))
    assert options != survtrack.LinkOptions()
    assert "max_gap_s=2.0" in repr(options)
    with pytest.raises(AttributeError):
        options.max_gap_s = 3  # type: ignore[misc]


@pytest.mark.parametrize(
    ("keywords", "words"),
    [
        ({"max_gap_s": -1}, "LinkOptions.max_gap_s: -1 is not allowed; expected between 0"),
        ({"min_frames": 2.5}, "LinkOptions.min_frames: 2.5 is not allowed; expected an integer"),
        ({"max_cost": "low"}, 'LinkOptions.max_cost: "low" is not allowed'),
        ({"max_gap": 1}, "LinkOptions.max_gap: unknown option; one of: max_gap_s"),
    ],
)
def test_options_that_are_wrong_are_named(keywords: dict[str, object], words: str) -> None:
    with pytest.raises(survtrack.ConfigError) as caught:
        survtrack.LinkOptions(**keywords)
    assert words in str(caught.value)


def test_a_history_of_columns_is_what_its_array_says() -> None:
    random = np.random.default_rng(2)
    points = 30
    given = {
        "ids": random.permutation(np.repeat([3, 1, 2], 10)),
        "indices": np.arange(points),
        "times_s": np.arange(points) / 7,
        "boxes": random.uniform(1, 90, (points, 4)),
        "positions": random.uniform(1, 90, (points, 2)),
        "velocities_px_per_s": random.normal(0, 9, (points, 2)),
        "mean_colors": random.uniform(0, 255, (points, 3)),
    }
    array = survtrack.History.from_columns(**given).array
    array = array[np.argsort(array["index"])]
    assert array["id"].tolist() == given["ids"].tolist()
    assert array["time_s"].tolist() == given["times_s"].tolist()
    for name, fields in {
        "boxes": ("x", "y", "width", "height"),
        "positions": ("position_x", "position_y"),
        "velocities_px_per_s": ("velocity_x_px_per_s", "velocity_y_px_per_s"),
        "mean_colors": ("mean_blue", "mean_green", "mean_red"),
    }.items():
        assert (np.column_stack([array[field] for field in fields]) == given[name]).all()


def test_what_is_not_given_is_the_centre_and_nothing() -> None:
    history = history_of((1, 3, 3))
    assert history.array[0].tolist() == (1, 3, 0.3, 12, 10, 20, 80, 22, 50, 0, 0, 0, 0, 0)


def test_a_history_may_be_empty() -> None:
    for history in (survtrack.History(), history_of(), survtrack.HistoryRecorder().history):
        assert len(history) == len(history.array) == 0
        linked = survtrack.link_tracks(history)
        assert (len(linked.history), linked.links, linked.dropped) == (0, [], [])


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"indices": [0, 0]}, "track 5, frame index 0: comes after frame index 0"),
        ({"indices": [0, -1]}, "track 5, frame index -1: frames count from 0"),
        ({"indices": [0, 1.5]}, "indices[1]: 1.5 is not an integer"),
        ({"ids": [5, float("nan")]}, "ids[1]: nan is not an integer"),
        ({"times_s": [0.0, float("nan")]}, "track 5, frame index 1: time_s nan"),
        ({"times_s": [0.2, 0.1]}, "track 5, frame index 1: time_s 0.1 is not allowed"),
        ({"times_s": [0.0]}, "times_s: expected 2 numbers"),
        ({"boxes": [[0, 0, 5, 5]]}, "boxes: expected 2x4 numbers"),
        ({"boxes": [0, 0, 5, 5, 0, 0, 5, 5]}, "boxes: expected 2x4 numbers"),
        ({"boxes": "text"}, "boxes: expected 2x4 numbers"),
        ({"boxes": [[0, 0, 5, 5], [0, 0, 0, 5]]}, "frame index 1: box width and height (0, 5)"),
        ({"mean_colors": [[0, 0, 300], [0, 0, 0]]}, "frame index 0: mean_color (0, 0, 300)"),
    ],
)
def test_bad_columns_are_named(changed: dict[str, object], words: str) -> None:
    good = {"ids": [5, 5], "indices": [0, 1], "times_s": [0.0, 0.1], "boxes": [[0, 0, 5, 5]] * 2}
    with pytest.raises(survtrack.InputError) as caught:
        survtrack.History.from_columns(**{**good, **changed})
    assert words in str(caught.value)


def test_recording_a_run_keeps_its_reported_tracks() -> None:
    recorder = survtrack.HistoryRecorder()
    pipeline = survtrack.Pipeline(survtrack.preset())
    results = scenes.run(pipeline, scenes.scene())
    for result in results:
        recorder.add(result)
    expected = [
        (track.id, result.index, result.time_s, *track.box, *track.position, *track.mean_color)
        for result in results
        for track in result.tracks
        if track.reported
    ]
    array = recorder.history.array
    names = ("id", "index", "time_s", "x", "y", "width", "height", "position_x", "position_y")
    colors = ("mean_blue", "mean_green", "mean_red")
    assert array[[*names, *colors]].tolist() == expected
    assert expected


def test_recording_takes_a_trackers_results_too() -> None:
    recorder = survtrack.HistoryRecorder()
    tracker = survtrack.Tracker(survtrack.preset())
    for k in range(20):
        recorder.add(tracker.process([[10.0 + 4 * k, 20, 16, 32]], time_s=k / 10))
    assert len(recorder.history) == 1
    assert len(survtrack.link_tracks(recorder.history).history) == 1


def test_a_square_that_was_hidden_is_one_track() -> None:
    frames = walking_square(90, width=256, still=10)
    ground = frames[0]
    frames[50:60] = [ground] * 10
    config = survtrack.preset()
    config.set("lifecycle.max_lost_s=0.2")
    recorder = survtrack.HistoryRecorder()
    for _, result in survtrack.track(frames, config=config, fps=10):
        recorder.add(result)
    assert len(recorder.history) == 2
    linked = survtrack.link_tracks(recorder.history)
    assert len(linked.history) == 1
    assert [(link.earlier_id, link.later_id) for link in linked.links] == [(1, 2)]
