# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Filters on objects that turn: rms errors, printed by `pytest -s`; a table of docs/filters.md."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import survtrack
from survtrack.scenes import make_scene

Array = NDArray[np.float64]
RATE, SECONDS, SEEDS, SIZE, SIGMA = 10, 20, 40, 40.0, 2.4
FILTERS: dict[str, Callable[..., Any]] = {
    "kalman_cv": survtrack.KalmanCvOptions,
    "kalman_ca": survtrack.KalmanCaOptions,
    "extended": survtrack.ExtendedOptions,
    "unscented": survtrack.UnscentedOptions,
    "particle": survtrack.ParticleOptions,
}
TURNING = ("extended", "unscented", "particle")
# For objects that keep their speed and turn for seconds. No velocity_noise of kalman_cv is better
# than its default both with measurements and in gaps.
TURNS = {"velocity_noise": 0.3, "turn_rate": 0.7, "turn_time": 3.0, "lost_damping_time": 0.0}
TUNED: dict[str, list[dict[str, float]]] = {
    "kalman_cv": [{}],
    "kalman_ca": [{}, {"acceleration_noise": 1.5}],
    **{name: [{}, TURNS] for name in TURNING},
}


def circle() -> Array:
    """60 px/s, once round in 6.3 s."""
    t = np.arange(RATE * SECONDS) / RATE
    return 300 + 60 * np.stack([np.cos(t), np.sin(t)], axis=1)


def s_curve() -> Array:
    """Left and right half circles of 4 s each, 60 px/s."""
    return winding(turn_deg=180.0, leg_px=240.0)


def weave() -> Array:
    """Left and right quarters of 1.3 s each: as long as the gaps."""
    return winding(turn_deg=90.0, leg_px=80.0)


def winding(**options: float) -> Array:
    count = RATE * (SECONDS + 2)
    scene = make_scene(
        "varying_direction", size=(2400, 960), fps=RATE, frame_count=count, **options
    )
    return np.asarray(scene.truth().of(1).positions[: RATE * SECONDS])


def straight() -> Array:
    return np.linspace([50, 50], [50 + 60 * SECONDS, 400], RATE * SECONDS)


def errors(options: Any, truth: Array) -> tuple[float, float]:
    """rms distance over seeds, px: where it is measured, and after a gap of one second."""
    random = np.random.default_rng(3)
    bank = survtrack.FilterBank(options)
    shape = (SEEDS, len(truth), 2)
    measured = truth + random.normal(0, SIGMA, shape)
    for seed in range(SEEDS):
        bank.add(*measured[seed, 0], object_size_px=SIZE)
    seen, ends = [], []
    for k in range(1, len(truth)):
        bank.predict(1 / RATE)
        missing = k > 40 and k % 40 < RATE
        z = np.full((SEEDS, 2), math.nan) if missing else measured[:, k]
        if k > 40 and k % 40 == RATE - 1:
            ends.append(bank.positions - truth[k])
        bank.correct(z)
        if k > 20 and not missing:
            seen.append(bank.positions - truth[k])
    rms = [math.sqrt(2 * float(np.mean(np.square(away)))) for away in (seen, ends)]
    return rms[0], rms[1]


def rows() -> Iterator[tuple[str, str, str, float, float]]:
    for way in (circle, s_curve, weave, straight):
        truth = way()
        for name, options in FILTERS.items():
            for made in TUNED[name]:
                label = "tuned" if made else "default"
                yield way.__name__, name, label, *errors(options(**made), truth)


@pytest.fixture(scope="module")
def table() -> dict[tuple[str, str, str], tuple[float, float]]:
    found = {}
    for way, name, label, seen, gap in rows():
        print(f"{way:9} {name:10} {label:8} {seen:6.2f} {gap:6.1f}")
        found[way, name, label] = (seen, gap)
    return found


@pytest.mark.parametrize("way", ["circle", "s_curve"])
@pytest.mark.parametrize("name", TURNING)
def test_turning_filters_follow_turns_through_gaps(
    way: str, name: str, table: dict[tuple[str, str, str], tuple[float, float]]
) -> None:
    seen, gap = table[way, name, "tuned"]
    assert seen < table[way, "kalman_cv", "default"][0]
    assert gap < 0.6 * table[way, "kalman_cv", "default"][1]
    assert gap < 0.8 * table[way, "kalman_ca", "tuned"][1]
    assert seen < math.sqrt(2) * SIGMA  # that of the measurements


def test_no_filter_is_lost_anywhere(
    table: dict[tuple[str, str, str], tuple[float, float]],
) -> None:
    assert len(table) == 36
    for (way, name, label), (seen, gap) in table.items():
        assert seen < 2 * SIGMA and gap < 3 * SIZE, (way, name, label)
