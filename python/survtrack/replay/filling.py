# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pictures at a steady rate from frames as they were recorded: what is missing is predicted."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from survtrack.errors import UsageError
from survtrack.replay.damping import check_damping
from survtrack.replay.motion import moved
from survtrack.replay.values import StreamFrame

if TYPE_CHECKING:
    from survtrack._core import Paths

MAX_GAP_S = 2.5  # as long as the default lifecycle keeps a track that is lost
MOST_FPS = 1000.0
MOST_GAP_S = 3600.0
MOST_PREDICTED_S = 1e9  # whatever a stream holds, the numbers stay finite so long


@dataclass(frozen=True, slots=True)
class Shown:
    """One picture of a replay.

    Attributes:
        frame: what is shown, recorded or predicted.
        following: the next recorded frame; None after the last.
    """

    frame: StreamFrame
    following: StreamFrame | None


def predicted(
    frame: StreamFrame,
    time_s: float,
    lost_damping_s: float | None = None,
    paths: "Paths | None" = None,
) -> StreamFrame:
    """The frame as it is expected to be at a later time, by one step of its tracks' filters.

    Positions and boxes move on with their velocities, and the covariance of a position becomes
    P + t (C + C') + t^2 V + t^3 / 3 q, with those of position (P), of position and velocity (C), of
    velocity (V) and its noise (q): docs/replay.md. What is near a path does so along and across it.

    Args:
        frame: as it was recorded.
        time_s: when; from the frame's own time to 1e9 s after it.
        lost_damping_s: the velocity of a lost track falls to 1/e in it, 0 to 1e9; None: it does
            not. The stream's header has it.
        paths: on frames of the stream's size; a track within max_distance_px of one goes along the
            nearest of them. None: all go straight on.

    Raises:
        UsageError: time_s or lost_damping_s is out of its bounds.
    """
    check_damping(lost_damping_s)
    passed_s = time_s - frame.time_s
    if not 0 <= passed_s <= MOST_PREDICTED_S:
        raise UsageError(
            f"time_s: {time_s} is not allowed; the frame's own, {frame.time_s}, to 1e9 s later"
        )
    tracks = tuple(moved(track, passed_s, lost_damping_s, paths) for track in frame.tracks)
    return replace(frame, time_s=time_s, tracks=tracks, predicted_s=passed_s, regions=())


def paced(
    frames: Iterable[StreamFrame],
    fps: float,
    *,
    lost_damping_s: float | None = None,
    max_gap_s: float = MAX_GAP_S,
    paths: "Paths | None" = None,
) -> Iterator[Shown]:
    """What to show, 1 / fps apart, from the first frame to the last.

    A recorded frame is shown when it is the nearest within half of 1 / fps; where none is, the one
    before is predicted. A gap that is longer than max_gap_s is filled so far and then passed over:
    the clock starts anew with the frame after it.

    Args:
        frames: rising in time.
        fps: pictures per second, above 0, at most 1000.
        lost_damping_s: as for predicted().
        max_gap_s: 0 to 3600.
        paths: as for predicted().

    Raises:
        UsageError: fps, lost_damping_s or max_gap_s is out of its bounds.
    """
    check_damping(lost_damping_s)
    if not 0 < fps <= MOST_FPS:
        raise UsageError(f"fps: {fps} pictures/s is not allowed; above 0, at most {MOST_FPS:g}")
    if not 0 <= max_gap_s <= MOST_GAP_S:
        raise UsageError(f"max_gap: {max_gap_s} s is not allowed; 0 to {MOST_GAP_S:g}")
    return _paced(iter(frames), fps, max_gap_s, lost_damping_s, paths)


def _paced(
    rest: Iterator[StreamFrame],
    fps: float,
    max_gap_s: float,
    lost_damping_s: float | None,
    paths: "Paths | None",
) -> Iterator[Shown]:
    current, following = next(rest, None), next(rest, None)
    if current is None:
        return
    half_s = 0.5 / fps
    began_s, count = current.time_s, 0
    while True:
        time_s = began_s + count / fps
        while following is not None and _is_nearer(following, current, time_s, half_s):
            current, following = following, next(rest, None)
        passed_s = time_s - current.time_s
        if passed_s <= half_s:
            yield Shown(current, following)
        elif following is None:
            return
        elif passed_s > max_gap_s:
            began_s, count = following.time_s, 0
            continue
        else:
            yield Shown(predicted(current, time_s, lost_damping_s, paths), following)
        count += 1


def _is_nearer(following: StreamFrame, current: StreamFrame, time_s: float, half_s: float) -> bool:
    """True when a picture for this time has more to do with the next frame."""
    ahead_s = following.time_s - time_s
    return ahead_s <= 0 or (ahead_s <= half_s and ahead_s < abs(time_s - current.time_s))
