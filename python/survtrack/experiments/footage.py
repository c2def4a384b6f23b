# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A set of footage in memory at one size, with its truth at that size."""

from dataclasses import dataclass

import numpy as np

from survtrack.errors import UsageError
from survtrack.evaluation import Boxes, read_boxes
from survtrack.experiments.datasets import Dataset
from survtrack.sources import Frame, open_source
from survtrack.sources.base import Size, resized


@dataclass(frozen=True, eq=False)
class Footage:
    """Everything that the runs on one set need; nothing of it is ever written again.

    Attributes:
        dataset: where it comes from.
        frames: all frames, scaled.
        fps: frames per second; frame k, from 0, has the time k / fps.
        size: (width, height) of the frames in pixels.
        source_size: the same before scaling.
        truth: the true boxes that have a frame in the footage, scaled alike; frames counted as in
            the footage, from 1; none for a set without truth.
    """

    dataset: Dataset
    frames: list[Frame]
    fps: float
    size: Size
    source_size: Size
    truth: Boxes

    @property
    def frame_period_s(self) -> float:
        """Seconds between two frames."""
        return 1 / self.fps


def load(dataset: Dataset, size: Size) -> Footage:
    """Read truth and frames of a set.

    Raises:
        InputError: footage or truth that cannot be read.
        UsageError: a truth without any box to score in these frames, or a bad frame rate.
    """
    truth = None if dataset.truth is None else read_boxes(dataset.truth, truth=True)
    source = open_source(dataset.source, fps=dataset.fps)
    frames: list[Frame] = []
    source_size = size
    for _, _, frame in source:
        source_size = (frame.shape[1], frame.shape[0])
        frames.append(resized(frame, size))
    if truth is None:
        return Footage(dataset, frames, source.fps, size, source_size, Boxes([], [], []))
    scale = (size[0] / source_size[0], size[1] / source_size[1])
    fitted = _fitted(truth, dataset.offset, len(frames), scale)
    if fitted.ignore.all():
        raise UsageError(
            f"{dataset.truth}: has no box to score in the {len(frames)} frames of "
            f"{dataset.source} (offset {dataset.offset})"
        )
    return Footage(dataset, frames, source.fps, size, source_size, fitted)


def _fitted(truth: Boxes, offset: int, count: int, scale: tuple[float, float]) -> Boxes:
    """The boxes of the first `count` frames after `offset`, renumbered from 1 and scaled."""
    frames = truth.frames - offset
    kept = (frames >= 1) & (frames <= count)
    boxes = truth.boxes[kept] * np.array([*scale, *scale])
    return Boxes(frames[kept], truth.ids[kept], boxes, truth.ignore[kept])
