# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How the vicinity factor (6) learns over the frames of a set."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.footage import Footage
from survtrack.experiments.trial import Variant, results_of

ENOUGH_UPDATES = 20  # of a cell, to be asked where its factor has gone
_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class Learning:
    """The grids of one run.

    Attributes:
        factor_y, factor_x: (frames, rows, columns), after each frame.
        updates: (rows, columns), displacements learned by the end.
        step_px: (rows, columns), their mean lengths, px per frame.
        max_factor: the upper clamp; the lower is 1.
    """

    factor_y: NDArray[np.float64]
    factor_x: NDArray[np.float64]
    updates: NDArray[np.int64]
    step_px: NDArray[np.float64]
    max_factor: float

    def busiest(self, count: int) -> list[tuple[int, int]]:
        """(row, column) of the cells with most updates, those without any left out."""
        order = np.argsort(-self.updates, axis=None, kind="stable")[:count]
        rows, columns = np.unravel_index(order, self.updates.shape)
        pairs = zip(rows.tolist(), columns.tolist(), strict=True)
        return [(row, column) for row, column in pairs if self.updates[row, column]]

    @property
    def mean_factor(self) -> float:
        """Mean of the factors at the end, Y and X, each cell by its updates; 1 without any."""
        if not self.updates.any():
            return 1.0
        both = (self.factor_y[-1] + self.factor_x[-1]) / 2
        return float(np.average(both, weights=self.updates))

    @property
    def mean_step_px(self) -> float:
        """Mean length of what it learned from, each cell by its updates; 0 without any."""
        if not self.updates.any():
            return 0.0
        return float(np.average(self.step_px, weights=self.updates))

    def at_clamp(self) -> tuple[int, int]:
        """How many factors, Y and X, stand at a clamp in the end, and of how many.

        Only cells with ENOUGH_UPDATES are asked.
        """
        asked = self.updates >= ENOUGH_UPDATES
        factors = np.concatenate([self.factor_y[-1][asked], self.factor_x[-1][asked]])
        clamped = (factors <= 1 + _ROUNDING) | (factors >= self.max_factor - _ROUNDING)
        return int(clamped.sum()), len(factors)


def learn(footage: Footage, variant: Variant) -> Learning:
    """Run a configuration with outputs.vicinity on a set."""
    config = variant.config(footage.frame_period_s)
    # The key -1 is the only class: nothing here classifies blobs.
    grids = [result.vicinity[-1] for result in results_of(footage, config)]
    return Learning(
        factor_y=np.array([grid.factor_y for grid in grids]),
        factor_x=np.array([grid.factor_x for grid in grids]),
        updates=np.array(grids[-1].updates, dtype=np.int64),
        step_px=np.array(grids[-1].mean_step_px),
        max_factor=grids[-1].max_factor,
    )
