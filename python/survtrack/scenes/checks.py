# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Checks of numbers that a user gave."""

from math import isfinite

from survtrack.errors import UsageError


def check_number(
    name: str,
    value: float,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
) -> None:
    """Raise UsageError that names it unless value is finite, > above, >= least and <= most."""
    if (
        not isfinite(value)
        or (above is not None and value <= above)
        or (least is not None and value < least)
        or (most is not None and value > most)
    ):
        limits = [
            f"{word} {limit:g}"
            for word, limit in (("above", above), ("at least", least), ("at most", most))
            if limit is not None
        ]
        allowed = " and ".join(limits) or "a finite number"
        raise UsageError(f"{name}: {value:g} is not allowed; {allowed}")


def check_integer(name: str, value: int, least: int, most: int) -> None:
    """Raise UsageError that names it unless value is a whole number from least to most."""
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise UsageError(f"{name}: {value} is not allowed; a whole number from {least} to {most}")
