# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the listing's filter. Each function answers (the listing's figure, ours)."""

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.following import rms
from survtrack.experiments.semko2007 import ours
from survtrack.experiments.semko2007.listing import ListingFilter

Floats = NDArray[np.float64]

FRAMES = 100
RUNS = 20
SETTLED = 25  # frames that a filter is given before its error counts
MISSING = 12
SPEED = np.array([2.0, 0.0])
START = np.array([60.0, 144.0])
CENTRE = (192.0, 144.0)


def trace_of_p() -> tuple[float, float]:
    """Of P after FRAMES noisy measurements."""
    listing, bank, _ = _with_noise(seed=0)
    return float(np.trace(listing.P)), float(np.trace(bank.state_covariance(0)))


def rms_with_noise() -> tuple[float, float]:
    """Of the position's error in px once the filter has settled, over RUNS runs."""
    errors = np.concatenate([_with_noise(seed)[2][SETTLED:] for seed in range(RUNS)])
    return rms(errors[:, 0]), rms(errors[:, 1])


def _with_noise(seed: int) -> tuple[ListingFilter, survtrack.FilterBank, Floats]:
    """Both filters after FRAMES, and (FRAMES, 2) their errors."""
    noise = np.random.default_rng(seed).standard_normal((FRAMES + 1, 2))
    listing = ListingFilter(START + noise[0], plus_sign=True)
    bank = ours.bank()
    bank.add(*(START + noise[0]))
    errors = []
    for frame in range(1, FRAMES + 1):
        true = START + frame * SPEED
        listing.step(true + noise[frame])
        ours.step(bank, true + noise[frame])
        both = (listing.position, bank.positions[0])
        errors.append([float(np.hypot(*(at - true))) for at in both])
    return listing, bank, np.array(errors)


def folded_without_noise() -> tuple[float, float]:
    """Largest difference of any component from the standard form's, with Q = 0."""
    standard, folded, bank = _three_forms(q=0.0)
    return float(np.abs(folded - standard).max()), float(np.abs(bank - standard).max())


def folded_with_noise() -> tuple[float, float]:
    """Largest difference of the position from the standard form's, with Q = 0.5 I."""
    standard, folded, bank = _three_forms(q=0.5)
    away = [np.hypot(*(form - standard)[:, :2].T).max() for form in (folded, bank)]
    return float(away[0]), float(away[1])


def _three_forms(q: float) -> tuple[Floats, Floats, Floats]:
    """(FRAMES, 6) states: of the standard form written with numpy, of the listing's after it has
    moved on, and of the library's; a contact that accelerates for a while, noise of 1 px."""
    noise = np.random.default_rng(1).standard_normal((FRAMES + 1, 2))
    # The library's Q cannot be 0: 1e-12 is as good.
    bank = ours.bank(acceleration_noise=max(np.sqrt(q), 1e-6))
    standard, folded = ListingFilter(START, q=q), ListingFilter(START, q=q, folded=True)
    bank.add(*START)
    states: list[tuple[Floats, Floats, Floats]] = []
    for frame in range(1, FRAMES + 1):
        pushed = 0.02 * min(frame, 50) ** 2
        z = START + noise[frame] + (2.0 * frame + pushed, 0.5 * frame)
        standard.step(z)
        ours.step(bank, z)
        folded.step(z)
        states.append((standard.x, folded.x, bank.state(0)))
    each = np.array(states)
    return each[:, 0], each[:, 1], each[:, 2]


def fed_own_estimate() -> tuple[float, float]:
    """How far off a contact is that was missing for MISSING frames at constant speed, px."""
    listing, bank, true = _missing()
    return (
        float(np.hypot(*(listing.position - true))),
        float(np.hypot(*(bank.positions[0] - true))),
    )


def fed_own_variance() -> tuple[float, float]:
    """Variance of its x, px^2."""
    listing, bank, _ = _missing()
    return float(listing.P[0, 0]), float(bank.state_covariance(0)[0, 0])


def _missing() -> tuple[ListingFilter, survtrack.FilterBank, Floats]:
    """60 frames seen, then MISSING not; both filters, and the true position."""
    listing, bank = ListingFilter(START), ours.bank()
    bank.add(*START)
    for frame in range(1, 60 + MISSING):
        seen = frame < 60
        true = START + frame * SPEED
        listing.step(true if seen else listing.position)
        ours.step(bank, true if seen else None)
    return listing, bank, true


def off_at_the_start() -> tuple[float, float]:
    """Largest distance of the estimate from a contact that comes in at the side, px."""
    listing, bank = ListingFilter(CENTRE), ours.bank()
    bank.add(*START)
    away = []
    for frame in range(SETTLED):
        true = START + frame * SPEED
        listing.step(true)
        if frame > 0:
            ours.step(bank, true)
        away.append([float(np.hypot(*(at - true))) for at in (listing.position, bank.positions[0])])
    return max(one for one, _ in away), max(one for _, one in away)


def start_at_a_tenth() -> tuple[float, float]:
    """Largest difference of the position from a right filter that starts at rest, px."""
    tenth, none, bank = ListingFilter(START, rate=0.1), ListingFilter(START), ours.bank()
    bank.add(*START)
    away = []
    for frame in range(1, FRAMES + 1):
        z = START + frame * SPEED
        tenth.step(z)
        none.step(z)
        ours.step(bank, z)
        both = (tenth.position, bank.positions[0])
        away.append([float(np.hypot(*(at - none.position))) for at in both])
    return max(one for one, _ in away), max(one for _, one in away)
