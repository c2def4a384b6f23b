# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a run learned of its scene."""

from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from survtrack.sinks.part_file import PartFile

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Pipeline
    from survtrack.sources.base import Frame


class LearnedScene:
    """Writes Pipeline.learned_scene() at the end of a run; load_learned_scene() reads it back."""

    def __init__(self, path: Path | str, pipeline: "Pipeline") -> None:
        """Args:
        path: the file to write, JSON.
        pipeline: the one that the results come from.
        """
        self._file = PartFile(Path(path))
        self._pipeline = pipeline

    @property
    def outputs(self) -> list[str]:
        """The file's name once it is in place."""
        return [self._file.path.name] if self._file.done else []

    def __enter__(self) -> Self:
        self._file.open()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            self._file.write(self._pipeline.learned_scene() + "\n")
        finally:
            self._file.finish()

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Nothing: the pipeline knows."""
