# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The vicinity grids (Narayana 2007, 6) in results, and what a tracker learned of a scene."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import run, scene
from survtrack import ConfigError, Detections, GridVicinityOptions, InputError, Tracker

SHAPE = (8, 11)  # 30 px cells of 320x240
GRID_ARRAYS = [
    *("factor_y", "factor_x", "updates", "active", "relative_size"),
    *("mean_step_px", "step_deviation_px"),
]


def config_of(**options: Any) -> survtrack.Config:
    return survtrack.Config(
        time_unit_s=0.1,
        filter=survtrack.MeanVelocityOptions(),
        measurement=survtrack.CentroidOptions(),
        cost=survtrack.BeliefOptions(learn_after=20),
        assignment=survtrack.OldestFirstOptions(),
        lifecycle=survtrack.LostCountOptions(),
        vicinity=GridVicinityOptions(**options),
        outputs=survtrack.OutputOptions(vicinity=True),
    )


def walk(tracker: Tracker, count: int = 30, class_id: int = -1) -> survtrack.TrackingResult:
    """One box that goes 6 px to the right and 2 px down a frame."""
    for k in range(count):
        box = [20 + 6 * k, 20 + 2 * k, 12, 12]
        detections = Detections([box], k / 10, index=k, frame_size=(320, 240), class_ids=[class_id])
        result = tracker.process(detections)
    return result


def taught(**options: Any) -> Tracker:
    tracker = Tracker(config_of(**options))
    walk(tracker)
    return tracker


def test_a_grid_is_arrays_of_cells() -> None:
    grid = walk(Tracker(config_of())).vicinity[-1]
    assert (grid.cell_px, grid.frame_size, grid.max_factor) == (30, (320, 240), 5.0)
    for name in GRID_ARRAYS:
        array = getattr(grid, name)
        assert array.shape == SHAPE, name
        assert array.dtype == (np.bool_ if name == "active" else np.float64), name
    assert grid.updates.sum() == 29
    assert np.array_equal(grid.active, grid.updates > 0)
    assert grid.relative_size == pytest.approx(np.hypot(grid.factor_y, grid.factor_x))
    assert grid.factor_y[~grid.active] == pytest.approx(3) and grid.active[0, 1]
    assert grid.mean_step_px[grid.active] == pytest.approx(np.hypot(6, 2))
    assert grid.step_deviation_px == pytest.approx(0, abs=1e-5)


def test_rows_are_vertical() -> None:
    """The published constant form by hand: 6 px in X run to the clamp, 2 px in Y do not yet."""
    grid = walk(Tracker(config_of(form="published_constant")), 2).vicinity[-1]
    assert (grid.factor_y[0, 1], grid.factor_x[0, 1]) == pytest.approx((3.5, 5))


def test_each_class_has_its_grid() -> None:
    grids = walk(Tracker(config_of()), class_id=4).vicinity
    assert sorted(grids) == [-1, 4]
    assert grids[4].updates.sum() == 29 and not grids[-1].active.any()


def test_without_a_grid_there_is_none() -> None:
    tracker = Tracker()
    assert tracker.predict(0.0).vicinity is None
    assert tracker.process([[1.0, 2, 30, 40]], 0.1).vicinity == {}


def test_the_expectation_has_the_grid_of_blobs() -> None:
    grid = taught().predict(10.0).vicinity
    assert grid is not None and grid.factor_x.shape == SHAPE


def test_rules_between_sections_are_named() -> None:
    for changes, message in (
        ({"outputs": survtrack.OutputOptions(vicinity=True)}, r"outputs\.vicinity: true needs"),
        (
            {"blobs": survtrack.BlobOptions(merge={"model": "close", "vicinity_scaled": True})},
            r"blobs\.merge\.vicinity_scaled: true needs",
        ),
    ):
        with pytest.raises(ConfigError, match=rf"^{message}.*vicinity\.model"):
            survtrack.Pipeline(survtrack.Config(**changes))


def test_frames_that_have_no_grid_are_refused() -> None:
    for frame_size, message in (
        ((0, 0), r"^detections\.frame_size: is not known.*expected \(width, height\)"),
        ((40, 20), r"^vicinity\.cell_px: 30 is larger than the frame of 40x20.*at most 20"),
    ):
        with pytest.raises(InputError, match=message):
            Tracker(config_of()).process(Detections([], 0.0, frame_size=frame_size))


# What was learned


def test_a_learned_scene_is_what_a_tracker_starts_with() -> None:
    learned = taught().learned_scene()
    tracker = Tracker(config_of())
    tracker.load_learned_scene(learned)
    before, after = json.loads(learned), json.loads(tracker.learned_scene())
    for part in ("frame_size", "scale", "vicinity"):
        assert after[part] == before[part]
    assert after["densities"]["x"]["values"] == pytest.approx(before["densities"]["x"]["values"])
    assert walk(tracker).vicinity[-1].updates.sum() == 58
    tracker.reset()
    assert tracker.learned_scene() == Tracker(config_of()).learned_scene()


def test_a_pipeline_learns_a_scene_too() -> None:
    config = survtrack.Config(vicinity=GridVicinityOptions(cell_px=8))
    pipeline = survtrack.Pipeline(config)
    run(pipeline, scene(60))
    learned = pipeline.learned_scene()
    assert json.loads(learned)["vicinity"]["grids"][0]["updates"] > 10
    other = survtrack.Pipeline(config)
    other.load_learned_scene(learned)
    assert other.learned_scene() == learned


def test_what_a_config_does_not_use_is_left_aside() -> None:
    tracker = Tracker()
    tracker.load_learned_scene(taught().learned_scene())
    assert "vicinity" not in json.loads(tracker.learned_scene())


SPOILERS: dict[str, tuple[Callable[[Any], object], str]] = {
    "factor": (
        lambda s: s["vicinity"]["grids"][0]["cells"][2].__setitem__(0, 5.5),
        r"\.vicinity\.grids\[0\]\.cells\[2\]\[0\]: is 5\.5",
    ),
    "cells": (
        lambda s: s["vicinity"]["grids"][0]["cells"].pop(),
        r"\.vicinity\.grids\[0\]\.cells: has 87 entries; expected 88",
    ),
    "cell size": (
        lambda s: s["vicinity"].update(cell_px=20),
        r"\.vicinity: cell_px is 20.*, and vicinity\.cell_px is 30.*; expected the same",
    ),
    "color space": (
        lambda s: s["densities"].update(color_space="lab"),
        r'\.densities: color_space is "lab", and cost\.color_space is "bgr"; expected the same',
    ),
    "mass": (
        lambda s: s["densities"]["y"].update(values=[0.0] * 401),
        r"\.densities\.y\.values: have no mass",
    ),
    "text": (lambda s: s["scale"].update(sum_h="1"), r"\.scale\.sum_h: is not a number"),
    "nothing": (lambda s: s.clear(), ": is no learned scene"),
}


@pytest.mark.parametrize(("spoil", "message"), SPOILERS.values(), ids=SPOILERS)
def test_a_wrong_scene_is_named_and_keeps_the_state(
    spoil: Callable[[Any], object], message: str
) -> None:
    tracker = taught()
    before = tracker.learned_scene()
    wrong = json.loads(before)
    spoil(wrong)
    with pytest.raises(InputError, match=rf"^yard\.json{message}"):
        tracker.load_learned_scene(json.dumps(wrong), "yard.json")
    with pytest.raises(InputError, match=r"^scene: is not JSON"):
        tracker.load_learned_scene(before[:-2])
    assert tracker.learned_scene() == before
