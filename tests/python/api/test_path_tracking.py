# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Tracks along paths on the scene of a closed track, against its exact truth."""

from typing import Any

import numpy as np
import pytest

import survtrack
from survtrack import Detections, InputError, Pipeline, Tracker
from survtrack.scenes import Scene, make_scene

SIZE = (320, 240)
SIDE = 20.0
FPS = 25.0


def race(frame_count: int, **options: Any) -> tuple[Scene, survtrack.Paths]:
    """The scene, and the lanes of its cars as paths."""
    scene = make_scene("race", size=SIZE, frame_count=frame_count, fps=FPS, seed=2, **options)
    paths = {}
    for car in scene.objects:
        along = np.linspace(0, car.path.length_px, 60, endpoint=False)
        points, _ = car.path.locate(along)
        paths[f"lane {car.id}"] = survtrack.Path(
            points, closed=True, kind="curve", max_distance_px=30
        )
    return scene, survtrack.Paths(paths, SIZE)


def tracker_of(paths: survtrack.Paths, options: Any = None) -> Tracker:
    lifecycle = survtrack.LostCountOptions(lost_after_frames=1000)
    filters = options or survtrack.KalmanPathOptions()
    tracker = Tracker(survtrack.Config(filter=filters, lifecycle=lifecycle))
    tracker.load_paths(paths)
    return tracker


def followed(tracker: Tracker, scene: Scene) -> list[survtrack.TrackingResult]:
    """Results on boxes whose centres are measured with a noise of 1 px."""
    return [
        tracker.process(
            Detections(
                np.array([[x - SIDE / 2, y - SIDE / 2, SIDE, SIDE] for x, y in seen.values()]),
                time_s,
                index=index,
                frame_size=SIZE,
            )
        )
        for index, time_s, seen in scene.measurements(sigma_px=1.0)
    ]


def test_any_number_of_laps_keeps_identities_and_a_small_error_along() -> None:
    scene, paths = race(1500, contacts=2)
    truth = scene.truth()
    assert 120 * 1500 / FPS / paths["lane 1"].length_px > 8
    errors = []
    for result in followed(tracker_of(paths), scene)[75:]:
        true = truth.at(result.index)
        assert [track.id for track in result.tracks] == [1, 2]
        for track, position in zip(result.tracks, true.positions, strict=True):
            lane = paths[f"lane {track.id}"]
            (s, t), (true_s, true_t) = lane.to_path([track.position, position])
            errors.append((lane.residual(s, true_s), t - true_t))
    rms = np.sqrt(np.mean(np.square(errors), axis=0))
    print("rms of S and T, px:", rms.round(2))
    assert (rms < 1.0).all() and np.abs(errors).max() < 4


def hidden_rms(filters: Any) -> float:
    """Of the position in px, while the car is hidden for the first time: round a bend."""
    scene, paths = race(160, occluders=((215, 0, 105, 240),))
    truth = scene.truth()
    off: list[float] = []
    for result in followed(tracker_of(paths, filters), scene):
        true = truth.at(result.index)
        if len(true.ids) and true.visible[0] < 0.25:
            track = result.tracks[0]
            off.append(float(np.hypot(*(np.array(track.position) - true.positions[0]))))
        elif off:
            break
    assert len(off) > 30, len(off)
    return float(np.sqrt(np.mean(np.square(off))))


def test_behind_a_bend_the_path_is_known() -> None:
    along = hidden_rms(survtrack.KalmanPathOptions())
    straight = hidden_rms(survtrack.KalmanCvOptions())
    print(f"rms while hidden in a bend: along the path {along:.1f} px, kalman_cv {straight:.1f} px")
    assert along < 8 and straight > 5 * along


def test_paths_are_loaded_before_the_first_frame() -> None:
    _, paths = race(100)
    config = survtrack.Config(filter=survtrack.KalmanPathOptions())
    frame = np.zeros((240, 320), np.uint8)
    pipeline = Pipeline(config)
    with pytest.raises(InputError, match=r"has no paths; expected load_paths\(\) before the first"):
        pipeline.process(frame, 0.0)
    with pytest.raises(InputError, match=r"^paths: has none"):
        pipeline.load_paths(survtrack.Paths({}))
    pipeline.load_paths(paths)
    with pytest.raises(InputError, match=r"^frame: is 100x100 px, and the paths are drawn on"):
        pipeline.process(np.zeros((100, 100), np.uint8), 0.0)
    assert pipeline.process(frame, 0.0) is not None
    with pytest.raises(InputError, match=r"^paths: frames were processed already"):
        pipeline.load_paths(paths)
    pipeline.reset()
    pipeline.load_paths(paths)
    assert pipeline.process(frame, 0.0) is not None
    with pytest.raises(InputError, match="has no paths"):
        list(survtrack.track([frame], config=config))
    [(_, result)] = survtrack.track([frame], config=config, paths=paths)
    assert result.index == 0
