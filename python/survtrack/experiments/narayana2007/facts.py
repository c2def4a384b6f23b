# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers as results.json holds them: at full precision, with what makes each run again."""

from typing import Any

from survtrack.experiments.narayana2007 import published
from survtrack.experiments.narayana2007.differences import statements
from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.reasons import reasons
from survtrack.experiments.narayana2007.variants import (
    BREAK_POINTS,
    CORRESPONDENCES,
    PRESETS,
    THRESHOLDS_PX,
    cells,
    fixed,
    scaled,
    with_break_point,
    with_form,
    with_grid,
    with_merging,
)
from survtrack.experiments.narayana2007.vicinity import Learning
from survtrack.experiments.trial import Variant
from survtrack.sources.base import Size

COUNTS = ("number_of_blobs_errors", "index_errors", "swap_errors")


def facts(every: list[Measured], size: Size) -> dict[str, Any]:
    """Of the whole experiment."""
    return {
        "size": list(size),
        "published": _published(),
        "sets": [_facts_of_set(measured) for measured in every],
    }


def _facts_of_set(measured: Measured) -> dict[str, Any]:
    return {
        "name": measured.name,
        "source": measured.dataset.source,
        "truth": str(measured.dataset.truth),
        "offset": measured.dataset.offset,
        "fps": measured.fps,
        "frames": measured.frames,
        "source_size": list(measured.source_size),
        "objects": measured.objects,
        "instances": measured.instances,
        "scene": vars(measured.scene),
        "presets": [{"name": name, **_run(measured, one)} for name, one in PRESETS.items()],
        "combinations": _combinations(measured),
        "break_point_sweep": _break_points(measured),
        "threshold_sweep": _thresholds(measured),
        "vicinity": _forms(measured),
        "vicinity_by_merging": _grids(measured),
        "statements": [vars(statement) for statement in statements(measured)],
        "reasons": reasons(measured),
    }


def _run(measured: Measured, variant: Variant) -> dict[str, Any]:
    """One run: its configuration, its scores."""
    trial = measured.trials[variant]
    scores = trial.scores.to_dict()
    return {
        "preset": variant.preset,
        "set": variant.assignments(1 / measured.fps),
        **{key: scores[key] for key in ("HOTA", "MOTA", "IDF1", *COUNTS)},
        "instances": scores["truth_boxes"],
        "ids": scores["output_ids"],
        "frames_per_s": round(trial.frames_per_s, 1),
    }


def _combinations(measured: Measured) -> list[dict[str, Any]]:
    return [
        {
            "correspondence": cell.correspondence,
            "merging": cell.merging.key,
            "velocity_factor": cell.velocity,
            **_run(measured, cell.variant),
        }
        for cell in cells()
    ]


def _break_points(measured: Measured) -> list[dict[str, Any]]:
    return [
        {
            "correspondence": name,
            "break_point_px": px,
            **_run(measured, with_break_point(name, px)),
        }
        for name in CORRESPONDENCES
        for px in BREAK_POINTS
    ]


def _thresholds(measured: Measured) -> list[dict[str, Any]]:
    return [
        {
            "correspondence": name,
            "scaled": how is scaled,
            "threshold_px": px,  # of scaled ones: at the factor's start
            **_run(measured, with_merging(name, how(px))),
        }
        for name in CORRESPONDENCES
        for how in (fixed, scaled)
        for px in THRESHOLDS_PX
    ]


def _forms(measured: Measured) -> list[dict[str, Any]]:
    return [
        {"form": form, **_grid(measured, learning, with_form(form))}
        for form, learning in measured.learning.items()
    ]


def _grids(measured: Measured) -> list[dict[str, Any]]:
    return [
        {
            "correspondence": name,
            "merging": key,
            **_grid(measured, learning, with_grid(name, key)),
        }
        for (name, key), learning in measured.grids.items()
    ]


def _grid(measured: Measured, learning: Learning, variant: Variant) -> dict[str, Any]:
    """What a grid learned, and what makes it again."""
    part, whole = learning.at_clamp()
    return {
        "preset": variant.preset,
        "set": variant.assignments(1 / measured.fps),
        "mean_factor": learning.mean_factor,
        "mean_step_px": learning.mean_step_px,
        "factors_at_clamp": part,
        "factors_asked": whole,
        "updates": learning.updates.tolist(),
        "factor_y": learning.factor_y[-1].tolist(),
        "factor_x": learning.factor_x[-1].tolist(),
    }


def _published() -> dict[str, Any]:
    def told(errors: published.Errors) -> dict[str, Any]:
        return {"each": list(errors.each), "total": errors.total, "percent": errors.percent}

    return {
        "instances": list(published.INSTANCES),
        COUNTS[0]: {key: told(errors) for key, errors in published.NUMBER_OF_BLOBS.items()},
        COUNTS[1]: {"without": told(published.INDEX[False]), "with": told(published.INDEX[True])},
        COUNTS[2]: {"without": told(published.SWAP[False]), "with": told(published.SWAP[True])},
    }
