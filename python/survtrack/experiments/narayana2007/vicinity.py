# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How each form of the vicinity factor (6) learns over the frames of a set."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.footage import Footage
from survtrack.experiments.narayana2007.variants import with_form
from survtrack.experiments.trial import results_of

ENOUGH_UPDATES = 20  # of a cell, to be asked where its factor has gone
_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class Learning:
    """The grids of one form.

    Attributes:
        factor_y, factor_x: (frames, rows, columns), after each frame.
        updates: (rows, columns), displacements learned by the end.
        max_factor: the upper clamp; the lower is 1.
    """

    factor_y: NDArray[np.float64]
    factor_x: NDArray[np.float64]
    updates: NDArray[np.int64]
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

    def at_clamp(self) -> tuple[int, int]:
        """How many factors, Y and X, stand at a clamp in the end, and of how many.

        Only cells with ENOUGH_UPDATES are asked.
        """
        asked = self.updates >= ENOUGH_UPDATES
        factors = np.concatenate([self.factor_y[-1][asked], self.factor_x[-1][asked]])
        clamped = (factors <= 1 + _ROUNDING) | (factors >= self.max_factor - _ROUNDING)
        return int(clamped.sum()), len(factors)


def learn(footage: Footage, form: str) -> Learning:
    """Run one form on a set."""
    config = with_form(form).config(footage.frame_period_s)
    # The key -1 is the only class: nothing here classifies blobs.
    grids = [result.vicinity[-1] for result in results_of(footage, config)]
    return Learning(
        factor_y=np.array([grid.factor_y for grid in grids]),
        factor_x=np.array([grid.factor_x for grid in grids]),
        updates=np.array(grids[-1].updates, dtype=np.int64),
        max_factor=grids[-1].max_factor,
    )
