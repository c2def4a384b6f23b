# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Track streams in files."""

from collections.abc import Iterator
from pathlib import Path

from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath
from survtrack.replay.decoder import TrackStreamDecoder
from survtrack.replay.values import RecordedStream, StreamFrame, StreamHeader

PIECE_BYTES = 2**16


class TrackStreamReader:
    """Iterates over the frames of a file; only a piece of it is in memory at a time.

    Attributes:
        header: what the stream says of itself; known before the first frame.
    """

    def __init__(self, path: StrPath) -> None:
        """Reads the header.

        Raises:
            InputError: the file cannot be read, is no track stream, is of another version, or ends
                within its header.
        """
        self._path = Path(path)
        self._decoder = TrackStreamDecoder(str(self._path))
        for _ in _pieces(self._path, self._decoder):
            if self._decoder.header is not None:
                break
        if self._decoder.header is None:
            raise InputError(
                self._decoder.problem if self._path.stat().st_size else f"{path}: is empty"
            )
        self.header: StreamHeader = self._decoder.header

    @property
    def problem(self) -> str | None:
        """After the last frame: why there may have been more; None when the stream is whole."""
        return self._decoder.problem

    @property
    def byte_count(self) -> int:
        """Bytes of the header and the frames read so far, and of the end mark."""
        return self._decoder.byte_count

    def __iter__(self) -> Iterator[StreamFrame]:
        """Each frame, from the first; raises InputError when the file can no longer be read."""
        self._decoder = TrackStreamDecoder(str(self._path))
        for frames in _pieces(self._path, self._decoder):
            yield from frames


def read_track_stream(path: StrPath) -> RecordedStream:
    """All whole frames of a track stream, also of one that is cut, damaged or still being written.

        stream = read_track_stream("out/tracks.svt")
        for frame in stream.frames:
            print(frame.time_s, [(track.id, track.box) for track in frame.tracks])

    Returns:
        The frames; `problem` says whether it was cut or damaged after them.

    Raises:
        InputError: as TrackStreamReader.
    """
    reader = TrackStreamReader(path)
    frames = list(reader)
    return RecordedStream(reader.header, frames, reader.problem, reader.byte_count)


def _pieces(path: Path, decoder: TrackStreamDecoder) -> Iterator[list[StreamFrame]]:
    """The frames of each piece of the file."""
    try:
        with path.open("rb") as file:
            while not decoder.damaged and (piece := file.read(PIECE_BYTES)):
                yield decoder.feed(piece)
    except IsADirectoryError as error:
        raise InputError(f"{path}: is a folder, a file is needed") from error
    except FileNotFoundError as error:
        raise InputError(f"{path}: no such file") from error
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error
