# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Track streams of made-up runs."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from hypothesis import strategies as st

import survtrack
from clips import Image
from fakes import Box, Detection, Result, Status, Track
from survtrack import Region, RegionKind
from survtrack.replay import TrackStreamDecoder, TrackStreamEncoder

FRAME: Image = np.zeros((48, 64, 3), np.uint8)
SIZE = (64, 48)
FPS = 10.0


def pieces(
    results: Sequence[Any],
    fps: float = FPS,
    size: tuple[int, int] = SIZE,
    lost_damping_s: float | None = None,
) -> list[bytes]:
    """The header, a record for each result, and the end mark."""
    encoder = TrackStreamEncoder(size, fps=fps, lost_damping_s=lost_damping_s)
    return [encoder.header(), *(encoder.frame(result) for result in results), encoder.end()]


def stream(results: Sequence[Any], fps: float = FPS) -> bytes:
    return b"".join(pieces(results, fps))


def decoded(data: bytes) -> tuple[list[Any], TrackStreamDecoder]:
    decoder = TrackStreamDecoder("x.svt")
    return decoder.feed(data), decoder


def result_at(index: int, time_s: float, *tracks: Track, **more: Any) -> Result:
    return Result(index, time_s, FRAME, FRAME[..., 0], list(tracks), **more)


def region(
    kind: RegionKind, x: float, y: float, width: float, height: float, track_id: int = 0
) -> Region:
    return Region(survtrack.Box(x, y, width, height), kind, track_id)


def walk(count: int, step: int = 1) -> list[Result]:
    """Two tracks; the second is lost from the fifth frame on and gone from the seventh.

    The first is expected in a region up to frame 18, and newcomers above all the time.
    """
    results = []
    for k in range(0, count, step):
        first = Track(1, Box(2.0 + 3 * k, 10, 8, 20), velocity_px_per_s=(30.0, 0.0), detection=0)
        lost = Status.lost if k >= 4 else Status.confirmed
        second = Track(7, Box(40 - k, 5, 6.5, 12), lost, velocity_px_per_s=(-10.0, 1.5))
        seen = Detection(Box(2.5 + 3 * k, 9.5, 8.5, 20.5))
        first.velocity_covariance_px2_per_s2 = np.diag([9.0, 4.0 + k])
        first.position_velocity_covariance_px2_per_s = np.diag([1.5, 1.0])
        first.velocity_noise_px2_per_s3 = 16.0 * np.eye(2)
        tracks = [first, second] if k < 6 else [first]
        regions = [region(RegionKind.acquisition, 0, 0, 64, 5)]
        regions += [region(RegionKind.predicted, 1.0 + 3 * k, 7, 12, 26, 1)] if k < 18 else []
        regions += [region(RegionKind.whole_frame, 0, 0, *SIZE)] if k == 0 else []
        results.append(result_at(k, k / FPS, *tracks, detections=[seen], regions=regions))
    return results


NUMBERS = st.floats(-1e5, 1e5, allow_subnormal=False) | st.sampled_from([0.0, -3e10, 2e10])
SIDES = st.floats(0, 1e4, allow_subnormal=False) | st.sampled_from([0.0, 1 / 16, 2e10])
BOXES = st.builds(Box, NUMBERS, NUMBERS, SIDES, SIDES)
SPREADS = st.tuples(
    st.sampled_from([0.0]) | st.floats(1e-4, 1e6),
    st.sampled_from([0.0]) | st.floats(1e-4, 1e6),
    st.floats(-1, 1),
)


CORRELATIONS = st.floats(-1, 1)
EDGES = st.floats(-20, 80) | st.integers(-3, 70)
LENGTHS = st.floats(0, 90, exclude_min=True) | st.integers(1, 64)


def covariance(spread: tuple[float, float, float]) -> np.ndarray:
    sx, sy, correlation = spread
    return np.array([[sx * sx, correlation * sx * sy], [correlation * sx * sy, sy * sy]])


@st.composite
def tracks(draw: Any, track_id: int) -> Track:
    position, velocity = draw(SPREADS), draw(SPREADS)
    correlations = np.reshape([draw(CORRELATIONS) for _ in range(4)], (2, 2))
    return Track(
        track_id,
        draw(BOXES),
        draw(st.sampled_from(Status)),
        draw(st.sampled_from([True, True, True, False])),
        draw(st.tuples(NUMBERS, NUMBERS)),
        covariance(position),
        covariance(velocity),
        correlations * np.outer(position[:2], velocity[:2]),
        covariance(draw(SPREADS)),
        detection=draw(st.integers(-1, 1)),
        group=draw(st.sampled_from([0, 0, 3])),
    )


@st.composite
def regions(draw: Any, ids: list[int]) -> Region:
    kind = draw(st.sampled_from(RegionKind))
    track_id = draw(st.sampled_from([0, *ids])) if kind is RegionKind.predicted else 0
    return region(kind, draw(EDGES), draw(EDGES), draw(LENGTHS), draw(LENGTHS), track_id)


@st.composite
def runs(draw: Any, most_frames: int = 6) -> list[Result]:
    """Results whose indices and times rise; ids come, stay and go."""
    results = []
    index, ticks = -1, draw(st.integers(-(10**9), 10**12))
    pool = draw(st.lists(st.integers(1, 2**53), min_size=1, max_size=6, unique=True))
    for _ in range(draw(st.integers(0, most_frames))):
        index += draw(st.integers(1, 3) | st.integers(1, 10**9))
        ticks += draw(st.integers(1, 10**6) | st.integers(1, 10**12))
        ids = draw(st.lists(st.sampled_from(pool), unique=True))
        found = [draw(tracks(track_id)) for track_id in ids]
        detections = [Detection(draw(BOXES)) for _ in range(2)]
        read = draw(st.lists(regions(pool), max_size=4))
        more = {"detections": detections, "regions": read}
        results.append(result_at(index, ticks / 1e6, *found, **more))
    return results
