# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What every published experiment has."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from survtrack.experiments.folder import ReportFolder
    from survtrack.experiments.footage import Footage
    from survtrack.sources.base import Size


class Experiment(Protocol):
    """Measures one set of footage after the other, then writes what it found."""

    @property
    def size(self) -> "Size":
        """(width, height) of the published frames in pixels, which its thresholds are made for."""

    @property
    def sets(self) -> tuple[str, ...]:
        """Names of the public sets (datasets.PUBLIC) that it runs on when none is given."""

    @property
    def runs(self) -> int:
        """How many times each set goes through a pipeline."""

    @property
    def made_frames(self) -> int:
        """Synthetic frames that go through a tracker; with any, it can do without footage."""

    def measure_made(self, tick: Callable[[int], None]) -> None:
        """Run all that needs no footage, first; `tick` gets the number of frames of each run."""

    def measure(self, footage: "Footage", tick: Callable[[], None]) -> None:
        """Run everything on one set and remember the numbers; `tick` is called after each run."""

    def write(self, folder: "ReportFolder") -> dict[str, Any]:
        """Write report.md and its plots; returns what results.json says besides the versions."""
