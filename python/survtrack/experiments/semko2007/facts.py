# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers as results.json holds them."""

import math
from typing import Any

from survtrack.experiments.marked_set import MarkedSet
from survtrack.experiments.semko2007.artificial import SIGMA_PX, Made, Run
from survtrack.experiments.semko2007.claims import claims, event_after
from survtrack.experiments.semko2007.errata import Erratum


def facts(made: Made, errata: list[Erratum], every: list[MarkedSet]) -> dict[str, Any]:
    """Of the whole experiment."""
    return {
        "preset": "semko2007",
        "noise_px": SIGMA_PX,
        "trials": [
            {
                "name": trial.key,
                "label": trial.label,
                "contacts": len(trial.scene.objects),
                "frames": trial.scene.frame_count,
                **{way: run_facts(run) for way, run in made.runs[trial.key].items()},
            }
            for trial in made.trials
        ],
        "lost": {
            key: {
                "events": len(run.ended),
                "frames_to_the_event": event_after(run),
                "places": [event.place.name for event in run.ended],
                "positions": [list(event.position) for event in run.ended],
            }
            for key, run in made.lost.items()
        },
        "claims": [vars(claim) for claim in claims(made, every)],
        "errata": [vars(erratum) for erratum in errata],
        "sets": [one.facts() for one in every],
    }


def run_facts(run: Run) -> dict[str, Any]:
    """Of one trial in one way; None for what is not defined."""
    delay, bias, rest = (None if math.isnan(value) else value for value in run.lag)
    return {
        "under_1_px_after_frames": run.settled_after,
        "largest_px": run.largest_px,
        "rms_px": run.rms_px,
        "delay_frames": delay,
        "bias_right_px": bias,
        "rms_without_delay_px": rest,
        "tracks": [one.track_id for one in run.followed],
        "events": len(run.ended),
    }
