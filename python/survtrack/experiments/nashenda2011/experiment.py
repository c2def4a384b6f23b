# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the simulations, measures every set, then writes the report."""

from collections.abc import Callable
from typing import Any

from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage
from survtrack.experiments.nashenda2011 import published, simulated
from survtrack.experiments.nashenda2011.facts import facts
from survtrack.experiments.nashenda2011.footage import OnFootage, measure
from survtrack.experiments.nashenda2011.plots import footage_plot, plots
from survtrack.experiments.nashenda2011.report import report
from survtrack.sources.base import Size


class Nashenda2011:
    """See experiment.Experiment."""

    size: Size = published.SIZE
    sets = ("Walk1",)
    runs = 1
    made_frames = simulated.frames()

    def __init__(self) -> None:
        self._made: simulated.Made | None = None
        self._sets: list[OnFootage] = []

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Run the simulations and the errata."""
        self._made = simulated.measure(tick)

    def measure(self, footage: Footage, tick: Callable[[], None]) -> None:
        """Find the person in one set, and run the sweep on it; raises UsageError for too little."""
        self._sets.append(measure(footage))
        tick()

    def write(self, folder: ReportFolder) -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
        assert self._made is not None, "measure_made comes first"
        links = {name: folder.add_plot(name, png) for name, png in plots(self._made).items()}
        links |= {
            one.name: folder.add_plot(f"{one.name}-sweep", footage_plot(one)) for one in self._sets
        }
        folder.add_report(report(self._made, self._sets, links))
        return facts(self._made, self._sets)
