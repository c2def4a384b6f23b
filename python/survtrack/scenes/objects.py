# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One object of a scene: what it looks like, where it goes, how fast, and when it is there."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.scenes.body import Body
from survtrack.scenes.checks import check_integer, check_number
from survtrack.scenes.pace import Pace
from survtrack.scenes.path import Path

MAX_ID = 2**31 - 1  # masks of identities are int32


@dataclass(frozen=True)
class SceneObject:
    """An object that moves on a way.

    id: 1 or more; its texture, and the noise of its measurements, follow from it and the seed.
    body: its looks.
    path, pace: where it goes on the ground, and how fast.
    from_s, until_s: it is there at times t with from_s <= t < until_s; None without limit.
    """

    id: int
    body: Body
    path: Path
    pace: Pace
    from_s: float | None = None
    until_s: float | None = None

    def __post_init__(self) -> None:
        """Raises UsageError."""
        check_integer("id", self.id, 1, MAX_ID)
        for name in ("from_s", "until_s"):
            if getattr(self, name) is not None:
                check_number(f"object {self.id}: {name}", getattr(self, name))

    def motion(
        self, times_s: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Where its centre is on the ground.

        Returns:
            (N, 2) positions in px, (N, 2) velocities in px/s, (N,) px gone on its way.
        """
        distances = self.pace.distances(times_s)
        points, directions = self.path.locate(distances)
        return points, directions * self.pace.speeds(times_s)[:, None], distances

    def present(self, times_s: NDArray[np.float64]) -> NDArray[np.bool_]:
        """(N,) whether it is there at all."""
        begun = np.full(times_s.shape, True) if self.from_s is None else times_s >= self.from_s
        return begun if self.until_s is None else begun & (times_s < self.until_s)
