# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From a scene to pictures of one kind."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from survtrack.scenes.layers import Placed, occluder_area, paint_owners, placed
from survtrack.scenes.randomness import Purpose, stream
from survtrack.scenes.texture import Texture

if TYPE_CHECKING:
    from survtrack.scenes.scene import Scene
    from survtrack.sources.base import Frame

Picture = NDArray[np.float32]

# ITU-R BT.601, in the order blue, green, red.
LUMINANCE = np.array([0.114, 0.587, 0.299])

GROUND_LEVEL, GROUND_CONTRAST, GROUND_CELL_PX = 110.0, 25.0, 32.0
OCCLUDER_LEVEL, OCCLUDER_CONTRAST, OCCLUDER_CELL_PX = 75.0, 15.0, 16.0
# Bright or dark: in no channel ever as the ground is somewhere.
OBJECT_LEVELS, OBJECT_CONTRAST, OBJECT_CELL_PX = (200.0, 30.0), 18.0, 8.0
TINT = 12.0  # largest difference of a channel from the level


class Renderer(Protocol):
    """Makes the frames of one scene."""

    def frame(self, index: int) -> "Frame":
        """A new array of frame `index`, from 0; always the same bytes."""


class MaskRenderer:
    """HxW: 255 where an object is seen, else 0."""

    def __init__(self, scene: "Scene") -> None:
        self._scene = scene

    def frame(self, index: int) -> "Frame":
        """See Renderer."""
        owners = paint_owners(self._scene, placed(self._scene, index))
        return (owners > 0).astype(np.uint8) * np.uint8(255)


@dataclass(frozen=True)
class Paint:
    """Colour (channels,) in grey levels, with a texture of some contrast on all channels."""

    color: NDArray[np.float32]
    texture: Texture
    contrast: float

    def at(self, xs: NDArray[np.float64], ys: NDArray[np.float64]) -> Picture:
        """(H, W, channels) at W xs and H ys, px."""
        grey = np.float32(self.contrast) * self.texture.at(xs, ys)
        return np.asarray(self.color + grey[..., None])


class VideoRenderer:
    """HxWx3 BGR, or HxW grey: textured objects before a textured ground, occluders on top.

    An object's edge pixels are mixed with what is behind by the part that it covers. Then the
    light, then the noise; levels are clipped and rounded last.
    """

    def __init__(self, scene: "Scene", *, grey: bool) -> None:
        self._scene = scene
        self._grey = grey
        self._gains = scene.conditions.gains(scene.times_s)
        width, height = scene.size
        self._columns, self._rows = pixel_centers(width), pixel_centers(height)
        ground = self._paint(
            Purpose.BACKGROUND, 0, (GROUND_LEVEL,), GROUND_CONTRAST, GROUND_CELL_PX
        )
        self._ground = ground.at(self._columns, self._rows)
        self._occluders = [self._occluder(k) for k in range(len(scene.conditions.occluders))]
        self._paints = {
            thing.id: self._paint(
                Purpose.OBJECT, thing.id, OBJECT_LEVELS, OBJECT_CONTRAST, OBJECT_CELL_PX
            )
            for thing in scene.objects
        }

    def frame(self, index: int) -> "Frame":
        """See Renderer."""
        picture = self._ground.copy()
        for one in placed(self._scene, index):
            self._draw(picture, one)
        for area, pixels in self._occluders:
            picture[area] = pixels
        picture *= np.float32(self._gains[index])
        sigma = self._scene.conditions.noise_sigma
        if sigma > 0:
            random = stream(self._scene.seed, Purpose.NOISE, index)
            picture += np.float32(sigma) * random.standard_normal(picture.shape, np.float32)
        np.clip(picture, 0, 255, out=picture)
        levels = np.rint(picture, out=picture).astype(np.uint8)
        return levels[..., 0] if self._grey else levels

    def _draw(self, picture: Picture, one: Placed) -> None:
        """Lay an object over a picture; its texture moves and grows with it."""
        cover = one.thing.body.coverage(one.position, one.scale).clipped(self._scene.size)
        rows, columns = cover.area
        xs = (self._columns[columns] - one.position[0]) / one.scale
        ys = (self._rows[rows] - one.position[1]) / one.scale
        behind = picture[rows, columns]  # a view
        behind += cover.values[..., None] * (self._paints[one.thing.id].at(xs, ys) - behind)

    def _occluder(self, number: int) -> tuple[tuple[slice, slice], Picture]:
        area = occluder_area(self._scene.conditions.occluders[number], self._scene.size)
        paint = self._paint(
            Purpose.OCCLUDER, number, (OCCLUDER_LEVEL,), OCCLUDER_CONTRAST, OCCLUDER_CELL_PX
        )
        return area, paint.at(self._columns[area[1]], self._rows[area[0]])

    def _paint(
        self, purpose: Purpose, key: int, levels: tuple[float, ...], contrast: float, cell_px: float
    ) -> Paint:
        """The paint of one thing, from its own stream."""
        random = stream(self._scene.seed, purpose, key)
        color = random.choice(levels) + random.uniform(-TINT, TINT, 3)
        if self._grey:
            color = np.array([color @ LUMINANCE])
        return Paint(color.astype(np.float32), Texture(random, cell_px), contrast)


def pixel_centers(count: int) -> NDArray[np.float64]:
    """(count,) 0.5, 1.5, ..."""
    return np.arange(count, dtype=np.float64) + 0.5
