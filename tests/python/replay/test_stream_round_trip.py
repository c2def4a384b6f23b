# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A track stream gives back what was written, to half a step, and is what docs/replay.md says."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from fakes import Box, Detection, Result, Status, Track
from survtrack import TrackStatus
from survtrack.errors import InputError, UsageError
from survtrack.replay import StreamHeader, StreamTrack, TrackStreamEncoder
from track_stream_reference import read
from track_streams import FPS, decoded, pieces, result_at, runs, stream, walk

settings.register_profile("streams", deadline=None, derandomize=True, max_examples=100)
settings.load_profile("streams")

HALF_PX, HALF_SPEED = 1 / 32, 1 / 8


def own_box(track: Track, result: Result) -> Box | None:
    own = track.status is Status.confirmed and track.detection >= 0 and track.group == 0
    return result.detections[track.detection].box if own else None


def assert_near(box: Any, true: Box, margin: float = HALF_PX) -> None:
    for got, wanted in zip(box, (true.x, true.y, true.width, true.height), strict=True):
        assert got == pytest.approx(wanted, abs=margin, rel=1e-12)


def assert_same(got: StreamTrack, track: Track, result: Result) -> None:
    assert (got.id, got.status) == (track.id, TrackStatus[track.status.name])
    assert_near(got.box, track.box)
    for a, b in zip(got.position, track.position, strict=True):
        assert a == pytest.approx(b, abs=HALF_PX, rel=1e-12)
    for a, b in zip(got.velocity_px_per_s, track.velocity_px_per_s, strict=True):
        assert a == pytest.approx(b, abs=HALF_SPEED, rel=1e-12)
    measured = own_box(track, result)
    assert (got.measured is None) == (measured is None)
    if measured is not None:
        assert_near(got.measured, measured)
    assert_same_spread(got.position_covariance_px2, track.position_covariance_px2)


def assert_same_spread(got: np.ndarray, true: np.ndarray) -> None:
    least = 2.0**-32
    for k in (0, 1):
        if true[k, k] < least:
            assert got[k, k] == 0
        else:  # half a step of 1/8 octave of the standard deviation
            assert abs(math.log2(got[k, k] / true[k, k])) <= 1 / 8 + 1e-9
    if min(true[0, 0], true[1, 1]) >= least:
        correlations = [each[0, 1] / math.sqrt(each[0, 0] * each[1, 1]) for each in (got, true)]
        assert abs(correlations[0] - correlations[1]) <= 1 / 64 + 1e-9
    assert np.linalg.eigvalsh(got)[0] >= -1e-12 * got.max()


@given(runs())
def test_every_run_comes_back_within_half_a_step(results: list[Result]) -> None:
    frames, decoder = decoded(stream(results))
    assert decoder.problem is None and decoder.ended
    assert [frame.index for frame in frames] == [result.index for result in results]
    for frame, result in zip(frames, results, strict=True):
        assert frame.time_s == pytest.approx(result.time_s, abs=5.1e-7, rel=1e-15)
        reported = {track.id: track for track in result.tracks if track.reported}
        assert [track.id for track in frame.tracks] == sorted(reported)
        for track in frame.tracks:
            assert_same(track, reported[track.id], result)


@given(runs())
def test_a_reader_written_from_the_document_reads_the_same(results: list[Result]) -> None:
    data = stream(results)
    frames, _ = decoded(data)
    header, others = read(data)
    assert header == {
        **{"width": 64, "height": 48, "rate": 10_000, "ticks": 10**6},
        **{"px": 16, "speed": 4, "octave": 8, "correlation": 32},
    }
    assert [(frame.index, frame.time_s) for frame in frames] == [
        (other["index"], other["time_s"]) for other in others
    ]
    for frame, other in zip(frames, others, strict=True):
        assert [track.id for track in frame.tracks] == list(other["tracks"])
        for track in frame.tracks:
            wanted = other["tracks"][track.id]
            assert (track.status.value, [*track.box]) == (wanted["status"], wanted["box"])
            assert (track.position, track.velocity_px_per_s) == (
                wanted["position"],
                wanted["velocity"],
            )
            assert track.covariance_px2 == pytest.approx(wanted["covariance"], rel=1e-12)
            assert (None if track.measured is None else [*track.measured]) == wanted["measured"]


def test_the_bytes_of_a_small_stream() -> None:
    """Worked out by hand from docs/replay.md."""
    covariance = np.array([[4.0, 0.0], [0.0, 1.0]])
    first = Track(
        3, Box(1, 2, 4, 6), velocity_px_per_s=(10.0, 0.0), position_covariance_px2=covariance
    )
    second = Track(3, Box(2.0625, 2, 4, 6), velocity_px_per_s=(10.0, 0.0), detection=0)
    second.position_covariance_px2 = covariance
    seen = Detection(Box(2.0625, 1.875, 4, 6))
    results = [result_at(0, 0.0, first), result_at(1, 0.1, second, detections=[seen])]
    header, *records, end = (piece[:-4].hex() for piece in pieces(results))
    # 64, 48, 10000, 1000000, 16, 4, 8, 32 as varints, 11 bytes of them.
    assert header == "895356540d0a1a0a010b4030904ec0843d10040820"
    # Index and time as foreseen, one track, id 3 - 0 - 1; confirmed, with shape, velocity, spread;
    # position (3, 5) px = (48, 80); 64 x 96 steps, centred; 40 steps; 8 steps are one octave.
    place, shape, velocity, spread = "60a001", "8001c0010000", "5000", "100000"
    assert records[0] == "130000010239" + place + shape + velocity + spread
    # It went 1 px in 0.1 s, as foreseen, and 1/16 px more; measured two steps higher.
    assert records[1] == "0b0000010205020000030000"
    assert end == "00"


