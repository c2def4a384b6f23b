# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From results to the bytes of a track stream."""

import math
import zlib
from dataclasses import replace
from typing import TYPE_CHECKING

from survtrack.errors import InputError, UsageError
from survtrack.replay.damping import check_damping
from survtrack.replay.header import CRC_BYTES, MOST_RATE_MHZ, write_header
from survtrack.replay.places import places_of
from survtrack.replay.records import Foresight, Moment, write_record
from survtrack.replay.states import State, quantized
from survtrack.replay.values import StreamHeader
from survtrack.replay.varint import put

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Track


class TrackStreamEncoder:
    """Makes the pieces of one stream, in order: header(), then frame() for each result, then end().

    What each gives can be sent at once: a reader needs nothing that comes later.
    """

    def __init__(
        self, size: tuple[int, int], *, fps: float, lost_damping_s: float | None = None
    ) -> None:
        """Args:
        size: (width, height) of the frames in px, each 1 to 2^24.
        fps: nominal results per second, 0.001 to 1e6.
        lost_damping_s: in which the filter lets the velocity of a lost track fall to 1/e, 0 (it
            stands at once) to 1e9; None: it does not fall. lost_damping_s(config) knows.

        Raises:
            UsageError: fps or lost_damping_s is out of its bounds.
            InputError: size is.
        """
        if not (math.isfinite(fps) and 0.001 <= fps <= MOST_RATE_MHZ / 1000):
            raise UsageError(f"fps: {fps} frames/s is not allowed in a track stream; 0.001 to 1e6")
        check_damping(lost_damping_s)
        header = StreamHeader(*size, rate_mhz=round(1000 * fps))
        if lost_damping_s is not None:
            ticks = max(1, round(lost_damping_s * header.ticks_per_s))
            header = replace(header, lost_damping_ticks=ticks)
        self._header = header
        self._start = write_header(self._header)
        self._foresight = Foresight(self._header)
        self._crc = 0

    def header(self) -> bytes:
        """The first bytes."""
        self._crc = 0
        return self._sealed(self._start)

    def frame(self, result: "FrameResult") -> bytes:
        """The record of one result.

        Raises:
            InputError: index or time do not rise, an id is below 1, or a number is not finite.
        """
        time_s = result.time_s
        if not math.isfinite(time_s):
            raise InputError(f"frame {result.index + 1}: its time is {time_s} s")
        states = {track.id: self._state(track, result) for track in result.tracks if track.reported}
        ticks = math.floor(time_s * self._header.ticks_per_s + 0.5)
        places = places_of(result, self._header)
        record = write_record(Moment(result.index, ticks, states, places), self._foresight)
        data = bytearray()
        put(data, len(record))
        return self._sealed(bytes(data + record))

    def end(self) -> bytes:
        """The end mark: an empty record. Without it a reader says that the stream is cut."""
        return self._sealed(b"\0")

    def _state(self, track: "Track", result: "FrameResult") -> State:
        own = track.status.name == "confirmed" and track.detection >= 0 and track.group == 0
        return quantized(track, result.detections[track.detection] if own else None, self._header)

    def _sealed(self, data: bytes) -> bytes:
        """With the checksum of the stream up to here: no record can be lost or doubled unseen."""
        self._crc = zlib.crc32(data, self._crc)
        return data + self._crc.to_bytes(CRC_BYTES, "little")
