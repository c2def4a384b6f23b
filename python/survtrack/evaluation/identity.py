# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""IDF1: how long each object carries one and the same identity.

Source: E. Ristani, F. Solera, R. Zou, R. Cucchiara, C. Tomasi, "Performance Measures and a Data
Set for Multi-Target, Multi-Camera Tracking", ECCV workshops 2016. Identities of truth and output
are paired one to one, once for the whole sequence, so that IDTP, the number of boxes that fit
within the pairs, is highest:

    IDP = IDTP / (output boxes)    IDR = IDTP / (truth boxes)
    IDF1 = 2 IDTP / (truth boxes + output boxes)

The paper minimises misses plus false positives with unpaired identities allowed. Their sum is
truth boxes + output boxes - 2 IDTP, so the pairing is the same.
"""

from dataclasses import dataclass

import numpy as np

from survtrack.evaluation.comparison import Comparison


@dataclass(frozen=True)
class Identity:
    """Identity scores, from 0 to 1."""

    idf1: float
    idp: float
    idr: float


def identity_scores(comparison: Comparison, iou: float = 0.5) -> Identity:
    """Score a comparison with boxes that fit at least so well; 0 where there is none."""
    from scipy.optimize import linear_sum_assignment

    fitting = np.zeros((comparison.truth_ids, comparison.output_ids))
    for frame in comparison.frames:
        fitting[np.ix_(frame.truth, frame.output)] += frame.iou >= iou
    rows, columns = linear_sum_assignment(fitting, maximize=True)
    kept = float(fitting[rows, columns].sum())
    truth, output = comparison.truth_boxes, comparison.output_boxes
    return Identity(
        idf1=2 * kept / max(1, truth + output), idp=kept / max(1, output), idr=kept / max(1, truth)
    )
