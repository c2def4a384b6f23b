# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""CLEAR MOT: misses, false positives, identity switches, fragments, and MOTA over them.

Sources: K. Bernardin, R. Stiefelhagen, "Evaluating Multiple Object Tracking Performance: The
CLEAR MOT Metrics", EURASIP JIVP 2008; fragments and mostly tracked after Y. Li, C. Huang, R.
Nevatia, "Learning to Associate: HybridBoosted Multi-Target Tracker", CVPR 2009:

    MOTA = (TP - FP - switches) / (truth boxes)       MOTP = mean IoU of the matches

A frame's matching keeps pairs of the frame before first, then has the highest sum of IoUs. A
switch is a match to another identity than the object's last one, however long ago. A fragment is
a time that an object's tracking resumes after a break. Mostly tracked: matched in more than 80 %
of its frames; mostly lost: in less than 20 %. As in TrackEval, "the frame before" is the last
frame that had both truth and output boxes, so that a wholly empty one breaks nothing.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation.comparison import Comparison, FrameOverlap
from survtrack.evaluation.overlap import EPSILON, best_matching

NOBODY = -1
_KEEP_PAIR = 1000.0  # outweighs every sum of IoUs in a frame


@dataclass(frozen=True)
class Clear:
    """CLEAR MOT scores; mota is at most 1 and can be negative, motp is from 0 to 1."""

    mota: float
    motp: float
    true_positives: int
    false_positives: int
    misses: int
    id_switches: int
    fragments: int
    mostly_tracked: int
    partly_tracked: int
    mostly_lost: int


def clear_scores(comparison: Comparison, iou: float = 0.5) -> Clear:
    """Score a comparison with matches of at least this IoU. Without truth, mota is 0."""
    objects = comparison.truth_ids
    last_match = np.full(objects, NOBODY)
    match_before = np.full(objects, NOBODY)
    matched_boxes = np.zeros(objects)
    starts = np.zeros(objects, dtype=np.int64)
    matches, switches, fit = 0, 0, 0.0
    for frame in comparison.frames:
        if not (len(frame.truth) and len(frame.output)):
            continue
        rows, columns = _matching(frame, match_before, iou)
        who, by = frame.truth[rows], frame.output[columns]
        switches += int(((last_match[who] != NOBODY) & (last_match[who] != by)).sum())
        starts[who] += match_before[who] == NOBODY
        matched_boxes[who] += 1
        last_match[who] = by
        match_before[:] = NOBODY
        match_before[who] = by
        matches += len(who)
        fit += float(frame.iou[rows, columns].sum())

    tracked = matched_boxes / comparison.boxes_per_identity()[0]
    mostly, lost = int((tracked > 0.8).sum()), int((tracked < 0.2).sum())
    false_positives = comparison.output_boxes - matches
    truth = comparison.truth_boxes
    return Clear(
        mota=(matches - false_positives - switches) / truth if truth else 0.0,
        motp=fit / max(1, matches),
        true_positives=matches,
        false_positives=false_positives,
        misses=truth - matches,
        id_switches=switches,
        fragments=int((starts[starts > 0] - 1).sum()),
        mostly_tracked=mostly,
        partly_tracked=objects - mostly - lost,
        mostly_lost=lost,
    )


def _matching(
    frame: FrameOverlap, match_before: NDArray[np.int64], iou: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    kept = frame.output == match_before[frame.truth][:, None]
    score = _KEEP_PAIR * kept + frame.iou
    return best_matching(np.where(frame.iou < iou - EPSILON, 0.0, score))
