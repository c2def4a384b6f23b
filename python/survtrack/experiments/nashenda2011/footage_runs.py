# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Footage as several runs at about the published frame rate, and the errors of a filter on them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.following import rms
from survtrack.experiments.nashenda2011 import filters
from survtrack.experiments.nashenda2011.filters import Way

Floats = NDArray[np.float64]

SETTLED = 5  # frames that a filter is given before its error counts
GAP = 2  # frames hidden, as in figure 21


@dataclass(frozen=True)
class FootageErrors:
    """Root mean squares of the distance, px.

    Attributes:
        truth_px: to the centre of the true box, where the blob is of that object.
        measured_px: to the measurement, in the same frames.
        hidden_px: to the centre of the true box in the last frame of a gap of GAP, all gaps.
    """

    truth_px: float
    measured_px: float
    hidden_px: float


@dataclass(frozen=True, eq=False)
class Runs:
    """The footage as runs side by side.

    z, true: (T, N, 2) measured and true positions, px; scored: (T, N) whether errors count.
    start: of the filters, (x, y). period_s: between two frames of a run.
    """

    z: Floats
    true: Floats
    scored: NDArray[np.bool_]
    start: tuple[float, float]
    period_s: float

    def estimates(self, q: float, way: Way, z: Floats | None = None) -> Floats:
        """(T, N, 2) of the measurements, or of others."""
        seen = self.z if z is None else z
        return filters.estimates(seen, q, way, self.start, self.period_s)

    def rms_to(self, others: Floats, at: Floats) -> float:
        """Of the distance where errors count, px."""
        return rms(_away(at, others)[self.scored])

    def errors(self, q: float, way: Way) -> FootageErrors:
        """Of one filter."""
        at = self.estimates(q, way)
        return FootageErrors(
            self.rms_to(self.true, at), self.rms_to(self.z, at), self._hidden_px(q, way)
        )

    def _hidden_px(self, q: float, way: Way) -> float:
        """Rms distance in the last frame of each gap that ends where errors count."""
        away = []
        for end in range(SETTLED + GAP - 1, len(self.z)):
            seen = self.z[: end + 1].copy()
            seen[end - GAP + 1 :] = np.nan
            at = self.estimates(q, way, seen)[end]
            away.append(_away(at, self.true[end])[self.scored[end]])
        return rms(np.concatenate(away))


def _away(positions: Floats, others: Floats) -> Floats:
    return np.asarray(np.hypot(*np.moveaxis(positions - others, -1, 0)))
