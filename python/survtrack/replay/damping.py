# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How the velocity of a lost track falls."""

import math
from typing import TYPE_CHECKING

from survtrack._core import MeanVelocityOptions
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import Config

MOST_DAMPING_S = 1e9


def lost_damping_s(config: "Config") -> float | None:
    """In which time the config's filter lets the velocity of a lost track fall to 1/e, s.

    Returns:
        0 where a lost track stays where it is (`mean_velocity` without `extrapolate_lost`); None
        where the velocity does not fall, or takes more than 1e9 s for it.
    """
    options = config.filter
    if isinstance(options, MeanVelocityOptions):
        return None if options.extrapolate_lost else 0.0
    time_s: float = getattr(options, "lost_damping_time", 0.0) * config.time_unit_s
    return time_s if 0 < time_s <= MOST_DAMPING_S else None


def check_damping(damping_s: float | None) -> None:
    """Raises UsageError unless it is None, or 0 to 1e9 s."""
    if not (damping_s is None or 0 <= damping_s <= MOST_DAMPING_S):
        raise UsageError(f"lost_damping: {damping_s} s is not allowed; 0 to 1e9, or None")


def damped(passed_s: float, damping_s: float | None) -> tuple[float, float]:
    """What of a velocity is left after a time, and for how many s at full speed it went so far.

    v' = -v / tau: e^(-t / tau) and tau (1 - e^(-t / tau)).
    """
    if damping_s is None:
        return 1.0, passed_s
    if damping_s == 0:
        return float(passed_s == 0), 0.0
    return math.exp(-passed_s / damping_s), -damping_s * math.expm1(-passed_s / damping_s)
