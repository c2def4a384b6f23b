# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What goes along a path is predicted along it, as the filter along paths does it."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import survtrack
from predictions import (
    MATRICES,
    PERIOD_S,
    StreamTime,
    exact,
    through_a_stream,
    tracked,
    without_detection,
)
from survtrack import Box, TrackStatus
from survtrack.replay import StreamFrame, StreamTrack, lost_damping_s, paced, predicted

CENTER, RADIUS_PX, CAR_PX = np.array([320.0, 240.0]), 100.0, 16.0
GAPS_S = (0.2, 0.5, 2.0)


def circle() -> survtrack.Path:
    angles = np.linspace(0, 2 * np.pi, 72, endpoint=False)
    points = CENTER + RADIUS_PX * np.column_stack([np.cos(angles), np.sin(angles)])
    return survtrack.Path(points, closed=True, kind="curve", max_distance_px=40)


def serpentine() -> survtrack.Path:
    """Open; bends to both sides."""
    x = np.linspace(20, 620, 31)
    points = np.column_stack([x, 240 + 60 * np.sin(x / 60)])
    return survtrack.Path(points, kind="curve", max_distance_px=40)


def car_on(path: survtrack.Path, across_px: float) -> Callable[[int], list[float]]:
    """At 80 px/s of S beside the middle of the path, from S = 20."""

    def box_at(k: int) -> list[float]:
        [(x, y)] = path.to_image([(20 + 80 * PERIOD_S * k, across_px)])
        return [x - CAR_PX / 2, y - CAR_PX / 2, CAR_PX, CAR_PX]

    return box_at


def driven(
    path: survtrack.Path, across_px: float, lost: int, **options: Any
) -> tuple[survtrack.Tracker, StreamTime, survtrack.Config, survtrack.Paths]:
    """A tracker along the path, after 30 frames with the car and some without."""
    paths = survtrack.Paths({"lane": path}, (640, 480))
    config = survtrack.Config(
        filter=survtrack.KalmanPathOptions(step_time=PERIOD_S, **options),
        lifecycle=survtrack.LostCountOptions(lost_after_frames=1000),
    )
    tracker, at = tracked(config, 30, lost, car_on(path, across_px), paths)
    assert at.track.status.name == ("lost" if lost else "confirmed")
    return tracker, at, config, paths


# The tests' speeds do not change much: 20 px/s in a second.
Q = (0.01, 0.01, 40.0, 10.0)
PLACES = [(circle, 0.0), (circle, 12.0), (circle, -25.0), (serpentine, 0.0), (serpentine, 8.0)]


@pytest.mark.parametrize(("make", "across_px"), PLACES)
@pytest.mark.parametrize("lost", [0, 3])
@pytest.mark.parametrize("gap_s", GAPS_S)
def test_a_gap_is_a_step_of_the_filter_along_paths(
    make: Callable[[], survtrack.Path], across_px: float, lost: int, gap_s: float
) -> None:
    """Without process noise, of which the filter adds a step's at once, to the last digits."""
    tracker, at, config, paths = driven(make(), across_px, lost, process_variances=[0.0] * 4)
    later_s = at.time_s + gap_s
    [ours] = predicted(exact(at), later_s, lost_damping_s(config), paths).tracks
    filters = without_detection(tracker, later_s)
    assert ours.position == pytest.approx(filters.position, abs=1e-7)
    assert [*ours.box] == pytest.approx([*filters.box], abs=1e-7)
    assert ours.velocity_px_per_s == pytest.approx(filters.velocity_px_per_s, abs=1e-6)
    for name in MATRICES:
        wanted = getattr(filters, name)
        assert np.abs(getattr(ours, name) - wanted).max() < 1e-7 * np.abs(wanted).max(), name


@pytest.mark.parametrize(("make", "across_px"), PLACES)
@pytest.mark.parametrize("gap_s", GAPS_S)
def test_so_it_is_through_a_stream_to_its_steps(
    make: Callable[[], survtrack.Path], across_px: float, gap_s: float
) -> None:
    tracker, at, config, paths = driven(make(), across_px, 0, process_variances=Q)
    frame, damping_s = through_a_stream(at, config)
    [ours] = predicted(frame, at.time_s + gap_s, damping_s, paths).tracks
    for k in range(1, round(gap_s / PERIOD_S) + 1):
        filters = without_detection(tracker, at.time_s + k * PERIOD_S)
    off_px = np.hypot(*np.subtract(ours.position, filters.position))
    # Half a step of place and velocity in x and y; by the bend 1/32 px more or less of T is some
    # 1/1000 more or less of the speed.
    assert off_px < np.sqrt(2) * (1 / 32 + gap_s / 8) + gap_s * 80 / 1000
    ratio = ours.position_covariance_px2.diagonal() / filters.position_covariance_px2.diagonal()
    print(f"off by {off_px:.3f} px, variances", ratio.round(3))
    # 11 % by the stream's steps; the rest is the noise, which comes at the end of a filter's step.
    assert (np.abs(ratio - 1) < 0.2).all(), ratio
    # Straight on would be another place.
    [straight] = predicted(frame, at.time_s + gap_s, damping_s).tracks
    straight_px = np.hypot(*np.subtract(straight.position, filters.position))
    assert straight_px > (0.5 if gap_s < 0.3 else 4) * off_px


