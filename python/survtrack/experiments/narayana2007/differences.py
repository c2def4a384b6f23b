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
    THRESHOLDS_PX,
    fixed,
    mergings,
    scaled,
    with_break_point,
    with_merging,
)
from survtrack.experiments.narayana2007.vicinity import ENOUGH_UPDATES

SCALED = {"vicinity_published": "published base", "vicinity_preset": "preset's base"}


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
    found = [_merging(measured)]
    found += [_velocity(measured, name) for name in CORRESPONDENCES]
    for key, name in SCALED.items():
        found += _vicinity(measured, key, name)
    return [*found, _sweep(measured), _bayesian(measured), _drift(measured)]


def _fewer(claim: str, before: int, after: int, more: str = "") -> Statement:
    """That a count goes down."""
    short = f"{percent(after - before, before):+.1f} %" if before else f"{after - before:+d}"
    return Statement(
        claim,
        after < before,
        short if after != before else "the same",
        f"{before} to {after}{more}",
    )


def _merging(measured: Measured) -> Statement:
    best = _best_fixed(measured)
    return _fewer(
        "merging by the best fixed threshold makes fewer number-of-blobs errors than none "
        f"({_thesis('none')} to {_thesis('fixed_15')})",
        _blobs(measured, "none"),
        _blobs(measured, best),
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


def _vicinity(measured: Measured, key: str, name: str) -> list[Statement]:
    ours, best = _blobs(measured, key), _best_fixed(measured)
    claim = f"the vicinity factor, {name}, makes fewer number-of-blobs errors than"
    there = _thesis("vicinity_published")
    none, fixed_best = _thesis("none"), _thesis("fixed_15")
    return [
        _fewer(f"{claim} no merging ({none} to {there})", _blobs(measured, "none"), ours),
        _fewer(
            f"{claim} the best fixed threshold ({fixed_best} to {there})",
            _blobs(measured, best),
            ours,
            _threshold_of(best),
        ),
    ]


def _sweep(measured: Measured) -> Statement:
    errors = {
        how: {
            px: measured.trials[with_merging(how(px))].scores.number_of_blobs_errors
            for px in THRESHOLDS_PX
        }
        for how in (fixed, scaled)
    }
    best = {how: min(swept, key=swept.__getitem__) for how, swept in errors.items()}
    return _fewer(
        f"of all thresholds from {THRESHOLDS_PX[0]} to {THRESHOLDS_PX[-1]} px, the best "
        "vicinity-scaled one makes fewer number-of-blobs errors than the best fixed one "
        "(the claim before, over a finer sweep)",
        errors[fixed][best[fixed]],
        errors[scaled][best[scaled]],
        f"; fixed {best[fixed]} px, scaled {best[scaled]} px at the factor's start",
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


def _blobs(measured: Measured, merging: str) -> int:
    return measured.cell("Euclidean", merging, True).scores.number_of_blobs_errors


def _best_fixed(measured: Measured) -> str:
    return min((f"fixed_{px}" for px in FIXED_PX), key=lambda key: _blobs(measured, key))


def _thesis(merging: str) -> int:
    return published.NUMBER_OF_BLOBS[merging].total


def _threshold_of(merging: str) -> str:
    best = merging.removeprefix("fixed_")
    return f"; of {', '.join(map(str, FIXED_PX))} px the best is {best} px"
