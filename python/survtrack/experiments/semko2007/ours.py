# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the errata are measured against: the library itself, with the preset semko2007."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack._core import KalmanCaOptions, TrackingResult

PRESET = "semko2007"
SIDE_PX = 20.0
FRAME_SIZE = (384, 288)

Floats = NDArray[np.float64]


def bank(**changes: float) -> survtrack.FilterBank:
    """The preset's filters, none started yet."""
    options = survtrack.preset(PRESET).filter
    assert isinstance(options, KalmanCaOptions)
    return survtrack.FilterBank(options.replace(**changes))


def step(filters: survtrack.FilterBank, z: Sequence[float] | Floats | None) -> None:
    """One frame on, of a bank of one filter."""
    filters.predict(1.0)
    filters.correct(np.full((1, 2), np.nan) if z is None else np.reshape(z, (1, 2)))


def monitor(
    frames: Sequence[Sequence[Sequence[float]]], *changes: str
) -> list[tuple[TrackingResult, dict[int, Floats]]]:
    """Measured positions of each frame through the preset's tracker.

    Args:
        frames: (x, y) of each blob, in each frame.
        changes: from the preset, as for --set.

    Returns:
        The result of each frame, and the positions of its reported tracks by their ids.
    """
    config = survtrack.preset(PRESET)
    for change in changes:
        config.set(change)
    tracker = survtrack.Tracker(config)
    answers = []
    for index, blobs in enumerate(frames):
        corners = [[x - SIDE_PX / 2, y - SIDE_PX / 2, SIDE_PX, SIDE_PX] for x, y in blobs]
        boxes = np.array(corners).reshape(-1, 4)
        found = survtrack.Detections(
            boxes, index * config.time_unit_s, index=index, frame_size=FRAME_SIZE
        )
        result = tracker.process(found)
        positions = {
            track.id: np.array(track.position) for track in result.tracks if track.reported
        }
        answers.append((result, positions))
    return answers


def ended(result: TrackingResult) -> dict[int, tuple[float, float]]:
    """Last measured position of each track that ends in this frame, by its id."""
    return {
        event.track_id: event.position
        for event in result.events
        if event.kind == survtrack.EventKind.track_ended
    }
