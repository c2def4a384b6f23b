# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The contract of a sink, and the base of those that write lines."""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Protocol, Self

from survtrack.sinks.part_file import PartFile

if TYPE_CHECKING:
    from survtrack._core import FrameResult
    from survtrack.sources.base import Frame


class Sink(Protocol):
    """Takes the results of a run, one frame after the other.

    On entering it opens NAME.part, so that a place that cannot be written shows with the first
    result. On leaving, for whatever reason, it finishes what was written and renames it to NAME: a
    file called NAME is never half a file. Only when writing itself failed there is no NAME.
    """

    @property
    def outputs(self) -> list[str]:
        """Names put in place so far: none before the sink was left."""

    def __enter__(self) -> Self: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None: ...

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Take one frame, HxW or HxWx3 uint8, and what was found in it; OSError when it cannot."""


class TextSink(ABC):
    """A sink that turns each result into lines of a UTF-8 text file."""

    header = ""

    def __init__(self, path: Path | str) -> None:
        self._file = PartFile(Path(path))

    @property
    def outputs(self) -> list[str]:
        """The file's name once it is in place."""
        return [self._file.path.name] if self._file.done else []

    def __enter__(self) -> Self:
        self._file.open()
        self._file.write(self.header)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._file.finish()

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Append the lines of one result."""
        self._file.write("".join(f"{line}\n" for line in self.lines(result)))

    @abstractmethod
    def lines(self, result: "FrameResult") -> Iterable[str]:
        """Lines for one result, without their line ends."""
