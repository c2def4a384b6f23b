# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Frames as records: what can be foreseen from the frame before costs one byte or none."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from survtrack.errors import InputError
from survtrack.replay.covariances import Cross, Spread
from survtrack.replay.places import NO_PLACES, Places, read_places, write_places
from survtrack.replay.states import MOST_STEPS, NEW, State, is_allowed
from survtrack.replay.values import StreamHeader
from survtrack.replay.varint import Damaged, Numbers, put, put_signed

# Of the byte of flags; its lowest two bits are the status.
STATUS_BITS = 0b11
MEASURED, SHAPE, VELOCITY, SPREAD, MOTION = 4, 8, 16, 32, 64
ALL_FLAGS = STATUS_BITS | MEASURED | SHAPE | VELOCITY | SPREAD | MOTION
MOTION_NUMBERS = 10
LEAST_TRACK_BYTES = 4
MOST_INDEX = 2**53  # of indices, ids and ticks
# What claims more is damaged, so that a reader never keeps more than this.
MOST_RECORD_BYTES = 2**24


@dataclass(frozen=True)
class Moment:
    """One frame in steps: its index, its time in ticks, the states of its tracks by id, regions."""

    index: int
    ticks: int
    states: dict[int, State] = field(default_factory=dict)
    places: Places = NO_PLACES


class Foresight:
    """What writer and reader both expect of the next frame, by the last one."""

    def __init__(self, header: StreamHeader) -> None:
        self._header = header
        self._last: Moment | None = None
        self._step_ticks = header.period_ticks

    @property
    def index(self) -> int:
        """Of the next frame."""
        return 0 if self._last is None else self._last.index + 1

    @property
    def ticks(self) -> int:
        """Time of the next frame: as far from the last as that was from the one before."""
        return 0 if self._last is None else self._last.ticks + self._step_ticks

    @property
    def places(self) -> Places:
        """The last frame's regions."""
        return NO_PLACES if self._last is None else self._last.places

    def state(self, track_id: int, ticks: int) -> State:
        """The track's last state, moved on with its velocity; NEW for one that is new."""
        state = NEW if self._last is None else self._last.states.get(track_id, NEW)
        if self._last is None or state is NEW:
            return NEW
        gone = ticks - self._last.ticks
        (x, y), (vx, vy) = state.place, state.velocity
        return state._replace(place=(self._moved(x, vx, gone), self._moved(y, vy, gone)))

    def advance(self, moment: Moment) -> None:
        """Take a frame as the last one."""
        if self._last is not None:
            self._step_ticks = moment.ticks - self._last.ticks
        self._last = moment

    def follows(self, moment: Moment) -> bool:
        """True when index and time rise and are within their bounds."""
        rises = self._last is None or moment.ticks > self._last.ticks
        return (
            rises and self.index <= moment.index <= MOST_INDEX and abs(moment.ticks) <= MOST_INDEX
        )

    def _moved(self, place: int, velocity: int, ticks: int) -> int:
        """Steps of place after `ticks`, rounded half up; in whole numbers, so alike everywhere."""
        header = self._header
        per = header.steps_per_px_per_s * header.ticks_per_s
        moved = place + (2 * velocity * ticks * header.steps_per_px + per) // (2 * per)
        return min(max(moved, -MOST_STEPS), MOST_STEPS)


def write_record(moment: Moment, foresight: Foresight) -> bytes:
    """The record of a frame; raises InputError when it does not follow the last one."""
    if not foresight.follows(moment):
        raise InputError(
            f"frame {moment.index + 1}: index and time must rise from frame to frame, the time by "
            "a tick of the stream at least"
        )
    data = bytearray()
    put(data, moment.index - foresight.index)
    put_signed(data, moment.ticks - foresight.ticks)
    put(data, len(moment.states))
    last_id = 0
    for track_id, state in sorted(moment.states.items()):
        if not last_id < track_id <= MOST_INDEX:
            raise InputError(f"track {track_id}: ids from 1 to 2^53 are allowed")
        put(data, track_id - last_id - 1)
        last_id = track_id
        _write_state(data, state, foresight.state(track_id, moment.ticks))
    write_places(data, moment.places, foresight.places)
    if len(data) > MOST_RECORD_BYTES:
        raise InputError(
            f"frame {moment.index + 1}: {len(moment.states)} tracks and {len(moment.places.items)} "
            "regions are too many"
        )
    foresight.advance(moment)
    return bytes(data)


