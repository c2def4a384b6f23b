# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Which frames of a source are wanted."""

from dataclasses import dataclass

from survtrack.errors import InputError, UsageError


@dataclass(frozen=True)
class Selection:
    """Frames start, start + step, start + 2 step, ... of a source, at most `limit` of them.

    Attributes:
        start: how many frames of the source are skipped first; 0 or more.
        step: every step-th frame is taken; 1 or more.
        limit: most frames taken; None for all, else 1 or more.
    """

    start: int = 0
    step: int = 1
    limit: int | None = None

    def __post_init__(self) -> None:
        for name, least in (("start", 0), ("step", 1), ("limit", 1)):
            value = getattr(self, name)
            if value is not None and value < least:
                raise UsageError(f"{name}: {value} is not allowed; {least} or more")

    def wants(self, index: int) -> bool:
        """True when frame `index` is selected, the limit left aside."""
        return index >= self.start and (index - self.start) % self.step == 0

    def indices(self, count: int) -> range:
        """Selected indices of a source of `count` frames."""
        chosen = range(self.start, count, self.step)
        return chosen if self.limit is None else chosen[: self.limit]

    def expected_count(self, declared: int | None) -> int | None:
        """How many frames will come, by the declared count; None when nobody knows."""
        return self.limit if declared is None else len(self.indices(declared))

    def refuse_nothing(self, name: str, count: int) -> None:
        """Raise when a source of `count` frames has no selected one.

        Raises:
            InputError: the source holds no frames at all.
            UsageError: it does, but they end before `start`.
        """
        if count == 0:
            raise InputError(f"{name}: holds no frames")
        if self.start >= count:
            raise UsageError(f"start: {self.start} skips all {count} frames of {name}")
