# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Results: what they hold, that their forms agree, and that nothing later changes them."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import PRESETS, answer, rows, run, scene
from survtrack import EventKind, Pipeline, TrackStatus

FRAMES = scene(60)
TRACK_FIELDS = [
    *("id", "status", "reported", "x", "y", "width", "height", "position_x", "position_y"),
    *("velocity_x_px_per_s", "velocity_y_px_per_s"),
    *("covariance_xx_px2", "covariance_xy_px2", "covariance_yy_px2"),
    *("detection", "age_frames", "matched_frames", "lost_frames", "group"),
]
DETECTION_FIELDS = [
    *("x", "y", "width", "height", "position_x", "position_y", "area_px"),
    *("mean_blue", "mean_green", "mean_red"),
    *("moment_xx_px2", "moment_xy_px2", "moment_yy_px2", "confidence", "class_id"),
]
INTEGERS = {
    "id": "i8",
    "status": "u1",
    "reported": "?",
    "group": "i8",
    **dict.fromkeys(("detection", "age_frames", "matched_frames", "lost_frames", "class_id"), "i4"),
}


@pytest.fixture(scope="module")
def results() -> list[survtrack.FrameResult]:
    """The square comes in frame 10 and is gone from frame 50."""
    empty = scene(10)
    return run(Pipeline(), FRAMES[:50] + empty)


def test_the_square_is_tracked(results: list[survtrack.FrameResult]) -> None:
    result = results[40]
    (track,) = result.tracks
    (detection,) = result.detections
    assert (result.index, result.time_s) == (40, 4.0)
    assert list(detection.box) == pytest.approx([4 + 2 * 30, 21, 14, 14], abs=2)
    assert list(track.box) == pytest.approx([4 + 2 * 30, 21, 14, 14], abs=2)
    assert track.position == pytest.approx((71.0, 28.0), abs=1)
    assert track.velocity_px_per_s == pytest.approx((20.0, 0.0), abs=1)
    assert detection.mean_color == pytest.approx((40, 200, 230), abs=20)
    assert (track.id, track.status, track.reported) == (1, TrackStatus.confirmed, True)
    assert (track.detection, track.lost_frames) == (0, 0)
    assert track.age_frames == track.end_index - track.start_index
    assert (track.end_index, track.end_time_s) == (40, 4.0)
    assert 10 <= track.start_index <= 12
    assert (track.start_time_s, track.matched_frames) == (
        track.start_index / 10,
        track.age_frames + 1,
    )


def test_the_mask_is_of_the_frame_before_blobs(results: list[survtrack.FrameResult]) -> None:
    for result in results:
        assert result.mask.shape == (64, 96) and result.mask.dtype == np.uint8
        assert set(np.unique(result.mask)) <= {0, 255}
        assert np.array_equal(result.mask, result.detections.mask)
        assert (result.detections.index, result.detections.time_s) == (result.index, result.time_s)
        assert result.detections.frame_size == (96, 64)
        (region,) = result.detections.regions
        assert list(region.box) == [0, 0, 96, 64] and region.kind.name == "whole_frame"
    (detection,) = results[40].detections
    x, y, width, height = (int(value) for value in detection.box)
    blob = results[40].mask[y : y + height, x : x + width] > 0
    assert np.count_nonzero(blob) == detection.area_px
    rows_down, columns_right = np.argwhere(blob).mean(axis=0)
    assert detection.position == pytest.approx((x + columns_right, y + rows_down))
    assert detection.mean_color == pytest.approx(
        tuple(results[40].frame[y : y + height, x : x + width][blob].mean(axis=0))
    )


def test_array_fields_have_documented_types(results: list[survtrack.FrameResult]) -> None:
    for names, array in (
        (TRACK_FIELDS, results[0].track_array),
        (DETECTION_FIELDS, results[0].detection_array),
    ):
        assert array.shape == (0,)
        assert list(array.dtype.names or ()) == names
        for name in names:
            assert array.dtype[name] == np.dtype(INTEGERS.get(name, "f8"))


