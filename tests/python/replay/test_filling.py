# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A steady rate of pictures: what is missing is predicted, long gaps are passed over."""

import math
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from survtrack import Box, RegionKind, TrackStatus
from survtrack.errors import UsageError
from survtrack.replay import StreamFrame, StreamTrack, paced, predicted
from track_streams import FPS, decoded, region, stream, walk

TRACK = StreamTrack(
    3,
    TrackStatus.confirmed,
    Box(10, 20, 4, 8),
    (12.0, 24.0),
    (30.0, -10.0),
    (4.0, 1.0, 9.0),
    Box(9, 19, 5, 9),
    (25.0, 5.0, 16.0),
    (2.0, 0.5, 1.0, 3.0),
    (6.0, 0.0, 12.0),
)


def at(*times_s: float) -> list[StreamFrame]:
    return [StreamFrame(k, time_s, (TRACK,)) for k, time_s in enumerate(times_s)]


def shown_at(frames: list[StreamFrame], fps: float, **more: Any) -> list[tuple[int, float]]:
    """(index, predicted_s) of each picture."""
    shown = paced(frames, fps, **more)
    return [(each.frame.index, round(each.frame.predicted_s, 6)) for each in shown]


def test_a_prediction_moves_with_the_velocity_and_is_less_certain() -> None:
    [track] = predicted(at(5.0)[0], 5.2).tracks
    assert track.position == pytest.approx((18.0, 22.0))
    assert [*track.box] == pytest.approx([16, 18, 4, 8])
    # P + t (C + C') + t^2 V + t^3 / 3 q: 4 + 0.2 * 4 + 0.04 * 25 + 0.008 / 3 * 6, ...
    assert track.covariance_px2 == pytest.approx((5.816, 1.5, 10.872), rel=1e-12)
    # C + t V + t^2 / 2 q: 2 + 0.2 * 25 + 0.02 * 6, ...
    assert track.cross_covariance == pytest.approx((7.12, 1.5, 2.0, 6.44), rel=1e-12)
    assert track.rate_covariance == pytest.approx((26.2, 5.0, 18.4), rel=1e-12)
    assert (track.id, track.measured, track.velocity_px_per_s) == (3, None, (30.0, -10.0))
    assert track.rate_noise == TRACK.rate_noise


def test_what_is_lost_comes_to_a_standstill() -> None:
    lost = replace(TRACK, status=TrackStatus.lost)
    way, kept = 0.8 * (1 - math.exp(-0.5)), math.exp(-0.5)
    [track] = predicted(StreamFrame(0, 5.0, (lost,)), 5.4, lost_damping_s=0.8).tracks
    assert track.position == pytest.approx((12 + 30 * way, 24 - 10 * way))
    assert track.velocity_px_per_s == pytest.approx((30 * kept, -10 * kept))
    noise = 0.4**3 / 3 * 6
    assert track.covariance_px2[0] == pytest.approx(4 + 4 * way + 25 * way**2 + noise)
    assert track.rate_covariance[0] == pytest.approx(25 * kept**2 + 0.4 * 6)
    # What was found goes on, and so does what is lost without a damping.
    assert predicted(at(5.0)[0], 5.4, 0.8) == predicted(at(5.0)[0], 5.4)
    [undamped] = predicted(StreamFrame(0, 5.0, (lost,)), 5.4).tracks
    assert undamped.position == pytest.approx((24.0, 20.0))
    for at_once_s in (1e-6, 0.0):
        [stopped] = predicted(StreamFrame(0, 5.0, (lost,)), 5.4, at_once_s).tracks
        assert stopped.position == pytest.approx((12.0, 24.0), abs=1e-4)
        assert stopped.velocity_px_per_s == pytest.approx((0, 0), abs=1e-9)
    [now] = predicted(StreamFrame(0, 5.0, (lost,)), 5.0, 0.0).tracks
    assert now.rate_covariance == lost.rate_covariance


def test_two_steps_are_one_step() -> None:
    frame = at(5.0)[0]
    once, twice = predicted(frame, 5.9), predicted(predicted(frame, 5.3), 5.9)
    for name in ("covariance_px2", "rate_covariance", "cross_covariance", "position"):
        assert getattr(once.tracks[0], name) == pytest.approx(getattr(twice.tracks[0], name))


def test_rounded_numbers_give_no_covariance_that_is_none() -> None:
    """Correlations that cannot be together, as rounding may leave them a little."""
    odd = replace(
        TRACK,
        covariance_px2=(4.0, 6.0, 9.0),
        rate_covariance=(4.0, -6.0, 9.0),
        cross_covariance=(-4.0, 6.0, 6.0, -9.0),
        rate_noise=(0.0, 0.0, 0.0),
    )
    for time_s in (5.0, 5.5, 6.0, 6.5, 9.0, 1e9):
        [track] = predicted(StreamFrame(0, 5.0, (odd,)), time_s).tracks
        P = track.position_covariance_px2
        assert np.linalg.eigvalsh(P)[0] >= -1e-12 * P.max()


def test_a_prediction_for_now_is_the_frame_itself() -> None:
    [track] = predicted(at(5.0)[0], 5.0).tracks
    assert track.box == TRACK.box and track.covariance_px2 == TRACK.covariance_px2
    assert track.cross_covariance == TRACK.cross_covariance


def test_nothing_was_read_in_a_frame_that_is_predicted() -> None:
    frame = replace(at(5.0)[0], regions=(region(RegionKind.predicted, 1, 2, 3, 4, 3),))
    assert predicted(frame, 5.1).regions == ()


