# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the numbers of a set say of the thesis's claims."""

from dataclasses import dataclass

from survtrack.experiments.markdown import percent
from survtrack.experiments.narayana2007 import published
from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.variants import (
    BREAK_POINTS,
    CORRESPONDENCES,
    FIXED_PX,
    SCALED,
    THRESHOLDS_PX,
    fixed,
    mergings,
    scaled,
    start_factor,
    with_break_point,
)
from survtrack.experiments.narayana2007.vicinity import ENOUGH_UPDATES


@dataclass(frozen=True)
class Statement:
    """A claim, and what became of it on one set.

    Attributes:
        claim: of the thesis; the same words for every set.
        holds: whether the numbers of this set say the same.
        short: by how much, in a word.
        numbers: the numbers themselves.
    """

    claim: str
    holds: bool
    short: str
    numbers: str


def statements(measured: Measured) -> list[Statement]:
    """All claims, in the order of the thesis; computed, none is taken for granted."""
    found = [_merging(measured, name) for name in CORRESPONDENCES]
    found += [_velocity(measured, name) for name in CORRESPONDENCES]
    for key in SCALED:
        for name in CORRESPONDENCES:
            found += _vicinity(measured, name, key)
    found += [_sweep(measured, name) for name in CORRESPONDENCES]
    return [*found, _bayesian(measured), _drift(measured)]


def _fewer(claim: str, before: int, after: int, more: str = "") -> Statement:
    """That a count goes down."""
    short = f"{percent(after - before, before):+.1f} %" if before else f"{after - before:+d}"
    return Statement(
        claim,
        after < before,
        short if after != before else "the same",
        f"{before} to {after}{more}",
    )


def _merging(measured: Measured, correspondence: str) -> Statement:
    best = measured.best_fixed(correspondence)
    return _fewer(
        "merging by the best fixed threshold makes fewer number-of-blobs errors than none, "
        f"{correspondence} correspondence ({_thesis('none')} to {_thesis('fixed_15')}, Euclidean)",
        measured.blobs(correspondence, "none"),
        measured.blobs(correspondence, best),
        _threshold_of(best),
    )


def _velocity(measured: Measured, correspondence: str) -> Statement:
    pairs = [
        [
            measured.cell(correspondence, way.key, velocity).identity_errors
            for velocity in (False, True)
        ]
        for way in mergings()
    ]
    sweep = {
        px: measured.trials[with_break_point(correspondence, px)].identity_errors
        for px in BREAK_POINTS
    }
    best = min(sweep, key=sweep.__getitem__)
    there = [published.INDEX[on].total + published.SWAP[on].total for on in (False, True)]
    before, after = pairs[-1]  # the preset's merging
    return _fewer(
        f"the velocity factor lowers index + swap errors, {correspondence} correspondence "
        f"({there[0]} to {there[1]}, Euclidean)",
        before,
        after,
        f" with the preset's merging; lower with {sum(on < off for off, on in pairs)} of "
        f"{len(pairs)} mergings; best break-point of the sweep {best} px per frame: {sweep[best]}",
    )


def _vicinity(measured: Measured, correspondence: str, key: str) -> list[Statement]:
    ours, best = measured.blobs(correspondence, key), measured.best_fixed(correspondence)
    none, fixed_best, there = map(_thesis, ("none", "fixed_15", "vicinity_published"))

    def claim(before: str, counts: str) -> str:
        return (
            f"the vicinity factor, {SCALED[key]}, makes fewer number-of-blobs errors than "
            f"{before}, {correspondence} correspondence ({counts}, Euclidean)"
        )

    return [
        _fewer(
            claim("no merging", f"{none} to {there}"),
            measured.blobs(correspondence, "none"),
            ours,
        ),
        _fewer(
            claim("the best fixed threshold", f"{fixed_best} to {there}"),
            measured.blobs(correspondence, best),
            ours,
            _threshold_of(best),
        ),
    ]


def _sweep(measured: Measured, correspondence: str) -> Statement:
    fixed_px, before = measured.best_threshold(correspondence, fixed)
    scaled_px, after = measured.best_threshold(correspondence, scaled)
    return _fewer(
        f"of all thresholds from {THRESHOLDS_PX[0]} to {THRESHOLDS_PX[-1]} px, the best "
        "vicinity-scaled one makes fewer number-of-blobs errors than the best fixed one, "
        f"{correspondence} correspondence (the claims before, over a finer sweep)",
        before,
        after,
        f"; fixed {fixed_px} px, scaled {scaled_px} px at the factor's start, which is a base of "
        f"{scaled_px / start_factor():.1f} px",
    )


def _bayesian(measured: Measured) -> Statement:
    one, other = (measured.cell(name, "vicinity_preset", True) for name in CORRESPONDENCES)
    return _fewer(
        "Bayesian correspondence makes fewer index + swap errors than Euclidean (chapters 8 and 9 "
        "show examples, no totals)",
        one.identity_errors,
        other.identity_errors,
        f"; HOTA {one.scores.hota:.1f} to {other.scores.hota:.1f}, IDF1 {one.scores.idf1:.1f} to "
        f"{other.scores.idf1:.1f}",
    )


def _drift(measured: Measured) -> Statement:
    clamped = {form: learning.at_clamp() for form, learning in measured.learning.items()}
    told = ", ".join(f"{form} {part} of {whole}" for form, (part, whole) in clamped.items())
    settling, constant = clamped["settling"][0], clamped["published_constant"][0]
    return Statement(
        "the vicinity factor of eq. 6.4, which has no decay, ends at a clamp in more places than "
        "the settling form (erratum)",
        settling < constant,
        f"{settling} to {constant}",
        f"factors at a clamp in the end, Y and X of cells with {ENOUGH_UPDATES} updates: {told}",
    )


def _thesis(merging: str) -> int:
    return published.NUMBER_OF_BLOBS[merging].total


def _threshold_of(merging: str) -> str:
    best = merging.removeprefix("fixed_")
    return f"; of {', '.join(map(str, FIXED_PX))} px the best is {best} px"
