# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Errors counted per object and frame: how many blobs it has, and which numbers they carry.

Source: Narayana 2007, 5.2. An output belongs to the truth box that covers most of it, and at least
half of it (intersection / area of the output; of equal ones the one with the highest IoU, then the
first truth id), so that an object has a set of numbers in each of its frames:

    number-of-blobs errors   k numbers are k - 1, none is 1; an output over two objects belongs to
                             one, the other has none
    index errors             frames in which the set has numbers, but not the best: the one in most
                             of the object's frames (of equal ones the smallest)
    swap errors              changes of the frame's number: the one before if still in the set, else
                             the best if in the set, else the smallest; empty sets are skipped

All are sums over the objects. Boxes of don't-care truth are no instances, and what belongs to them
is not counted.
"""

from collections import Counter, defaultdict
from collections.abc import Sequence, Set
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation.boxes import Boxes
from survtrack.evaluation.comparison import rows_side_by_side
from survtrack.evaluation.overlap import coverage_matrix, iou_matrix

_LEAST_COVERAGE = 0.5
_ROUNDING = 1e-9  # of a coverage: equal ones can differ by it, since corners are rounded


@dataclass(frozen=True)
class Counts:
    """The errors of one object, or their sums over several."""

    number_of_blobs_errors: int
    index_errors: int
    swap_errors: int


def count_errors(truth: Boxes, tracks: Boxes, *, frames: range, offset: int = 0) -> Counts:
    """Count the errors of tracks over the boxes of truth that are not don't-care.

    Args:
        truth: the boxes that are right; an object may be away for some frames.
        tracks: the boxes to judge.
        frames: which frames count, in the numbering of the tracks.
        offset: frame f of the tracks is frame f + offset of the truth.
    """
    parts = [object_counts(sets) for sets in _sets(truth, tracks, frames, offset)]
    return Counts(
        number_of_blobs_errors=sum(part.number_of_blobs_errors for part in parts),
        index_errors=sum(part.index_errors for part in parts),
        swap_errors=sum(part.swap_errors for part in parts),
    )


def object_counts(sets: Sequence[Set[int]]) -> Counts:
    """Count the errors of one object from the numbers that it has in each of its frames."""
    found = [numbers for numbers in sets if numbers]
    best = _best_number(found)
    return Counts(
        number_of_blobs_errors=sum(abs(len(numbers) - 1) for numbers in sets),
        index_errors=sum(best not in numbers for numbers in found),
        swap_errors=sum(one != two for one, two in pairwise(_frame_numbers(found, best))),
    )


def _best_number(found: Sequence[Set[int]]) -> int | None:
    """The number in most frames, of equal ones the smallest; None without any."""
    frames = Counter(number for numbers in found for number in numbers)
    return min(frames, key=lambda number: (-frames[number], number), default=None)


def _frame_numbers(found: Sequence[Set[int]], best: int | None) -> list[int | None]:
    """The one number that stands for each set: the one before, the best, or the smallest."""
    chosen: list[int | None] = []
    before = None
    for numbers in found:
        before = next((number for number in (before, best) if number in numbers), min(numbers))
        chosen.append(before)
    return chosen


def _sets(truth: Boxes, tracks: Boxes, frames: range, offset: int) -> list[list[set[int]]]:
    """For every object, the numbers of the outputs that belong to it in each of its frames."""
    sets: dict[int, list[set[int]]] = defaultdict(list)
    for here, there in rows_side_by_side(truth, tracks, frames=frames, offset=offset):
        rows = here[np.argsort(truth.ids[here])]
        boxes = truth.boxes[rows], tracks.boxes[there]
        belongs = _belongs(coverage_matrix(*boxes), iou_matrix(*boxes))
        for row, outputs in zip(rows, belongs, strict=True):
            if not truth.ignore[row]:
                sets[int(truth.ids[row])].append(set(tracks.ids[there[outputs]].tolist()))
    return list(sets.values())


def _belongs(coverage: NDArray[np.float64], iou: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which output (column) belongs to which truth (row): at most one row a column."""
    reached = coverage >= coverage.max(axis=0, initial=_LEAST_COVERAGE) - _ROUNDING
    fit = np.where(reached, iou, -1.0)
    best = reached & (fit >= fit.max(axis=0, initial=0.0) - _ROUNDING)
    return np.asarray(best & (best.cumsum(axis=0) == 1))
