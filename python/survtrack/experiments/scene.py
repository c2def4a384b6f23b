# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a truth says of its scene: how large things are, how fast, how close together."""

from dataclasses import dataclass

import numpy as np

from survtrack.evaluation import Boxes
from survtrack.evaluation.overlap import iou_matrix


@dataclass(frozen=True)
class Scene:
    """Facts of the true boxes that count; lengths in pixels of the frames as they were run.

    Attributes:
        width_px, height_px: medians over the boxes.
        fast_step_px: what 95 % of the displacements of a box's centre from one frame to the next
            stay below; 0 without any.
        overlapping: part of the boxes that overlap another of their frame, 0 to 1.
    """

    width_px: float
    height_px: float
    fast_step_px: float
    overlapping: float


def describe(truth: Boxes) -> Scene:
    """The facts of a truth with at least one box that counts."""
    kept = ~truth.ignore
    frames, ids, boxes = truth.frames[kept], truth.ids[kept], truth.boxes[kept]
    order = np.lexsort((frames, ids))
    centres = (boxes[:, :2] + boxes[:, 2:] / 2)[order]
    follows = (np.diff(ids[order]) == 0) & (np.diff(frames[order]) == 1)
    steps = np.hypot(*np.diff(centres, axis=0)[follows].T)
    overlapping = 0
    for frame in np.unique(frames):
        here = boxes[frames == frame]
        overlapping += int(((iou_matrix(here, here) > 0).sum(axis=1) > 1).sum())
    return Scene(
        width_px=float(np.median(boxes[:, 2])),
        height_px=float(np.median(boxes[:, 3])),
        fast_step_px=float(np.percentile(steps, 95)) if len(steps) else 0.0,
        overlapping=overlapping / len(boxes),
    )
