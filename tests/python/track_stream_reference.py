# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A second reader of track streams, written from docs/replay.md alone and as plain as can be."""

import zlib
from typing import Any

# By flag: the parts of a track.
PARTS = {
    0: ("x", "y"),
    8: ("w", "h", "dx", "dy"),
    16: ("vx", "vy"),
    32: ("sx", "sy", "r"),
}
MOTION = ("svx", "svy", "xx", "yy", "nx", "ny", "rv", "xy", "yx", "rn")
NAMES = [name for names in (*PARTS.values(), MOTION) for name in names]
DEVIATIONS = ("sx", "sy", "svx", "svy", "nx", "ny")
HEADER = ("width", "height", "rate", "ticks", "px", "speed", "octave", "correlation", "damping")


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
    assert stream.take(1) == b"\x02"
    body = Bytes(stream.take(stream.varint()))
    header = {name: body.varint() for name in HEADER}
    assert body.at == len(body.data)
    sealed(0)
    frames: list[dict[str, Any]] = []
    index, ticks, period = -1, None, round(1000 * header["ticks"] / header["rate"])
    before: dict[int, dict[str, Any]] = {}
    read_before: list[tuple[int, int, list[int]]] = []
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
        regions, whole = regions_of(record, read_before)
        assert record.at == len(record.data)
        frame = {"index": index, "time_s": ticks / header["ticks"], "tracks": tracks}
        frames.append({**frame, "regions": regions, "whole": whole})
        before, read_before = tracks, regions
    assert stream.at == len(data)
    return header, frames


def regions_of(
    record: Bytes, before: list[tuple[int, int, list[int]]]
) -> tuple[list[tuple[int, int, list[int]]], bool]:
    """(kind, track's id or 0, box) of each region, and whether the whole frame was read, too."""
    regions: list[tuple[int, int, list[int]]] = []
    if record.at == len(record.data):
        return regions, False
    count, whole = divmod(record.varint(), 2)
    for _ in range(count):
        [flags] = record.take(1)
        kind = flags & 3
        assert kind in (1, 2, 3) and flags < 8
        track_id = record.varint() if kind == 1 else 0
        rank = sum(1 for region in regions if region[:2] == (kind, track_id))
        alike = [box for *which, box in before if which == [kind, track_id]]
        box = alike[rank] if rank < len(alike) else [0, 0, 0, 0]
        regions.append((kind, track_id, [a + record.signed() for a in box] if flags & 4 else box))
    return regions, bool(whole)


def track_of(
    record: Bytes, before: dict[str, Any] | None, passed: int, header: dict[str, int]
) -> dict[str, Any]:
    [flags] = record.take(1)
    steps = dict.fromkeys(NAMES, 0) if before is None else dict(before["steps"])
    per = header["speed"] * header["ticks"]
    for place, speed in (("x", "vx"), ("y", "vy")):
        moved = steps[place] + (2 * steps[speed] * passed * header["px"] + per) // (2 * per)
        steps[place] = max(-(2**40), min(moved, 2**40))
    for flag, names in PARTS.items():
        for name in names if flags & flag == flag else ():
            steps[name] += record.signed()
    mask = record.varint() if flags & 64 else 0
    assert flags < 128 and mask < 1024
    for k, name in enumerate(MOTION):
        if mask & 2**k:
            steps[name] += record.signed()
    left = steps["x"] - steps["w"] // 2 + steps["dx"]
    top = steps["y"] - steps["h"] // 2 + steps["dy"]
    box = [left, top, steps["w"], steps["h"]]
    measured = [a + record.signed() for a in box] if flags & 4 else None
    of = {name: deviation(step, header) for name, step in steps.items() if name in DEVIATIONS}
    part = {name: step / header["correlation"] for name, step in steps.items()}
    return {
        "steps": steps,
        "status": flags & 3,
        "box": [side / header["px"] for side in box],
        "position": (steps["x"] / header["px"], steps["y"] / header["px"]),
        "velocity": (steps["vx"] / header["speed"], steps["vy"] / header["speed"]),
        "covariance": (of["sx"] ** 2, part["r"] * of["sx"] * of["sy"], of["sy"] ** 2),
        "rates": (of["svx"] ** 2, part["rv"] * of["svx"] * of["svy"], of["svy"] ** 2),
        "cross": tuple(part[a + b] * of["s" + a] * of["sv" + b] for a in "xy" for b in "xy"),
        "noise": (of["nx"] ** 2, part["rn"] * of["nx"] * of["ny"], of["ny"] ** 2),
        "measured": None if measured is None else [side / header["px"] for side in measured],
    }


def deviation(steps: int, header: dict[str, int]) -> float:
    return 0.0 if steps == -16 * header["octave"] else 2.0 ** (steps / header["octave"])
