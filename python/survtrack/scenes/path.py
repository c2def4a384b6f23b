# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where a way leads: lines and arcs that go on from one another without corners.

Headings are degrees from the x axis (to the right), clockwise as seen, since y points down: 90 is
down the picture.
"""

from dataclasses import dataclass
from math import ceil, cos, hypot, pi, radians, sin

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import UsageError
from survtrack.scenes.checks import check_number

CLOSED_WITHIN = 1e-6  # of its length
MAX_PIECES = 100_000


@dataclass(frozen=True)
class Path:
    """A way by its length: from `start` along the pieces.

    start: (x, y) in px.
    heading_deg: direction at the start.
    pieces: (length_px, turn_deg) each, length above 0: a line where turn is 0, else the arc of a
        circle on which the heading changes by turn. Before the first and after the last the way
        goes straight on; without any it is a line.
    closed: the end is the start, in place and heading, and the way goes round and round.
    """

    start: tuple[float, float]
    heading_deg: float = 0.0
    pieces: tuple[tuple[float, float], ...] = ()
    closed: bool = False

    def __post_init__(self) -> None:
        """Raises UsageError."""
        for name, value in zip(("start x", "start y"), self.start, strict=True):
            check_number(f"path: {name}", value)
        check_number("path: heading_deg", self.heading_deg)
        for length, turn in self.pieces:
            check_number("path: length_px", length, above=0)
            check_number("path: turn_deg", turn)
        if self.closed:
            self._refuse_gap()

    @property
    def length_px(self) -> float:
        """Of all pieces: one lap of a closed way."""
        return sum(length for length, _ in self.pieces)

    def locate(self, distances: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        """Points and directions on the way.

        Args:
            distances: (N,) px along it from the start; below 0 before it.

        Returns:
            (N, 2) points in px, and (N, 2) unit vectors.
        """
        joints = self._joints()
        along = np.mod(distances, self.length_px) if self.closed else distances
        piece = np.maximum(np.searchsorted(joints[:, 0], along, side="right") - 1, 0)
        begun, x, y, heading, bend = joints[piece].T
        rest = along - begun
        turned = np.where(rest < 0, 0.0, bend * rest)
        chord = rest * np.sinc(turned / (2 * pi))
        toward = heading + turned / 2
        points = np.stack([x + chord * np.cos(toward), y + chord * np.sin(toward)], axis=1)
        ahead = heading + turned
        return points, np.stack([np.cos(ahead), np.sin(ahead)], axis=1)

    def _joints(self) -> NDArray[np.float64]:
        """Rows (distance, x, y, heading, curvature in 1/px) where pieces begin; last the end."""
        distance, (x, y), heading = 0.0, self.start, radians(self.heading_deg)
        rows = []
        for length, turn_deg in self.pieces:
            turn = radians(turn_deg)
            rows.append((distance, x, y, heading, turn / length))
            chord = length * float(np.sinc(turn / (2 * pi)))
            x += chord * cos(heading + turn / 2)
            y += chord * sin(heading + turn / 2)
            heading += turn
            distance += length
        return np.array([*rows, (distance, x, y, heading, 0.0)])

    def _refuse_gap(self) -> None:
        _, x, y, heading, _ = self._joints()[-1]
        gap = hypot(x - self.start[0], y - self.start[1])
        turned = (heading - radians(self.heading_deg)) % (2 * pi)
        off = min(turned, 2 * pi - turned)
        if not self.pieces or gap > CLOSED_WITHIN * self.length_px or off > 1e-9:
            raise UsageError(
                f"path: is not closed: it ends {gap:g} px from its start, "
                f"{np.degrees(off):g} degrees off its heading"
            )


def weave(
    start: tuple[float, float], heading_deg: float, turn_deg: float, leg_px: float, length_px: float
) -> Path:
    """A way that winds about a line: arcs of leg_px that turn by turn_deg, left and right in turn.

    Args:
        start: (x, y) in px.
        heading_deg: of the line.
        turn_deg: the heading goes from half of it on one side to half of it on the other.
        leg_px: length of an arc, above 0.
        length_px: the arcs go on for at least this long.
    """
    check_number("leg_px", leg_px, above=0)
    check_number("number of legs", length_px / leg_px, most=MAX_PIECES)
    count = max(ceil(length_px / leg_px), 1)
    pieces = tuple((leg_px, -turn_deg if k % 2 == 0 else turn_deg) for k in range(count))
    return Path(start, heading_deg + turn_deg / 2, pieces)


def oval(center: tuple[float, float], width_px: float, height_px: float) -> Path:
    """A closed way: two level lines and two half circles, clockwise from the middle of the top.

    Args:
        center: (x, y) in px.
        width_px, height_px: over all; the width above the height.
    """
    check_number("oval: height_px", height_px, above=0)
    check_number("oval: width_px", width_px, above=height_px)
    x, y = center
    line, arc = width_px - height_px, pi * height_px / 2
    pieces = ((line / 2, 0.0), (arc, 180.0), (line, 0.0), (arc, 180.0), (line / 2, 0.0))
    return Path((x, y - height_px / 2), 0.0, pieces, closed=True)
