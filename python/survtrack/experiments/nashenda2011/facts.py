# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers as results.json holds them."""

import math
from typing import Any

import numpy as np

from survtrack.experiments.nashenda2011 import gaps, published, sweep, targets
from survtrack.experiments.nashenda2011.claims import claims
from survtrack.experiments.nashenda2011.config import preset_config
from survtrack.experiments.nashenda2011.errata_filter import refusal_of_eq_22, refusal_of_r
from survtrack.experiments.nashenda2011.footage import OnFootage
from survtrack.experiments.nashenda2011.matrices import Compared
from survtrack.experiments.nashenda2011.simulated import Made


def facts(made: Made, every: list[OnFootage]) -> dict[str, Any]:
    """Of the whole experiment."""
    return {
        "noise_px": targets.SIGMA_PX,
        "acceleration_px_per_s2": sweep.ACCELERATION,
        "matrices": [_matrix(one) for one in made.matrices],
        "sweep": {
            name: {
                way: [{"q": q, **vars(errors)} for q, errors in of.items()]
                for way, of in by_way.items()
            }
            for name, by_way in made.sweep.items()
        },
        "best_q": [
            {
                "noise_px": sigma_px,
                "acceleration_px_per_s2": acceleration,
                "q": sweep.best_q(by_q),
                "rms_px": by_q[sweep.best_q(by_q)],
                "rms_px_by_q": [[q, px] for q, px in by_q.items()],
            }
            for sigma_px, by in made.best.items()
            for acceleration, by_q in by.items()
        ],
        "gaps": _gaps(made.gaps),
        "claims": [vars(claim) for claim in claims(made, every)],
        "errata": [vars(erratum) for erratum in made.errata],
        "refused": {"R": refusal_of_r(), "eq_22": refusal_of_eq_22()},
        "config": preset_config().to_dict(),
        "sets": [_set(one) for one in every],
    }


def _matrix(one: Compared) -> dict[str, Any]:
    return {
        "q": one.printed.q,
        "name": one.printed.name,
        "updates": one.printed.updates,
        "printed": one.printed.values.tolist(),
        "ours": np.round(one.ours, 6).tolist(),
        "largest_difference": one.largest,
        "same": one.same,
    }


def _gaps(every: gaps.Gaps) -> list[dict[str, Any]]:
    return [
        {"target": name, "way": way, "q": q, "frames": length, **vars(bridged)}
        for name, by_way in every.items()
        for way, by_q in by_way.items()
        for q, by_length in by_q.items()
        for length, bridged in by_length.items()
    ]


def _set(one: OnFootage) -> dict[str, Any]:
    return {
        "name": one.name,
        "frames": one.frames,
        "fps": one.fps,
        "with_blob": one.blobs,
        "with_blob_of_object": one.on_object,
        "stride": one.stride,
        "period_s": one.period_s,
        "object": one.object_id,
        "frames_compared": one.compared,
        "blob_px": one.blob_px,
        "errors": {
            way: [
                {"q": q, **{key: _known(px) for key, px in vars(of[q]).items()}}
                for q in published.SWEEP
            ]
            for way, of in one.errors.items()
        },
        "best_q": one.best_q,
        "rms_px_by_q": [[q, px] for q, px in one.best.items()],
    }


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value
