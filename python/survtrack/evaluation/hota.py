# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""HOTA, the higher order tracking accuracy, and its parts.

Source: J. Luiten, A. Osep, P. Dendorfer, P. Torr, A. Geiger, L. Leal-Taixe, B. Leibe, "HOTA: A
Higher Order Metric for Evaluating Multi-Object Tracking", IJCV 129, 2021. For one localisation
threshold alpha, with matches of IoU >= alpha:

    DetA  = TP / (TP + FN + FP)       DetRe = TP / (TP + FN)       DetPr = TP / (TP + FP)
    A(c)  = TPA(c) / (TPA(c) + FNA(c) + FPA(c))   AssA = mean of A(c) over the matches c
    HOTA  = sqrt(DetA * AssA)

where TPA(c) counts the matches between the two identities of c, and the boxes that the two
have besides are FNA(c) and FPA(c). AssRe and AssPr leave FPA and FNA out. Each is averaged over
alpha = 0.05, 0.10, ..., 0.95. A match is made so that pairs of identities that fit over the
whole sequence come first; details as in TrackEval, the authors' implementation.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation.comparison import Comparison
from survtrack.evaluation.overlap import EPSILON

ALPHAS = np.arange(0.05, 0.99, 0.05)


@dataclass(frozen=True)
class Hota:
    """Means over the 19 localisation thresholds, from 0 to 1; names as in the paper."""

    hota: float
    det_a: float
    ass_a: float
    det_re: float
    det_pr: float
    ass_re: float
    ass_pr: float
    loc_a: float


def hota_scores(comparison: Comparison) -> Hota:
    """Score a comparison; 0 where there is nothing to match (loc_a: 1)."""
    truth_boxes, output_boxes = comparison.boxes_per_identity()
    truth, output, iou = _matches(comparison, truth_boxes, output_boxes)
    reached = iou >= ALPHAS[:, None] - EPSILON  # (alpha, match)
    matches = reached.sum(axis=1).astype(np.float64)

    pairs, pair = np.unique(truth * max(1, comparison.output_ids) + output, return_inverse=True)
    shared = np.stack([np.bincount(pair[row], minlength=len(pairs)) for row in reached])
    of_truth = truth_boxes[pairs // max(1, comparison.output_ids)]
    of_output = output_boxes[pairs % max(1, comparison.output_ids)]

    def per_match(total: NDArray[np.float64]) -> NDArray[np.float64]:
        summed = (shared * (shared / np.maximum(1, total))).sum(axis=1)
        return np.asarray(summed / np.maximum(1, matches))

    all_truth, all_output = comparison.truth_boxes, comparison.output_boxes
    det_a = matches / np.maximum(1, all_truth + all_output - matches)
    ass_a = per_match(of_truth + of_output - shared)
    # Without any match nothing is out of place: 1, as TrackEval has it.
    located = np.where(reached, iou, 0.0).sum(axis=1) / np.maximum(1, matches)
    loc_a = np.where(matches > 0, located, 1.0)
    return Hota(
        hota=float(np.sqrt(det_a * ass_a).mean()),
        det_a=float(det_a.mean()),
        ass_a=float(ass_a.mean()),
        det_re=float((matches / max(1, all_truth)).mean()),
        det_pr=float((matches / max(1, all_output)).mean()),
        ass_re=float(per_match(of_truth).mean()),
        ass_pr=float(per_match(of_output).mean()),
        loc_a=float(loc_a.mean()),
    )


def _matches(
    comparison: Comparison, truth_boxes: NDArray[np.float64], output_boxes: NDArray[np.float64]
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.float64]]:
    """Every match of every frame: both identities, and the IoU."""
    from scipy.optimize import linear_sum_assignment

    alignment = _alignment(comparison, truth_boxes, output_boxes)
    truth: list[NDArray[np.intp]] = [np.empty(0, np.intp)]
    output: list[NDArray[np.intp]] = [np.empty(0, np.intp)]
    iou: list[NDArray[np.float64]] = [np.empty(0)]
    for frame in comparison.frames:
        score = alignment[np.ix_(frame.truth, frame.output)] * frame.iou
        rows, columns = linear_sum_assignment(score, maximize=True)
        truth.append(frame.truth[rows])
        output.append(frame.output[columns])
        iou.append(frame.iou[rows, columns])
    return np.concatenate(truth), np.concatenate(output), np.concatenate(iou)


def _alignment(
    comparison: Comparison, truth_boxes: NDArray[np.float64], output_boxes: NDArray[np.float64]
) -> NDArray[np.float64]:
    """How well two identities fit over the whole sequence: a Jaccard index of soft matches.

    A frame adds IoU / (sum of the IoUs of both boxes with all others), so that a box that lies
    on several shares itself out between them.
    """
    soft = np.zeros((comparison.truth_ids, comparison.output_ids))
    for frame in comparison.frames:
        iou = frame.iou
        around = iou.sum(axis=0) + iou.sum(axis=1)[:, None] - iou
        share = np.divide(iou, around, out=np.zeros_like(iou), where=around > EPSILON)
        soft[np.ix_(frame.truth, frame.output)] += share
    return np.asarray(soft / (truth_boxes[:, None] + output_boxes - soft))
