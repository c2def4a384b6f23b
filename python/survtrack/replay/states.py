# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From tracks to whole numbers of steps and back."""

import math
from typing import TYPE_CHECKING, NamedTuple

from survtrack._core import Box, TrackStatus
from survtrack.errors import InputError
from survtrack.replay.covariances import (
    Cross,
    Spread,
    covariance_of,
    cross_covariance_of,
    cross_of,
    is_spread,
    matrix_named,
    spread_of,
)
from survtrack.replay.values import StreamHeader, StreamTrack

if TYPE_CHECKING:
    from survtrack._core import Detection, Track

# Bounds of what is written, in steps: at 1/16 px some 7e10 px, far outside of every picture.
MOST_STEPS = 2**40

Pair = tuple[int, int]


class State(NamedTuple):
    """A track in steps of its stream.

    place: position (x, y).
    shape: width, height, and how far the box's upper left corner is from where it would be were
        the position its centre: left - (x - floor(width / 2)), top - (y - floor(height / 2)).
    velocity: (x, y).
    spread: standard deviations (x, y) of the position and their correlation.
    rate_spread: the same of the velocity.
    cross: correlations of position and velocity: (x, vx), (x, vy), (y, vx), (y, vy).
    noise: as spread, of what the velocity's covariance gains in a second.
    status: of TrackStatus.
    measured: left, top, width and height of the detection less those of the box; None: none.
    """

    place: Pair
    shape: tuple[int, int, int, int]
    velocity: Pair
    spread: Spread
    rate_spread: Spread
    cross: Cross
    noise: Spread
    status: int
    measured: tuple[int, int, int, int] | None


NEW = State((0, 0), (0, 0, 0, 0), (0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0, 0), (0, 0, 0), 0, None)


def quantized(track: "Track", detection: "Detection | None", header: StreamHeader) -> State:
    """The nearest state that the stream can hold.

    Args:
        track: as the tracker reports it.
        detection: the one that its estimate was made with, if there was one.
        header: the stream's steps.

    Raises:
        InputError: a number that is not finite, or a box of negative size.
    """
    corners = _box(track.box, track.id, header)
    x, y = (_steps(value, header.steps_per_px, track.id, "position") for value in track.position)
    left, top, width, height = corners
    shape = (width, height, left - x + width // 2, top - y + height // 2)
    vx, vy = (
        _steps(value, header.steps_per_px_per_s, track.id, "velocity")
        for value in track.velocity_px_per_s
    )
    seen = None if detection is None else _box(detection.box, track.id, header)
    measured = None if seen is None else _minus(seen, corners)
    status = TrackStatus[track.status.name].value
    return State((x, y), shape, (vx, vy), *_uncertainty(track, header), status, measured)


def restored(track_id: int, state: State, header: StreamHeader) -> StreamTrack:
    """The track that a state stands for."""
    (x, y), (width, height, dx, dy) = state.place, state.shape
    corners = (x - width // 2 + dx, y - height // 2 + dy, width, height)
    px, speed = header.steps_per_px, header.steps_per_px_per_s
    measured = None
    if state.measured is not None:
        deltas = zip(corners, state.measured, strict=True)
        measured = Box(*((a + b) / px for a, b in deltas))
    return StreamTrack(
        track_id,
        TrackStatus(state.status),
        Box(*(corner / px for corner in corners)),
        (x / px, y / px),
        (state.velocity[0] / speed, state.velocity[1] / speed),
        covariance_of(state.spread, header),
        measured,
        covariance_of(state.rate_spread, header),
        cross_covariance_of(state.cross, (state.spread, state.rate_spread), header),
        covariance_of(state.noise, header),
    )


def is_allowed(state: State, header: StreamHeader) -> bool:
    """True for a state that quantized() could have made."""
    (x, y), (width, height, dx, dy) = state.place, state.shape
    lengths = (x, y, x - width // 2 + dx, y - height // 2 + dy, *state.velocity)
    allowed = (
        all(abs(length) <= MOST_STEPS for length in lengths)
        and all(0 <= side <= MOST_STEPS for side in (width, height))
        and all(is_spread(each, header) for each in (state.spread, state.rate_spread, state.noise))
        and all(abs(correlation) <= header.steps_of_correlation for correlation in state.cross)
    )
    if not allowed or state.measured is None:
        return allowed
    seen = [a + b for a, b in zip((*lengths[2:4], width, height), state.measured, strict=True)]
    return max(map(abs, seen)) <= MOST_STEPS and min(seen[2:]) >= 0


def _box(box: Box, track_id: int, header: StreamHeader) -> tuple[int, int, int, int]:
    values = (box.x, box.y, box.width, box.height)
    if box.width < 0 or box.height < 0:
        raise InputError(f"track {track_id}: its box has the size {box.width} x {box.height} px")
    left, top, width, height = (
        _steps(value, header.steps_per_px, track_id, "box") for value in values
    )
    return left, top, width, height


def _steps(value: float, steps: int, track_id: int, what: str) -> int:
    """The nearest number of steps, upwards from the middle, within its bounds."""
    if not math.isfinite(value):
        raise InputError(f"track {track_id}: its {what} holds {value}; a finite number is needed")
    # Bounded first: a product could become infinite.
    bounded = min(max(float(value), -float(MOST_STEPS)), float(MOST_STEPS))
    return min(max(math.floor(bounded * steps + 0.5), -MOST_STEPS), MOST_STEPS)


def _minus(a: tuple[int, int, int, int], b: tuple[int, int, int, int]) -> tuple[int, int, int, int]:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]


def _uncertainty(track: "Track", header: StreamHeader) -> tuple[Spread, Spread, Cross, Spread]:
    """Spread, rate_spread, cross and noise of a track."""
    position = track.position_covariance_px2
    xx, xy, yy = float(position[0, 0]), float(position[0, 1]), float(position[1, 1])
    if not all(map(math.isfinite, (xx, xy, yy))) or xx < 0 or yy < 0:
        raise InputError(
            f"track {track.id}: its position_covariance_px2 is [{xx}, {xy}, {yy}] (xx, xy, yy); "
            "finite numbers with variances of 0 or more are needed"
        )
    velocity = matrix_named(track, "velocity_covariance_px2_per_s2")
    both = matrix_named(track, "position_velocity_covariance_px2_per_s")
    noise = matrix_named(track, "velocity_noise_px2_per_s3")
    spreads = spread_of(position, header), spread_of(velocity, header)
    cross = cross_of(both, (position, velocity), spreads, header)
    return *spreads, cross, spread_of(noise, header)
