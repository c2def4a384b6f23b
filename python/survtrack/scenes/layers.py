# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Which object is seen at which pixel."""

from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from survtrack.scenes.body import Patch

if TYPE_CHECKING:
    from survtrack.scenes.conditions import OccluderBox
    from survtrack.scenes.objects import SceneObject
    from survtrack.scenes.scene import Scene
    from survtrack.sources.base import Size

Point = tuple[float, float]


@dataclass(frozen=True)
class Placed:
    """An object in one frame.

    position, velocity_px_per_s: of its centre in the picture, (x, y).
    distance_px: gone on its path.
    scale: what its size is multiplied by.
    """

    thing: "SceneObject"
    position: Point
    velocity_px_per_s: Point
    distance_px: float
    scale: float

    def silhouette(self) -> Patch:
        """All of its pixels, also those outside of the frame or behind something."""
        return self.thing.body.silhouette(self.position, self.scale)


def placed(scene: "Scene", index: int) -> list[Placed]:
    """The objects that are there in a frame, from the far to the near."""
    found = []
    for thing, motion in zip(scene.objects, scene.motions, strict=True):
        if motion.present[index]:
            view = motion.view
            x, y = view.positions[index].tolist()
            speed_x, speed_y = view.velocities_px_per_s[index].tolist()
            gone, scale = float(motion.distances_px[index]), float(view.scales[index])
            found.append(Placed(thing, (x, y), (speed_x, speed_y), gone, scale))
    return sorted(found, key=lambda one: one.scale)


def paint_owners(scene: "Scene", objects: list[Placed]) -> NDArray[np.int32]:
    """(height, width) id of the object that is seen at each pixel; 0 for none.

    Args:
        scene: for its size and occluders.
        objects: from the far to the near; see placed.
    """
    width, height = scene.size
    owners = np.zeros((height, width), np.int32)
    for one in objects:
        patch = one.silhouette().clipped(scene.size)
        owners[patch.area][patch.values] = one.thing.id
    for box in scene.conditions.occluders:
        owners[occluder_area(box, scene.size)] = 0
    return owners


def occluder_area(box: "OccluderBox", size: "Size") -> tuple[slice, slice]:
    """Rows and columns of a frame of `size` whose pixels' centres are in the box."""
    (left, top, width, height), (columns, rows) = box, size
    return _covered(top, top + height, rows), _covered(left, left + width, columns)


def _covered(begin: float, end: float, count: int) -> slice:
    """The k from 0 to count - 1 with begin <= k + 0.5 < end."""
    first = min(max(ceil(begin - 0.5), 0), count)
    return slice(first, max(min(ceil(end - 0.5), count), first))