def test_arrays_say_the_same_as_objects(results: list[survtrack.FrameResult]) -> None:
    for result in results:
        assert rows(result.detection_array) == rows(result.detections.array)
        assert len(result.detection_array) == len(result.detections)
        assert len(result.track_array) == len(result.tracks)
        for row, track in zip(result.track_array, result.tracks, strict=True):
            P = track.position_covariance_px2
            expected = (track.id, track.status.value, track.reported, *track.box, *track.position)
            expected += (*track.velocity_px_per_s, P[0, 0], P[0, 1], P[1, 1], track.detection)
            expected += (track.age_frames, track.matched_frames, track.lost_frames, track.group)
            assert tuple(row) == expected
            assert P.shape == (2, 2) and P[0, 1] == P[1, 0] and np.linalg.eigvalsh(P).min() > 0
            C = track.position_velocity_covariance_px2_per_s
            V = track.velocity_covariance_px2_per_s2
            assert np.linalg.eigvalsh(np.block([[P, C], [C.T, V]])).min() > 0
            assert (track.velocity_noise_px2_per_s3.diagonal() > 0).all()
        for row, one in zip(result.detection_array, result.detections, strict=True):
            M = one.moments_px2
            expected = (*one.box, *one.position, one.area_px, *one.mean_color)
            assert tuple(row) == (
                *expected,
                M[0, 0],
                M[0, 1],
                M[1, 1],
                one.confidence,
                one.class_id,
            )


def test_a_detections_object_is_a_sequence(results: list[survtrack.FrameResult]) -> None:
    detections = results[40].detections
    assert len(detections) == 1
    assert repr(detections[0]) == repr(detections[-1]) == repr(next(iter(detections)))
    for index in (1, -2):
        with pytest.raises(IndexError):
            detections[index]


def test_events_tell_the_life_of_a_track(results: list[survtrack.FrameResult]) -> None:
    events = [event for result in results for event in result.events if event.track_id]
    assert [event.kind for event in events[:2]] == [EventKind.track_started, EventKind.track_lost]
    for result in results:
        for event in result.events:
            assert (event.index, event.time_s) == (result.index, result.time_s)
            assert event.text
    started, lost = events[:2]
    assert (started.track_id, started.text, started.other_track_ids) == (1, "track 1 started", [])
    assert lost.index == 50
    (track,) = results[started.index].tracks
    assert (started.box, started.position) == (track.box, track.position)
    assert np.array_equal(started.position_covariance_px2, track.position_covariance_px2)
    assert not results[started.index - 1].tracks and results[started.index - 1].tentative
    (track,) = results[50].tracks
    assert (track.status, track.detection, track.lost_frames) == (TrackStatus.lost, -1, 1)


def test_a_track_ends_once_and_its_id_is_not_used_again() -> None:
    frames = scene(40) + 40 * scene(1) + scene(40)
    results = run(Pipeline(), frames)
    kinds = [event.kind for result in results for event in result.events if event.track_id == 1]
    assert kinds == [EventKind.track_started, EventKind.track_lost, EventKind.track_ended]
    closed = [r for r in results if any(t.status == TrackStatus.closed for t in r.tracks)]
    assert [r.index for r in closed] == [
        e.index for r in results for e in r.events if e.kind == EventKind.track_ended
    ][: len(closed)]
    assert {track.id for result in results for track in result.tracks} == {1, 2}


def test_matches_name_the_rows_of_tracks_and_detections(
    results: list[survtrack.FrameResult],
) -> None:
    for before, result in pairwise(results):
        for match in result.matches:
            assert 0 <= match.detection < len(result.detections)
            assert np.isfinite(match.cost)
            assert match.track_id in {0, *(track.id for track in before.tracks)}
    (match,) = results[40].matches
    assert (match.track_id, match.track, match.detection, match.assigned) == (1, 0, 0, True)


def test_nothing_costly_comes_unasked(results: list[survtrack.FrameResult]) -> None:
    for result in results:
        assert result.background is None and result.detections.background is None
        assert result.costs is None
        assert result.detections.contours == []


