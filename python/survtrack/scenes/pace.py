# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How fast a way is gone, over time."""

from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import UsageError
from survtrack.scenes.checks import check_number

MAX_PERIODS = 100_000


@dataclass(frozen=True)
class Pace:
    """Speed that runs straight from knot to knot, and stays before the first and after the last.

    times_s: of the knots, rising; at the first the distance is 0.
    speeds_px_per_s: as many; below 0 goes backwards.
    """

    times_s: tuple[float, ...]
    speeds_px_per_s: tuple[float, ...]

    def __post_init__(self) -> None:
        """Raises UsageError."""
        if not self.times_s or len(self.times_s) != len(self.speeds_px_per_s):
            raise UsageError(
                f"pace: {len(self.times_s)} times and {len(self.speeds_px_per_s)} speeds; "
                "as many of both, 1 or more"
            )
        for name in ("times_s", "speeds_px_per_s"):
            for value in getattr(self, name):
                check_number(f"pace: {name}", value)
        if any(later <= time for time, later in zip(self.times_s, self.times_s[1:], strict=False)):
            raise UsageError(f"pace: times_s: {self.times_s} must rise")

    def speeds(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """(N,) px/s at (N,) seconds: the derivative of distances."""
        return np.interp(times_s, self.times_s, self.speeds_px_per_s)

    def distances(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """(N,) px gone at (N,) seconds, exactly: the integral of a straight line in each part."""
        knots, speeds = np.array(self.times_s), np.array(self.speeds_px_per_s)
        lengths = np.diff(knots)
        gone = np.concatenate([[0.0], np.cumsum(lengths * (speeds[:-1] + speeds[1:]) / 2)])
        gains = np.append(np.diff(speeds) / lengths, 0.0)
        part = np.maximum(np.searchsorted(knots, times_s, side="right") - 1, 0)
        since = times_s - knots[part]
        gain = np.where(since < 0, 0.0, gains[part])
        return np.asarray(gone[part] + speeds[part] * since + gain * since * since / 2)


def steady(speed_px_per_s: float, from_s: float = 0.0) -> Pace:
    """Always the same speed; distance 0 at from_s."""
    return Pace((from_s,), (speed_px_per_s,))


def surging(
    speed_px_per_s: float, swing: float, period_s: float, from_s: float, until_s: float
) -> Pace:
    """Up and down in straight lines, starting at the mean and upwards.

    Args:
        speed_px_per_s: the mean.
        swing: largest difference from the mean, in parts of it: 0 to 1.
        period_s: of one up and down, above 0.
        from_s, until_s: the time that it goes on for, at least.
    """
    check_number("swing", swing, least=0, most=1)
    check_number("period_s", period_s, above=0)
    check_number("number of periods", (until_s - from_s) / period_s, most=MAX_PERIODS)
    quarters = max(ceil(4 * (until_s - from_s) / period_s), 1)
    high, low = speed_px_per_s * (1 + swing), speed_px_per_s * (1 - swing)
    cycle = (speed_px_per_s, high, speed_px_per_s, low)
    times = tuple(from_s + k * period_s / 4 for k in range(quarters + 1))
    return Pace(times, tuple(cycle[k % 4] for k in range(quarters + 1)))
