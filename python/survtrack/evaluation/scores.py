# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a field of scores says of itself: its published name, its meaning, its unit."""

from dataclasses import Field, field
from typing import Any


def score(meaning: str, key: str = "", *, percent: bool = False) -> Any:
    """A dataclass field for a score.

    Args:
        meaning: what it says, in a few words.
        key: its name in papers and in JSON; empty when it is the field's own.
        percent: whether it is a percentage that people read with one decimal.
    """
    return field(metadata={"key": key, "meaning": meaning, "percent": percent})


def score_key(entry: "Field[Any]") -> str:
    """The name of a score for readers and programs."""
    return str(entry.metadata["key"] or entry.name)
