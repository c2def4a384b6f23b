# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The presets of O'Malley 2000 on a made race: followed along the track, read in small regions."""

import numpy as np
import pytest

import survtrack
from scenes import answer
from survtrack.scenes import Scene, make_scene

SIZE = (320, 240)
FPS = 15.0
LENGTH = 278.586  # of the published track, in its own units
WARM_UP = 15  # frames of the reference picture


def race(contacts: int = 1) -> tuple[Scene, survtrack.Paths]:
    scene = make_scene(
        "race", size=SIZE, frame_count=240, fps=FPS, seed=2, contacts=contacts, noise_sigma=2
    )
    paths = {}
    for car in scene.objects:
        along = np.linspace(0, car.path.length_px, 60, endpoint=False)
        points, _ = car.path.locate(along)
        paths[f"lane {car.id}"] = survtrack.Path(
            points, closed=True, kind="curve", max_distance_px=30
        )
    return scene, survtrack.Paths(paths, SIZE)


def pipeline_of(preset: str, paths: survtrack.Paths) -> survtrack.Pipeline:
    config = survtrack.preset(preset)
    lane = paths[paths.names[0]]
    unit_px = lane.length_px / LENGTH
    config.set(f"filter.unit_px={unit_px}")
    config.set(f"filter.initial_velocity=[{120 / unit_px}, 0]")
    pipeline = survtrack.Pipeline(config)
    pipeline.load_paths(paths)
    # Across all lanes, where the first one begins.
    x, y = lane.points[0]
    pipeline.load_zones([survtrack.Box(x - 30, y - 40, 60, 80)])
    return pipeline


def results_of(pipeline: survtrack.Pipeline, scene: Scene) -> list[survtrack.FrameResult]:
    given = [pipeline.process(frame, time_s, index) for index, time_s, frame in scene.frames()]
    return [result for result in given if result is not None]


@pytest.mark.parametrize("contacts", [1, 2])
def test_cars_are_followed_in_a_small_part_of_the_picture(contacts: int) -> None:
    scene, paths = race(contacts)
    truth = scene.truth()
    results = results_of(pipeline_of("omalley2000_identified", paths), scene)
    assert {result.pixels_read for result in results[:WARM_UP]} == {SIZE[0] * SIZE[1]}
    later = results[160:]
    assert np.mean([r.pixels_read for r in later]) < (0.12 + 0.06 * contacts) * SIZE[0] * SIZE[1]
    off, held = [], []
    for result in later:
        assert len(result.tracks) == contacts
        true = truth.at(result.index)
        for track in result.tracks:
            away = np.hypot(*(np.array(true.positions) - track.position).T)
            nearest = int(away.argmin())
            off.append(away[nearest])
            region = next(r for r in result.regions if r.track_id == track.id)
            x, y, width, height = true.boxes[nearest]
            held.append(
                x >= region.box.x
                and y >= region.box.y
                and x + width <= region.box.right
                and y + height <= region.box.bottom
            )
    print(f"{contacts} cars: rms {np.sqrt(np.mean(np.square(off))):.2f} px, {np.mean(held):.3f}")
    assert np.sqrt(np.mean(np.square(off))) < 3
    assert np.mean(held) >= 0.99
    assert len({track.id for result in later for track in result.tracks}) == contacts


@pytest.mark.parametrize("preset", ["omalley2000", "omalley2000_published"])
def test_the_printed_values_run_and_say_the_same_again(preset: str) -> None:
    scene, paths = race()
    pipeline = pipeline_of(preset, paths)
    first = answer(results_of(pipeline, scene))
    pipeline.reset()
    assert answer(results_of(pipeline, scene)) == first
    assert any(row[6] for row in first), "somebody was followed"


def test_no_gap_in_time_ends_the_run() -> None:
    scene, paths = race()
    frames = [frame for _, _, frame in scene.frames()][:120]
    lane = survtrack.Paths({"open": survtrack.Path([(0, 120), (319, 100)], max_distance_px=200)})
    for preset in ("omalley2000", "omalley2000_identified", "omalley2000_published"):
        for lanes in (paths, lane):
            pipeline = pipeline_of(preset, lanes)
            for index, frame in enumerate(frames):
                pipeline.process(frame, index / FPS)
            for gap_s in (1e3, 3e5, 1e7, 1e9):
                assert pipeline.process(frames[-1], 100 + gap_s) is not None


def test_what_is_missing_is_told_before_the_first_frame() -> None:
    frame = np.zeros((240, 320, 3), np.uint8)
    pipeline = survtrack.Pipeline.from_preset("omalley2000")
    with pytest.raises(survtrack.InputError, match=r"needs zones|has no paths"):
        pipeline.process(frame, 0.0)
    _, paths = race()
    pipeline.load_paths(paths)
    with pytest.raises(survtrack.InputError, match="needs zones"):
        pipeline.process(frame, 0.0)
