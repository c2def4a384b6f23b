# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the thesis's listing (appendix), each written down alone, to be measured.

Nothing here is used to track. Contacts and filters are numbered from 0; positions are (x, y), px.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

START_VARIANCES = (9.0, 9.0, 25.0, 25.0, 49.0, 49.0)
_EYE = np.eye(2)
F = np.block([[_EYE, _EYE, _EYE / 2], [0 * _EYE, _EYE, _EYE], [0 * _EYE, 0 * _EYE, _EYE]])
H = np.hstack([_EYE, 0 * _EYE, 0 * _EYE])
FOLDED_H = np.hstack([_EYE, _EYE, _EYE / 2])  # eq. 9: H F of the standard form


class ListingFilter:
    """Constant acceleration, Q = q I, R = I; right but for the fault that is asked for.

    x: (6,) position, velocity, acceleration. P: (6, 6).
    """

    def __init__(
        self,
        position: Sequence[float] | Floats,
        *,
        plus_sign: bool = False,
        folded: bool = False,
        q: float = 0.5,
        rate: float = 0.0,
    ) -> None:
        """Args:
        position: where it starts.
        plus_sign: P = (I + K H) P instead of (I - K H) P.
        folded: H = [I, I, I/2], and the state is moved on after the measurement, not before.
        q: variance that each state gains in a frame.
        rate: velocity and acceleration at the start; the listing has 0.1.
        """
        self.x: Floats = np.array([*position, *4 * [rate]])
        self.P: Floats = np.diag(START_VARIANCES)
        self._sign = 1.0 if plus_sign else -1.0
        self._folded = folded
        self._Q: Floats = q * np.eye(6)

    def step(self, z: Sequence[float] | Floats | None) -> None:
        """One frame on, with a measurement or without."""
        if not self._folded:
            self._propagate()
        if z is not None:
            self._correct(np.asarray(z, np.float64), FOLDED_H if self._folded else H)
        if self._folded:
            self._propagate()

    @property
    def position(self) -> Floats:
        """(2,) of the state."""
        return self.x[:2].copy()

    def _propagate(self) -> None:
        self.x = F @ self.x
        self.P = F @ self.P @ F.T + self._Q

    def _correct(self, z: Floats, h: Floats) -> None:
        gain = self.P @ h.T @ np.linalg.inv(h @ self.P @ h.T + np.eye(2))
        self.x = self.x + gain @ (z - h @ self.x)
        self.P = (np.eye(6) + self._sign * gain @ h) @ self.P


def nearest_not_successive(filters: Floats, measured: Floats) -> list[int]:
    """The filter of each measurement, top to bottom: the nearest but the one given just before."""
    index: list[int] = []
    for z in measured:
        away = np.hypot(*(filters - z).T)
        if index:
            away[index[-1]] = np.inf
        index.append(int(np.argmin(away)))
    return index


def permuted_twice(
    index: Sequence[int], measured: Floats, before: Floats | None = None
) -> dict[int, Floats]:
    """What each filter is given: z is put into the order of the filters, and then z(:, i) is paired
    with filter index(i) all the same.

    Args:
        index: the filter of each measurement.
        measured: (N, 2), top to bottom.
        before: (M, 2) what the array held before; entries that nobody writes stay.
    """
    ordered = np.zeros((max(index) + 1, 2)) if before is None else before.copy()
    for k, filter in enumerate(index):
        ordered[filter] = measured[k]
    return {filter: ordered[k] for k, filter in enumerate(index)}


def stale_index(index: Sequence[int], new: Mapping[int, int]) -> list[int]:
    """The array after a frame with fewer measurements: only some entries are new."""
    return [new.get(k, filter) for k, filter in enumerate(index)]


def lost_by_sums(filters: int, seen: Sequence[int]) -> int:
    """The number of the lost filter: the sum of all numbers, from 1, less that of those seen."""
    return sum(range(1, filters + 1)) - sum(seen)


def summed_marker(losses: Sequence[tuple[int, Sequence[float]]], frame: int) -> Floats:
    """Where the lost contact is shown: the sum of the positions lost in the last 50 frames."""
    shown = [position for lost, position in losses if 0 <= frame - lost < 50]
    return np.asarray(np.sum(shown, axis=0))


def drop_state(filters: Sequence[ListingFilter], lost: int) -> list[ListingFilter]:
    """After a loss: states move up, the freed one goes to the end; covariances stay where they are.

    The filters are changed in place and returned.
    """
    states = [filter.x for k, filter in enumerate(filters) if k != lost] + [filters[lost].x]
    for filter, state in zip(filters, states, strict=True):
        filter.x = state
    return list(filters)


def frames_until_lost(counts: Sequence[int], contacts: int, more_than: int) -> int | None:
    """Frames of too low a count until more than so many of the last 25 are; None: never."""
    window = 25 * [contacts]
    for frame, count in enumerate(counts, 1):
        window = [*window[1:], count]
        if sum(one < contacts for one in window) > more_than:
            return frame
    return None


def printed_transition() -> tuple[Floats, tuple[str, ...]]:
    """Eq. 6 of Suliman et al. 2010: the shape that is printed, seven rows for six states, and the
    names on the right-hand side, of which one is missing."""
    return np.vstack([F, np.zeros((1, 6))]), ("x", "y", "v_y", "a_x", "a_y")
