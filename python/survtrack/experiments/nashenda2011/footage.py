# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The sweep on footage: the largest blob's centroid, filtered, against the true boxes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.errors import UsageError
from survtrack.experiments.following import TO_EDGES
from survtrack.experiments.footage import Footage
from survtrack.experiments.nashenda2011 import published
from survtrack.experiments.nashenda2011.config import preset_config
from survtrack.experiments.nashenda2011.filters import WAYS, Way
from survtrack.experiments.nashenda2011.footage_runs import GAP, SETTLED, FootageErrors, Runs
from survtrack.experiments.nashenda2011.sweep import GRID_Q, best_q

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class OnFootage:
    """One set; every stride-th frame is a run, and so is every one of the frames after it, T each.

    Attributes:
        name: of the set.
        frames, fps: of the footage.
        blobs, on_object: frames with a blob; of these, with it in the object's true box.
        stride: frames from one to the next of a run: about the published rate.
        period_s: between them.
        object_id: true object in whose boxes most of the measurements lie.
        compared: frames that errors are of.
        blob_px: rms distance of the measurement from the centre of the true box.
        errors: by way and q.
        best: rms distance to the truth by q, corrected filter.
        frames_of_run: (T,) frames of the first run, from 1.
        measured, truth: (T, 2) of the first run, px; NaN where there is none.
        estimates: (T, 2) of the first run, by way and q.
    """

    name: str
    frames: int
    fps: float
    blobs: int
    on_object: int
    stride: int
    period_s: float
    object_id: int
    compared: int
    blob_px: float
    errors: dict[Way, dict[float, FootageErrors]]
    best: dict[float, float]
    frames_of_run: NDArray[np.int64]
    measured: Floats
    truth: Floats
    estimates: dict[Way, dict[float, Floats]]

    @property
    def best_q(self) -> float:
        """Of the smallest error to the truth."""
        return best_q(self.best)


def measurements(footage: Footage) -> Floats:
    """(F, 2) centroid of the largest blob in each frame, as the truth counts, px; NaN for none."""
    detector = survtrack.Detector(preset_config())
    places = np.full((len(footage.frames), 2), np.nan)
    found = [
        detector.process(frame, index / footage.fps, index)
        for index, frame in enumerate(footage.frames)
    ]
    for detections in [*(each for each in found if each is not None), *detector.finish()]:
        largest = max(detections, key=lambda one: one.area_px, default=None)
        if largest is not None:
            places[detections.index] = np.add(largest.position, TO_EDGES)
    return places


def measure(footage: Footage) -> OnFootage:
    """Run both filters over one set.

    Raises:
        UsageError: no blob lies in a true box, or there are too few frames.
    """
    places = measurements(footage)
    id, truth, on_object = _object(footage, places)
    stride = max(round(footage.fps * published.PERIOD_S), 1)
    first = int(np.argmax(on_object))
    runs = _in_runs(footage, (places, truth), on_object, first, stride)
    errors = {way: {q: runs.errors(q, way) for q in published.SWEEP} for way in WAYS}
    one = {way: {q: runs.estimates(q, way)[:, 0] for q in published.SWEEP} for way in WAYS}
    return OnFootage(
        footage.dataset.name,
        len(places),
        footage.fps,
        int(np.isfinite(places[:, 0]).sum()),
        int(on_object.sum()),
        stride,
        runs.period_s,
        id,
        int(runs.scored.sum()),
        runs.rms_to(runs.true, runs.z),
        errors,
        {q: runs.rms_to(runs.true, runs.estimates(q, "corrected")) for q in GRID_Q},
        np.arange(first, first + len(runs.z) * stride, stride) + 1,
        runs.z[:, 0],
        runs.true[:, 0],
        one,
    )


def _in_runs(
    footage: Footage,
    positions: tuple[Floats, Floats],
    on_object: NDArray[np.bool_],
    first: int,
    stride: int,
) -> Runs:
    """From the first blob of the object on; UsageError when that is too little."""
    kept = (len(on_object) - first) // stride
    rows = slice(first, first + kept * stride)
    scored = on_object[rows].reshape(kept, stride).copy()
    scored[: SETTLED + GAP] = False
    if not scored.any():
        raise UsageError(
            f"{footage.dataset.source}: no blob lies in the true box {SETTLED + GAP} frames "
            f"of {stride / footage.fps:.3f} s after the first one; more footage is needed"
        )
    z, true = (each[rows].reshape(kept, stride, 2) for each in positions)
    start = (footage.size[0] / 2, footage.size[1] / 2)
    return Runs(z, true, scored, start, stride / footage.fps)


def _object(footage: Footage, places: Floats) -> tuple[int, Floats, NDArray[np.bool_]]:
    """The followed object: its id, (F, 2) its centre, and where the measurement is in its box."""
    truth = footage.truth
    at = places[truth.frames - 1]
    centres = truth.boxes[:, :2] + truth.boxes[:, 2:] / 2
    inside = (np.abs(at - centres) <= truth.boxes[:, 2:] / 2).all(axis=1) & ~truth.ignore
    if not inside.any():
        raise UsageError(
            f"{footage.dataset.source}: no blob of the {len(places)} frames lies in a true box"
        )
    ids, counts = np.unique(truth.ids[inside], return_counts=True)
    id = ids[np.argmax(counts)]
    own = truth.ids == id
    centre = np.full((len(places), 2), np.nan)
    centre[truth.frames[own] - 1] = centres[own]
    on_object = np.zeros(len(places), bool)
    on_object[truth.frames[own & inside] - 1] = True
    return int(id), centre, on_object
