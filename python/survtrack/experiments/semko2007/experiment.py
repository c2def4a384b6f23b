# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the artificial trials, measures every set, then writes the report."""

from collections.abc import Callable
from typing import Any

from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage
from survtrack.experiments.marked_set import MarkedSet, mark_set
from survtrack.experiments.semko2007 import artificial
from survtrack.experiments.semko2007.errata import Erratum, measure_errata
from survtrack.experiments.semko2007.facts import facts
from survtrack.experiments.semko2007.plots import plots
from survtrack.experiments.semko2007.report import report
from survtrack.experiments.semko2007.variants import VARIANTS
from survtrack.sources.base import Size


class Semko2007:
    """See experiment.Experiment."""

    size: Size = (384, 288)
    sets = ("Walk1", "OneLeaveShop1cor")
    runs = len(VARIANTS)
    made_frames = artificial.frames()

    def __init__(self) -> None:
        self._made: artificial.Made | None = None
        self._errata: list[Erratum] = []
        self._sets: list[MarkedSet] = []

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Run the artificial trials and the errata."""
        self._made = artificial.measure(tick)
        self._errata = measure_errata()

    def measure(self, footage: Footage, tick: Callable[[], None]) -> None:
        """Run the presets on one set."""
        self._sets.append(mark_set(footage, VARIANTS, tick))

    def write(self, folder: ReportFolder) -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
        assert self._made is not None, "measure_made comes first"
        links = {name: folder.add_plot(name, png) for name, png in plots(self._made).items()}
        links |= {
            one.name: folder.add_plot(f"{one.name}-markers", one.plot()) for one in self._sets
        }
        folder.add_report(report(self._made, self._errata, self._sets, links))
        return facts(self._made, self._errata, self._sets)
