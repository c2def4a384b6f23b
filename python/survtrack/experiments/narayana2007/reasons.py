# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Why the numbers of a set can differ from the thesis's: what is known of its scene."""

from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.variants import (
    CORRESPONDENCES,
    PUBLISHED_BASE_PX,
    preset_base_px,
    preset_break_point,
)

SLOW_FPS = 15.0  # below it, frames are further apart than the presets' 25 frames/s suppose
MANY = 0.1  # part of the instances from which a trait of the scene is worth a word


def reasons(measured: Measured) -> list[str]:
    """Those that this set's own numbers support, in whole sentences."""
    every = (_objects, _reach, _fragments, _undetected, _groups, _rate, _speed, _refusals)
    return [text for text in (reason(measured) for reason in every) if text]


def pieces(measured: Measured) -> float:
    """Reported tracks per true box without any merging: above 1 masks fall into fragments."""
    scores = measured.cell("Euclidean", "none", True).scores
    return scores.output_boxes / scores.truth_boxes


def mean_factor(measured: Measured) -> float:
    """Of the settling vicinity factor at the end."""
    return measured.learning["settling"].mean_factor


def _objects(measured: Measured) -> str:
    if measured.dataset.objects == "objects":
        return ""
    return (
        f"What moves is {measured.dataset.objects}, in the thesis cars: no rigid bodies of one "
        "colour, so that a mask tears where clothes resemble the ground."
    )


def _reach(measured: Measured) -> str:
    factor, scene = mean_factor(measured), measured.scene
    reach = PUBLISHED_BASE_PX * factor
    none, base = (
        measured.cell("Euclidean", key, True).scores.number_of_blobs_errors
        for key in ("none", "vicinity_published")
    )
    if reach < scene.width_px or base <= none:
        return ""
    return (
        f"The published base of {PUBLISHED_BASE_PX} px times a vicinity factor of {factor:.1f} on "
        f"average at the end is {reach:.0f} px: {reach / scene.width_px:.1f} widths and "
        f"{reach / scene.height_px:.1f} heights of the median object, {scene.width_px:.0f} x "
        f"{scene.height_px:.0f} px, so that neighbours of like colour become one; the preset's "
        f"{preset_base_px():g} px reach {preset_base_px() * factor:.0f} px."
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
