# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Patterns in memory, as Python sees them; more of what is learned and judged is in C++."""

import copy

import numpy as np
import pytest

import survtrack
from streets import EAST, JAYWALKER, NORTH, SOUTH, USUAL, WEST, history_of
from survtrack import ActivityKind


@pytest.fixture(scope="module")
def learned() -> survtrack.Patterns:
    return survtrack.learn_patterns(history_of(USUAL))


def test_two_streets_are_four_ways(learned: survtrack.Patterns) -> None:
    assert len(learned) == 4
    assert [pattern.id for pattern in learned.patterns] == [1, 2, 3, 4]
    assert [pattern.count for pattern in learned.patterns] == [6, 5, 4, 3]
    for pattern, (start, end) in zip(learned.patterns, (EAST, WEST, SOUTH, NORTH), strict=True):
        assert pattern.way == pytest.approx(np.linspace(start, end, 16))
        assert (pattern.enters, pattern.leaves) == (pytest.approx(start), pytest.approx(end))
        assert pattern.spread_px == pytest.approx(np.zeros(16), abs=1e-9)
        assert pattern.size_px == pytest.approx(40)
        assert pattern.speed_px_per_s == pytest.approx(40)
        assert pattern.speed_deviation_px_per_s == pytest.approx(0, abs=1e-9)
        assert pattern.time_s == pytest.approx(np.linspace(0, pattern.duration_s, 16))
        assert pattern.duration_s == pytest.approx(np.hypot(*np.subtract(end, start)) / 40)
        assert pattern.duration_deviation_s == pytest.approx(0, abs=1e-9)
    assert repr(learned.patterns[0]) == "Pattern(id=1, count=6)"
    assert repr(learned) == "Patterns(4 patterns)"


def test_each_track_is_judged_with_the_numbers_that_decided(learned: survtrack.Patterns) -> None:
    part, standing = ((100, 200), (260, 200)), ((300, 300), (340, 300))
    history = history_of([EAST, JAYWALKER, EAST, part, standing], speeds=[40, 40, 80])
    usual, jaywalker, fast, partial, stands = learned.classify(history)
    assert (usual.track_id, usual.kind, usual.pattern, usual.partial) == (
        1,
        ActivityKind.usual,
        1,
        False,
    )
    assert usual.distance == pytest.approx(0, abs=1e-9)
    assert usual.speed_ratio == pytest.approx(1)
    assert not usual.unusual
    assert (jaywalker.kind, jaywalker.unusual) == (ActivityKind.other_way, True)
    assert (jaywalker.pattern, jaywalker.speed_ratio) == (None, None)
    assert jaywalker.distance > 1.5
    assert (fast.kind, fast.unusual, fast.pattern) == (ActivityKind.too_fast, True, 1)
    assert (fast.speed_px_per_s, fast.speed_ratio) == (pytest.approx(80), pytest.approx(2))
    assert (partial.kind, partial.partial, partial.pattern) == (ActivityKind.usual, True, 1)
    assert (stands.kind, stands.unusual) == (ActivityKind.standing, False)
    assert (stands.distance, stands.angle_deg) == (None, None)
    assert repr(fast) == "Activity(track_id=3, kind=too_fast, pattern=1)"
    assert repr(stands) == "Activity(track_id=5, kind=standing, pattern=None)"


def test_a_track_under_way_is_judged_by_what_there_is_of_it(learned: survtrack.Patterns) -> None:
    recorder = survtrack.HistoryRecorder()
    tracker = survtrack.Tracker(survtrack.preset())
    for k in range(50):
        recorder.add(tracker.process([[30.0 + 4 * k, 160, 20, 80]], time_s=k / 10))
    [activity] = learned.classify(recorder.history)
    assert (activity.kind, activity.pattern, activity.partial) == (ActivityKind.usual, 1, True)


def test_the_order_of_the_tracks_does_not_matter(learned: survtrack.Patterns) -> None:
    array = history_of(USUAL).array
    random = np.random.default_rng(3)
    for _ in range(5):
        rows = random.permutation(len(array))
        mixed = array[rows]
        history = survtrack.History.from_columns(
            ids=mixed["id"],
            indices=mixed["index"],
            times_s=mixed["time_s"],
            boxes=np.column_stack([mixed[name] for name in ("x", "y", "width", "height")]),
        )
        assert survtrack.learn_patterns(history) == learned


def test_saved_and_loaded_are_equal(learned: survtrack.Patterns) -> None:
    loaded = survtrack.Patterns.from_json(learned.to_json())
    assert loaded == learned
    assert loaded.options == survtrack.PatternOptions()
    assert loaded.frame_size is None
    loaded.frame_size = (640, 480)
    assert loaded != learned
    again = survtrack.Patterns.from_json(loaded.to_json())
    assert again.frame_size == (640, 480)
    assert again != "patterns"


def test_options_are_those_given(learned: survtrack.Patterns) -> None:
    options = survtrack.PatternOptions(min_tracks=5, points=8)
    assert options == copy.deepcopy(options) != survtrack.PatternOptions()
    few = survtrack.learn_patterns(history_of(USUAL), options)
    assert [pattern.count for pattern in few.patterns] == [6, 5]
    assert few.patterns[0].way.shape == (8, 2)
    assert few.options == options
    other = survtrack.Patterns.from_json(learned.to_json())
    other.options = survtrack.PatternOptions(max_speed_deviations=20)
    [fast] = other.classify(history_of([EAST], speeds=[80]))
    assert fast.kind == ActivityKind.usual


def test_nothing_is_learned_from_nothing() -> None:
    nothing = survtrack.learn_patterns(survtrack.History())
    assert len(nothing) == 0
    assert nothing.classify(survtrack.History()) == []
    [activity] = nothing.classify(history_of([EAST]))
    assert (activity.kind, activity.distance) == (ActivityKind.other_way, None)


@pytest.mark.parametrize(
    ("keywords", "words"),
    [
        ({"points": 3}, "PatternOptions.points: 3 is not allowed; expected between 4 and 256"),
        ({"min_travel": 0}, "PatternOptions.min_travel: 0 is not allowed"),
        ({"max_angle_deg": 181}, "PatternOptions.max_angle_deg: 181 is not allowed"),
        ({"max_distance": float("nan")}, "PatternOptions.max_distance: nan is not allowed"),
        ({"min_track": 1}, "PatternOptions.min_track: unknown option; one of: points"),
    ],
)
def test_options_that_are_wrong_are_named(keywords: dict[str, object], words: str) -> None:
    with pytest.raises(survtrack.ConfigError) as caught:
        survtrack.PatternOptions(**keywords)
    assert words in str(caught.value)


@pytest.mark.parametrize("size", [(0, 10), (10, -1), (10, 1_000_001)])
def test_a_frame_size_that_is_wrong_is_named(size: tuple[int, int]) -> None:
    patterns = survtrack.learn_patterns(survtrack.History())
    with pytest.raises(survtrack.InputError, match=r"^frame_size: \("):
        patterns.frame_size = size
    assert patterns.frame_size is None


def test_texts_that_are_no_patterns_are_refused() -> None:
    for text, words in {
        "": "^mine: is not JSON, at byte",
        "{}": '^mine: has no "options"',
        '{"options": {}, "patterns": 4}': r"^mine\.patterns: is not a list",
        '{"options": {}, "patterns": [{"id": 1}]}': r'^mine\.patterns\[0\]: has no "count"',
    }.items():
        with pytest.raises(survtrack.InputError, match=words):
            survtrack.Patterns.from_json(text, "mine")
