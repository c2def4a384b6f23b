# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The value that is scored: boxes with identities, over the frames of one sequence."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from survtrack.errors import InputError

MAX_INTEGER = 2**53  # beyond it a float64, which text goes through, skips integers
MAX_COORDINATE_PX = 1e9  # far above any image; keeps areas and their sums finite


@dataclass(frozen=True, eq=False, init=False)
class Boxes:
    """Boxes with identities, one row a box, in any order of frames; read-only arrays.

    frames: (N,) int64, the frame each box belongs to, counted from 1.
    ids: (N,) int64 from 0, the identity of the object; at most one box a frame each.
    boxes: (N, 4) float64, left, top, width, height in pixels; widths and heights above 0.
    ignore: (N,) bool, true where a truth box is don't-care: it is never missed, and an output
        that matches it is not scored.
    """

    frames: NDArray[np.int64]
    ids: NDArray[np.int64]
    boxes: NDArray[np.float64]
    ignore: NDArray[np.bool_]

    def __init__(
        self,
        frames: ArrayLike,
        ids: ArrayLike,
        boxes: ArrayLike,
        ignore: ArrayLike | None = None,
        *,
        where: Callable[[int], str] = "box {}".format,
    ) -> None:
        """Copy and check the values.

        Args:
            frames: see the class, as the others; integers may come as whole floats.
            ids: see the class.
            boxes: see the class.
            ignore: see the class; None means that every box counts.
            where: turns a row number into words for error messages, such as a file and line.

        Raises:
            InputError: values outside the ranges of the class, NaN or infinity, an identity
                that appears twice in a frame. The message names the row.
        """
        corners = np.array(boxes, dtype=np.float64)
        if corners.size == 0:
            corners = corners.reshape(0, 4)
        if corners.ndim != 2 or corners.shape[1] != 4:
            raise InputError(f"boxes must have the shape (N, 4), not {corners.shape}")
        rows = len(corners)
        marked = np.zeros(rows, bool) if ignore is None else np.array(ignore, dtype=bool)
        if marked.shape != (rows,):
            raise InputError(f"ignore must have the shape ({rows},), not {marked.shape}")
        values = {
            "frames": _integers(frames, "frame", 1, rows, where),
            "ids": _integers(ids, "id", 0, rows, where),
            "boxes": corners,
            "ignore": marked,
        }
        _check_geometry(corners, where)
        _check_unique(values["frames"], values["ids"], where)
        for name, value in values.items():
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    def scaled(self, scale: tuple[float, float]) -> "Boxes":
        """The same in frames that are scaled by (across, down), both above 0."""
        return Boxes(self.frames, self.ids, self.boxes * np.array([*scale, *scale]), self.ignore)

    def __len__(self) -> int:
        """The number of boxes."""
        return len(self.frames)


def _integers(
    values: ArrayLike, what: str, lowest: int, rows: int, where: Callable[[int], str]
) -> NDArray[np.int64]:
    """The values as int64, or an InputError for the first that is none or is out of range."""
    raw: NDArray[Any] = np.asarray(values)
    if raw.size == 0:
        raw = raw.reshape(-1).astype(np.int64)
    if raw.shape != (rows,) or raw.dtype.kind not in "iuf":
        raise InputError(
            f"{what}s must be {rows} numbers, one a box, not {raw.dtype} of shape {raw.shape}"
        )
    in_range = (raw >= lowest) & (raw <= MAX_INTEGER)  # false for NaN
    bad = np.flatnonzero(~in_range | (raw != np.floor(raw)))
    if bad.size:
        row = int(bad[0])
        hint = "; boxes without identity are detections, not tracks" if what == "id" else ""
        raise InputError(
            f"{where(row)}: {what} {raw[row]:.16g} is not an integer from {lowest} on{hint}"
        )
    return raw.astype(np.int64)


def _check_geometry(boxes: NDArray[np.float64], where: Callable[[int], str]) -> None:
    bad = np.argwhere(~(np.abs(boxes) <= MAX_COORDINATE_PX))
    if bad.size:
        row, column = (int(index) for index in bad[0])
        side = ("left", "top", "width", "height")[column]
        raise InputError(
            f"{where(row)}: {side} {boxes[row, column]:g} is not a number of pixels within "
            f"+-{MAX_COORDINATE_PX:g}"
        )
    empty = np.flatnonzero((boxes[:, 2:] <= 0).any(axis=1))
    if empty.size:
        row = int(empty[0])
        width, height = boxes[row, 2:]
        raise InputError(f"{where(row)}: size {width:g} x {height:g} must be above 0 both ways")


def _check_unique(
    frames: NDArray[np.int64], ids: NDArray[np.int64], where: Callable[[int], str]
) -> None:
    order = np.lexsort((ids, frames))  # stable, so equal pairs stand in row order
    same = (np.diff(frames[order]) == 0) & (np.diff(ids[order]) == 0)
    if same.any():
        first = int(np.flatnonzero(same)[0])
        row, earlier = int(order[first + 1]), int(order[first])
        raise InputError(
            f"{where(row)}: id {ids[row]} appears twice in frame {frames[row]} "
            f"(first at {where(earlier)})"
        )
