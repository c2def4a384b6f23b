# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The tracker alone, on boxes of any detector."""

import math
from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import PRESETS, rows
from survtrack import Detections, EventKind, InputError, Tracker, TrackStatus

BOX = [10.0, 10.0, 20.0, 40.0]
ONE = ("suliman2010", "nashenda2011", "nashenda2011_published")  # one contact, kept for ever
OF_SEVERAL = [name for name in PRESETS if name not in ONE]


def walk(k: int) -> list[list[float]]:
    """Two people who pass each other."""
    return [[10 + 3.0 * k, 20, 20, 40], [300 - 3.0 * k, 90, 22, 44]]


def followed(preset: str, count: int = 60, **more: Any) -> list[survtrack.TrackingResult]:
    tracker = Tracker(survtrack.preset(preset))
    return [
        tracker.process(Detections(walk(k), k / 10, index=k, frame_size=(320, 240), **more))
        for k in range(count)
    ]


@pytest.mark.parametrize("preset", OF_SEVERAL)
def test_boxes_become_tracks(preset: str) -> None:
    results = followed(preset)
    for k, result in enumerate(results):
        assert (result.index, result.time_s) == (k, k / 10)
    for track, box in zip(results[-1].tracks, walk(59), strict=True):
        assert list(track.box) == pytest.approx(box, abs=0.5)
        assert track.status == TrackStatus.confirmed
        assert track.age_frames == 59 and track.matched_frames == 60
    assert [track.id for track in results[-1].tracks] == [1, 2]
    assert results[-1].tracks[0].velocity_px_per_s == pytest.approx((30, 0), abs=0.5)


@pytest.mark.parametrize("preset", PRESETS)
def test_arrays_and_detections_are_the_same(preset: str) -> None:
    config = survtrack.preset(preset)
    config.set("filter.model=kalman_cv")
    config.set("cost.model=gaussian")  # the others look at the frame's size
    config.set("blobs.merge.model=none")
    config.set("vicinity.model=none")
    by_array, by_detections, by_steps = Tracker(config), Tracker(config), Tracker(config)
    for k in range(30):
        one = by_array.process(np.array(walk(k), np.float32), k / 10)
        two = by_detections.process(Detections(walk(k), k / 10, index=k))
        by_steps.predict(k / 10)
        three = by_steps.update(Detections(walk(k), k / 10, index=k))
        assert rows(one.track_array) == rows(two.track_array) == rows(three.track_array)
        assert one.index == two.index == three.index == k


LAYOUTS: dict[str, Any] = {
    "list": [BOX],
    "tuple": (tuple(BOX),),
    "integers": np.array([BOX], np.int16),
    "float32": np.array([BOX], np.float32),
    "big-endian": np.array([BOX], ">f8"),
    "Fortran": np.asfortranarray([BOX]),
    "strided": np.tile(np.repeat(np.array([BOX]), 2, axis=1), (1, 1))[:, ::2],
    "backwards": np.array([BOX[::-1]])[:, ::-1],
    "read only": np.frombuffer(np.array([BOX]).tobytes()).reshape(1, 4),
}


@pytest.mark.parametrize("boxes", LAYOUTS.values(), ids=LAYOUTS)
def test_boxes_of_any_layout(boxes: Any) -> None:
    (candidate,) = Tracker().process(boxes, 0.0).tentative
    assert list(candidate.box) == BOX
    assert [list(one.box) for one in Detections(boxes, 0.0)] == [BOX]


NO_BOXES: dict[str, tuple[Any, str]] = {
    "one flat box": (BOX, r"boxes: is \(4,\); expected an Nx4 array of left, top, width, height"),
    "five columns": (np.zeros((2, 5)), r"boxes: is \(2, 5\); expected an Nx4"),
    "three axes": (np.ones((1, 1, 4)), r"boxes: is \(1, 1, 4\); expected"),
    "text": ("abc", "boxes: is no array; expected"),
    "words": ([["a", "b", "c", "d"]], "boxes: is no array; expected"),
    "None": (None, r"boxes: is \(\); expected"),
    "number": (5, r"boxes: is \(\); expected"),
    "ragged": ([[1, 2, 3], [1, 2, 3, 4]], "boxes: is no array; expected"),
    "objects": ([survtrack.Box(*BOX)], "boxes: is no array; expected"),
}


