# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Truth and outputs laid side by side, frame by frame: what every tracking score starts from."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation.boxes import Boxes
from survtrack.evaluation.overlap import EPSILON, best_matching, iou_matrix


@dataclass(frozen=True, eq=False)
class FrameOverlap:
    """One frame: who is there, and how well they fit.

    truth: (N,) indices of the identities of the truth, from 0 to Comparison.truth_ids - 1.
    output: (M,) indices of the identities of the output, likewise.
    iou: (N, M) intersection over union.
    """

    truth: NDArray[np.intp]
    output: NDArray[np.intp]
    iou: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Comparison:
    """All frames with a box to score, in order, and totals over them."""

    frames: list[FrameOverlap]
    truth_ids: int
    output_ids: int
    truth_boxes: int
    output_boxes: int
    ignored_outputs: int

    def boxes_per_identity(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The number of boxes of each identity of the truth, and of the output."""
        truth, output = np.zeros(self.truth_ids), np.zeros(self.output_ids)
        for frame in self.frames:
            truth[frame.truth] += 1
            output[frame.output] += 1
        return truth, output


def compare(
    truth: Boxes, tracks: Boxes, *, frames: range, offset: int = 0, iou: float = 0.5
) -> Comparison:
    """Lay tracks beside truth and take out what is not to be scored.

    Args:
        truth: the boxes that are right; those marked `ignore` are don't-care.
        tracks: the boxes to judge.
        frames: which frames count, in the numbering of the tracks.
        offset: frame f of the tracks is frame f + offset of the truth.
        iou: an output that fits an ignored box at least so well, in the best one-to-one matching
            of the frame's outputs with all boxes of the truth, is removed. This is the
            preprocessing of MOTChallenge (Milan et al., "MOT16", arXiv:1603.00831, section 4.1).
    """
    kept_truth: list[NDArray[np.intp]] = []
    kept_tracks: list[NDArray[np.intp]] = []
    overlaps: list[NDArray[np.float64]] = []
    removed = 0
    for here, there in rows_side_by_side(truth, tracks, frames=frames, offset=offset):
        overlap = iou_matrix(truth.boxes[here], tracks.boxes[there])
        ignore = truth.ignore[here]
        counts = _not_matched_to_ignored(overlap, ignore, iou)
        removed += int((~counts).sum())
        kept_truth.append(here[~ignore])
        kept_tracks.append(there[counts])
        overlaps.append(overlap[~ignore][:, counts])
    truth_index, truth_ids = _contiguous(truth.ids, kept_truth)
    track_index, track_ids = _contiguous(tracks.ids, kept_tracks)
    return Comparison(
        frames=[
            FrameOverlap(*parts) for parts in zip(truth_index, track_index, overlaps, strict=True)
        ],
        truth_ids=truth_ids,
        output_ids=track_ids,
        truth_boxes=sum(map(len, kept_truth)),
        output_boxes=sum(map(len, kept_tracks)),
        ignored_outputs=removed,
    )


def rows_side_by_side(
    truth: Boxes, tracks: Boxes, *, frames: range, offset: int = 0
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """The rows of truth and of tracks in every frame that counts and has any, in order.

    Args:
        truth: the boxes that are right.
        tracks: the boxes to judge.
        frames: which frames count, in the numbering of the tracks.
        offset: frame f of the tracks is frame f + offset of the truth.
    """
    truth_numbers, truth_rows = _rows_by_frame(truth.frames - offset, frames)
    track_numbers, track_rows = _rows_by_frame(tracks.frames, frames)
    for number in np.union1d(truth_numbers, track_numbers):
        yield truth_rows[_span(truth_numbers, number)], track_rows[_span(track_numbers, number)]


def _rows_by_frame(
    numbers: NDArray[np.int64], frames: range
) -> tuple[NDArray[np.int64], NDArray[np.intp]]:
    """The rows whose frame counts, ordered by frame and then as given, and their frames."""
    within = (numbers >= frames.start) & (numbers < frames.stop)
    rows = np.flatnonzero(within & ((numbers - frames.start) % frames.step == 0))
    rows = rows[np.argsort(numbers[rows], kind="stable")]
    return numbers[rows], rows


def _span(numbers: NDArray[np.int64], number: np.int64) -> slice:
    """Where a number stands in ascending numbers."""
    return slice(*np.searchsorted(numbers, (number, number + 1)))


def _not_matched_to_ignored(
    overlap: NDArray[np.float64], ignore: NDArray[np.bool_], iou: float
) -> NDArray[np.bool_]:
    """Which columns are not matched to a row that is to be ignored."""
    counts = np.ones(overlap.shape[1], dtype=bool)
    if ignore.any():
        rows, columns = best_matching(np.where(overlap < iou - EPSILON, 0.0, overlap))
        counts[columns[ignore[rows]]] = False
    return counts


def _contiguous(
    ids: NDArray[np.int64], frames: list[NDArray[np.intp]]
) -> tuple[list[NDArray[np.intp]], int]:
    """The identities of the rows of each frame as indices from 0, and how many there are."""
    if not frames:
        return [], 0
    names, index = np.unique(ids[np.concatenate(frames)], return_inverse=True)
    ends = np.cumsum([len(rows) for rows in frames])[:-1]
    return np.split(index.astype(np.intp), ends), len(names)
