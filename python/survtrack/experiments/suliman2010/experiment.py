# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the synthetic scenes, measures every set, then writes the report."""

from collections.abc import Callable
from typing import Any

from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage
from survtrack.experiments.marked_set import MarkedSet, mark_set
from survtrack.experiments.semko2007.trials import SIZE
from survtrack.experiments.suliman2010 import scenes
from survtrack.experiments.suliman2010.errata import measure_eq6
from survtrack.experiments.suliman2010.facts import facts
from survtrack.experiments.suliman2010.footage import VARIANTS, OnFootage, compare_on
from survtrack.experiments.suliman2010.plots import plots
from survtrack.experiments.suliman2010.report import report
from survtrack.sources.base import Size


class Suliman2010:
    """See experiment.Experiment. Its lengths are semko2007's, and so is the size."""

    size: Size = SIZE
    sets = ("Walk1", "OneLeaveShop1cor")
    runs = len(VARIANTS) + 1
    made_frames = scenes.frames()

    def __init__(self) -> None:
        self._made: scenes.Made | None = None
        self._sets: list[MarkedSet] = []
        self._compared: dict[str, OnFootage] = {}

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Run the synthetic scenes."""
        self._made = scenes.measure(tick)

    def measure(self, footage: Footage, tick: Callable[[], None]) -> None:
        """Run the presets on one set."""
        self._sets.append(mark_set(footage, VARIANTS, tick))
        self._compared[footage.dataset.name] = compare_on(footage)
        tick()

    def write(self, folder: ReportFolder) -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
        assert self._made is not None, "measure_made comes first"
        links = {name: folder.add_plot(name, png) for name, png in plots(self._made).items()}
        links |= {
            one.name: folder.add_plot(f"{one.name}-markers", one.plot()) for one in self._sets
        }
        eq6 = measure_eq6()
        folder.add_report(report(self._made, eq6, self._sets, self._compared, links))
        return facts(self._made, eq6, self._sets, self._compared)