@pytest.mark.parametrize(("boxes", "message"), NO_BOXES.values(), ids=NO_BOXES)
def test_what_is_no_array_of_boxes_is_refused(boxes: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        Tracker().process(boxes, 0.0)
    with pytest.raises(InputError, match=f"^{message}"):
        Detections(boxes, 0.0)


BAD_BOXES = [
    *([math.nan, 1, 2, 3], [1, math.inf, 2, 3], [1, 2, -math.inf, 3], [1, 2, 3, math.nan]),
    *([1, 2, 0, 3], [1, 2, 3, -4], [1, 2, 1e-9, 4], [1e10, 2, 3, 4], [1, -1e300, 3, 4]),
    *([1, 2, 3, 1e12], [1, 2, 1e300, 1e300]),
]


@pytest.mark.parametrize("bad", BAD_BOXES, ids=str)
@pytest.mark.parametrize("preset", PRESETS)
def test_a_bad_box_is_named_and_keeps_the_state(bad: list[float], preset: str) -> None:
    tracker = Tracker(survtrack.preset(preset))
    for k, expected in enumerate(followed(preset, 20)):
        if k == 10:
            with pytest.raises(InputError, match=r"^detections\[1\]\.box: .* expected finite left"):
                tracker.process(Detections([BOX, bad], 1.0, frame_size=(320, 240)))
        detections = Detections(walk(k), k / 10, index=k, frame_size=(320, 240))
        assert rows(tracker.process(detections).track_array) == rows(expected.track_array)


@pytest.mark.parametrize("time_s", [0.5, 0.4, -1.0, math.nan, math.inf, -math.inf, 1e13])
def test_a_bad_time_is_named_and_keeps_the_state(time_s: float) -> None:
    tracker = Tracker()
    tracker.process([BOX], 0.5)
    for refused in (tracker.predict, lambda t: tracker.process([BOX], t)):
        with pytest.raises(InputError, match=r"^time_s: "):
            refused(time_s)
    assert tracker.process([BOX], 0.6).index == 1


def test_update_follows_predict_of_the_same_time() -> None:
    tracker = Tracker(survtrack.preset("narayana2007"))
    here = Detections([BOX], 1.0, frame_size=(320, 240))
    with pytest.raises(InputError, match=r"^detections\.time_s: 1 is not the time given to pre"):
        tracker.update(here)
    tracker.predict(1.0)
    with pytest.raises(InputError, match=r"^detections\.time_s: 1\.5"):
        tracker.update(Detections([BOX], 1.5, frame_size=(320, 240)))
    assert len(tracker.update(here).tracks) == 1
    with pytest.raises(InputError, match=r"^detections\.time_s: 1 "):
        tracker.update(here)
    with pytest.raises(InputError, match=r"^time_s: 1 does not come after 1"):
        tracker.process(here)


def test_the_expectation_is_where_tracks_will_be() -> None:
    tracker = Tracker()
    for k in range(40):
        tracker.process(walk(k), k / 10)
    expectation = tracker.predict(4.0)
    assert expectation.time_s == 4.0
    assert expectation.regions == expectation.keep == []
    for one, (x, y, width, height) in zip(expectation.tracks, walk(40), strict=True):
        assert one.confirmed and one.id in (1, 2)
        assert list(one.box) == pytest.approx([x, y, width, height], abs=0.5)
        assert one.position == pytest.approx((x + width / 2, y + height / 2), abs=0.5)
        assert one.lost_s == pytest.approx(0.1)
        assert np.linalg.eigvalsh(one.innovation_covariance_px2).min() > 0


@pytest.mark.parametrize("preset", OF_SEVERAL)
@pytest.mark.parametrize("nothing", [[], np.zeros((0, 4)), np.zeros((0, 4), np.float32)])
def test_many_frames_of_nothing(preset: str, nothing: Any) -> None:
    tracker = Tracker(survtrack.preset(preset))
    for k in range(12):
        tracker.process(Detections(walk(k), k / 10, frame_size=(320, 240)))
    results = [
        tracker.process(Detections(nothing, 2 + k / 10, frame_size=(320, 240))) for k in range(300)
    ]
    assert len(results[0].tracks) == 2
    assert not results[-1].tracks and not results[-1].tentative
    ended = [e.track_id for r in results for e in r.events if e.kind == EventKind.track_ended]
    assert ended == [1, 2]
    for k in range(14):
        result = tracker.process(Detections(walk(k), 40 + k / 10, frame_size=(320, 240)))
    assert [track.id for track in result.tracks] == [3, 4], "ids are not used again"


def test_reset_starts_ids_at_one() -> None:
    tracker = Tracker()
    for _ in range(2):
        results = [tracker.process(walk(k), k / 10) for k in range(20)]
        assert [track.id for track in results[-1].tracks] == [1, 2]
        assert [result.index for result in results] == list(range(20))
        tracker.reset()


def test_a_crowd_of_boxes() -> None:
    random = np.random.default_rng(3)
    places = np.column_stack([random.uniform(0, 1e4, (400, 2)), np.full((400, 2), 12.0)])
    tracker = Tracker()
    for k in range(12):
        result = tracker.process(places + np.array([k, 0, 0, 0]), k / 10)
    assert [track.id for track in result.tracks] == list(range(1, 401))
    assert all(track.matched_frames == 12 for track in result.tracks)


def test_boxes_far_apart_in_size_and_place_give_finite_numbers() -> None:
    tracker = Tracker()
    extremes = [[-9e8, 9e8, 9e8, 9e8], [0, 0, 0.001, 0.001], [1e-3, 0, 9e8, 0.001]]
    for k in range(20):
        result = tracker.process(extremes, k / 10)
    for name in result.track_array.dtype.names:
        assert np.isfinite(result.track_array[name]).all()


def test_the_cost_matrix_has_tracks_as_rows() -> None:
    tracker = Tracker(survtrack.Config(outputs=survtrack.OutputOptions(cost_matrix=True)))
    assert tracker.process([], 0.0).costs.shape == (0, 0)
    assert Tracker().process([], 0.0).costs is None
    for k in range(1, 20):
        result = tracker.process([*walk(k), [9000.0, 9000, 5, 5]], k / 10)
    assert result.costs.shape == (3, 3)
    assert np.isfinite(np.diag(result.costs)).all()
    assert np.isinf(result.costs).sum() == 6


def test_detections_keep_what_they_are_given() -> None:
    boxes = [[1, 2, 3, 4], [5, 6, 7, 8]]
    detections = Detections(
        boxes, 1.5, index=9, confidences=[0.5, 94], class_ids=[3, -2], frame_size=(640, 480)
    )
    assert (detections.time_s, detections.index, detections.frame_size) == (1.5, 9, (640, 480))
    assert [list(one.box) for one in detections] == boxes
    assert [one.position for one in detections] == [(2.5, 4.0), (8.5, 10.0)]
    assert [one.area_px for one in detections] == [12, 56]
    assert [(one.confidence, one.class_id) for one in detections] == [(0.5, 3), (94, -2)]
    assert detections.mask is None and detections.background is None
    assert detections.contours == detections.regions == detections.events == []
    plain = Detections(boxes, 0.0)
    assert [(one.confidence, one.class_id) for one in plain] == [(1, -1)] * 2
    assert (plain.index, plain.frame_size) == (0, (0, 0))


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"confidences": [0.5]}, "confidences: expected 2 numbers, one a box"),
        ({"confidences": 0.5}, "confidences: expected 2 numbers"),
        ({"confidences": [[0.5], [0.5]]}, "confidences: expected 2 numbers"),
        ({"confidences": ["a", "b"]}, "confidences: expected 2 numbers"),
        ({"confidences": [0.5, math.nan]}, "confidences: .*finite"),
        ({"confidences": [0.5, math.inf]}, "confidences: .*finite"),
        ({"class_ids": [1, 2, 3]}, "class_ids: expected 2 numbers"),
        ({"class_ids": [1, 2.5]}, "class_ids: expected integers below 1e9"),
        ({"class_ids": [1, math.nan]}, "class_ids: expected integers"),
        ({"class_ids": [1, 1e10]}, "class_ids: expected integers below 1e9"),
        ({"frame_size": (-1, 5)}, r"frame_size: \(-1, 5\) is not allowed"),
    ],
)
def test_refused_columns_are_named(more: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        Detections([BOX, BOX], 0.0, **more)
