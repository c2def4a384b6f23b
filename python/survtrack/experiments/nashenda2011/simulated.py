# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""All that is run without footage."""

from collections.abc import Callable
from dataclasses import dataclass

from survtrack.experiments.nashenda2011 import gaps, matrices, sweep, walk
from survtrack.experiments.nashenda2011.errata import measure_errata
from survtrack.experiments.nashenda2011.gaps import Gaps
from survtrack.experiments.nashenda2011.matrices import Compared
from survtrack.experiments.nashenda2011.sweep import Best, Sweep
from survtrack.experiments.nashenda2011.walk import Walk
from survtrack.experiments.semko2007.errata import Erratum


@dataclass(frozen=True, eq=False)
class Made:
    """What the report's first part is written from."""

    matrices: list[Compared]
    sweep: Sweep
    best: Best
    gaps: Gaps
    walk: Walk
    errata: list[Erratum]


def frames() -> int:
    """Of all runs, for the progress."""
    return sweep.frames() + gaps.frames() + walk.frames()


def measure(tick: Callable[[int], None]) -> Made:
    """Run everything; `tick` gets the number of frames of each run."""
    return Made(
        matrices.compare(),
        sweep.measure_sweep(tick),
        sweep.measure_best(tick),
        gaps.measure(tick),
        walk.measure(tick),
        measure_errata(),
    )
