# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From tracks to whole numbers of steps and back."""

import math
from typing import TYPE_CHECKING, NamedTuple

from survtrack._core import Box, TrackStatus
from survtrack.errors import InputError
from survtrack.replay.values import StreamHeader, StreamTrack

if TYPE_CHECKING:
    from survtrack._core import Detection, Track

# Bounds of what is written, in steps: at 1/16 px some 7e10 px, far outside of every picture.
MOST_STEPS = 2**40
# Standard deviations, in octaves from 1 px: the least stands for none at all.
LEAST_OCTAVE, MOST_OCTAVE = -16, 40

Pair = tuple[int, int]


class State(NamedTuple):
    """A track in steps of its stream.

    place: position (x, y).
    shape: width, height, and how far the box's upper left corner is from where it would be were
        the position its centre: left - (x - floor(width / 2)), top - (y - floor(height / 2)).
    velocity: (x, y).
    spread: standard deviations (x, y) and the correlation.
    status: of TrackStatus.
    measured: left, top, width and height of the detection less those of the box; None: none.
    """

    place: Pair
    shape: tuple[int, int, int, int]
    velocity: Pair
    spread: tuple[int, int, int]
    status: int
    measured: tuple[int, int, int, int] | None


NEW = State((0, 0), (0, 0, 0, 0), (0, 0), (0, 0, 0), 0, None)


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
    return State((x, y), shape, (vx, vy), _spread(track, header), status, measured)


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
        _covariance(state.spread, header),
        measured,
    )


def is_allowed(state: State, header: StreamHeader) -> bool:
    """True for a state that quantized() could have made."""
    (x, y), (width, height, dx, dy) = state.place, state.shape
    lengths = (x, y, x - width // 2 + dx, y - height // 2 + dy, *state.velocity)
    least, most = (header.steps_per_octave * octave for octave in (LEAST_OCTAVE, MOST_OCTAVE))
    *deviations, correlation = state.spread
    allowed = (
        all(abs(length) <= MOST_STEPS for length in lengths)
        and all(0 <= side <= MOST_STEPS for side in (width, height))
        and all(least <= deviation <= most for deviation in deviations)
        and abs(correlation) <= header.steps_of_correlation
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


def _spread(track: "Track", header: StreamHeader) -> tuple[int, int, int]:
    matrix = track.position_covariance_px2
    xx, xy, yy = float(matrix[0, 0]), float(matrix[0, 1]), float(matrix[1, 1])
    if not all(map(math.isfinite, (xx, xy, yy))) or xx < 0 or yy < 0:
        raise InputError(
            f"track {track.id}: its position_covariance_px2 is [{xx}, {xy}, {yy}] (xx, xy, yy); "
            "finite numbers with variances of 0 or more are needed"
        )
    sx, sy = (_deviation(value, header.steps_per_octave) for value in (xx, yy))
    none = LEAST_OCTAVE * header.steps_per_octave
    if none in (sx, sy):
        return sx, sy, 0
    correlation = xy / math.sqrt(xx) / math.sqrt(yy)
    steps = header.steps_of_correlation
    return sx, sy, math.floor(min(max(correlation, -1.0), 1.0) * steps + 0.5)


def _deviation(variance_px2: float, steps_per_octave: int) -> int:
    """Steps of the standard deviation whose square this is."""
    least, most = LEAST_OCTAVE * steps_per_octave, MOST_OCTAVE * steps_per_octave
    if variance_px2 <= 0:
        return least
    steps = math.floor(0.5 * steps_per_octave * math.log2(variance_px2) + 0.5)
    return min(max(steps, least), most)


def _covariance(spread: tuple[int, int, int], header: StreamHeader) -> tuple[float, float, float]:
    none = LEAST_OCTAVE * header.steps_per_octave
    sx, sy = (
        0.0 if deviation <= none else 2.0 ** (deviation / header.steps_per_octave)
        for deviation in spread[:2]
    )
    return sx * sx, spread[2] / header.steps_of_correlation * sx * sy, sy * sy
