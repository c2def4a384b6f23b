# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the race, reads footage in regions, then writes the report."""

from collections.abc import Callable
from typing import Any

from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage
from survtrack.experiments.omalley2000 import footage_runs, measured, race
from survtrack.experiments.omalley2000.facts import facts
from survtrack.experiments.omalley2000.plots import plots
from survtrack.experiments.omalley2000.report import report
from survtrack.sources.base import Size


class OMalley2000:
    """See experiment.Experiment. There is no footage of cars on a track: a motorway, and people."""

    size: Size = race.SIZE
    sets: tuple[str, ...] = ("motorway", "vtest")
    runs = len(footage_runs.VARIANTS)
    made_frames = measured.frames()

    def __init__(self) -> None:
        self._made: measured.Made | None = None
        self._read: list[footage_runs.Read] = []

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Run the race and the errata."""
        self._made = measured.measure(tick)

    def measure(self, footage: Footage, tick: Callable[[], None]) -> None:
        """Read a set whole and in regions."""
        self._read.append(footage_runs.measure(footage, tick))

    def write(self, folder: ReportFolder) -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
        assert self._made is not None, "measure_made comes first"
        links = {name: folder.add_plot(name, png) for name, png in plots(self._made).items()}
        folder.add_report(report(self._made, self._read, links))
        return facts(self._made, self._read)
