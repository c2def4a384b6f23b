# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a replay predicts over a gap is what the run's own filter would have predicted."""

from typing import Any, NamedTuple

import numpy as np
import pytest

import survtrack
from clips import Image
from fakes import Result
from survtrack.replay import (
    StreamFrame,
    StreamTrack,
    TrackStreamDecoder,
    TrackStreamEncoder,
    lost_damping_s,
    predicted,
)

FRAME: Image = np.zeros((480, 640, 3), np.uint8)
PERIOD_S = 0.1


def config_of(*settings: str) -> survtrack.Config:
    config = survtrack.Config()
    for setting in settings:
        config.set(setting)
    return config


class StreamTime(NamedTuple):
    track: survtrack.Track
    time_s: float


def box_at(k: int) -> list[float]:
    """A walker of 20 x 50 px who speeds up and turns."""
    return [50 + 4 * k + 0.05 * k * k, 200 + 30 * np.sin(k / 9), 20, 50]


def tracked(config: survtrack.Config, seen: int, lost: int) -> tuple[survtrack.Tracker, StreamTime]:
    """A tracker after frames with and without its object, its track and the time."""
    tracker = survtrack.Tracker(config)
    for k in range(seen + lost):
        boxes = [box_at(k)] if k < seen else np.empty((0, 4))
        result = tracker.process(boxes, k * PERIOD_S)
    [track] = result.tracks
    return tracker, StreamTime(track, (seen + lost - 1) * PERIOD_S)


def without_detection(tracker: survtrack.Tracker, time_s: float) -> survtrack.Track:
    [track] = tracker.process(np.empty((0, 4)), time_s).tracks
    return track


def exact(track: survtrack.Track) -> StreamTrack:
    """As a stream without steps would have it."""

    def numbers(matrix: np.ndarray) -> Any:
        return float(matrix[0, 0]), float(matrix[0, 1]), float(matrix[1, 1])

    return StreamTrack(
        track.id,
        track.status,
        track.box,
        track.position,
        track.velocity_px_per_s,
        numbers(track.position_covariance_px2),
        None,
        numbers(track.velocity_covariance_px2_per_s2),
        tuple(track.position_velocity_covariance_px2_per_s.ravel().tolist()),
        numbers(track.velocity_noise_px2_per_s3),
    )


def through_a_stream(at: StreamTime, config: survtrack.Config) -> tuple[StreamFrame, float | None]:
    encoder = TrackStreamEncoder((640, 480), fps=10, lost_damping_s=lost_damping_s(config))
    seen: Any = at.track  # as the detection: something with a box
    result: Any = Result(0, at.time_s, FRAME, FRAME[..., 0], [seen], detections=[seen])
    decoder = TrackStreamDecoder()
    [frame] = decoder.feed(encoder.header() + encoder.frame(result) + encoder.end())
    assert decoder.header is not None
    return frame, decoder.header.lost_damping_s


MATRICES = (
    "position_covariance_px2",
    "velocity_covariance_px2_per_s2",
    "position_velocity_covariance_px2_per_s",
)
FILTERS = [
    ("filter.model=kalman_cv", "time_unit_s=0.1", "filter.velocity_noise=0.1"),
    ("filter.model=kalman_cv",),
    (
        *("filter.noise_unit=px", "filter.velocity_noise=40"),
        *("filter.position_noise=2", "filter.initial_velocity=60"),
    ),
    ("filter.model=kalman_cv", "filter.lost_damping_time=0"),
    ("filter.model=kalman_box",),
]