def test_frames_at_their_own_rate_are_shown_as_they_are() -> None:
    times = [k / 7 for k in range(200)]
    assert shown_at(at(*times), 7.0) == [(k, 0.0) for k in range(200)]
    shaken = [time_s + 0.03 * (-1) ** k for k, time_s in enumerate(times)]
    assert shown_at(at(*shaken), 7.0)[5:9] == [(5, 0), (6, 0), (7, 0), (8, 0)]


def test_missing_frames_are_predicted() -> None:
    assert shown_at(at(0.0, 0.1, 0.4, 0.5), 10) == [
        *((0, 0.0), (1, 0.0)),
        *((1, 0.1), (1, 0.2)),
        *((2, 0.0), (3, 0.0)),
    ]


def test_a_higher_rate_predicts_between_and_a_lower_one_leaves_out() -> None:
    between = shown_at(at(0.0, 0.1, 0.2), 30)
    assert between[:4] == [(0, 0.0), (0, 0.033333), (0, 0.066667), (1, 0.0)]
    assert shown_at(at(*(k / 10 for k in range(11))), 5) == [(2 * k, 0.0) for k in range(6)]


def test_what_follows_is_the_next_recorded_frame() -> None:
    frames = at(0.0, 0.3)
    shown = list(paced(frames, 10))
    assert [each.following for each in shown] == [frames[1]] * 3 + [None]


def test_a_long_gap_is_filled_so_far_and_passed_over() -> None:
    shown = shown_at(at(0.0, 1000.0, 1000.1), 10, max_gap_s=0.25)
    assert shown == [(0, 0.0), (0, 0.1), (0, 0.2), (1, 0.0), (2, 0.0)]
    assert shown_at(at(0.0, 1000.0), 10, max_gap_s=0) == [(0, 0.0), (1, 0.0)]


def test_no_frames_and_one() -> None:
    assert shown_at([], 10) == []
    assert shown_at(at(3.0), 10) == [(0, 0.0)]


@given(
    st.lists(st.floats(1e-4, 50), max_size=30),
    st.floats(0.5, 60),
    st.floats(0, 3),
    st.floats(-1e9, 1e9),
)
def test_any_times_end_and_go_forwards(
    steps: list[float], fps: float, max_gap_s: float, start_s: float
) -> None:
    times = start_s + np.cumsum([0.0, *steps])
    frames = at(*times.tolist())
    shown = list(paced(frames, fps, max_gap_s=max_gap_s))
    assert len(shown) <= len(frames) * (max_gap_s * fps + 3)
    indices = [each.frame.index for each in shown]
    assert indices == sorted(indices)
    for each in shown:
        assert 0 <= each.frame.predicted_s <= max_gap_s
        recorded = frames[each.frame.index]
        if each.frame.predicted_s == 0:
            assert each.frame is recorded


@pytest.mark.parametrize("fps", [0, -1, 1001, float("nan"), float("inf")])
def test_a_rate_out_of_bounds_is_refused(fps: float) -> None:
    with pytest.raises(UsageError, match=f"fps: {fps} pictures/s is not allowed"):
        paced([], fps)


@pytest.mark.parametrize("damping_s", [-1e-9, 2e9, float("nan"), float("inf")])
def test_a_damping_out_of_bounds_is_refused(damping_s: float) -> None:
    words = f"lost_damping: {damping_s} s is not allowed; 0 to 1e9"
    with pytest.raises(UsageError, match=words):
        predicted(at(5.0)[0], 5.1, damping_s)
    with pytest.raises(UsageError, match=words):
        paced([], 10, lost_damping_s=damping_s)


@pytest.mark.parametrize("time_s", [4.9, -math.inf, math.inf, math.nan, 1e120, 1.1e9])
def test_a_time_out_of_bounds_is_refused(time_s: float) -> None:
    words = f"time_s: {time_s} is not allowed; the frame's own, 5.0, to 1e9 s later"
    with pytest.raises(UsageError, match=f"^{re.escape(words)}$"):
        predicted(at(5.0)[0], time_s)
    with pytest.raises(UsageError, match=r"^time_s: 5\.0 is not allowed; the frame's own, nan"):
        predicted(at(math.nan)[0], 5.0)


def test_at_the_last_time_all_is_finite_of_whatever_a_stream_can_hold() -> None:
    most, square = 2.0**40, 2.0**80
    wild = StreamTrack(
        1, TrackStatus.confirmed, Box(most, most, most, most), (most, most), (most, -most),
        (square, square, square), None, (square,) * 3, (square,) * 4, (square,) * 3,
    )  # fmt: skip
    [track] = predicted(StreamFrame(0, 5.0, (wild,)), 5.0 + 1e9).tracks
    numbers = [*track.box, *track.position, *track.velocity_px_per_s, *track.covariance_px2]
    assert np.isfinite([*numbers, *track.rate_covariance, *track.cross_covariance]).all()


@pytest.mark.parametrize("gap_s", [-1, 3601, float("nan"), float("inf")])
def test_a_gap_out_of_bounds_is_refused(gap_s: float) -> None:
    with pytest.raises(UsageError, match=f"max_gap: {gap_s} s is not allowed"):
        paced([], 10, max_gap_s=gap_s)


def test_a_stream_with_every_third_frame_is_replayed_at_the_full_rate() -> None:
    frames, decoder = decoded(stream(walk(13, step=3), fps=FPS / 3))
    assert decoder.header is not None
    shown = list(paced(frames, FPS))
    assert len(shown) == 13
    places = [each.frame.by_id()[1].position[0] for each in shown]
    # Three px a frame, as it walks.
    assert places == pytest.approx([6 + 3 * k for k in range(13)], abs=0.1)
