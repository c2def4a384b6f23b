# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Drives filmed, and followed by the presets as they are, through the whole pipeline."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import film, published, race, regions
from survtrack.experiments.omalley2000.followed import Filmed, Followed
from survtrack.experiments.omalley2000.race import Race

if TYPE_CHECKING:
    from survtrack._core import FrameResult

Floats = NDArray[np.float64]

PRESETS = ("omalley2000", "omalley2000_identified")
SEEDS = (1, 2, 3, 4, 5, 6)  # of the drives
FRAMES = 300  # of each: four laps of the slowest
LAPS = (3, 4)  # the fourth counts: by then all that a preset may learn of the scene is learned
ZONE_PX = 80.0  # side of that place


def frames() -> int:
    """Of all runs, for the progress."""
    return len(PRESETS) * len(SEEDS) * FRAMES


def measure(tick: Callable[[int], None]) -> list[Filmed]:
    """Film the drives and follow them with each of the presets."""
    drives = [race.race(FRAMES, seed, race.drawn(seed)) for seed in SEEDS]
    found = []
    for preset in PRESETS:
        each = []
        for one in drives:
            each.append(follow(pipeline_of(preset, one.unit_px), one))
            tick(FRAMES)
        found.append(Filmed(preset, tuple(each)))
    return found


def pipeline_of(preset: str, unit_px: float) -> survtrack.Pipeline:
    """The preset on the track, with newcomers looked for where S begins."""
    config = survtrack.preset(preset)
    config.set(f"filter.unit_px={unit_px}")
    pipeline = survtrack.Pipeline(config)
    track = survtrack.Path(race.POINTS, closed=True, kind="curve", max_distance_px=40)
    pipeline.load_paths(survtrack.Paths({"track": track}, race.SIZE))
    x, y = track.to_image(np.zeros((1, 2)))[0]
    pipeline.load_zones([survtrack.Box(x - ZONE_PX / 2, y - ZONE_PX / 2, ZONE_PX, ZONE_PX)])
    return pipeline


def counted(one: Race) -> slice:
    """The frames between LAPS, from where the car started."""
    driven = np.unwrap(one.truth[:, 0], period=published.LENGTH)
    first, last = np.searchsorted(driven - driven[0], published.LENGTH * np.array(LAPS))
    return slice(int(first), int(last))


def follow(pipeline: survtrack.Pipeline, one: Race) -> Followed:
    """Film a drive and follow it."""
    cars = regions.car_corners_px(one)
    span = counted(one)
    areas: list[float] = []
    off: list[Floats] = []
    with_region = held = read = 0
    for number, picture in enumerate(film.pictures(cars[: span.stop])):
        result = pipeline.process(picture, number * published.PERIOD_S)
        assert result is not None
        index = number - film.EMPTY
        if index < span.start:
            continue
        boxes = [region.box for region in result.regions if region.kind.name == "predicted"]
        areas.append(sum(box.area_px for box in boxes) if boxes else ZONE_PX**2)
        with_region += bool(boxes)
        held += any(regions.holds(box, cars[index]) for box in boxes)
        read += result.pixels_read
        off += _off(result, one, index)
    steps = np.diff(np.unwrap(one.truth[:, 0], period=published.LENGTH))
    return Followed(
        np.array(areas),
        with_region,
        held,
        read,
        _needed_px(one, cars, span, published.START[2] * published.PERIOD_S),
        _needed_px(one, cars, span, float(steps[span.start - 1 : span.stop - 1].mean())),
        np.reshape(off, (-1, 2)),
    )


def _off(result: "FrameResult", one: Race, index: int) -> list[Floats]:
    """(2,) measured less true S and T of each track that is measured."""
    found = []
    for track in result.tracks:
        if track.detection >= 0:
            place = np.array(result.detections[track.detection].position)
            off = race.track().to_path(place[None])[0] / one.unit_px - one.truth[index, :2]
            found.append(np.array([survtrack.wrapped_difference(off[0], published.LENGTH), off[1]]))
    return found


def _needed_px(one: Race, cars: Floats, span: slice, step: float) -> Floats:
    """(N, 2) sides of a box that holds the car, a step ahead of the true place a frame before."""
    before = one.truth[span.start - 1 : span.stop - 1, :2]
    middles = np.asarray(race.track().to_image(one.unit_px * (before + np.array([step, 0.0]))))
    return np.asarray(2 * np.abs(cars[span] - middles[:, None]).max(axis=1))