@pytest.mark.parametrize("settings", FILTERS)
@pytest.mark.parametrize("lost", [0, 3])
@pytest.mark.parametrize("gap_s", [0.03, 0.4, 2.0])
def test_a_gap_is_a_step_of_the_filter(settings: tuple[str], lost: int, gap_s: float) -> None:
    config = config_of(*settings)
    tracker, at = tracked(config, 30, lost)
    assert at.track.status.name == ("lost" if lost else "confirmed")
    later_s = at.time_s + gap_s
    frame = StreamFrame(0, at.time_s, (exact(at.track),))
    [ours] = predicted(frame, later_s, lost_damping_s(config)).tracks
    filters = without_detection(tracker, later_s)
    assert ours.position == pytest.approx(filters.position, rel=1e-12)
    assert ours.velocity_px_per_s == pytest.approx(filters.velocity_px_per_s, rel=1e-9)
    for name in MATRICES:
        wanted = getattr(filters, name)
        assert np.abs(getattr(ours, name) - wanted).max() < 1e-9 * np.abs(wanted).max(), name


@pytest.mark.parametrize("settings", FILTERS)
@pytest.mark.parametrize("lost", [0, 3])
@pytest.mark.parametrize("gap_s", [0.03, 0.4, 2.0])
def test_so_it_is_through_a_stream_to_its_steps(
    settings: tuple[str], lost: int, gap_s: float
) -> None:
    config = config_of(*settings)
    tracker, at = tracked(config, 30, lost)
    frame, damping_s = through_a_stream(at, config)
    [ours] = predicted(frame, at.time_s + gap_s, damping_s).tracks
    filters = without_detection(tracker, at.time_s + gap_s)
    assert ours.position == pytest.approx(filters.position, abs=1 / 32 + gap_s / 8)
    # Half a step of each standard deviation is 4.5 %, of a correlation 1/64.
    ratio = ours.position_covariance_px2.diagonal() / filters.position_covariance_px2.diagonal()
    assert (np.abs(ratio - 1) < 0.11).all(), ratio


def test_a_frozen_track_stays_and_one_that_is_extrapolated_does_not() -> None:
    for settings, moves in (((), False), (("filter.extrapolate_lost=true",), True)):
        config = config_of("filter.model=mean_velocity", "cost.model=distance", *settings)
        tracker, at = tracked(config, 30, 2)
        frame, damping_s = through_a_stream(at, config)
        [ours] = predicted(frame, at.time_s + 0.5, damping_s).tracks
        filters = without_detection(tracker, at.time_s + 0.5)
        assert ours.position == pytest.approx(filters.position, abs=0.1)
        assert (abs(ours.position[0] - frame.tracks[0].position[0]) > 10) is moves
        assert ours.covariance_px2 == (0, 0, 0)


@pytest.mark.parametrize("model", ["extended", "unscented", "particle"])
def test_of_filters_that_turn_it_is_nearly_one(model: str) -> None:
    config = config_of(f"filter.model={model}")
    tracker, at = tracked(config, 30, 0)
    frame = StreamFrame(0, at.time_s, (exact(at.track),))
    [ours] = predicted(frame, at.time_s + 0.1).tracks
    filters = without_detection(tracker, at.time_s + 0.1)
    ratio = ours.position_covariance_px2.diagonal() / filters.position_covariance_px2.diagonal()
    assert (np.abs(ratio - 1) < 0.05).all(), ratio


DAMPING: list[tuple[tuple[str, ...], float | None]] = [
    (("filter.lost_damping_time=3", "time_unit_s=0.2"), 0.6),
    (("filter.lost_damping_time=0",), None),
    (("filter.model=extended", "filter.lost_damping_time=1.5"), 1.5),
    (("filter.model=kalman_ca",), None),
    (("filter.model=kalman_discrete",), None),
    (("filter.model=mean_velocity",), 0.0),
    (("filter.model=mean_velocity", "filter.extrapolate_lost=true"), None),
    (("filter.lost_damping_time=1e6", "time_unit_s=3000"), None),
]


@pytest.mark.parametrize(("settings", "wanted"), DAMPING)
def test_the_damping_is_the_configs(settings: tuple[str, ...], wanted: float | None) -> None:
    damping_s = lost_damping_s(config_of(*settings))
    assert damping_s == (None if wanted is None else pytest.approx(wanted))
