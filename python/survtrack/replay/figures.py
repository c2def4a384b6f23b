# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a stream costs, against the video that it was made of."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from survtrack.errors import InputError
from survtrack.evaluation.files import read_bytes
from survtrack.replay.reader import TrackStreamReader
from survtrack.replay.values import StreamFrame
from survtrack.sinks.folder import MANIFEST

RAW_BYTES_PER_PX = 3


class StreamFigures:
    """Counts a stream while it is read.

    Attributes:
        frames: whole frames.
        first_s, last_s: times of the first and the last; None without any.
        first_index, last_index: their indices in the source.
        tracks: different ids.
    """

    def __init__(self, reader: TrackStreamReader) -> None:
        self._reader = reader
        self.frames = 0
        self.first_s: float | None = None
        self.last_s = 0.0
        self.first_index = self.last_index = 0
        self._ids: set[int] = set()

    @property
    def tracks(self) -> int:
        """Number of different ids."""
        return len(self._ids)

    @property
    def duration_s(self) -> float:
        """How long all frames last: the last one as long as the others do on the average."""
        if self.first_s is None:
            return 0.0
        if self.frames == 1:
            return 1 / self._reader.header.fps
        return (self.last_s - self.first_s) * self.frames / (self.frames - 1)

    def counted(self) -> Iterator[StreamFrame]:
        """The stream's frames, each counted before it is given."""
        for frame in self._reader:
            if self.first_s is None:
                self.first_s, self.first_index = frame.time_s, frame.index
            self.last_s, self.last_index = frame.time_s, frame.index
            self.frames += 1
            self._ids.update(track.id for track in frame.tracks)
            yield frame

    def facts(self, source_bytes: int | None) -> dict[str, Any]:
        """What the stream holds and costs; rates are null without frames.

        Args:
            source_bytes: size of the file(s) that it was made of; None: not known.
        """
        header = self._reader.header
        raw_bytes = header.width_px * header.height_px * RAW_BYTES_PER_PX * self.frames
        bytes_of = {"stream": self._reader.byte_count, "raw": raw_bytes, "source": source_bytes}
        return {
            "size": [header.width_px, header.height_px],
            "frames": {
                "first": self.first_index + 1 if self.frames else None,
                "last": self.last_index + 1 if self.frames else None,
                "count": self.frames,
            },
            "seconds": round(self.duration_s, 6),
            "tracks": self.tracks,
            **{f"{name}_bytes": count for name, count in bytes_of.items()},
            **{f"{name}_bytes_per_s": self._per_s(count) for name, count in bytes_of.items()},
            "raw_ratio": self._ratio(raw_bytes),
            "source_ratio": self._ratio(source_bytes),
        }

    def _per_s(self, count: int | None) -> float | None:
        return round(count / self.duration_s, 3) if count is not None and self.frames else None

    def _ratio(self, count: int | None) -> float | None:
        stream = self._reader.byte_count
        return round(count / stream, 3) if count is not None and self.frames else None


def source_bytes_of(path: Path) -> int | None:
    """Bytes of the source, as the run.json beside a stream says; None when there is none.

    Raises:
        InputError: there is a run.json that lists the stream, but cannot be understood.
    """
    manifest = path.parent / MANIFEST
    if not manifest.is_file():
        return None
    try:
        facts = json.loads(read_bytes(manifest).decode("utf-8"))
        if path.name not in facts["outputs"]:
            return None
        count = facts.get("source_bytes")
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"{manifest}: is not what a run leaves") from error
    if count is not None and (not isinstance(count, int) or isinstance(count, bool) or count < 0):
        raise InputError(f'{manifest}: "source_bytes" is {count!r}; a number of bytes is expected')
    return count
