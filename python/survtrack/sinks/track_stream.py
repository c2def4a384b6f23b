# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The tracked states alone, and where they were looked for, as few bytes as they need."""

from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from survtrack.replay.encoder import TrackStreamEncoder
from survtrack.sinks.part_file import BytesPartFile

if TYPE_CHECKING:
    from survtrack._core import FrameResult
    from survtrack.sources.base import Frame


class TrackStream:
    """Writes reported tracks and regions of each result as a track stream, as in docs/replay.md.

    Each frame can be read as soon as it is written, in NAME.part while the run goes on.
    survtrack.replay.read_track_stream() reads it back. A run without frames leaves no file.
    """

    def __init__(
        self, path: Path | str, *, fps: float, lost_damping_s: float | None = None
    ) -> None:
        """Args:
        path: the file to write.
        fps: nominal results per second; a reader knows by it where frames are missing.
        lost_damping_s: as of TrackStreamEncoder: survtrack.replay.lost_damping_s(config).
        """
        self._file = BytesPartFile(Path(path))
        self._fps = fps
        self._lost_damping_s = lost_damping_s
        self._encoder: TrackStreamEncoder | None = None

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
        if self._encoder is None:
            self._file.discard()
            return
        try:
            if not self._file.failed:
                self._file.write(self._encoder.end())
        finally:
            self._file.finish()

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Append what one result has, to be seen at once by whoever follows the file.

        Raises:
            InputError: as TrackStreamEncoder.frame; nothing of this frame is written.
            OSError: it cannot be written.
        """
        if self._encoder is None:
            height, width = result.frame.shape[:2]
            self._encoder = TrackStreamEncoder(
                (width, height), fps=self._fps, lost_damping_s=self._lost_damping_s
            )
            self._file.write(self._encoder.header())
        self._file.write(self._encoder.frame(result))
        self._file.flush()
