# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a track stream holds."""

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from survtrack._core import Box, Region, TrackStatus
from survtrack.replay.damping import MOST_DAMPING_S


@dataclass(frozen=True)
class StreamHeader:
    """What a stream says of itself before its first frame.

    Attributes:
        width_px, height_px: size of the frames; 1 or more.
        rate_mhz: nominal frames in 1000 s; 1 or more. A frame that is later than that is missing.
        ticks_per_s: the unit of times.
        steps_per_px: the unit of places and sizes.
        steps_per_px_per_s: the unit of velocities.
        steps_per_octave: a standard deviation of n steps is 2^(n / steps_per_octave) px, or px/s of
            a velocity, or px/s^1.5 of its noise.
        steps_of_correlation: a correlation of n steps is n / steps_of_correlation.
        lost_damping_ticks: the velocity of a lost track falls to 1/e in this time; 0: it does not.
    """

    width_px: int
    height_px: int
    rate_mhz: int
    ticks_per_s: int = 1_000_000
    steps_per_px: int = 16
    steps_per_px_per_s: int = 4
    steps_per_octave: int = 8
    steps_of_correlation: int = 32
    lost_damping_ticks: int = 0

    @property
    def fps(self) -> float:
        """Nominal frames per second."""
        return self.rate_mhz / 1000

    @property
    def lost_damping_s(self) -> float | None:
        """In which the velocity of a lost track falls to 1/e; None: never, or in over 1e9 s."""
        damping_s = self.lost_damping_ticks / self.ticks_per_s
        return damping_s if 0 < damping_s <= MOST_DAMPING_S else None

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
        rate_covariance: of the velocity, px^2/s^2: (xx, xy, yy).
        cross_covariance: of position and velocity, px^2/s: (xx, xy, yx, yy), the position first.
        rate_noise: what the velocity's covariance gains a second, px^2/s^3: (xx, xy, yy).
    """

    id: int
    status: TrackStatus
    box: Box
    position: tuple[float, float]
    velocity_px_per_s: tuple[float, float]
    covariance_px2: tuple[float, float, float]
    measured: Box | None = None
    rate_covariance: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cross_covariance: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    rate_noise: tuple[float, float, float] = (0.0, 0.0, 0.0)

    @property
    def reported(self) -> bool:
        """True: a stream holds nothing else."""
        return True

    @property
    def position_covariance_px2(self) -> npt.NDArray[np.float64]:
        """2x2, symmetric, no eigenvalue below 0."""
        return _symmetric(self.covariance_px2)

    @property
    def velocity_covariance_px2_per_s2(self) -> npt.NDArray[np.float64]:
        """2x2, symmetric, no eigenvalue below 0; zero of filters that do not know theirs."""
        return _symmetric(self.rate_covariance)

    @property
    def position_velocity_covariance_px2_per_s(self) -> npt.NDArray[np.float64]:
        """2x2, rows of the position, columns of the velocity."""
        return np.array(self.cross_covariance).reshape(2, 2)

    @property
    def velocity_noise_px2_per_s3(self) -> npt.NDArray[np.float64]:
        """2x2, symmetric, no eigenvalue below 0."""
        return _symmetric(self.rate_noise)

    @property
    def foot(self) -> tuple[float, float]:
        """(x, y) in px of the middle of the box's lower edge: where it stands on the ground."""
        return self.box.x + self.box.width / 2, self.box.y + self.box.height


@dataclass(frozen=True, slots=True)
class StreamFrame:
    """The reported tracks of one frame, and where they were looked for.

    Attributes:
        index: the frame's index in its source, from 0.
        time_s: of the frame; of a predicted one the time that it was predicted for.
        tracks: by id.
        predicted_s: how far from the recorded frame this one was predicted; 0: it was recorded.
        regions: what the detector read, in whole pixels, as the result had it; none where it had
            nothing but the whole frame, and in predicted frames.
    """

    index: int
    time_s: float
    tracks: tuple[StreamTrack, ...] = ()
    predicted_s: float = 0.0
    regions: tuple[Region, ...] = ()

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


def _symmetric(numbers: tuple[float, float, float]) -> npt.NDArray[np.float64]:
    xx, xy, yy = numbers
    return np.array([[xx, xy], [xy, yy]])
