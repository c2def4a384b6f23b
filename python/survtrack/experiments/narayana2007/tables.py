# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The tables of the report."""

from collections.abc import Callable

from survtrack.experiments.markdown import counted, table
from survtrack.experiments.narayana2007 import published
from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.reasons import pieces
from survtrack.experiments.narayana2007.variants import (
    CORRESPONDENCES,
    PRESETS,
    cells,
    merging,
    mergings,
    preset_base_px,
    start_factor,
)
from survtrack.experiments.trial import Trial

OFF_ON = {False: "off", True: "on"}
SCORES = ("HOTA", "MOTA", "IDF1", "number-of-blobs", "index", "swap", "ids", "frames/s")


def sets(every: list[Measured]) -> str:
    """The footage."""
    header = [
        "set", "footage", "frames", "frames/s", "size", "objects", "instances", "object, px",
        "overlapping", "tracks per box",
    ]  # fmt: skip
    rows = [
        [
            one.name,
            f"`{one.dataset.source.rstrip('/').rsplit('/', 1)[-1]}`",
            str(one.frames),
            f"{one.fps:g}",
            "{}x{}".format(*one.source_size),
            str(one.objects),
            str(one.instances),
            f"{one.scene.width_px:.0f} x {one.scene.height_px:.0f}",
            f"{100 * one.scene.overlapping:.0f} %",
            f"{pieces(one):.1f}",
        ]
        for one in every
    ]
    return table(header, rows, left=2)


def blobs(every: list[Measured]) -> str:
    """Number-of-blobs errors of every merging, the thesis's first."""
    rows = []
    for name in CORRESPONDENCES:
        for way in mergings():
            there = published.NUMBER_OF_BLOBS.get(way.key) if name == "Euclidean" else None
            ours = [counted(one.blobs(name, way.key), one.instances) for one in every]
            rows.append([name, way.label, *(_thesis(there) if there else ("", "")), *ours])
    header = ["correspondence", "merging", "thesis", "total", *_names(every)]
    return table(header, rows, left=2)


def identities(every: list[Measured]) -> str:
    """Index and swap errors without and with the velocity factor, the thesis's first."""
    kinds: dict[str, tuple[dict[bool, published.Errors], Callable[[Trial], int]]] = {
        "index": (published.INDEX, lambda trial: trial.scores.index_errors),
        "swap": (published.SWAP, lambda trial: trial.scores.swap_errors),
    }
    rows = []
    for kind, (there, errors) in kinds.items():
        for name in CORRESPONDENCES:
            for on, word in OFF_ON.items():
                ours = [
                    counted(errors(one.cell(name, "vicinity_preset", on)), one.instances)
                    for one in every
                ]
                told = _thesis(there[on]) if name == "Euclidean" else ("", "")
                rows.append([f"{kind}, {name}, {word}", *told, *ours])
    return table(
        ["errors, correspondence, velocity factor", "thesis", "total", *_names(every)], rows
    )


def presets(every: list[Measured]) -> str:
    """The scores of the presets as they are, set by set."""
    rows = [
        [one.name, f"`{name}`", *_scores(one, one.trials[variant])]
        for one in every
        for name, variant in PRESETS.items()
    ]
    return table(["set", "preset", *SCORES], rows, left=2)


def combinations(measured: Measured) -> str:
    """All combinations of one set."""
    rows = [
        [
            cell.correspondence,
            cell.merging.label,
            OFF_ON[cell.velocity],
            *_scores(measured, measured.trials[cell.variant]),
        ]
        for cell in cells()
    ]
    return table(["correspondence", "merging", "velocity factor", *SCORES], rows, left=3)


def vicinity(measured: Measured) -> str:
    """Where the vicinity factor has gone, by its form and by the tracks that it learned from."""
    common = preset_base_px() * start_factor()
    learned = {
        (f"`{form}`", "Euclidean", f"fixed, {common:g} px"): learning
        for form, learning in measured.learning.items()
    }
    learned |= {
        ("`settling`", name, merging(key).label): learning
        for (name, key), learning in measured.grids.items()
    }
    rows = []
    for words, learning in learned.items():
        part, whole = learning.at_clamp()
        numbers = (f"{learning.mean_factor:.2f}", f"{learning.mean_step_px:.1f}")
        rows.append([*words, *numbers, f"{part} of {whole}"])
    header = [
        "form", "correspondence", "merging", "mean factor at the end", "mean step, px",
        "factors at a clamp",
    ]  # fmt: skip
    return table(header, rows, left=3)


def _scores(measured: Measured, trial: Trial) -> list[str]:
    scores = trial.scores
    counts = (scores.number_of_blobs_errors, scores.index_errors, scores.swap_errors)
    return [
        *(f"{value:.1f}" for value in (scores.hota, scores.mota, scores.idf1)),
        *(counted(count, measured.instances) for count in counts),
        str(scores.output_ids),
        f"{trial.frames_per_s:.0f}",
    ]


def _thesis(errors: published.Errors) -> tuple[str, str]:
    """Of the three subsequences, and in total with the corrected and the printed percentage."""
    each = " / ".join(map(str, errors.each))
    return each, f"{errors.total} ({errors.percent:.1f} %) [{errors.printed_percent:.1f} %]"


def _names(every: list[Measured]) -> list[str]:
    return [one.name for one in every]
