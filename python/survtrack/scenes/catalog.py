# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The ready-made scenes by name: each name is that of the function which makes it."""

from collections.abc import Callable

from survtrack.scenes import filming, movements
from survtrack.scenes.stage import Cast

MAKERS: tuple[Callable[..., Cast], ...] = (
    movements.constant,
    movements.varying_speed,
    movements.varying_direction,
    movements.crossing,
    filming.pillar,
    movements.reentry,
    movements.stopping,
    movements.removal,
    filming.light_fade,
    filming.light_switch,
    filming.noise,
    filming.perspective,
    movements.race,
    movements.crowd,
)
SCENES = {maker.__name__: maker for maker in MAKERS}
