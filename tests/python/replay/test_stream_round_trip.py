# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A track stream gives back what was written, to half a step, and is what docs/replay.md says."""

import copy
import math
import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from fakes import Box, Detection, Result, Status, Track
from survtrack import RegionKind, TrackStatus
from survtrack.errors import InputError, UsageError
from survtrack.replay import StreamFrame, StreamHeader, StreamTrack, TrackStreamEncoder
from track_stream_reference import read
from track_streams import FPS, decoded, pieces, region, result_at, runs, stream, walk

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
    for name in (
        "position_covariance_px2",
        "velocity_covariance_px2_per_s2",
        "velocity_noise_px2_per_s3",
    ):
        assert_same_spread(getattr(got, name), getattr(track, name))
    assert_same_cross(got, track)


def assert_same_cross(got: StreamTrack, track: Track) -> None:
    """Correlations to half a step; none where either deviation is none."""
    P, V = got.position_covariance_px2, got.velocity_covariance_px2_per_s2
    for row in (0, 1):
        for column in (0, 1):
            scale = math.sqrt(P[row, row] * V[column, column])
            cross = got.position_velocity_covariance_px2_per_s[row, column]
            if scale == 0:
                assert cross == 0
                continue
            true = track.position_velocity_covariance_px2_per_s[row, column] / math.sqrt(
                track.position_covariance_px2[row, row]
                * track.velocity_covariance_px2_per_s2[column, column]
            )
            assert abs(cross / scale - true) <= 1 / 64 + 1e-9


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


def assert_same_regions(frame: StreamFrame, result: Result) -> None:
    """The pixels that each region touches in the frame, in their order; the whole frame last."""
    wanted, whole = [], []
    for each in result.regions:
        box = each.box
        if each.kind is RegionKind.whole_frame:
            whole = [(each.kind, 0, [0, 0, 64, 48])]
            continue
        left, top = max(0, math.floor(box.x)), max(0, math.floor(box.y))
        right = min(64, math.ceil(box.x + box.width))
        bottom = min(48, math.ceil(box.y + box.height))
        if right > left and bottom > top:
            sides = [left, top, right - left, bottom - top]
            wanted.append((each.kind, each.track_id, sides))
    wanted += whole if wanted else []
    assert [(each.kind, each.track_id, [*each.box]) for each in frame.regions] == wanted


@given(runs())
def test_every_run_comes_back_within_half_a_step(results: list[Result]) -> None:
    frames, decoder = decoded(stream(results))
    assert decoder.problem is None and decoder.ended
    assert [frame.index for frame in frames] == [result.index for result in results]
    for frame, result in zip(frames, results, strict=True):
        assert frame.time_s == pytest.approx(result.time_s, abs=5.1e-7, rel=1e-15)
        reported = {track.id: track for track in result.tracks if track.reported}
        assert [track.id for track in frame.tracks] == sorted(reported)
        assert_same_regions(frame, result)
        for track in frame.tracks:
            assert_same(track, reported[track.id], result)


