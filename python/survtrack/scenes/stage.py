# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the makers of ready-made scenes are given, and what they answer."""

from dataclasses import dataclass
from math import cos, inf, radians, sin
from typing import NamedTuple

from survtrack.errors import UsageError
from survtrack.scenes.body import Body
from survtrack.scenes.checks import check_integer
from survtrack.scenes.conditions import Conditions
from survtrack.scenes.layers import Point
from survtrack.scenes.objects import SceneObject

MAX_CONTACTS = 1000


@dataclass(frozen=True)
class Stage:
    """Everything that a scene's maker has to go by.

    name: of the scene.
    size: (width, height) in px.
    duration_s: until the end of the last frame.
    seed: of the scene.
    body: the looks of all contacts.
    """

    name: str
    size: tuple[int, int]
    duration_s: float
    seed: int
    body: Body

    @property
    def center(self) -> Point:
        """Of the frame, px."""
        return self.size[0] / 2, self.size[1] / 2

    def entry(self, through: Point, heading_deg: float) -> Point:
        """Where a contact that goes straight through a point of the frame is just outside."""
        distance = self.distance_out(through, heading_deg + 180)
        turn = radians(heading_deg)
        return through[0] - distance * cos(turn), through[1] - distance * sin(turn)

    def distance_out(self, point: Point, heading_deg: float) -> float:
        """How far a contact goes straight from a point of the frame until none of it is inside."""
        turn = radians(heading_deg)
        reach = (self.body.width_px / 2, self.body.height_px / 2)
        distances = []
        for along, start, side, half in zip(
            (cos(turn), sin(turn)), point, self.size, reach, strict=True
        ):
            edge = side + half if along > 0 else -half
            distances.append((edge - start) / along if abs(along) > 1e-12 else inf)
        return min(distances)

    def require(self, what: str, at_s: float) -> None:
        """Raise UsageError unless what a scene is made to show happens before its end."""
        if at_s >= self.duration_s:
            raise UsageError(
                f"{self.name}: {what} at {at_s:.2f} s, but the scene ends at "
                f"{self.duration_s:.2f} s: more frames or a higher speed"
            )


class Cast(NamedTuple):
    """What a maker answers: who moves, and under what conditions unless others are asked for."""

    objects: list[SceneObject]
    conditions: Conditions = Conditions()


def contact_ids(contacts: int) -> range:
    """1 to contacts; UsageError for a number that is not allowed."""
    check_integer("contacts", contacts, 0, MAX_CONTACTS)
    return range(1, contacts + 1)


def lane(number: int) -> float:
    """Where the number-th of several ways lies, 0 to 1: 1/2, 1/4, 3/4, 1/8, 5/8, 3/8, 7/8, ...

    The van der Corput sequence: ways keep their places however many there are.

    Args:
        number: from 1.
    """
    place, part = 0.0, 0.5
    while number:
        place += part * (number % 2)
        number //= 2
        part /= 2
    return place
