# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The value that everything is made from: frames, truth and measurements follow from a Scene."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import UsageError
from survtrack.scenes.body import LEAST_SIDE_PX
from survtrack.scenes.checks import check_integer, check_number
from survtrack.scenes.conditions import Conditions
from survtrack.scenes.layers import occluder_area
from survtrack.scenes.measurements import Measured, measurements
from survtrack.scenes.objects import SceneObject
from survtrack.scenes.perspective import Perspective, View
from survtrack.scenes.randomness import MAX_SEED
from survtrack.scenes.source import SceneSource
from survtrack.scenes.truth import DEFAULT_MIN_VISIBLE, Truth, truth_of
from survtrack.sources.base import DEFAULT_FPS, Size
from survtrack.sources.selection import Selection

MAX_SIDE_PX = 16384
MAX_FRAMES = 1_000_000


@dataclass(frozen=True)
class Motion:
    """How one object is seen, over all frames.

    view: positions, velocities and scales in the picture.
    distances_px: (frames,) gone on its way, on the ground.
    present: (frames,) whether it is there at all.
    """

    view: View
    distances_px: NDArray[np.float64]
    present: NDArray[np.bool_]


@dataclass(frozen=True)
class Scene:
    """Objects that move before a still camera. Frame k has the time k / fps.

    name: of the scene, for people.
    objects: no two of one id. Of equal scale, later ones are in front of earlier ones.
    size: (width, height) of the frames in px.
    frame_count: 1 or more.
    fps: frames per second, above 0.
    seed: 0 to 2**32 - 1; of textures, noise and measurements.
    conditions: see Conditions.
    """

    name: str
    objects: tuple[SceneObject, ...]
    size: tuple[int, int] = (320, 240)
    frame_count: int = 200
    fps: float = DEFAULT_FPS
    seed: int = 0
    conditions: Conditions = field(default_factory=Conditions)

    def __post_init__(self) -> None:
        """Raises UsageError: a bad value, or an object that is in no frame."""
        check_filming(self.size, self.frame_count, self.fps, self.seed)
        ids = [thing.id for thing in self.objects]
        twice = sorted({id for id in ids if ids.count(id) > 1})
        if twice:
            raise UsageError(f"objects: id {twice[0]} is that of several")
        for box in self.conditions.occluders:
            if any(part.start == part.stop for part in occluder_area(box, self.size)):
                raise UsageError(f"occluders: {box} covers no pixel of the frame")
        for thing, motion in zip(self.objects, self.motions, strict=True):
            self._check_object(thing, motion)

    @property
    def duration_s(self) -> float:
        """Frames times their period."""
        return self.frame_count / self.fps

    @property
    def times_s(self) -> NDArray[np.float64]:
        """(frame_count,) of the frames."""
        return np.arange(self.frame_count) / self.fps

    @cached_property
    def motions(self) -> tuple[Motion, ...]:
        """One each object, in their order."""
        return tuple(self._motion(thing) for thing in self.objects)

    def under(self, **conditions: Any) -> "Scene":
        """The same scene with other conditions: scene.under(noise_sigma=4)."""
        return replace(self, conditions=replace(self.conditions, **conditions))

    def frames(self, kind: str = "video", *, selection: Selection | None = None) -> SceneSource:
        """A source of its frames: `for index, time_s, frame in scene.frames()`.

        Args:
            kind: "video" (HxWx3 BGR), "grey" (HxW), or "mask" (HxW, 255 where an object is seen).
            selection: which frames; all when None. Each is the same, whichever are asked for.

        Raises:
            UsageError: an unknown kind.
        """
        return SceneSource(self, kind, selection)

    def truth(self) -> Truth:
        """What is true of each object in each frame in which it is there."""
        return truth_of(self)

    def measurements(
        self, sigma_px: float = 0.0, *, min_visible: float = DEFAULT_MIN_VISIBLE
    ) -> Iterator[Measured]:
        """Positions as a sensor would measure them: `for index, time_s, positions in ...`.

        Args:
            sigma_px: standard deviation of the Gaussian noise on x and on y; 0 or more.
            min_visible: an object less visible than this is missing; above 0, up to 1.

        Yields:
            (index, time_s, {id: (x, y) in px}) of each frame.

        Raises:
            UsageError: a bad value.
        """
        return measurements(self, sigma_px, min_visible)

    def _motion(self, thing: SceneObject) -> Motion:
        points, velocities, distances = thing.motion(self.times_s)
        camera = Perspective(self.size, self.conditions.far_scale)
        view = camera.view(points, velocities)
        return Motion(view, distances, thing.present(self.times_s) & view.in_front)

    def _check_object(self, thing: SceneObject, motion: Motion) -> None:
        sides = np.array([thing.body.width_px, thing.body.height_px])
        far_scale = self.conditions.far_scale
        if sides.min() * far_scale < LEAST_SIDE_PX:
            raise UsageError(
                f"far_scale: {far_scale:g} makes object {thing.id} {sides.min() * far_scale:g} px "
                f"small at the top of the frame; {LEAST_SIDE_PX:g} px or more are allowed"
            )
        reach = sides / 2 * motion.view.scales[:, None]
        positions = motion.view.positions
        inside = (positions + reach > 0.5) & (positions - reach < np.array(self.size) - 0.5)
        if not (inside.all(axis=1) & motion.present).any():
            raise UsageError(
                f"{self.name}: object {thing.id} is never in the frame: nowhere within "
                f"{self.size[0]}x{self.size[1]} px in {self.frame_count} frames "
                f"({self.duration_s:g} s)"
            )


def check_filming(size: Size, frame_count: int, fps: float, seed: int) -> None:
    """Raise UsageError unless these can be those of a Scene."""
    if not isinstance(size, tuple) or len(size) != 2:
        raise UsageError(f"size: {size!r} is not allowed; (width, height) in px")
    for name, side in zip(("width", "height"), size, strict=True):
        check_integer(f"size: {name}", side, 1, MAX_SIDE_PX)
    check_integer("frame_count", frame_count, 1, MAX_FRAMES)
    check_number("fps", fps, above=0)
    check_integer("seed", seed, 0, MAX_SEED)