@given(runs())
def test_a_reader_written_from_the_document_reads_the_same(results: list[Result]) -> None:
    data = stream(results)
    frames, _ = decoded(data)
    header, others = read(data)
    assert header == {
        **{"width": 64, "height": 48, "rate": 10_000, "ticks": 10**6},
        **{"px": 16, "speed": 4, "octave": 8, "correlation": 32, "damping": 0},
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
            assert track.rate_covariance == pytest.approx(wanted["rates"], rel=1e-12)
            assert track.cross_covariance == pytest.approx(wanted["cross"], rel=1e-12)
            assert track.rate_noise == pytest.approx(wanted["noise"], rel=1e-12)
        parts = [each for each in frame.regions if each.kind is not RegionKind.whole_frame]
        assert (len(parts) < len(frame.regions)) == other["whole"]
        assert [(each.kind.value, each.track_id, [*each.box]) for each in parts] == other["regions"]


def test_frames_are_copied_and_pickled() -> None:
    frames, _ = decoded(stream(walk(8)))
    assert all(frame.tracks and frame.regions for frame in frames)
    assert any(track.measured is not None for track in frames[3].tracks)
    for frame in frames:
        for copied in (copy.deepcopy(frame), pickle.loads(pickle.dumps(frame))):
            assert copied == frame
            assert copied.tracks[0].box is not frame.tracks[0].box
            assert copied.tracks[0].status is frame.tracks[0].status


def test_the_bytes_of_a_small_stream() -> None:
    """Worked out by hand from docs/replay.md."""
    covariance = np.array([[4.0, 0.0], [0.0, 1.0]])
    first = Track(
        3, Box(1, 2, 4, 6), velocity_px_per_s=(10.0, 0.0), position_covariance_px2=covariance
    )
    second = Track(3, Box(2.0625, 2, 4, 6), velocity_px_per_s=(10.0, 0.0), detection=0)
    second.position_covariance_px2 = covariance
    seen = Detection(Box(2.0625, 1.875, 4, 6))
    for track in (first, second):
        track.velocity_covariance_px2_per_s2 = np.diag([16.0, 1.0])
        track.position_velocity_covariance_px2_per_s = np.diag([4.0, 0.5])
        track.velocity_noise_px2_per_s3 = np.diag([0.0, 4.0])
    looked = [
        region(RegionKind.predicted, 60.25, -5, 100, 99, 3),
        region(RegionKind.whole_frame, 0, 0, 64, 48),
    ]
    more = {"detections": [seen], "regions": looked}
    results = [result_at(0, 0.0, first), result_at(1, 0.1, second, **more)]
    header, *records, end = (piece[:-4].hex() for piece in pieces(results))
    # 64, 48, 10000, 1000000, 16, 4, 8, 32, 0 as varints, 12 bytes of them.
    assert header == "895356540d0a1a0a020c4030904ec0843d1004082000"
    # Index and time as foreseen, one track, id 3 - 0 - 1; confirmed, with all five parts;
    # position (3, 5) px = (48, 80); 64 x 96 steps, centred; 40 steps; 8 steps are one octave;
    # 4 px/s are two octaves, correlations of a half are 16 steps; no noise in x, 2 px/s^1.5 in y:
    # of the ten numbers the first (velocity, x), third and fourth (correlations), fifth and sixth.
    place, shape, velocity, spread = "60a001", "8001c0010000", "5000", "100000"
    motion = "3d" + "20" + "2020" + "ff0110"
    assert records[0] == "1a0000010279" + place + shape + velocity + spread + motion
    # It went 1 px in 0.1 s, as foreseen, and 1/16 px more; measured two steps higher. One region
    # and the whole frame; predicted, moved; of track 3, at (60, 0), 4 x 48 px.
    assert records[1] == "120000010205020000030000" + "03" + "0503" + "7800" + "0860"
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
    many = [covariance, covariance, np.full((2, 2), -1e308), -covariance]
    track = Track(1, Box(-1e300, 1e300, 1e300, 1e300), Status.confirmed, True, (0.0, 0.0), *many)
    track.velocity_px_per_s = (1e308, -1e308)
    [frame, again], decoder = decoded(stream([result_at(0, 0.0, track), result_at(1, 0.1, track)]))
    assert decoder.problem is None
    bound = 2.0**40
    for each in (frame.tracks[0], again.tracks[0]):
        assert [*each.box] == [-bound / 16, bound / 16, bound / 16, bound / 16]
        assert each.velocity_px_per_s == (bound / 4, -bound / 4)
        assert each.covariance_px2 == each.rate_covariance == (2.0**80, -(2.0**80), 2.0**80)
        assert each.cross_covariance == (-(2.0**80),) * 4
        assert each.rate_noise == (0, 0, 0)  # variances below 0 are none


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
        (
            {"velocity_covariance_px2_per_s2": np.full((2, 2), INF)},
            r"track 4: its velocity_covariance_px2_per_s2 is \[\[inf, inf\], \[inf, inf\]\]",
        ),
        ({"position_velocity_covariance_px2_per_s": np.full((2, 2), NAN)}, "_per_s is .*nan"),
        ({"velocity_noise_px2_per_s3": np.diag([1.0, NAN])}, "_per_s3 is .*nan"),
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


@pytest.mark.parametrize("damping_s", [-1e-9, NAN, INF, 2e9])
def test_a_damping_out_of_bounds_is_refused(damping_s: float) -> None:
    with pytest.raises(UsageError, match=f"lost_damping: {damping_s} s is not allowed; 0 to 1e9"):
        TrackStreamEncoder((64, 48), fps=FPS, lost_damping_s=damping_s)


@pytest.mark.parametrize(
    ("given", "read"), [(None, None), (0.0, 1e-6), (1e-9, 1e-6), (0.8, 0.8), (1e9, 1e9)]
)
def test_the_header_has_the_damping(given: float | None, read: float | None) -> None:
    frames, decoder = decoded(b"".join(pieces([], lost_damping_s=given)))
    assert frames == [] and decoder.header is not None
    assert decoder.header.lost_damping_s == read


def test_a_damping_that_no_filter_has_is_none() -> None:
    assert StreamHeader(1, 1, 1, ticks_per_s=1, lost_damping_ticks=2**53).lost_damping_s is None
    assert StreamHeader(1, 1, 1, ticks_per_s=1, lost_damping_ticks=10**9).lost_damping_s == 1e9


def test_a_size_out_of_bounds_is_refused() -> None:
    with pytest.raises(InputError, match="width_px is 0; 1 to 16777216"):
        TrackStreamEncoder((0, 48), fps=FPS)


def test_the_period_is_rounded_half_up() -> None:
    assert StreamHeader(1, 1, 30_000).period_ticks == 33_333
    assert StreamHeader(1, 1, 3_000_000, ticks_per_s=1500).period_ticks == 1
