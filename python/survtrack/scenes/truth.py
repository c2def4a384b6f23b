# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is true: where each object is, how fast it moves, and how much of it can be seen."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from survtrack.scenes.checks import check_number
from survtrack.scenes.layers import Placed, paint_owners, placed

if TYPE_CHECKING:
    from survtrack.evaluation import Boxes
    from survtrack.scenes.scene import Scene

# Less of an object than this is no fair thing to ask a tracker for.
DEFAULT_MIN_VISIBLE = 0.25


@dataclass(frozen=True, eq=False)
class Truth:
    """N rows, one for each object in each frame in which it is there, also outside of the frame.

    Rows come in order of frames, and in each in order of ids. Positions are continuous: the pixel
    of column c and row r is centred at (c + 0.5, r + 0.5), so that a box's left + width / 2 is its
    centre's x. Parts are shares of the object's own pixels; the three add up to 1.

    indices: (N,) int64, of the frames, from 0.
    times_s: (N,) of the frames.
    ids: (N,) int64.
    positions: (N, 2) the centre, x and y, px.
    velocities_px_per_s: (N, 2) its derivative.
    distances_px: (N,) gone on the object's path, on the ground; modulo path.length_px where it
        is closed.
    boxes: (N, 4) left, top, width, height, px: the smallest box of the object's pixels in the
        frame, hidden ones included; width and height 0 when there are none.
    visible: (N,) part that is seen.
    occluded: (N,) part that is in the frame, behind something.
    outside: (N,) part that is out of the frame.
    """

    indices: NDArray[np.int64]
    times_s: NDArray[np.float64]
    ids: NDArray[np.int64]
    positions: NDArray[np.float64]
    velocities_px_per_s: NDArray[np.float64]
    distances_px: NDArray[np.float64]
    boxes: NDArray[np.float64]
    visible: NDArray[np.float64]
    occluded: NDArray[np.float64]
    outside: NDArray[np.float64]

    def __post_init__(self) -> None:
        """The arrays become read-only."""
        for column in vars(self).values():
            column.setflags(write=False)

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.indices)

    def at(self, index: int) -> "Truth":
        """The rows of one frame, from 0."""
        return self._where(self.indices == index)

    def of(self, id: int) -> "Truth":
        """The rows of one object."""
        return self._where(self.ids == id)

    def to_boxes(self, min_visible: float = DEFAULT_MIN_VISIBLE) -> "Boxes":
        """For survtrack.evaluation: the boxes of all rows that have one, frames counted from 1.

        Args:
            min_visible: boxes of objects less visible than this are don't-care; 0 to 1.

        Raises:
            UsageError: a bad value.
        """
        from survtrack.evaluation import Boxes

        check_number("min_visible", min_visible, least=0, most=1)
        rows = self._where(self.boxes[:, 2] > 0)
        return Boxes(rows.indices + 1, rows.ids, rows.boxes, rows.visible < min_visible)

    def _where(self, chosen: NDArray[np.bool_]) -> "Truth":
        return Truth(**{name: column[chosen] for name, column in vars(self).items()})


def truth_of(scene: "Scene") -> Truth:
    """All rows of a scene."""
    rows = [row for index in range(scene.frame_count) for row in _rows(scene, index)]
    table = np.array(rows, np.float64).reshape(-1, 14)
    indices = table[:, 0].astype(np.int64)
    return Truth(
        indices=indices,
        times_s=scene.times_s[indices],
        ids=table[:, 1].astype(np.int64),
        positions=table[:, 2:4],
        velocities_px_per_s=table[:, 4:6],
        distances_px=table[:, 6],
        boxes=table[:, 7:11],
        visible=table[:, 11],
        occluded=table[:, 12],
        outside=table[:, 13],
    )


def _rows(scene: "Scene", index: int) -> list[tuple[float, ...]]:
    """Index, id, position, velocity, distance, box and parts of each object in one frame."""
    objects = placed(scene, index)
    owners = paint_owners(scene, objects)
    return [
        (index, one.thing.id, *_moving(one), *_seen(one, owners))
        for one in sorted(objects, key=lambda one: one.thing.id)
    ]


def _moving(one: Placed) -> tuple[float, ...]:
    return (*one.position, *one.velocity_px_per_s, one.distance_px)


def _seen(one: Placed, owners: NDArray[np.int32]) -> tuple[float, ...]:
    """Box, visible, occluded and outside part; all of what has no pixel is outside."""
    whole = one.silhouette()
    inside = whole.clipped((owners.shape[1], owners.shape[0]))
    pixels = max(int(np.count_nonzero(whole.values)), 1)
    within = int(np.count_nonzero(inside.values))
    seen = int(np.count_nonzero(owners[inside.area] == one.thing.id))
    parts = (seen / pixels, (within - seen) / pixels, (pixels - within) / pixels)
    return (*inside.box(), *parts)