def read_record(data: bytes, foresight: Foresight, header: StreamHeader) -> Moment:
    """The frame of a record; raises Damaged when no encoder wrote it."""
    numbers = Numbers(data)
    index = foresight.index + numbers.number()
    ticks = foresight.ticks + numbers.signed()
    count = numbers.number()
    if count * LEAST_TRACK_BYTES > numbers.left:
        raise Damaged(f"{count} tracks cannot be in {numbers.left} bytes")
    states: dict[int, State] = {}
    track_id = 0
    for _ in range(count):
        track_id += numbers.number() + 1
        state = _read_state(numbers, foresight.state(track_id, ticks))
        if not is_allowed(state, header) or track_id > MOST_INDEX:
            raise Damaged(f"track {track_id} is out of bounds")
        states[track_id] = state
    places = read_places(numbers, foresight.places, header)
    numbers.all_read()
    moment = Moment(index, ticks, states, places)
    if not foresight.follows(moment):
        raise Damaged("its index or time does not follow that of the frame before")
    foresight.advance(moment)
    return moment


def _write_state(data: bytearray, state: State, expected: State) -> None:
    parts = [(SHAPE, _changes(state.shape, expected.shape))]
    parts.append((VELOCITY, _changes(state.velocity, expected.velocity)))
    parts.append((SPREAD, _changes(state.spread, expected.spread)))
    motion = _changes(_in_motion_order(state), _in_motion_order(expected))
    flags = state.status | (0 if state.measured is None else MEASURED)
    flags |= sum(flag for flag, changes in parts if any(changes)) | (MOTION if any(motion) else 0)
    data.append(flags)
    for change in _changes(state.place, expected.place):
        put_signed(data, change)
    for flag, changes in parts:
        for change in changes if flags & flag else ():
            put_signed(data, change)
    if flags & MOTION:
        put(data, sum(1 << k for k, change in enumerate(motion) if change))
        for change in filter(None, motion):
            put_signed(data, change)
    for difference in state.measured or ():
        put_signed(data, difference)


def _read_state(numbers: Numbers, expected: State) -> State:
    flags = numbers.byte()
    if flags & ~ALL_FLAGS:
        raise Damaged(f"the flags {flags:#04x} are none of version 2")
    x, y = _plus(expected.place, numbers, True)
    width, height, dx, dy = _plus(expected.shape, numbers, bool(flags & SHAPE))
    vx, vy = _plus(expected.velocity, numbers, bool(flags & VELOCITY))
    sx, sy, correlation = _plus(expected.spread, numbers, bool(flags & SPREAD))
    rate_spread, cross, noise = _read_motion(numbers, expected, bool(flags & MOTION))
    measured = None
    if flags & MEASURED:
        left, top, wide, high = (numbers.signed() for _ in range(4))
        measured = (left, top, wide, high)
    return State(
        (x, y),
        (width, height, dx, dy),
        (vx, vy),
        (sx, sy, correlation),
        rate_spread,
        cross,
        noise,
        flags & STATUS_BITS,
        measured,
    )


def _read_motion(numbers: Numbers, expected: State, written: bool) -> tuple[Spread, Cross, Spread]:
    """rate_spread, cross and noise."""
    mask = numbers.number() if written else 0
    if mask >> MOTION_NUMBERS:
        raise Damaged(f"the mask {mask:#x} is none of version 2")
    values = [
        value + (numbers.signed() if mask >> k & 1 else 0)
        for k, value in enumerate(_in_motion_order(expected))
    ]
    vx, vy, xx, yy, nx, ny, turned, xy, yx, noise_turned = values
    return (vx, vy, turned), (xx, xy, yx, yy), (nx, ny, noise_turned)


def _in_motion_order(state: State) -> tuple[int, ...]:
    """What is written number by number; those first that change with axes on their own."""
    (vx, vy, turned), (xx, xy, yx, yy), (nx, ny, noise_turned) = (
        state.rate_spread,
        state.cross,
        state.noise,
    )
    return vx, vy, xx, yy, nx, ny, turned, xy, yx, noise_turned


def _changes(values: Sequence[int], expected: Sequence[int]) -> list[int]:
    return [a - b for a, b in zip(values, expected, strict=True)]


def _plus(expected: Sequence[int], numbers: Numbers, written: bool) -> list[int]:
    return [value + (numbers.signed() if written else 0) for value in expected]