def test_outputs_that_are_asked_for() -> None:
    outputs = survtrack.OutputOptions(background=True, contours=True, cost_matrix=True)
    asked = run(Pipeline(survtrack.Config(outputs=outputs)), FRAMES[:50])
    assert answer(asked) == answer(run(Pipeline(), FRAMES[:50])), "extras change the answer"
    for result in asked:
        assert result.background is not None and result.background.shape == (64, 96, 3)
        assert np.array_equal(result.background, result.detections.background)
        assert len(result.detections.contours) == len(result.detections)
        for contour, detection in zip(result.detections.contours, result.detections, strict=True):
            x, y, width, height = detection.box
            assert contour.dtype == np.int32 and contour.shape[1] == 2
            assert contour.min(axis=0).tolist() == [x, y]
            assert contour.max(axis=0).tolist() == [x + width - 1, y + height - 1]
    assert np.abs(asked[40].background.astype(int) - FRAMES[0]).max() < 12
    (match,) = asked[40].matches
    assert asked[40].costs.tolist() == [[match.cost]]


@pytest.mark.parametrize("preset", PRESETS)
def test_a_result_never_changes(preset: str) -> None:
    config = survtrack.preset(preset)
    pictures = config.segmenter.model != "horn_schunck"
    config.outputs = survtrack.OutputOptions(
        background=pictures, contours=True, cost_matrix=True, flow=not pictures
    )
    config.set("segmenter.model=" + config.segmenter.model)
    pipeline = Pipeline(config)
    kept: list[Any] = []
    for index, frame in enumerate(FRAMES + FRAMES):
        result = pipeline.process(frame, index / 10)
        if result is not None:
            arrays = (result.mask, result.track_array, result.detection_array)
            if result.background is not None:  # optical flow has none
                arrays = (*arrays, result.background)
            contours = result.detections.contours
            kept.append((result, arrays, contours, *copies((*arrays, *contours)), answer([result])))
    pipeline.reset()
    pipeline.process(FRAMES[0][:40, :50], 0.0)
    for result, arrays, contours, copied, first_answer in kept:
        for array, copy in zip((*arrays, *contours), copied, strict=True):
            assert array.tobytes() == copy
        assert answer([result]) == first_answer


def copies(arrays: tuple[np.ndarray, ...]) -> tuple[list[bytes]]:
    return ([array.tobytes() for array in arrays],)


def test_arrays_outlive_their_result_and_pipeline() -> None:
    pipeline = Pipeline()
    masks = [pipeline.process(frame, k / 10).mask for k, frame in enumerate(FRAMES[:30])]
    del pipeline
    expected = [result.mask for result in run(Pipeline(), FRAMES[:30])]
    assert all(np.array_equal(a, b) for a, b in zip(masks, expected, strict=True))


def test_attributes_of_values_cannot_be_assigned(results: list[survtrack.FrameResult]) -> None:
    result = results[40]
    values = (result, result.tracks[0], result.tracks[0].box, result.detections[0])
    for value in (*values, result.detections, result.matches[0], results[50].events[0]):
        for name in [name for name in dir(value) if not name.startswith("_")]:
            if not callable(getattr(value, name)):
                with pytest.raises(AttributeError):
                    setattr(value, name, 1)


def test_a_changed_list_is_not_the_results() -> None:
    result = run(Pipeline(), FRAMES[:40])[-1]
    result.tracks.clear()
    assert len(result.tracks) == 1


def test_boxes_are_values() -> None:
    box = survtrack.Box(1, 2, 3, 4)
    assert box == survtrack.Box(1.0, 2, 3, 4) != survtrack.Box(1, 2, 3, 5)
    assert box != (1, 2, 3, 4) and len({box, survtrack.Box(1, 2, 3, 4)}) == 1
    assert tuple(box) == (1, 2, 3, 4)
    assert (box.right, box.bottom, box.area_px, box.center) == (4, 6, 12, (2.5, 4))
    assert repr(box) == "Box(x=1, y=2, width=3, height=4)"
    assert survtrack.iou(survtrack.Box(0, 0, 2, 2), survtrack.Box(1, 1, 2, 2)) == 1 / 7
    assert survtrack.iou(box, box) == 1
    assert survtrack.iou(box, survtrack.Box(4, 2, 3, 4)) == 0
    assert survtrack.iou(survtrack.Box(0, 0, 0, 0), survtrack.Box(0, 0, 0, 0)) == 0
