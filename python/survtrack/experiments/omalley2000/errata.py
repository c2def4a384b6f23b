# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of report and listings. Each function answers (the print's figure, ours)."""

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.omalley2000 import filters, identified, listing, published, race
from survtrack.experiments.omalley2000.listing import ListingFilter
from survtrack.experiments.semko2007.errata import Erratum, Measure

Floats = NDArray[np.float64]

SETTLE = 500
STAND_FRAMES = 60


def gain_of_s() -> tuple[float, float]:
    """Gain of S on S once settled."""
    port = _settled()
    return float(port.K[0, 0]), filters.steady_gain_s(published.TEXT)


def sigma_of_s() -> tuple[float, float]:
    """Root of the predicted variance of S once settled."""
    port = _settled()
    return float(np.sqrt(port.predicted_P[0, 0])), filters.steady_sigma_s(published.TEXT)


def _settled() -> ListingFilter:
    port = ListingFilter(published.TEXT, gain_of_p=True, start=published.START)
    for _ in range(SETTLE):
        port.step(published.START[:2])
    return port


def echo() -> tuple[float, float]:
    """Rms of the predicted S from the measured one in the race."""
    measured = race.race().measured
    port = ListingFilter(published.TEXT, gain_of_p=True, start=published.START)
    away = []
    for z in measured:
        port.step(z)
        away.append(port.innovation[0])
    ours = filters.run(measured, published.TEXT).innovations[:, 0]
    return float(np.sqrt(np.mean(np.square(away)))), float(np.sqrt(np.mean(ours**2)))


def wrap_innovation() -> tuple[float, float]:
    """Innovation of S with 277 measured and 2 in the state."""
    ours = filters.difference(np.array([277.0, 0.0]), np.array([2.0, 0.0]))
    return listing.wrapped_innovation(277.0, 2.0), float(ours[0])


def wrap_of_one_who_stands() -> tuple[float, float]:
    """Largest error of S of a car that stands on the start line, measured with a noise of 0.5."""
    noise = np.random.default_rng(7).standard_normal((STAND_FRAMES, 2))
    z = np.stack([np.mod(0.5 * noise[:, 0], published.LENGTH), 1.83 + 0.5 * noise[:, 1]], axis=1)
    start = np.array([0.0, 1.83, 0.0, 0.0])
    port = ListingFilter(published.TEXT, wrap=True, start=start)
    ours = filters.one(published.TEXT, start)
    worst = [0.0, 0.0]
    for row in z:
        port.step(row)
        ours.predict()
        ours.update(row)
        for k, s in enumerate((port.x[0], ours.x[0])):
            off = survtrack.wrapped_difference(float(s), published.LENGTH)
            worst[k] = max(worst[k], abs(float(off)))
    return worst[0], worst[1]


def raw_velocity() -> tuple[float, float]:
    """Raw vS of a car that is measured 0.1 further back than before."""
    s = np.array([100.0, 99.9])
    step = survtrack.wrapped_difference(float(s[1] - s[0]), published.LENGTH)
    return float(listing.raw_velocities(s)[1]), float(step) / published.PERIOD_S


def reach() -> tuple[float, float]:
    """3 sigma_S ahead once settled, by the printed values and by identified ones."""
    right = identified.noises(*identified.identify())
    each = [filters.steady_sigma_s(noises) for noises in (published.TEXT, right)]
    return published.SIGMAS_S * each[0], published.SIGMAS_S * each[1]


def reach_of_listing() -> tuple[float, float]:
    """3 sigma_S by the listing's values, and by the text's."""
    each = [filters.steady_sigma_s(noises) for noises in (published.LISTING, published.TEXT)]
    return published.SIGMAS_S * each[0], published.SIGMAS_S * each[1]


def worst_of_listing() -> tuple[float, float]:
    """Largest error of the predicted S to the measured one, listing's values and text's."""
    measured = race.race().measured
    each = [
        np.abs(filters.run(measured, noises).innovations[:, 0]).max()
        for noises in (published.LISTING, published.TEXT)
    ]
    return float(each[0]), float(each[1])


def variance() -> tuple[float, float]:
    """3 sigma_S where sigma is the variance, as it is called, and where it is its root."""
    sigma = filters.steady_sigma_s(published.TEXT)
    return published.SIGMAS_S * sigma**2, published.SIGMAS_S * sigma


def percent_smaller() -> tuple[float, float]:
    """By how much the mean area of table 3 is smaller, in %."""
    new, old = published.AREAS
    return 100 * published.SMALLER, 100 * (1 - new / old)


ERRATA: tuple[tuple[str, str, str, Measure], ...] = (
    ("gain", "the gain is that of P before the prediction", "gain of S on S, settled", gain_of_s),
    ("gain_sigma", "the same", "sigma_S of the prediction, settled", sigma_of_s),
    ("gain_error", "the same", "predicted S from the measured one in the race, rms", echo),
    (
        "wrap",
        "l is taken off the state on whichever side the measurement is",
        "innovation, 277 measured, 2 in the state",
        wrap_innovation,
    ),
    (
        "wrap_stands",
        "the same",
        "largest error of S of one who stands on the start line, noise of 0.5",
        wrap_of_one_who_stands,
    ),
    (
        "raw_velocity",
        "each step back counts as one over the start line",
        "raw vS of a step back by 0.1, per s",
        raw_velocity,
    ),
    (
        "reach",
        "Q is too small: the region is carried by the car's longest axis",
        "3 sigma_S, where the car goes 5.13 in a frame; by identified values",
        reach,
    ),
    (
        "values_reach",
        "the listing has 20 for 1 in Q and 0.01 for 1 in R",
        "3 sigma_S; by the text's values",
        reach_of_listing,
    ),
    (
        "values_worst",
        "the same",
        "largest distance of the predicted S in the race; by the text's values",
        worst_of_listing,
    ),
    ("variance", "sigma is called the variance", "3 of it; 3 of its root", variance),
    ("percent", "33.1 % smaller", "2001.25 instead of 2995.26, %", percent_smaller),
)


def measure_errata() -> list[Erratum]:
    """All of them; the same each time."""
    return [Erratum(key, fault, figure, *measure()) for key, fault, figure, measure in ERRATA]
