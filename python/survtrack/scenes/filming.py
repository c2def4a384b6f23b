# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Ready-made scenes that show a condition: what hides, the light, noise, perspective."""

from survtrack.scenes.checks import check_number
from survtrack.scenes.conditions import Conditions
from survtrack.scenes.movements import constant, passers
from survtrack.scenes.objects import SceneObject
from survtrack.scenes.pace import steady
from survtrack.scenes.path import Path
from survtrack.scenes.stage import Cast, Stage, contact_ids, lane


def pillar(
    stage: Stage,
    *,
    contacts: int = 2,
    speed_px_per_s: float = 60.0,
    pillar_width_px: float = 40.0,
    enter_s: float = 1.0,
) -> Cast:
    """A pillar in the middle, from top to bottom, that hides those who pass behind it."""
    check_number("pillar_width_px", pillar_width_px, above=0, most=stage.size[0])
    left = (stage.size[0] - pillar_width_px) / 2
    objects = passers(stage, contacts, speed_px_per_s, steady(speed_px_per_s, enter_s))
    box = (left, 0.0, pillar_width_px, float(stage.size[1]))
    return Cast(objects, Conditions(occluders=(box,)))


def light_fade(
    stage: Stage, *, contacts: int = 1, speed_px_per_s: float = 60.0, enter_s: float = 1.0
) -> Cast:
    """As constant, while the light goes down to 0.6 within 4 s, from 2 s on."""
    conditions = Conditions(light_gain=0.6, light_at_s=2.0, light_over_s=4.0)
    cast = constant(stage, contacts=contacts, speed_px_per_s=speed_px_per_s, enter_s=enter_s)
    return Cast(cast.objects, conditions)


def light_switch(
    stage: Stage, *, contacts: int = 1, speed_px_per_s: float = 60.0, enter_s: float = 1.0
) -> Cast:
    """As constant, and at 4 s a light goes off: all levels are 0.6 of what they were."""
    cast = constant(stage, contacts=contacts, speed_px_per_s=speed_px_per_s, enter_s=enter_s)
    return Cast(cast.objects, Conditions(light_gain=0.6, light_at_s=4.0))


def noise(
    stage: Stage, *, contacts: int = 1, speed_px_per_s: float = 60.0, enter_s: float = 1.0
) -> Cast:
    """As constant, with the noise of a sensor: 8 grey levels."""
    cast = constant(stage, contacts=contacts, speed_px_per_s=speed_px_per_s, enter_s=enter_s)
    return Cast(cast.objects, Conditions(noise_sigma=8.0))


def perspective(
    stage: Stage, *, contacts: int = 2, speed_px_per_s: float = 50.0, enter_s: float = 1.0
) -> Cast:
    """Contacts that come towards the camera and go away from it; at the top they are 0.4 as large.

    They are as fast on the ground everywhere; in the picture they are faster the nearer they are.
    """
    check_number("speed_px_per_s", speed_px_per_s, above=0)
    objects = []
    for id in contact_ids(contacts):
        heading = 90.0 if id % 2 else 270.0
        through = (stage.size[0] * lane(id + 1), stage.center[1])
        path = Path(stage.entry(through, heading), heading)
        objects.append(SceneObject(id, stage.body, path, steady(speed_px_per_s, enter_s)))
    return Cast(objects, Conditions(far_scale=0.4))
