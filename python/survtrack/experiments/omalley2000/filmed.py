# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The drive filmed, and followed by the presets as they are, through the whole pipeline."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import published, race, regions
from survtrack.experiments.omalley2000.race import Race

if TYPE_CHECKING:
    from survtrack._core import FrameResult

Floats = NDArray[np.float64]
Image = NDArray[np.uint8]

PRESETS = ("omalley2000", "omalley2000_identified")
FRAMES = 4 * published.DATAPOINTS
WARM_UP = 100  # frames: the background, and the way to where newcomers are looked for
EMPTY = 25  # frames before the car comes
SEED = 3
NOISE_SIGMA = 2.0  # grey levels of the camera
CAR_BGR = (30, 30, 220)
GRAINS = 8  # pictures of noise, in turn


@dataclass(frozen=True, eq=False)
class Filmed:
    """What a preset read of the drive.

    Attributes:
        preset: its name.
        frames: in which the car could have been followed.
        areas_px: of the regions; a frame without one has none.
        held: of these frames, those in which the whole car lay in its region.
        constant_px: area of the smallest constant box that holds the car as often.
        pixels: part of all pixels that was read.
        variances: (2,) of the measured S and T about the truth, in the track's units.
    """

    preset: str
    frames: int
    areas_px: Floats
    held: int
    constant_px: float
    pixels: float
    variances: Floats

    @property
    def hit_rate(self) -> float:
        """0 to 1."""
        return self.held / self.frames

    @property
    def saving(self) -> float:
        """Part of the constant box's area that is not read."""
        return 1 - float(self.areas_px.mean()) / self.constant_px

    def facts(self) -> dict[str, Any]:
        """As results.json holds them."""
        return {
            "preset": self.preset,
            "frames": self.frames,
            "area_px": float(self.areas_px.mean()),
            "hit_rate": self.hit_rate,
            "constant_area_px": self.constant_px,
            "saving": self.saving,
            "pixels": self.pixels,
            "measurement_variances": self.variances.tolist(),
        }


def frames() -> int:
    """Of all runs, for the progress."""
    return len(PRESETS) * FRAMES


def measure(tick: Callable[[int], None]) -> list[Filmed]:
    """Film the drive and follow it with each of the presets."""
    one = race.race(FRAMES, SEED)
    cars = regions.car_corners_px(one)
    found = []
    for preset in PRESETS:
        found.append(_follow(preset, one, cars))
        tick(FRAMES)
    return found


def pictures(cars: Floats) -> Iterator[Image]:
    """The empty scene, then the car where it is; the same every time.

    Args:
        cars: (N, 4, 2) corners.
    """
    rng = np.random.default_rng(SEED)
    width, height = race.SIZE
    ground = cv2.GaussianBlur(rng.uniform(60, 140, (height, width, 3)), (0, 0), 2)
    grains = rng.normal(0, NOISE_SIGMA, (GRAINS, height, width, 3))
    empty = [np.clip(ground + grain, 0, 255).astype(np.uint8) for grain in grains]
    for index in range(-EMPTY, len(cars)):
        picture = empty[index % GRAINS].copy()
        if index >= 0:
            sixteenths = np.round(16 * cars[index]).astype(np.int32)
            cv2.fillConvexPoly(picture, sixteenths, CAR_BGR, cv2.LINE_AA, shift=4)
        yield picture


def pipeline_of(preset: str, unit_px: float) -> survtrack.Pipeline:
    """The preset on the track, with newcomers looked for where S begins."""
    config = survtrack.preset(preset)
    config.set(f"filter.unit_px={unit_px}")
    pipeline = survtrack.Pipeline(config)
    track = survtrack.Path(race.POINTS, closed=True, kind="curve", max_distance_px=40)
    pipeline.load_paths(survtrack.Paths({"track": track}, race.SIZE))
    x, y = track.to_image(np.zeros((1, 2)))[0]
    pipeline.load_zones([survtrack.Box(x - 40, y - 40, 80, 80)])
    return pipeline


def _follow(preset: str, one: Race, cars: Floats) -> Filmed:
    path = race.track()
    pipeline = pipeline_of(preset, one.unit_px)
    step = np.array([one.unit_px * published.START[2] * published.PERIOD_S, 0.0])
    areas, needed, off = [], [], []
    held = counted = read = 0
    before = np.full(2, np.nan)  # the place of the frame before
    for number, picture in enumerate(pictures(cars)):
        result = pipeline.process(picture, number * published.PERIOD_S)
        assert result is not None
        index = number - EMPTY
        place = _place(result)
        if index >= WARM_UP:
            counted += 1
            read += result.pixels_read
            region = next((r.box for r in result.regions if r.kind.name == "predicted"), None)
            if region is not None:
                areas.append(region.area_px)
                held += regions.holds(region, cars[index])
            if np.isfinite(before).all():
                middle = path.to_image(path.to_path(before[None]) + step)[0]
                needed.append(2 * np.abs(cars[index] - middle).max(axis=0))
            if place is not None and result.tracks[0].detection >= 0:
                off.append(path.to_path(place[None])[0] / one.unit_px - one.truth[index, :2])
        before = np.full(2, np.nan) if place is None else place
    away = np.array(off)
    away[:, 0] = survtrack.wrapped_difference(away[:, 0], published.LENGTH)
    # Below one half a box of the same rate says nothing.
    width, height = regions.smallest_sides(np.array(needed), max(held / counted, 0.5))
    part = read / (counted * race.SIZE[0] * race.SIZE[1])
    return Filmed(preset, counted, np.array(areas), held, width * height, part, away.var(axis=0))


def _place(result: "FrameResult") -> Floats | None:
    """Where the car is measured, px; where it is filtered if it is not; None without a track."""
    if not result.tracks:
        return None
    track = result.tracks[0]
    if track.detection < 0:
        return np.array(track.position)
    return np.array(result.detections[track.detection].position)
