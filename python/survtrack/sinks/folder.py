# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The folder of one run: what is in it, and run.json that says so."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from survtrack.errors import UsageError
from survtrack.sinks.masks import MASK_GLOB, masks_in
from survtrack.sinks.part_file import naming, write_whole

MANIFEST = "run.json"
CONFIG = "config.toml"
# What a run may leave besides config.toml and run.json, which every run writes; nothing else is
# ever removed from a folder.
OUTPUTS = (
    "tracks.txt",
    "events.jsonl",
    "tracks.csv",
    "tracks.svt",
    "matrices.jsonl",
    "path.csv",
    "scene.json",
    "link.jsonl",
    "patterns.json",
    "activities.csv",
    "patterns.png",
    "paths.json",
    "annotated.mp4",
    MASK_GLOB,
)


class RunFolder:
    """Output folder. It belongs to the last run that ended in it.

    The outputs of an earlier run stay until those of this one are put in place; finish() then
    removes the ones that this run did not write, so that nothing old poses as part of it.
    """

    def __init__(self, path: Path | str) -> None:
        """Looks at what an earlier run left; changes nothing."""
        self.path = Path(path)
        self._earlier = self._outputs_of_earlier_run()

    def make(self) -> None:
        """Make the folder when it is missing; raises OSError that names it."""
        with naming(self.path):
            self.path.mkdir(parents=True, exist_ok=True)

    def refuse_foreign_masks(self) -> None:
        """Raise UsageError when there are masks that no run of survtrack says are its own."""
        masks = [] if MASK_GLOB in self._earlier else masks_in(self.path)
        if masks:
            raise UsageError(
                f"{self.path}: holds {len(masks)} masks ({masks[0].name}, ...) that are not of an "
                "earlier run with its run.json; give another folder or remove them"
            )

    def finish(self, facts: Mapping[str, Any], config: str) -> None:
        """Write config.toml and run.json, remove what is left of an earlier run.

        Args:
            facts: what run.json says, as values that JSON knows; "outputs" are the names that
                this run's sinks put in place.
            config: text of the resolved config.

        Raises:
            OSError: a file cannot be written. An earlier run.json is then gone as well.
        """
        manifest = self.path / MANIFEST
        try:
            write_whole(self.path / CONFIG, config)
            for name in self._earlier - set(facts["outputs"]):
                self._remove(name)
            write_whole(manifest, json.dumps(facts, indent=2, allow_nan=False) + "\n")
        except OSError:
            manifest.unlink(missing_ok=True)
            raise

    def _remove(self, name: str) -> None:
        stale = masks_in(self.path) if name == MASK_GLOB else [self.path / name]
        for path in stale:
            path.unlink(missing_ok=True)

    def _outputs_of_earlier_run(self) -> set[str]:
        try:
            manifest = json.loads((self.path / MANIFEST).read_text(encoding="utf-8"))
            return {name for name in OUTPUTS if name in manifest["outputs"]}
        except (OSError, ValueError, KeyError, TypeError):
            return set()
