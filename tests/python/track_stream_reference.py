# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A second reader of track streams, written from docs/replay.md alone and as plain as can be."""

import zlib
from typing import Any

NAMES = ("x", "y", "w", "h", "dx", "dy", "vx", "vy", "sx", "sy", "r")


class Bytes:
    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def take(self, count: int) -> bytes:
        assert self.at + count <= len(self.data)
        self.at += count
        return self.data[self.at - count : self.at]

    def varint(self) -> int:
        number = shift = 0
        while True:
            [byte] = self.take(1)
            number += (byte % 128) << shift
            shift += 7
            if byte < 128:
                return number

    def signed(self) -> int:
        number = self.varint()
        return -(number + 1) // 2 if number % 2 else number // 2


def read(data: bytes) -> tuple[dict[str, int], list[dict[str, Any]]]:
    """The header's fields and the frames of a whole stream; asserts what the format says."""
    stream, crc = Bytes(data), 0

    def sealed(since: int) -> None:
        nonlocal crc
        crc = zlib.crc32(data[since : stream.at], crc)
        assert int.from_bytes(stream.take(4), "little") == crc

    assert stream.take(8) == bytes([0x89, 0x53, 0x56, 0x54, 0x0D, 0x0A, 0x1A, 0x0A])
    assert stream.take(1) == b"\x01"
    body = Bytes(stream.take(stream.varint()))
    names = ("width", "height", "rate", "ticks", "px", "speed", "octave", "correlation")
    header = {name: body.varint() for name in names}
    assert body.at == len(body.data)
    sealed(0)
    frames: list[dict[str, Any]] = []
    index, ticks, period = -1, None, round(1000 * header["ticks"] / header["rate"])
    before: dict[int, dict[str, Any]] = {}
    while True:
        since = stream.at
        record = Bytes(stream.take(stream.varint()))
        sealed(since)
        if not record.data:
            break
        index += 1 + record.varint()
        if ticks is None:
            passed, ticks = 0, record.signed()
        else:
            passed = period + record.signed()
            period, ticks = passed, ticks + passed
        tracks: dict[int, dict[str, Any]] = {}
        track_id = 0
        for _ in range(record.varint()):
            track_id += 1 + record.varint()
            tracks[track_id] = track_of(record, before.get(track_id), passed, header)
        assert record.at == len(record.data)
        frames.append({"index": index, "time_s": ticks / header["ticks"], "tracks": tracks})
        before = tracks
    assert stream.at == len(data)
    return header, frames


def track_of(
    record: Bytes, before: dict[str, Any] | None, passed: int, header: dict[str, int]
) -> dict[str, Any]:
    [flags] = record.take(1)
    steps = dict.fromkeys(NAMES, 0) if before is None else dict(before["steps"])
    per = header["speed"] * header["ticks"]
    for place, speed in (("x", "vx"), ("y", "vy")):
        moved = steps[place] + (2 * steps[speed] * passed * header["px"] + per) // (2 * per)
        steps[place] = max(-(2**40), min(moved, 2**40))
    steps["x"] += record.signed()
    steps["y"] += record.signed()
    for flag, names in ((8, "w h dx dy"), (16, "vx vy"), (32, "sx sy r")):
        for name in names.split() if flags & flag else ():
            steps[name] += record.signed()
    left = steps["x"] - steps["w"] // 2 + steps["dx"]
    top = steps["y"] - steps["h"] // 2 + steps["dy"]
    box = [left, top, steps["w"], steps["h"]]
    measured = [a + record.signed() for a in box] if flags & 4 else None
    none = -16 * header["octave"]
    sx, sy = (0 if steps[s] == none else 2 ** (steps[s] / header["octave"]) for s in ("sx", "sy"))
    return {
        "steps": steps,
        "status": flags & 3,
        "box": [side / header["px"] for side in box],
        "position": (steps["x"] / header["px"], steps["y"] / header["px"]),
        "velocity": (steps["vx"] / header["speed"], steps["vy"] / header["speed"]),
        "covariance": (sx**2, steps["r"] / header["correlation"] * sx * sy, sy**2),
        "measured": None if measured is None else [side / header["px"] for side in measured],
    }
