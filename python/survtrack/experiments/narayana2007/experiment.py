# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Measures every set, then writes the report."""

from collections.abc import Callable
from typing import Any

from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage
from survtrack.experiments.narayana2007.facts import facts
from survtrack.experiments.narayana2007.measured import Measured, measure, runs
from survtrack.experiments.narayana2007.plots import plots
from survtrack.experiments.narayana2007.report import report
from survtrack.sources.base import Size


class Narayana2007:
    """See experiment.Experiment."""

    size: Size = (320, 240)
    sets = ("vtest", "Walk1", "OneLeaveShop1cor", "TUD-Campus")
    made_frames = 0

    def __init__(self) -> None:
        self._measured: list[Measured] = []
        self._ran_at: Size = self.size

    @property
    def runs(self) -> int:
        """How many times each set goes through a pipeline."""
        return runs()

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Nothing: all of it needs footage."""

    def measure(self, footage: Footage, tick: Callable[[], None]) -> None:
        """Run everything on one set and remember the numbers; `tick` is called after each run."""
        self._ran_at = footage.size
        self._measured.append(measure(footage, tick))

    def write(self, folder: ReportFolder) -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
        links = {
            one.name: {
                name: folder.add_plot(f"{one.name}-{name}", png) for name, png in plots(one).items()
            }
            for one in self._measured
        }
        folder.add_report(report(self._measured, self._ran_at, links))
        return facts(self._measured, self._ran_at)
