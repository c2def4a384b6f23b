# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The folder of a report: report.md, plots, and results.json that says all of it is there."""

import json
import os
from pathlib import Path
from typing import Any

from survtrack.errors import UsageError
from survtrack.sinks.part_file import naming, part_of, write_whole

REPORT, RESULTS, PLOTS = "report.md", "results.json", "plots"


class ReportFolder:
    """Output folder, made when missing. Every file in it is NAME.part until it is whole.

    While results.json is there, the report and the plots are those it tells of: the first file
    that is written removes the one of an earlier report, finish() writes the new one last.
    """

    def __init__(self, path: Path) -> None:
        """Raises UsageError for a file, OSError that names the folder when it cannot be made."""
        if path.exists() and not path.is_dir():
            raise UsageError(f"--out {path}: is a file, a folder is needed")
        self.path = path
        self.plots: list[str] = []
        self._begun = False
        with naming(path):
            path.mkdir(parents=True, exist_ok=True)

    def add_plot(self, name: str, png: bytes) -> str:
        """Write plots/NAME.png; returns its path in the folder, for a link."""
        self._begin()
        path = self.path / PLOTS / f"{name}.png"
        with naming(path):
            path.parent.mkdir(exist_ok=True)
            part_of(path).write_bytes(png)
            os.replace(part_of(path), path)
        self.plots.append(f"{PLOTS}/{path.name}")
        return self.plots[-1]

    def add_report(self, text: str) -> None:
        """Write report.md."""
        self._begin()
        write_whole(self.path / REPORT, text)

    def finish(self, facts: dict[str, Any]) -> None:
        """Write results.json: the facts, and the names of the other files as "outputs"."""
        self._begin()
        whole = {**facts, "outputs": [REPORT, *self.plots]}
        write_whole(self.path / RESULTS, json.dumps(whole, indent=2, allow_nan=False) + "\n")

    def _begin(self) -> None:
        """Before the first file: what an earlier report says it left is removed."""
        if self._begun:
            return
        self._begun = True
        results = self.path / RESULTS
        for name in _plots_of(results):
            (self.path / PLOTS / name).unlink(missing_ok=True)
        with naming(results):
            results.unlink(missing_ok=True)


def _plots_of(results: Path) -> list[str]:
    """File names of the plots that an earlier results.json lists."""
    try:
        outputs = json.loads(results.read_text(encoding="utf-8"))["outputs"]
        return [Path(name).name for name in outputs if name.startswith(f"{PLOTS}/")]
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return []
