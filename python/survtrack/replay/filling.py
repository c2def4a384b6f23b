# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pictures at a steady rate from frames as they were recorded: what is missing is predicted."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from survtrack._core import Box
from survtrack.errors import UsageError
from survtrack.replay.values import StreamFrame, StreamTrack

MAX_GAP_S = 2.5  # as long as the default lifecycle keeps a track that is lost
# Of a velocity, in standard deviations of its position a nominal period.
VELOCITY_DEVIATION = 0.5
MOST_FPS = 1000.0
MOST_GAP_S = 3600.0


@dataclass(frozen=True, slots=True)
class Shown:
    """One picture of a replay.

    Attributes:
        frame: what is shown, recorded or predicted.
        following: the next recorded frame; None after the last.
    """

    frame: StreamFrame
    following: StreamFrame | None


def predicted(frame: StreamFrame, time_s: float, period_s: float) -> StreamFrame:
    """The frame as it is expected to be at a later time.

    Positions and boxes move on with their velocities; the covariance P of a position becomes
    (1 + (n / 2)^2) P after n nominal periods. That is what a velocity gives which is known to half
    a standard deviation of the position a period; docs/replay.md says how often it holds.

    Args:
        frame: as it was recorded.
        time_s: when; not before the frame's own time.
        period_s: from frame to frame, above 0.
    """
    passed_s = time_s - frame.time_s
    growth = 1 + (VELOCITY_DEVIATION * passed_s / period_s) ** 2
    tracks = tuple(_moved(track, passed_s, growth) for track in frame.tracks)
    return replace(frame, time_s=time_s, tracks=tracks, predicted_s=passed_s)


def paced(
    frames: Iterable[StreamFrame],
    fps: float,
    *,
    period_s: float,
    max_gap_s: float = MAX_GAP_S,
) -> Iterator[Shown]:
    """What to show, 1 / fps apart, from the first frame to the last.

    A recorded frame is shown when it is the nearest within half of 1 / fps; where none is, the one
    before is predicted. A gap that is longer than max_gap_s is filled so far and then passed over:
    the clock starts anew with the frame after it.

    Args:
        frames: rising in time.
        fps: pictures per second, above 0, at most 1000.
        period_s: as for predicted().
        max_gap_s: 0 to 3600.

    Raises:
        UsageError: fps or max_gap_s is out of its bounds.
    """
    if not 0 < fps <= MOST_FPS:
        raise UsageError(f"fps: {fps} pictures/s is not allowed; above 0, at most {MOST_FPS:g}")
    if not 0 <= max_gap_s <= MOST_GAP_S:
        raise UsageError(f"max_gap: {max_gap_s} s is not allowed; 0 to {MOST_GAP_S:g}")
    return _paced(iter(frames), fps, period_s, max_gap_s)


def _paced(
    rest: Iterator[StreamFrame], fps: float, period_s: float, max_gap_s: float
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
            yield Shown(predicted(current, time_s, period_s), following)
        count += 1


def _is_nearer(following: StreamFrame, current: StreamFrame, time_s: float, half_s: float) -> bool:
    """True when a picture for this time has more to do with the next frame."""
    ahead_s = following.time_s - time_s
    return ahead_s <= 0 or (ahead_s <= half_s and ahead_s < abs(time_s - current.time_s))


def _moved(track: StreamTrack, passed_s: float, growth: float) -> StreamTrack:
    dx, dy = (speed * passed_s for speed in track.velocity_px_per_s)
    box, (x, y) = track.box, track.position
    xx, xy, yy = track.covariance_px2
    return replace(
        track,
        box=Box(box.x + dx, box.y + dy, box.width, box.height),
        position=(x + dx, y + dy),
        covariance_px2=(growth * xx, growth * xy, growth * yy),
        measured=None,
    )
