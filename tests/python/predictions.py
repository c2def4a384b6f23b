# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A run's own filter, and what a replay has of it: to hold one prediction against the other."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

import survtrack
from clips import Image
from fakes import Result
from survtrack.replay import (
    StreamFrame,
    StreamTrack,
    TrackStreamDecoder,
    TrackStreamEncoder,
    lost_damping_s,
)

FRAME: Image = np.zeros((480, 640, 3), np.uint8)
PERIOD_S = 0.1
MATRICES = (
    "position_covariance_px2",
    "velocity_covariance_px2_per_s2",
    "position_velocity_covariance_px2_per_s",
)


class StreamTime(NamedTuple):
    track: survtrack.Track
    time_s: float


def config_of(*settings: str) -> survtrack.Config:
    config = survtrack.Config()
    for setting in settings:
        config.set(setting)
    return config


def tracked(
    config: survtrack.Config,
    seen: int,
    lost: int,
    box_at: Callable[[int], Sequence[float]],
    paths: survtrack.Paths | None = None,
) -> tuple[survtrack.Tracker, StreamTime]:
    """A tracker after frames with and without its object, its track and the time."""
    tracker = survtrack.Tracker(config)
    if paths is not None:
        tracker.load_paths(paths)
    for k in range(seen + lost):
        boxes = [box_at(k)] if k < seen else np.empty((0, 4))
        result = tracker.process(boxes, k * PERIOD_S)
    [track] = result.tracks
    return tracker, StreamTime(track, (seen + lost - 1) * PERIOD_S)


def without_detection(tracker: survtrack.Tracker, time_s: float) -> survtrack.Track:
    [track] = tracker.process(np.empty((0, 4)), time_s).tracks
    return track


def exact(at: StreamTime) -> StreamFrame:
    """As a stream without steps would have it."""

    def numbers(matrix: np.ndarray) -> Any:
        return float(matrix[0, 0]), float(matrix[0, 1]), float(matrix[1, 1])

    track = at.track
    both = track.position_velocity_covariance_px2_per_s
    exactly = StreamTrack(
        track.id,
        track.status,
        track.box,
        track.position,
        track.velocity_px_per_s,
        numbers(track.position_covariance_px2),
        None,
        numbers(track.velocity_covariance_px2_per_s2),
        tuple(both.ravel().tolist()),
        numbers(track.velocity_noise_px2_per_s3),
    )
    return StreamFrame(0, at.time_s, (exactly,))


def through_a_stream(at: StreamTime, config: survtrack.Config) -> tuple[StreamFrame, float | None]:
    encoder = TrackStreamEncoder((640, 480), fps=10, lost_damping_s=lost_damping_s(config))
    seen: Any = at.track  # as the detection: something with a box
    result: Any = Result(0, at.time_s, FRAME, FRAME[..., 0], [seen], detections=[seen])
    decoder = TrackStreamDecoder()
    [frame] = decoder.feed(encoder.header() + encoder.frame(result) + encoder.end())
    assert decoder.header is not None
    return frame, decoder.header.lost_damping_s