def test_what_is_foreseen_costs_next_to_nothing() -> None:
    still = Track(5, Box(10, 10, 8, 8), Status.lost, velocity_px_per_s=(20.0, -10.0))
    results = []
    for k in range(50):
        track = Track(
            5, Box(10 + 2 * k, 10 - k, 8, 8), Status.lost, velocity_px_per_s=(20.0, -10.0)
        )
        results.append(result_at(k, k / FPS, track))
    sizes = [len(piece) for piece in pieces(results)[1:-1]]
    # Length, index, time, count, id, flags, x, y, and four bytes of checksum.
    assert set(sizes[1:]) == {12} and sizes[0] > 12
    assert still.box == results[0].tracks[0].box


@given(runs())
def test_the_same_run_gives_the_same_bytes_in_any_order_of_tracks(results: list[Result]) -> None:
    data = stream(results)
    for result in results:
        result.tracks.reverse()
    assert stream(results) == data


def test_beyond_the_bounds_is_written_as_the_bound() -> None:
    covariance = np.array([[1e300, -1e300], [-1e300, 1e300]])
    track = Track(1, Box(-1e300, 1e300, 1e300, 1e300), position_covariance_px2=covariance)
    track.velocity_px_per_s = (1e308, -1e308)
    [frame, again], decoder = decoded(stream([result_at(0, 0.0, track), result_at(1, 0.1, track)]))
    assert decoder.problem is None
    bound = 2.0**40
    for each in (frame.tracks[0], again.tracks[0]):
        assert [*each.box] == [-bound / 16, bound / 16, bound / 16, bound / 16]
        assert each.velocity_px_per_s == (bound / 4, -bound / 4)
        assert each.covariance_px2 == (2.0**80, -(2.0**80), 2.0**80)


NAN, INF = float("nan"), float("inf")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"box": Box(NAN, 0, 1, 1)}, "track 4: its position holds nan|track 4: its box holds nan"),
        ({"box": Box(0, INF, 1, 1)}, "track 4: its box holds inf"),
        ({"box": Box(0, 0, -1, 1)}, "track 4: its box has the size -1 x 1 px"),
        ({"velocity_px_per_s": (0.0, -INF)}, "track 4: its velocity holds -inf"),
        ({"position_covariance_px2": np.full((2, 2), NAN)}, r"covariance_px2 is \[nan, nan, nan\]"),
        ({"position_covariance_px2": -np.eye(2)}, r"covariance_px2 is \[-1.0, -0.0, -1.0\]"),
        ({"id": 0}, "track 0: ids from 1"),
        ({"id": -3}, "track -3: ids from 1"),
    ],
)
def test_what_cannot_be_written_is_named_and_leaves_the_stream_whole(
    change: dict[str, Any], words: str
) -> None:
    track = Track(**{"id": 4, "box": Box(0, 0, 1, 1), **change})
    encoder = TrackStreamEncoder((64, 48), fps=FPS)
    data = encoder.header() + encoder.frame(walk(1)[0])
    with pytest.raises(InputError, match=words):
        encoder.frame(result_at(1, 0.1, track))
    data += encoder.frame(walk(2)[1]) + encoder.end()
    frames, decoder = decoded(data)
    assert [frame.index for frame in frames] == [0, 1] and decoder.problem is None


@pytest.mark.parametrize(
    ("index", "time_s"),
    [(1, 0.2), (2, 0.1), (0, 0.2), (2, 0.1000004), (2, NAN), (2, INF), (2, 1e12)],
)
def test_index_and_time_must_rise(index: int, time_s: float) -> None:
    encoder = TrackStreamEncoder((64, 48), fps=FPS)
    encoder.frame(result_at(1, 0.1))
    with pytest.raises(InputError, match=f"frame {index + 1}: "):
        encoder.frame(result_at(index, time_s))


@pytest.mark.parametrize("fps", [0.0, -1.0, NAN, INF, 1e-4, 2e6])
def test_a_rate_out_of_bounds_is_refused(fps: float) -> None:
    with pytest.raises(UsageError, match="frames/s is not allowed"):
        TrackStreamEncoder((64, 48), fps=fps)


def test_a_size_out_of_bounds_is_refused() -> None:
    with pytest.raises(InputError, match="width_px is 0; 1 to 16777216"):
        TrackStreamEncoder((0, 48), fps=FPS)


def test_the_period_is_rounded_half_up() -> None:
    assert StreamHeader(1, 1, 30_000).period_ticks == 33_333
    assert StreamHeader(1, 1, 3_000_000, ticks_per_s=1500).period_ticks == 1
