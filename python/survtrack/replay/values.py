# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a track stream holds."""

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from survtrack._core import Box, TrackStatus


@dataclass(frozen=True)
class StreamHeader:
    """What a stream says of itself before its first frame.

    Attributes:
        width_px, height_px: size of the frames; 1 or more.
        rate_mhz: nominal frames in 1000 s; 1 or more. A frame that is later than that is missing.
        ticks_per_s: the unit of times.
        steps_per_px: the unit of places and sizes.
        steps_per_px_per_s: the unit of velocities.
        steps_per_octave: a standard deviation of n steps is 2^(n / steps_per_octave) px.
        steps_of_correlation: a correlation of n steps is n / steps_of_correlation.
    """

    width_px: int
    height_px: int
    rate_mhz: int
    ticks_per_s: int = 1_000_000
    steps_per_px: int = 16
    steps_per_px_per_s: int = 4
    steps_per_octave: int = 8
    steps_of_correlation: int = 32

    @property
    def fps(self) -> float:
        """Nominal frames per second."""
        return self.rate_mhz / 1000

    @property
    def period_ticks(self) -> int:
        """Nominal time from frame to frame, rounded half up."""
        return (2000 * self.ticks_per_s + self.rate_mhz) // (2 * self.rate_mhz)


@dataclass(frozen=True, slots=True)
class StreamTrack:
    """One track in one frame. Renderers take it as they take the core's Track.

    Attributes:
        id: from 1.
        status: as the tracker said; `lost` without a detection in this frame.
        box: estimated box, px.
        position: (x, y), estimated position, px.
        velocity_px_per_s: (x, y).
        covariance_px2: of the position: (xx, xy, yy).
        measured: box of the detection that this frame's estimate was made with, px; None: none, or
            it is one that several tracks share.
    """

    id: int
    status: TrackStatus
    box: Box
    position: tuple[float, float]
    velocity_px_per_s: tuple[float, float]
    covariance_px2: tuple[float, float, float]
    measured: Box | None = None

    @property
    def reported(self) -> bool:
        """True: a stream holds nothing else."""
        return True

    @property
    def position_covariance_px2(self) -> npt.NDArray[np.float64]:
        """2x2, symmetric, no eigenvalue below 0."""
        xx, xy, yy = self.covariance_px2
        return np.array([[xx, xy], [xy, yy]])

    @property
    def foot(self) -> tuple[float, float]:
        """(x, y) in px of the middle of the box's lower edge: where it stands on the ground."""
        return self.box.x + self.box.width / 2, self.box.y + self.box.height


@dataclass(frozen=True, slots=True)
class StreamFrame:
    """The reported tracks of one frame.

    Attributes:
        index: the frame's index in its source, from 0.
        time_s: of the frame; of a predicted one the time that it was predicted for.
        tracks: by id.
        predicted_s: how far from the recorded frame this one was predicted; 0: it was recorded.
    """

    index: int
    time_s: float
    tracks: tuple[StreamTrack, ...] = ()
    predicted_s: float = 0.0

    def by_id(self) -> dict[int, StreamTrack]:
        """The tracks by their id."""
        return {track.id: track for track in self.tracks}


@dataclass(frozen=True)
class RecordedStream:
    """A stream that was read as far as it goes.

    Attributes:
        header: what it says of itself.
        frames: all whole ones.
        problem: why there may have been more, in words; None when the stream came to its end.
        byte_count: bytes of the header and of the whole frames, the end mark included.
    """

    header: StreamHeader
    frames: list[StreamFrame] = field(default_factory=list)
    problem: str | None = None
    byte_count: int = 0
