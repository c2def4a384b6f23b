# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Why the numbers of a set can differ from the thesis's: what is known of its scene."""

from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.variants import (
    CORRESPONDENCES,
    SCALED,
    THRESHOLDS_PX,
    fixed,
    merging,
    preset_break_point,
    scaled,
    scaled_bases,
    start_factor,
)

SLOW_FPS = 15.0  # below it, frames are further apart than the presets' 25 frames/s suppose
MANY = 0.1  # part of the instances from which a trait of the scene is worth a word


def reasons(measured: Measured) -> list[str]:
    """Those that this set's own numbers support, in whole sentences."""
    every = (_objects, _fragments, _undetected, _groups, _rate, _speed, _refusals)
    found = [reason(measured) for reason in every]
    found += [_vicinity(measured, name, key) for key in SCALED for name in CORRESPONDENCES]
    return [text for text in found if text]


def pieces(measured: Measured) -> float:
    """Reported tracks per true box without any merging: above 1 masks fall into fragments."""
    scores = measured.cell("Euclidean", "none", True).scores
    return scores.output_boxes / scores.truth_boxes


def _objects(measured: Measured) -> str:
    if measured.dataset.objects == "objects":
        return ""
    return (
        f"What moves is {measured.dataset.objects}, in the thesis cars: no rigid bodies of one "
        "colour, so that a mask tears where clothes resemble the ground."
    )


def _vicinity(measured: Measured, correspondence: str, key: str) -> str:
    """Why the vicinity factor makes no fewer number-of-blobs errors here, and what would."""
    ours = measured.blobs(correspondence, key)
    before, rival = min(
        (measured.blobs(correspondence, other), merging(other).label)
        for other in ("none", measured.best_fixed(correspondence))
    )
    if ours <= before:
        return ""
    base, learned = scaled_bases()[key], measured.grids[correspondence, key]
    reach, scene = base * learned.mean_factor, measured.scene
    best_fixed, _ = measured.best_threshold(correspondence, fixed)
    return (
        f"{SCALED[key].capitalize()}, {correspondence} correspondence: {ours} number-of-blobs "
        f"errors, {before} with merging {rival}. {_learned(measured, correspondence, key)} So "
        f"{base:g} px reach {reach:.0f} px on average, {reach / scene.width_px:.1f} widths and "
        f"{reach / scene.height_px:.1f} heights of the median object, {scene.width_px:.0f} x "
        f"{scene.height_px:.0f} px; the best fixed threshold of the sweep is {best_fixed} px: "
        f"{_too_far(reach, best_fixed)} {_remedy(measured, correspondence, before)}"
    )


def _learned(measured: Measured, correspondence: str, key: str) -> str:
    """The factor here, and what the tracks of the other correspondence made of it."""
    grids = {name: measured.grids[name, key] for name in CORRESPONDENCES}
    [other] = [name for name in CORRESPONDENCES if name != correspondence]
    told = {
        name: f"{measured.cell(name, key, True).scores.output_ids} tracks, steps of "
        f"{grid.mean_step_px:.1f} px per frame on average, a factor of {grid.mean_factor:.1f}"
        for name, grid in grids.items()
    }
    text = f"Its grid learned from {told[correspondence]} ({other}: {told[other]})."
    fewest, most = sorted(grids.values(), key=lambda grid: grid.mean_step_px)
    limit = measured.scene.fast_step_px
    if most.mean_step_px > limit and most.mean_factor < fewest.mean_factor:
        text += (
            f" 95 % of the true steps are at most {limit:.1f} px: longer ones, from object to "
            "object, raise the scene's mean, which the factor is relative to, and so lower it."
        )
    return text


def _too_far(reach: float, best_fixed: float) -> str:
    if reach > best_fixed:
        return "too far, so that neighbours of like colour become one."
    return "not far enough for the pieces of an object."


def _remedy(measured: Measured, correspondence: str, before: int) -> str:
    """Which base of the sweep has fewer errors than `before`."""
    px, errors = measured.best_threshold(correspondence, scaled)
    if errors < before:
        return f"A base of {px / start_factor():.1f} px would make the claim hold: {errors}."
    bases = [THRESHOLDS_PX[at] / start_factor() for at in (0, -1)]
    return (
        f"No base of the sweep, {bases[0]:.1f} to {bases[1]:.1f} px, would make the claim hold; "
        f"the best, {px / start_factor():.1f} px, has {errors}."
    )


def _fragments(measured: Measured) -> str:
    if pieces(measured) < 1 + MANY:
        return ""
    return (
        f"Without merging there are {pieces(measured):.1f} reported tracks for every true box: "
        "masks are fragments, or things move that the truth does not list."
    )


def _undetected(measured: Measured) -> str:
    if pieces(measured) > 1 - MANY:
        return ""
    return (
        f"Without merging there are {pieces(measured):.1f} reported tracks for every true box, so "
        f"about {100 * (1 - pieces(measured)):.0f} % of the instances or more are undetected (what "
        "stands still melts into an average background): number-of-blobs errors that no merging "
        "can take away."
    )


def _groups(measured: Measured) -> str:
    if measured.scene.overlapping < MANY:
        return ""
    return (
        f"{100 * measured.scene.overlapping:.0f} % of the true boxes overlap another one: such a "
        "group is often one connected blob, which is credited to one object and leaves the others "
        "undetected whatever the threshold."
    )


def _rate(measured: Measured) -> str:
    if measured.fps >= SLOW_FPS:
        return ""
    return (
        f"{measured.fps:g} frames/s: the last 5 steps, from which a velocity is averaged, are "
        f"{5 / measured.fps:.1f} s, in which objects turn and stop; at 25 frames/s {5 / 25:.1f} s."
    )


def _speed(measured: Measured) -> str:
    step, limit = measured.scene.fast_step_px, preset_break_point()
    if step >= limit:
        return ""
    return (
        f"95 % of the steps between frames are at most {step:.1f} px long beside a break-point of "
        f"{limit:g} px per frame: the velocity factor can hardly tell true displacements apart, "
        "only blobs whose centroid jumps as fragments come and go."
    )


def _refusals(measured: Measured) -> str:
    one, other = (measured.cell(name, "vicinity_preset", True) for name in CORRESPONDENCES)
    numbers = [trial.scores.output_ids for trial in (one, other)]
    if other.identity_errors <= one.identity_errors or numbers[1] <= numbers[0]:
        return ""
    return (
        "Bayesian correspondence loses a track rather than give it a blob that is no more probable "
        f"than none: {numbers[1]} numbers instead of {numbers[0]}, and more index + swap errors "
        "with them."
    )
