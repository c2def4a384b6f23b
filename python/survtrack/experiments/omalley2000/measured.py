# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The race, filtered with the values of the text, of the listing, and with identified ones."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.following import rms
from survtrack.experiments.omalley2000 import (
    filmed,
    filters,
    identified,
    published,
    race,
    region_trials,
)
from survtrack.experiments.omalley2000.errata import measure_errata
from survtrack.experiments.omalley2000.filters import Filtered
from survtrack.experiments.omalley2000.followed import Filmed
from survtrack.experiments.omalley2000.race import Race
from survtrack.experiments.omalley2000.region_trials import Regions
from survtrack.experiments.semko2007.errata import Erratum

Floats = NDArray[np.float64]

NAMES = ("text", "listing", "identified")


@dataclass(frozen=True)
class Errors:
    """Of one set of values over the race; lengths in the track's unit.

    Attributes:
        worst_s: largest distance of the predicted S from the measured one.
        t, v_s, v_t: rms errors of the updated state to the truth.
        nis: mean of the normalised innovations squared; 2 if the model fits.
        three_sigma_s: 3 sigma_S of the prediction once it has settled.
        within: part of the frames in which the true S is no further from the predicted one.
    """

    worst_s: float
    t: float
    v_s: float
    v_t: float
    nis: float
    three_sigma_s: float
    within: float


@dataclass(frozen=True, eq=False)
class Made:
    """What the report is written from.

    Attributes:
        race: the truth and the measurements.
        runs, errors: by the names in NAMES.
        raw: rms errors of T, vS and vT, as they are measured and differenced.
        densities: identified, of S and T.
        filmed: what the presets read of filmed drives, through the whole pipeline.
    """

    race: Race
    runs: dict[str, Filtered]
    errors: dict[str, Errors]
    raw: tuple[float, float, float]
    densities: tuple[float, float]
    errata: list[Erratum]
    regions: Regions
    filmed: list[Filmed]


def frames() -> int:
    """Of all runs, for the progress."""
    filtered = published.DATAPOINTS * (len(NAMES) + 2 * len(identified.DENSITIES))
    return filtered + region_trials.frames() + filmed.frames()


def measure(tick: Callable[[int], None]) -> Made:
    """Run everything; `tick` gets the number of frames of each run."""
    one = race.race()
    densities = identified.identify()
    tick(2 * len(identified.DENSITIES) * published.DATAPOINTS)
    values = {**published.VALUES, "identified": identified.noises(*densities)}
    runs, errors = {}, {}
    for name in NAMES:
        runs[name] = filters.run(one.measured, values[name])
        errors[name] = _errors(one, runs[name])
        tick(published.DATAPOINTS)
    velocities = raw_velocities(one.measured)
    raw = (
        rms(one.measured[:, 1] - one.truth[:, 1]),
        rms(velocities[:, 0] - one.truth[:, 2]),
        rms(velocities[:, 1]),
    )
    looked = region_trials.measure(tick)
    seen = filmed.measure(tick)
    return Made(one, runs, errors, raw, densities, measure_errata(), looked, seen)


def raw_velocities(measured: Floats) -> Floats:
    """(N, 2) of S and T: differences, in S the shorter way round; NaN in the first frame."""
    steps = np.diff(measured, axis=0)
    steps[:, 0] = survtrack.wrapped_difference(steps[:, 0], published.LENGTH)
    return np.concatenate([np.full((1, 2), np.nan), steps / published.PERIOD_S])


def _errors(one: Race, run: Filtered) -> Errors:
    off = survtrack.wrapped_difference(run.predicted[:, 0] - one.truth[:, 0], published.LENGTH)
    away = run.updated - one.truth
    return Errors(
        float(np.abs(run.innovations[:, 0]).max()),
        rms(away[:, 1]),
        rms(away[:, 2]),
        rms(away[:, 3]),
        float(run.nis.mean()),
        float(published.SIGMAS_S * run.sigmas[-1, 0]),
        float((np.abs(off) <= published.SIGMAS_S * run.sigmas[:, 0]).mean()),
    )
