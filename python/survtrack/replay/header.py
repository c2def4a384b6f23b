# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The first bytes of a track stream."""

from dataclasses import astuple, fields

from survtrack.errors import InputError
from survtrack.replay.values import StreamHeader
from survtrack.replay.varint import Damaged, Numbers, find, put

# As PNG's: no text begins so, and a transfer that changes line ends or the eighth bit shows.
MAGIC = b"\x89SVT\r\n\x1a\n"
VERSION = 2
CRC_BYTES = 4
MOST_HEADER_BYTES = 1024
MOST_STEP = 2**24  # of the units, and of the frame's sides
MOST_RATE_MHZ = 1_000_000_000
MOST_TICKS = 2**53
BOUNDS = {
    "rate_mhz": (1, MOST_RATE_MHZ),
    "ticks_per_s": (1, MOST_RATE_MHZ),
    "lost_damping_ticks": (0, MOST_TICKS),
}


def write_header(header: StreamHeader) -> bytes:
    """Magic, version and the header's fields, without the checksum.

    Raises:
        InputError: a field is out of its bounds.
    """
    problem = what_is_wrong(header)
    if problem is not None:
        raise InputError(f"the track stream's {problem}")
    body = bytearray()
    for value in astuple(header):
        put(body, value)
    data = bytearray(MAGIC + bytes([VERSION]))
    put(data, len(body))
    return bytes(data + body)


def header_length(data: bytes | bytearray) -> int | None:
    """Bytes of the header with its checksum, which may be more than there are; None: not known yet.

    Raises:
        InputError: the data does not begin as a track stream does, or is one of another version.
    """
    if data[: len(MAGIC)] != MAGIC[: len(data)]:
        raise InputError(f"is no track stream: it begins with {bytes(data[: len(MAGIC)])!r}")
    if len(data) > len(MAGIC) and data[len(MAGIC)] != VERSION:
        raise InputError(
            f"is a track stream of version {data[len(MAGIC)]}; this survtrack reads version "
            f"{VERSION}: `survtrack run --stream` writes it anew"
        )
    try:
        found = find(data, len(MAGIC) + 1) if len(data) > len(MAGIC) + 1 else None
    except Damaged as error:
        raise InputError(f"its header is damaged: {error}") from error
    if found is None:
        return None
    if found[0] > MOST_HEADER_BYTES:
        raise InputError(f"its header is damaged: it would have {found[0]} bytes")
    return found[1] + found[0] + CRC_BYTES


def read_header(data: bytes) -> StreamHeader:
    """The header of data that write_header() made; raises InputError when it is none."""
    try:
        found = find(data, len(MAGIC) + 1)
        if found is None:
            raise Damaged("it ends too early")
        numbers = Numbers(data[found[1] :])
        header = StreamHeader(*(numbers.number() for _ in fields(StreamHeader)))
        numbers.all_read()
    except Damaged as error:
        raise InputError(f"its header is damaged: {error}") from error
    problem = what_is_wrong(header)
    if problem is not None:
        raise InputError(f"its header's {problem}")
    return header


def what_is_wrong(header: StreamHeader) -> str | None:
    """Words for the first field that is out of its bounds; None when none is."""
    for each in fields(header):
        value = getattr(header, each.name)
        least, most = BOUNDS.get(each.name, (1, MOST_STEP))
        if not least <= value <= most:
            return f"{each.name} is {value}; {least} to {most} is allowed"
    return None
