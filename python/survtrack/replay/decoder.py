# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From the bytes of a track stream to its frames, as they come."""

import zlib

from survtrack.errors import InputError
from survtrack.replay.header import CRC_BYTES, header_length, read_header
from survtrack.replay.places import regions_of
from survtrack.replay.records import MOST_RECORD_BYTES, Foresight, Moment, read_record
from survtrack.replay.states import restored
from survtrack.replay.values import StreamFrame, StreamHeader
from survtrack.replay.varint import Damaged, find


class TrackStreamDecoder:
    """Takes a stream in pieces of any size: of a file that grows, or of a connection.

        decoder = TrackStreamDecoder()
        for piece in pieces:
            for frame in decoder.feed(piece):
                print(frame.time_s, [track.id for track in frame.tracks])

    Attributes:
        header: None until it is whole.
        frame_count: frames given so far.
        byte_count: bytes of the header and of these frames, and of the end mark.
        ended: the end mark came.
    """

    def __init__(self, name: str = "the track stream") -> None:
        """Args:
        name: begins the messages, such as the file's name.
        """
        self._name = name
        self._data = bytearray()
        self._taken = b""
        self._crc = 0
        self._damage: str | None = None
        self._foresight: Foresight | None = None
        self.header: StreamHeader | None = None
        self.frame_count = 0
        self.byte_count = 0
        self.ended = False

    @property
    def damaged(self) -> bool:
        """True after bytes that no encoder writes; nothing after them is looked at."""
        return self._damage is not None

    @property
    def problem(self) -> str | None:
        """What is wrong if no more bytes come; None when the stream is whole."""
        after = (
            f"after frame {self.frame_count} of it" if self.frame_count else "in its first frame"
        )
        if self._damage is not None:
            return f"{self._name}: is damaged {after}: {self._damage}"
        if self.ended:
            return None
        if self.header is None:
            return f"{self._name}: is cut in its header; it holds no frames"
        before = "what was before is whole" if self.frame_count else "it holds no whole frame"
        return f"{self._name}: is cut {after}; {before}"

    def feed(self, data: bytes) -> list[StreamFrame]:
        """The frames that these bytes complete; none after damage.

        Raises:
            InputError: what came is no track stream, is of another version, or has a damaged
                header.
        """
        if self.damaged:
            return []
        self._data += data
        try:
            if self.header is None:
                self._read_header()
            return [] if self.header is None else self._read_frames(self.header)
        except InputError as error:
            raise InputError(f"{self._name}: {error}") from error

    def _read_header(self) -> None:
        length = header_length(self._data)
        if length is None or len(self._data) < length:
            return
        if not self._take_sealed(length):
            raise InputError("its header is damaged: its checksum is wrong")
        self.header = read_header(self._taken)
        self._foresight = Foresight(self.header)

    def _read_frames(self, header: StreamHeader) -> list[StreamFrame]:
        frames = []
        try:
            while not self.ended and (moment := self._next_moment(header)) is not None:
                frames.append(_frame(moment, header))
                self.frame_count += 1
            if self.ended and self._data:
                raise Damaged("more bytes follow its end")
        except Damaged as error:
            self._damage = str(error)
            self._data.clear()
        return frames

    def _next_moment(self, header: StreamHeader) -> Moment | None:
        """The next record's; None when it is not whole yet, or is the end mark."""
        found = find(self._data)
        if found is None:
            return None
        length, start = found
        if length > MOST_RECORD_BYTES:
            raise Damaged(f"a record would have {length} bytes")
        if len(self._data) < start + length + CRC_BYTES:
            return None
        if not self._take_sealed(start + length + CRC_BYTES):
            raise Damaged("its checksum is wrong")
        if length == 0:
            self.ended = True
            return None
        assert self._foresight is not None
        return read_record(self._taken[start:], self._foresight, header)

    def _take_sealed(self, length: int) -> bool:
        """Move the first bytes to _taken, without their checksum; False when that is wrong."""
        self._taken = bytes(self._data[: length - CRC_BYTES])
        seal = int.from_bytes(self._data[length - CRC_BYTES : length], "little")
        self._crc = zlib.crc32(self._taken, self._crc)
        if self._crc != seal:
            return False
        del self._data[:length]
        self.byte_count += length
        return True


def _frame(moment: Moment, header: StreamHeader) -> StreamFrame:
    tracks = tuple(restored(track_id, state, header) for track_id, state in moment.states.items())
    regions = regions_of(moment.places, header)
    return StreamFrame(moment.index, moment.ticks / header.ticks_per_s, tracks, regions=regions)
