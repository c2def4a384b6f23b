# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers as results.json holds them."""

import math
from collections.abc import Mapping
from typing import Any

from survtrack.experiments.marked_set import MarkedSet
from survtrack.experiments.suliman2010.errata import Eq6
from survtrack.experiments.suliman2010.footage import OnFootage
from survtrack.experiments.suliman2010.scenes import PRESET, Made, Reentry


def facts(
    made: Made, eq6: Eq6, every: list[MarkedSet], compared: Mapping[str, OnFootage]
) -> dict[str, Any]:
    """Of the whole experiment."""
    return {
        "preset": PRESET,
        "reentry": {way: _reentry(one) for way, one in made.reentries.items()},
        "centroid_and_estimate": {key: vars(one) for key, one in made.compared.items()},
        "centroid_and_estimate_on_footage": {
            name: {key: _known(value) for key, value in vars(one).items()}
            for name, one in compared.items()
        },
        "eq6": {
            key: list(value) if isinstance(value, tuple) else value
            for key, value in vars(eq6).items()
        },
        "sets": [one.facts() for one in every],
    }


def _reentry(one: Reentry) -> dict[str, Any]:
    return {
        "tracks": sorted(one.track_ids),
        "left": one.left,
        "back": one.back,
        "given_again_after_frames": one.given_again_after,
        "on_contact_before": one.share(after=False),
        "on_contact_after": one.share(after=True),
    }


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value
