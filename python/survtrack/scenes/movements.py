# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Ready-made scenes that show a movement: one function each, its options as keywords.

Contacts come in after enter_s, so that a background can be learned before. Speeds are px/s on the
ground, angles degrees, times seconds.
"""

from collections.abc import Callable

from survtrack.errors import UsageError
from survtrack.scenes.body import Body
from survtrack.scenes.checks import check_number
from survtrack.scenes.objects import SceneObject
from survtrack.scenes.pace import Pace, steady, surging
from survtrack.scenes.path import Path, oval, weave
from survtrack.scenes.randomness import Purpose, stream
from survtrack.scenes.stage import Cast, Stage, contact_ids, lane


def constant(
    stage: Stage, *, contacts: int = 1, speed_px_per_s: float = 60.0, enter_s: float = 1.0
) -> Cast:
    """Constant speed and direction; several contacts on lines of their own, left and right."""
    return Cast(passers(stage, contacts, speed_px_per_s, steady(speed_px_per_s, enter_s)))


def varying_speed(
    stage: Stage,
    *,
    contacts: int = 1,
    speed_px_per_s: float = 60.0,
    swing: float = 0.6,
    period_s: float = 3.0,
    enter_s: float = 1.0,
) -> Cast:
    """Constant direction; the speed rises and falls by a part `swing` of itself."""
    until_s = max(stage.duration_s, enter_s)
    pace = surging(speed_px_per_s, swing, period_s, enter_s, until_s)
    return Cast(passers(stage, contacts, speed_px_per_s, pace))


def varying_direction(
    stage: Stage,
    *,
    contacts: int = 1,
    speed_px_per_s: float = 60.0,
    turn_deg: float = 90.0,
    leg_px: float = 80.0,
    enter_s: float = 1.0,
) -> Cast:
    """Constant speed; the heading swings by turn_deg on arcs of leg_px."""
    check_number("turn_deg", turn_deg, least=-360, most=360)
    length = speed_px_per_s * max(stage.duration_s - enter_s, 0)

    def wind(line: Path) -> Path:
        return weave(line.start, line.heading_deg, turn_deg, leg_px, length)

    pace = steady(speed_px_per_s, enter_s)
    return Cast(passers(stage, contacts, speed_px_per_s, pace, wind))


def crossing(
    stage: Stage, *, speed_px_per_s: float = 60.0, angle_deg: float = 40.0, enter_s: float = 1.0
) -> Cast:
    """Two contacts that meet in the middle of the frame and go on; angle_deg between their ways."""
    check_number("angle_deg", angle_deg, least=-180, most=180)
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    objects = []
    for id, heading in ((1, -angle_deg / 2), (2, angle_deg / 2)):
        path = Path(stage.entry(stage.center, heading), heading)
        objects.append(SceneObject(id, stage.body, path, steady(speed_px_per_s, enter_s)))
    way = stage.distance_out(stage.center, 180 + angle_deg / 2)
    stage.require("the contacts meet", enter_s + way / speed_px_per_s)
    return Cast(objects)


def reentry(
    stage: Stage, *, speed_px_per_s: float = 120.0, away_s: float = 2.0, enter_s: float = 1.0
) -> Cast:
    """One contact leaves the frame, turns round, and comes back after away_s."""
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    check_number("away_s", away_s, above=0)
    path = _line(stage, 1)
    left_s = enter_s + stage.distance_out(path.start, 0) / speed_px_per_s
    stage.require("the contact comes back", left_s + away_s)
    pace = Pace(
        (enter_s, left_s, left_s + away_s), (speed_px_per_s, speed_px_per_s, -speed_px_per_s)
    )
    return Cast([SceneObject(1, stage.body, path, pace)])


def stopping(
    stage: Stage, *, speed_px_per_s: float = 60.0, brake_s: float = 1.0, enter_s: float = 1.0
) -> Cast:
    """One contact that slows down within brake_s, stops in the middle of the frame, and stays."""
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    path = _line(stage, 1)
    way = stage.center[0] - path.start[0]
    check_number("brake_s", brake_s, above=0, most=2 * way / speed_px_per_s)
    brakes_s = enter_s + way / speed_px_per_s - brake_s / 2
    stage.require("the contact stands", brakes_s + brake_s)
    pace = Pace((enter_s, brakes_s, brakes_s + brake_s), (speed_px_per_s, speed_px_per_s, 0.0))
    return Cast([SceneObject(1, stage.body, path, pace)])


def removal(
    stage: Stage, *, speed_px_per_s: float = 40.0, removed_s: float = 5.0, enter_s: float = 1.0
) -> Cast:
    """One contact that vanishes in the open, from one frame to the next."""
    stage.require("the contact is removed", removed_s)
    [moving] = passers(stage, 1, speed_px_per_s, steady(speed_px_per_s, enter_s))
    return Cast([SceneObject(1, stage.body, moving.path, moving.pace, until_s=removed_s)])


def race(
    stage: Stage, *, contacts: int = 1, speed_px_per_s: float = 120.0, enter_s: float = 1.0
) -> Cast:
    """Cars on a closed track of two straights and two half circles, each in a lane of its own.

    They are put on it at enter_s, the second half a lap before the first, the third a quarter.
    """
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    objects = []
    widest = max(stage.body.width_px, stage.body.height_px)
    for id in contact_ids(contacts):
        inset = (2 * id - 0.5) * widest
        width, height = stage.size[0] - inset, stage.size[1] - inset
        if not width > height > 0:
            raise UsageError(
                f"{stage.name}: no room for the lane of contact {id}: {width:g}x{height:g} px; it "
                "must be wider than high: a wider frame, fewer contacts or smaller ones"
            )
        track = oval(stage.center, width, height)
        ahead = track.length_px * (lane(id - 1) if id > 1 else 0.0)
        begin_s = enter_s - ahead / speed_px_per_s
        pace = steady(speed_px_per_s, begin_s)
        objects.append(SceneObject(id, stage.body, track, pace, from_s=enter_s))
    return Cast(objects)


def crowd(stage: Stage, *, contacts: int = 6, speed_px_per_s: float = 60.0) -> Cast:
    """Contacts of many sizes, speeds and directions, drawn from the seed.

    Each goes straight, at 0.5 to 1.5 of the speed, and is 0.7 to 1.3 as large as the others'
    common size; at a time of the scene it passes a point in the inner 0.8 of the frame.
    """
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    objects = []
    for id in contact_ids(contacts):
        random = stream(stage.seed, Purpose.PLACEMENT, id)
        x, y = (0.1 + 0.8 * random.random(2)) * stage.size
        heading, speed = random.uniform(0, 360), speed_px_per_s * random.uniform(0.5, 1.5)
        passes_s, scale = random.uniform(0, stage.duration_s), random.uniform(0.7, 1.3)
        body = Body(stage.body.shape, stage.body.width_px * scale, stage.body.height_px * scale)
        path = Path((float(x), float(y)), heading)
        objects.append(SceneObject(id, body, path, steady(speed, passes_s)))
    return Cast(objects)


def passers(
    stage: Stage,
    contacts: int,
    speed_px_per_s: float,
    pace: Pace,
    bend: Callable[[Path], Path] = lambda line: line,
) -> list[SceneObject]:
    """Contacts that cross the frame, odd ids to the right, even ids to the left."""
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    return [
        SceneObject(id, stage.body, bend(_line(stage, id)), pace) for id in contact_ids(contacts)
    ]


def _line(stage: Stage, id: int) -> Path:
    """The level way of a contact, from just outside of the frame."""
    heading = 0.0 if id % 2 else 180.0
    through = (stage.center[0], stage.size[1] * lane(id))
    return Path(stage.entry(through, heading), heading)
