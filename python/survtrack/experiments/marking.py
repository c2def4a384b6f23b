# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One configuration on real footage: scores, markers, masks and lost contacts against the truth."""

from dataclasses import dataclass, field
from time import thread_time
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.evaluation import Boxes, evaluate_tracks
from survtrack.experiments.ends import End, Ends, compare_ends
from survtrack.experiments.footage import Footage
from survtrack.experiments.trial import Trial, Variant, boxes_of, results_of

if TYPE_CHECKING:
    from survtrack._core import FrameResult

FOUND_PART = 0.5  # of an object's boxes that must have a marker for it to count as found


@dataclass(frozen=True, eq=False)
class Marked:
    """What came out of one run.

    Attributes:
        trial: scores of the boxes.
        objects, found: true objects; those with a marker in FOUND_PART of their boxes.
        on_contact: part of the true boxes that hold a marker, 0 to 1.
        on_truth: part of the markers that lie in a true box; NaN without any marker.
        coverage: part of the true boxes' pixels that the mask has.
        mask_in_truth: part of the mask's pixels that lie in a true box; NaN for an empty mask.
        ends: lost contacts against the ends of true tracks.
        markers: (N, 4) frame from 1, track id, x, y: for plots.
    """

    trial: Trial
    objects: int
    found: int
    on_contact: float
    on_truth: float
    coverage: float
    mask_in_truth: float
    ends: Ends
    markers: NDArray[np.float64]


@dataclass
class _Counts:
    """Sums over the frames of a run."""

    markers: int = 0
    markers_in_truth: int = 0
    box_px: int = 0
    box_px_found: int = 0
    mask_px: int = 0
    mask_px_in_truth: int = 0
    boxes_of: dict[int, int] = field(default_factory=dict)
    marked_of: dict[int, int] = field(default_factory=dict)


def mark(footage: Footage, variant: Variant) -> Marked:
    """Run a configuration on a set and compare all that it shows with the truth."""
    # Processor time, not the clock's: frames lie in memory, and the pipeline runs in this thread.
    began = thread_time()
    answers = list(results_of(footage, variant.config(footage.frame_period_s)))
    seconds = thread_time() - began
    scores = evaluate_tracks(
        footage.truth, boxes_of(iter(answers)), frames=(1, len(footage.frames))
    )
    counts = _Counts()
    for result in answers:
        _count(counts, footage.truth, result)
    found = [
        id
        for id, boxes in counts.boxes_of.items()
        if counts.marked_of.get(id, 0) >= FOUND_PART * boxes
    ]
    return Marked(
        Trial(scores, len(footage.frames) / max(seconds, 1e-9)),
        len(counts.boxes_of),
        len(found),
        _part(sum(counts.marked_of.values()), sum(counts.boxes_of.values())),
        _part(counts.markers_in_truth, counts.markers),
        _part(counts.box_px_found, counts.box_px),
        _part(counts.mask_px_in_truth, counts.mask_px),
        compare_ends(footage, _ends(answers)),
        _markers(answers),
    )


def _count(counts: _Counts, truth: Boxes, result: "FrameResult") -> None:
    here = truth.frames == result.index + 1
    boxes, ids, ignore = truth.boxes[here], truth.ids[here], truth.ignore[here]
    at = np.array([track.position for track in result.tracks if track.reported]).reshape(-1, 2)
    # Positions count pixels by their index, boxes have their edges at whole numbers.
    inside = ((at[:, None] + 0.5 >= boxes[:, :2]) & (at[:, None] + 0.5 <= _ends_of(boxes))).all(-1)
    of_ignored = inside[:, ignore].any(axis=1) & ~inside[:, ~ignore].any(axis=1)
    counts.markers += int((~of_ignored).sum())
    counts.markers_in_truth += int(inside[:, ~ignore].any(axis=1).sum())
    for id, marked in zip(ids[~ignore].tolist(), inside[:, ~ignore].any(axis=0), strict=True):
        counts.boxes_of[id] = counts.boxes_of.get(id, 0) + 1
        counts.marked_of[id] = counts.marked_of.get(id, 0) + int(marked)
    mask = result.mask > 0
    wanted, unscored = _area(mask.shape, boxes[~ignore]), _area(mask.shape, boxes[ignore])
    scored = wanted | ~unscored
    counts.box_px += int(wanted.sum())
    counts.box_px_found += int((wanted & mask).sum())
    counts.mask_px += int((mask & scored).sum())
    counts.mask_px_in_truth += int((mask & wanted).sum())


def _ends_of(boxes: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(boxes[:, :2] + boxes[:, 2:])


def _area(shape: tuple[int, ...], boxes: NDArray[np.float64]) -> NDArray[np.bool_]:
    """The pixels of all boxes."""
    area = np.zeros(shape, bool)
    for left, top, right, bottom in np.rint(np.hstack([boxes[:, :2], _ends_of(boxes)])).astype(int):
        area[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = True
    return area


def _ends(answers: "list[FrameResult]") -> list[End]:
    """What the run says was lost, with the frame of the last measurement."""
    measured: dict[int, int] = {}
    ends = []
    for result in answers:
        for event in result.events:
            if event.kind == survtrack.EventKind.track_ended:
                last = measured.get(event.track_id, result.index + 1)
                ends.append(End(last, result.index + 1, event.position, event.place.name))
        for track in result.tracks:
            if track.lost_frames == 0:
                measured[track.id] = result.index + 1
    return ends


def _markers(answers: "list[FrameResult]") -> NDArray[np.float64]:
    rows = [
        (result.index + 1, track.id, track.position[0] + 0.5, track.position[1] + 0.5)
        for result in answers
        for track in result.tracks
        if track.reported
    ]
    return np.array(rows, np.float64).reshape(-1, 4)


def _part(part: int, whole: int) -> float:
    return part / whole if whole else float("nan")
