# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A steady rate of pictures: what is missing is predicted, long gaps are passed over."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from survtrack import Box, TrackStatus
from survtrack.errors import UsageError
from survtrack.replay import StreamFrame, StreamTrack, paced, predicted
from track_streams import FPS, decoded, stream, walk

TRACK = StreamTrack(
    3,
    TrackStatus.confirmed,
    Box(10, 20, 4, 8),
    (12.0, 24.0),
    (30.0, -10.0),
    (4.0, 1.0, 9.0),
    Box(9, 19, 5, 9),
)


def at(*times_s: float) -> list[StreamFrame]:
    return [StreamFrame(k, time_s, (TRACK,)) for k, time_s in enumerate(times_s)]


def shown_at(frames: list[StreamFrame], fps: float, **more: Any) -> list[tuple[int, float]]:
    """(index, predicted_s) of each picture."""
    shown = paced(frames, fps, **{"period_s": 0.1, **more})
    return [(each.frame.index, round(each.frame.predicted_s, 6)) for each in shown]


def test_a_prediction_moves_with_the_velocity_and_is_less_certain() -> None:
    [track] = predicted(at(5.0)[0], 5.2, period_s=0.1).tracks
    assert track.position == pytest.approx((18.0, 22.0))
    assert [*track.box] == pytest.approx([16, 18, 4, 8])
    # Two periods, in which the velocity's error adds as much as there was.
    assert np.allclose(track.position_covariance_px2, 2 * TRACK.position_covariance_px2)
    assert (track.id, track.measured, track.velocity_px_per_s) == (3, None, (30.0, -10.0))


def test_a_prediction_for_now_is_the_frame_itself() -> None:
    [track] = predicted(at(5.0)[0], 5.0, period_s=0.1).tracks
    assert track.box == TRACK.box and track.covariance_px2 == TRACK.covariance_px2


def test_frames_at_their_own_rate_are_shown_as_they_are() -> None:
    times = [k / 7 for k in range(200)]
    assert shown_at(at(*times), 7.0, period_s=1 / 7) == [(k, 0.0) for k in range(200)]
    shaken = [time_s + 0.03 * (-1) ** k for k, time_s in enumerate(times)]
    assert shown_at(at(*shaken), 7.0, period_s=1 / 7)[5:9] == [(5, 0), (6, 0), (7, 0), (8, 0)]


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
    shown = list(paced(frames, 10, period_s=0.1))
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
    shown = list(paced(frames, fps, period_s=0.1, max_gap_s=max_gap_s))
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
        paced([], fps, period_s=0.1)


@pytest.mark.parametrize("gap_s", [-1, 3601, float("nan"), float("inf")])
def test_a_gap_out_of_bounds_is_refused(gap_s: float) -> None:
    with pytest.raises(UsageError, match=f"max_gap: {gap_s} s is not allowed"):
        paced([], 10, period_s=0.1, max_gap_s=gap_s)


def test_a_stream_with_every_third_frame_is_replayed_at_the_full_rate() -> None:
    frames, decoder = decoded(stream(walk(13, step=3), fps=FPS / 3))
    assert decoder.header is not None
    shown = list(paced(frames, FPS, period_s=1 / decoder.header.fps))
    assert len(shown) == 13
    places = [each.frame.by_id()[1].position[0] for each in shown]
    # Three px a frame, as it walks.
    assert places == pytest.approx([6 + 3 * k for k in range(13)], abs=0.1)
