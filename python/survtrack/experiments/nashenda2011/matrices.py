# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The printed matrices beside those of the library's filter with the printed numbers."""

from dataclasses import dataclass

import numpy as np

import survtrack
from survtrack.experiments.nashenda2011 import filters, published
from survtrack.experiments.nashenda2011.published import Floats, Printed

ROUNDING = 0.5e-4 + 1e-9  # four decimals


@dataclass(frozen=True, eq=False)
class Compared:
    """One printed matrix and ours.

    Attributes:
        printed: as in the dissertation.
        ours: the same matrix of the recursion.
        largest: largest difference of any entry; without the misprint.
        misprint: (printed, ours) of the entry that is misprinted; None in the other matrices.
    """

    printed: Printed
    ours: Floats
    largest: float
    misprint: tuple[float, float] | None

    @property
    def same(self) -> bool:
        """To the four printed decimals, but for the misprint."""
        return self.largest <= ROUNDING


def compare() -> list[Compared]:
    """All printed matrices."""
    return [_compare(printed) for printed in published.PRINTED]


def recursion(q: float, updates: int) -> dict[str, Floats]:
    """P-, K and P after so many updates, by their names; they do not depend on the measurements."""
    filter = filters.one(q, "published")
    predicted = filter.P
    for _ in range(updates):
        filter.predict([1.0])
        predicted = filter.P
        filter.update(published.ENTERS)
    return {"P-": predicted, "K": filter.K, "P": filter.P}


def _compare(printed: Printed) -> Compared:
    ours = recursion(printed.q, printed.updates)[printed.name]
    away = np.abs(ours - printed.values)
    misprint = None
    if (printed.q, printed.name) == (10.0, "P-"):
        at = published.MISPRINT
        misprint = float(printed.values[at]), float(ours[at])
        away[at] = 0
    return Compared(printed, ours, float(away.max()), misprint)


def smallest_eigenvalues(q: float, R: Floats) -> Floats:
    """(FRAMES,) smallest eigenvalue of the innovation covariance in each frame."""
    filter = survtrack.KalmanFilter(
        F=filters.transition(),
        H=filters.H,
        Q=q * np.eye(4),
        R=R,
        x=np.zeros(4),
        P=published.START_VARIANCE * np.eye(4),
        validate=False,
    )
    smallest = []
    for _ in range(published.FRAMES):
        filter.predict()
        smallest.append(np.linalg.eigvalsh(filter.P[:2, :2] + R)[0])
        filter.update([0.0, 0.0])
    return np.array(smallest)