def track_at(x: float, y: float, vx: float, vy: float, **more: Any) -> StreamTrack:
    return StreamTrack(
        1, TrackStatus.confirmed, Box(x - 4, y - 10, 8, 20), (x, y), (vx, vy),
        (4.0, 0.0, 1.0), None, (25.0, 0.0, 9.0), (2.0, 0.0, 0.0, 0.5), (6.0, 0.0, 3.0), **more,
    )  # fmt: skip


def moved(track: StreamTrack, passed_s: float, path: survtrack.Path, **more: Any) -> StreamTrack:
    frame = StreamFrame(0, 5.0, (track,))
    [later] = predicted(frame, 5.0 + passed_s, paths=survtrack.Paths({"a": path}), **more).tracks
    return later


# Right, and at S = 100 downwards.
CORNER = survtrack.Path([(0, 50), (100, 50), (100, 300)], max_distance_px=20)


def test_round_a_corner_all_turns_with_the_path() -> None:
    later = moved(track_at(80, 45, 30, -1), 2.0, CORNER)
    # S = 80 + 60, T = -5 - 2: 40 px down the second leg, and 7 px to the left of who goes there.
    assert later.position == pytest.approx((107, 90))
    assert [*later.box] == pytest.approx([103, 80, 8, 20])
    assert later.velocity_px_per_s == pytest.approx((1, 30))
    # Along: 4 + 2 * 2 * 2 + 4 * 25 + 8 / 3 * 6; across: 1 + 2 * 2 * 0.5 + 4 * 9 + 8 / 3 * 3.
    assert later.covariance_px2 == pytest.approx((47, 0, 128))
    assert later.rate_covariance == pytest.approx((9 + 2 * 3, 0, 25 + 2 * 6))
    assert later.cross_covariance == pytest.approx((24.5, 0, 0, 64))
    assert later.rate_noise == pytest.approx((3, 0, 6))


def test_what_is_lost_comes_to_a_standstill_along_the_path_too() -> None:
    lost = replace(track_at(80, 50, 30, 0), status=TrackStatus.lost)
    later = moved(lost, 100.0, CORNER, lost_damping_s=1.0)
    assert later.position == pytest.approx((100, 60))
    assert later.velocity_px_per_s == pytest.approx((0, 0), abs=1e-9)


def test_beyond_the_end_it_goes_straight_on_and_round_a_closed_path_for_ever() -> None:
    assert moved(track_at(100, 290, 0, 30), 2.0, CORNER).position == pytest.approx((100, 350))
    path = circle()
    [start], [speed] = path.to_image([(10, 0)]), 50 * path.tangents([10.0])
    later = moved(track_at(*start, *speed), 3 * path.length_px / 50, path)
    assert later.position == pytest.approx(tuple(start), abs=1e-6)


@pytest.mark.parametrize("place", [(50.0, 71.0), (160.0, 20.0), (-2e9, 50.0)])
def test_off_the_path_it_goes_straight_on(place: tuple[float, float]) -> None:
    track = track_at(*place, 30, -1)
    [straight] = predicted(StreamFrame(0, 5.0, (track,)), 7.0).tracks
    assert moved(track, 2.0, CORNER) == straight
    assert straight.position == (place[0] + 60, place[1] - 2)


def test_of_several_paths_it_is_the_nearest_one() -> None:
    away = survtrack.Path([(0, 60), (90, 60), (90, 0)])
    both = survtrack.Paths({"a": CORNER, "away": away})
    frame = StreamFrame(0, 5.0, (track_at(80, 51, 30, 0), track_at(80, 59, 30, 0)))
    first, second = predicted(frame, 7.0, paths=both).tracks
    assert first.position == pytest.approx((99, 90))
    assert second.position == pytest.approx((89, 10))


def test_a_prediction_for_now_moves_nothing() -> None:
    track = track_at(*circle().to_image([(10, 5)])[0], 20, 30)
    now = moved(track, 0.0, circle())
    assert now.position == pytest.approx(track.position, abs=1e-9)
    for name in ("covariance_px2", "rate_covariance", "cross_covariance", "rate_noise"):
        assert getattr(now, name) == pytest.approx(getattr(track, name), abs=1e-9)


def test_the_pictures_between_are_along_the_path() -> None:
    paths = survtrack.Paths({"a": CORNER})
    frames = [StreamFrame(k, 2.0 * k, (track_at(80, 50, 30, 0),)) for k in range(2)]
    shown = [each.frame.tracks[0].position for each in paced(frames, 1, paths=paths)]
    assert np.ravel(shown) == pytest.approx([80, 50, 100, 60, 80, 50])


NUMBERS = st.floats(-1e3, 1e3) | st.floats(-7e10, 7e10)


@given(st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS), st.floats(0, 10) | st.floats(0, 1e9))
def test_whatever_moves_stays_finite(numbers: Any, passed_s: float) -> None:
    for path in (CORNER, circle(), survtrack.Path([(0, 0), (600, 400)])):
        later = moved(track_at(*numbers), passed_s, path)
        shown = [later.position, later.velocity_px_per_s, later.cross_covariance, [*later.box]]
        assert all(np.isfinite(each).all() for each in shown)
        for P in (later.position_covariance_px2, later.velocity_covariance_px2_per_s2):
            assert np.linalg.eigvalsh(P)[0] >= -1e-12 * P.max()
