# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Regions about the predicted car on the closed track: how large, and whether they hold it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import filters, identified, published, race
from survtrack.experiments.omalley2000.published import Noises
from survtrack.experiments.omalley2000.race import Race

Floats = NDArray[np.float64]

CAR_PX = (36.0, 16.0)  # length and width
SIGMAS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0)
LOST_AFTER = 5  # frames without the car until it has to be acquired again
LAPS = 6 * published.DATAPOINTS  # frames: a share of 99 % is known to within half a percent
SEED = 2
PUBLISHED = survtrack.PredictedRegionsOptions(
    sigmas_along=3,
    sigmas_across=1,
    forward_only=True,
    whole_object=False,
    margin=0,
    growth=0,
)
WHOLE = survtrack.PredictedRegionsOptions(margin=0, growth=0)


@dataclass(frozen=True, eq=False)
class Looked:
    """One way of choosing regions over a drive.

    Attributes:
        areas_px: (N,) of the regions.
        hits: (N,) bool, the whole car lay inside.
        losses: how often it had to be acquired again.
        sides_px: of the constant box; None for regions that change.
    """

    areas_px: Floats
    hits: NDArray[np.bool_]
    losses: int
    sides_px: tuple[float, float] | None = None

    @property
    def area_px(self) -> float:
        """Mean."""
        return float(self.areas_px.mean())

    @property
    def hit_rate(self) -> float:
        """0 to 1."""
        return float(self.hits.mean())


def drive() -> Race:
    """A longer race than that of the plots, measured with another seed."""
    return race.race(LAPS, SEED)


def corners_px(path: survtrack.Path, place_px: Floats) -> Floats:
    """(4, 2) corners of a car at (S, T) along the path."""
    center = np.asarray(path.to_image(place_px[None]))[0]
    s = place_px[:1] % path.length_px
    along, across = np.asarray(path.tangents(s))[0], np.asarray(path.normals(s))[0]
    length, width = CAR_PX
    signs = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) / 2
    return np.asarray(center + signs[:, :1] * length * along + signs[:, 1:] * width * across)


def car_corners_px(one: Race) -> Floats:
    """(N, 4, 2) of the true car."""
    path = race.track()
    return np.stack([corners_px(path, one.unit_px * state[:2]) for state in one.truth])


def holds(box: survtrack.Box, corners: Floats) -> bool:
    """Whether all corners lie in the box."""
    low, high = corners.min(axis=0), corners.max(axis=0)
    return bool(
        low[0] >= box.x and low[1] >= box.y and high[0] <= box.right and high[1] <= box.bottom
    )


def follow(
    one: Race, cars: Floats, noises: Noises, options: survtrack.PredictedRegionsOptions
) -> Looked:
    """The method itself: what the region does not hold is not measured, and it grows.

    Args:
        one: the drive.
        cars: its car_corners_px().
        noises: of the filter.
        options: of the regions.
    """
    path, unit = race.track(), one.unit_px
    filter = filters.one(noises)
    areas, hits, missed, losses = [], [], 0, 0
    for measured, corners in zip(one.measured, cars, strict=True):
        before = filter.x[:2]
        filter.predict()
        place = unit * filter.x[:2]
        size = np.ptp(corners_px(path, place), axis=0)
        region = survtrack.predicted_region_on_path(
            options,
            path,
            tuple(unit * before),
            tuple(place),
            unit**2 * np.diag(np.diag(filter.P)[:2]),
            tuple(size),
            lost_s=missed * published.PERIOD_S,
        )
        areas.append(region.area_px)
        hits.append(holds(region, corners))
        missed = 0 if hits[-1] else missed + 1
        if hits[-1]:
            filter.update(measured)
        elif missed > LOST_AFTER:
            # Found in the acquisition region: it starts anew where it is measured.
            losses, missed = losses + 1, 0
            filter = filters.one(noises, np.array([*measured, *published.START[2:]]))
    return Looked(np.array(areas), np.array(hits), losses)


def constant(one: Race, cars: Floats, hit_rate: float) -> Looked:
    """The baseline: the smallest box that holds the car in at least that share of the frames.

    Its middle is a fixed step ahead of the measured place, the mean way of a frame.
    """
    path, unit = race.track(), one.unit_px
    step = published.START[2] * published.PERIOD_S
    starts = np.concatenate([published.START[None, :2], one.measured[:-1]])
    middles = np.asarray(path.to_image(unit * (starts + np.array([step, 0.0]))))
    reach = np.abs(cars - middles[:, None]).max(axis=1)
    width, height = smallest_sides(2 * reach, hit_rate)
    hits = (2 * reach <= (width, height)).all(axis=1)
    return Looked(np.full(len(cars), width * height), hits, 0, (width, height))


def smallest_sides(needed: Floats, share: float) -> tuple[float, float]:
    """Of all boxes that are as large as needed (N, 2) in that share of the rows, the smallest."""
    count = int(np.ceil(share * len(needed)))
    best = (float(needed[:, 0].max()), float(needed[:, 1].max()))
    for width in np.unique(needed[:, 0]):
        heights = np.sort(needed[needed[:, 0] <= width, 1])
        if len(heights) >= count and width * heights[count - 1] < best[0] * best[1]:
            best = (float(width), float(heights[count - 1]))
    return best


def theory(sigmas: float) -> float:
    """Share of Gaussian places within so many standard deviations along and across."""
    from math import erf, sqrt

    return erf(sigmas / sqrt(2)) ** 2


def drawn(sigmas: float, count: int = 20000, seed: int = 3) -> float:
    """Share of cars inside on a straight track, their places drawn from the prediction."""
    path = survtrack.Path([(0.0, 240.0), (640.0, 240.0)])
    rng = np.random.default_rng(seed)
    deviations = np.array([8.0, 3.0])
    options = WHOLE.replace(sigmas_along=sigmas, sigmas_across=sigmas)
    region = survtrack.predicted_region_on_path(
        options, path, (300, 0), (320, 0), np.diag(deviations**2), CAR_PX
    )
    places = np.array([320.0, 240.0]) + deviations * rng.standard_normal((count, 2))
    half = np.array(CAR_PX) / 2
    inside = (places - half >= (region.x, region.y)) & (
        places + half <= (region.right, region.bottom)
    )
    return float(inside.all(axis=1).mean())


def values() -> dict[str, Noises]:
    """Those of the text, of the listing, and identified ones."""
    return {**published.VALUES, "identified": identified.noises(*identified.identify())}
