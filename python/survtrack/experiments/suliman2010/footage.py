# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The flow's centroid and the estimate on real footage, where the centroid is on a contact."""

from dataclasses import dataclass

import numpy as np

from survtrack.experiments.following import TO_EDGES, rms
from survtrack.experiments.footage import Footage
from survtrack.experiments.trial import Variant, results_of

VARIANTS = {
    name: Variant(name, in_frames=name != "survtrack") for name in ("suliman2010", "survtrack")
}


@dataclass(frozen=True)
class OnFootage:
    """Distances to the centre of the true box that holds the centroid, rms.

    Attributes:
        frames: of the footage.
        detected: of these, with a blob.
        compared: of these, with its centroid in a true box.
        centroid_px, estimate_px: NaN when none is compared.
    """

    frames: int
    detected: int
    compared: int
    centroid_px: float
    estimate_px: float


def compare_on(footage: Footage) -> OnFootage:
    """Run the preset on a set."""
    truth, detected = footage.truth, 0
    centroids, estimates = [], []
    for result in results_of(footage, VARIANTS["suliman2010"].config(footage.frame_period_s)):
        tracks = [track for track in result.tracks if track.reported]
        if not len(result.detections) or not tracks:
            continue
        detected += 1
        here = (truth.frames == result.index + 1) & ~truth.ignore
        boxes = truth.boxes[here]
        at = np.array(result.detections[0].position) + TO_EDGES
        centres = boxes[:, :2] + boxes[:, 2:] / 2
        inside = (np.abs(at - centres) <= boxes[:, 2:] / 2).all(axis=1)
        if inside.any():
            away = np.hypot(*(centres - at).T)
            centre = centres[np.argmin(np.where(inside, away, np.inf))]
            centroids.append(float(np.hypot(*(at - centre))))
            estimates.append(float(np.hypot(*(np.array(tracks[0].position) + TO_EDGES - centre))))
    return OnFootage(
        len(footage.frames),
        detected,
        len(centroids),
        rms(np.array(centroids)),
        rms(np.array(estimates)),
    )
