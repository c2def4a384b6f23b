# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The time of a decoded video frame."""

from av.video.frame import VideoFrame
from av.video.stream import VideoStream

from survtrack.errors import InputError

# These store pictures in coding order without presentation times. FFmpeg then numbers the packets;
# only the decode stamp of the packet that released a picture rises with the pictures.
CODING_ORDER_FORMATS = frozenset({"avi", "mpegvideo", "m4v"})


class ContainerClock:
    """Times as the container stores them, from its first frame, checked to be rising."""

    def __init__(self, stream: VideoStream, format_name: str, name: str, fps: float) -> None:
        self._by_coding_order = format_name in CODING_ORDER_FORMATS
        self._start = None if self._by_coding_order else stream.start_time
        self._name = name
        self._fps = fps
        self._last_s: float | None = None

    def time_s(self, index: int, frame: VideoFrame) -> float:
        """Time of the next frame; raises InputError when there is none or it does not rise."""
        stamp = frame.dts if self._by_coding_order else frame.pts
        if stamp is None or frame.time_base is None:
            time_s = self._after_last(index)
        else:
            if self._start is None:
                self._start = stamp
            time_s = float((stamp - self._start) * frame.time_base)
        if self._last_s is not None and time_s <= self._last_s:
            raise InputError(
                f"{self._name}: frame {index + 1} has the time {time_s:.6g} s, which is not after "
                f"the {self._last_s:.6g} s of the frame before; give the frame rate with --fps"
            )
        self._last_s = time_s
        return time_s

    def _after_last(self, index: int) -> float:
        """A decoder releases its last pictures without a packet: they follow at the frame rate."""
        if self._by_coding_order and self._last_s is not None:
            return self._last_s + 1 / self._fps
        raise InputError(
            f"{self._name}: frame {index + 1} has no time in this file; "
            "give the frame rate with --fps"
        )


class SteadyClock:
    """Frame k has the time k / fps, whatever the container says."""

    def __init__(self, fps: float) -> None:
        self._fps = fps

    def time_s(self, index: int, frame: VideoFrame) -> float:
        """Time of frame `index`."""
        return index / self._fps


def container_fps(stream: VideoStream) -> float | None:
    """Nominal frame rate of the stream; None when the container has none."""
    rate = stream.average_rate or stream.guessed_rate
    return float(rate) if rate else None


def declared_duration_s(stream: VideoStream) -> float | None:
    """Matroska's own length of the stream, seconds ("00:00:08.000000000"); None when untold."""
    hours, _, rest = stream.metadata.get("DURATION", "").partition(":")
    minutes, _, seconds = rest.partition(":")
    try:
        return 3600 * int(hours) + 60 * int(minutes) + float(seconds)
    except ValueError:
        return None
