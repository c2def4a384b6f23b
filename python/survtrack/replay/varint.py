# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Whole numbers in as few bytes as they need: LEB128, and zigzag for those with a sign."""

MOST_BYTES = 9  # 63 bits


class Damaged(ValueError):
    """Bytes that no encoder writes."""


def put(data: bytearray, number: int) -> None:
    """Append a number of 0 to 2^63 - 1: seven bits a byte, the lowest first; bit 7: more follow."""
    while number > 0x7F:
        data.append(number & 0x7F | 0x80)
        number >>= 7
    data.append(number)


def put_signed(data: bytearray, number: int) -> None:
    """Append a number with a sign: 0, -1, 1, -2, ... are written as 0, 1, 2, 3, ..."""
    put(data, 2 * number if number >= 0 else -2 * number - 1)


def find(data: bytes | bytearray, at: int = 0) -> tuple[int, int] | None:
    """(number, place after it) of the number at `at`; None when its end is not there yet.

    Raises:
        Damaged: it has more than 63 bits.
    """
    number = 0
    for k, byte in enumerate(data[at : at + MOST_BYTES]):
        number |= (byte & 0x7F) << (7 * k)
        if byte < 0x80:
            return number, at + k + 1
    if len(data) - at >= MOST_BYTES:
        raise Damaged("a number has more than 63 bits")
    return None


class Numbers:
    """Reads the numbers of a whole record, one after the other; Damaged where there is none."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    @property
    def left(self) -> int:
        """Bytes that were not read yet."""
        return len(self._data) - self._at

    def byte(self) -> int:
        """The next byte."""
        if self._at >= len(self._data):
            raise Damaged("it ends within a number")
        self._at += 1
        return self._data[self._at - 1]

    def number(self) -> int:
        """The next number without a sign."""
        found = find(self._data, self._at)
        if found is None:
            raise Damaged("it ends within a number")
        number, self._at = found
        return number

    def signed(self) -> int:
        """The next number with a sign."""
        number = self.number()
        return number >> 1 if number & 1 == 0 else -((number + 1) >> 1)

    def all_read(self) -> None:
        """Raises Damaged unless nothing is left."""
        if self.left:
            raise Damaged(f"{self.left} byte(s) are left over")
