# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Results made by hand: what sinks, drawing and the runner see of the core's own."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Any

import numpy as np

from clips import Image


class Status(Enum):
    tentative = 0
    confirmed = 1
    lost = 2


class Kind(Enum):
    track_started = 0
    scene_changed = 1
    track_ended = 2


class Place(Enum):
    none = 0
    border = 1
    open = 3


@dataclass
class Box:
    x: float
    y: float
    width: float
    height: float


@dataclass
class Track:
    id: int
    box: Box
    status: Status = Status.confirmed
    reported: bool = True
    velocity_px_per_s: tuple[float, float] = (0.0, 0.0)
    position_covariance_px2: np.ndarray = field(default_factory=lambda: np.eye(2))
    velocity_covariance_px2_per_s2: np.ndarray = field(default_factory=lambda: np.zeros((2, 2)))
    position_velocity_covariance_px2_per_s: np.ndarray = field(
        default_factory=lambda: np.zeros((2, 2))
    )
    velocity_noise_px2_per_s3: np.ndarray = field(default_factory=lambda: np.zeros((2, 2)))
    age_frames: int = 0
    lost_frames: int = 0
    mean_color: tuple[float, float, float] = (0.0, 0.0, 0.0)
    detection: int = -1
    group: int = 0

    @property
    def position(self) -> tuple[float, float]:
        return self.box.x + self.box.width / 2, self.box.y + self.box.height / 2


@dataclass
class Event:
    kind: Kind
    index: int
    time_s: float
    track_id: int = 0
    other_track_ids: list[int] = field(default_factory=list)
    position: tuple[float, float] = (0.0, 0.0)
    box: Box = field(default_factory=lambda: Box(0, 0, 0, 0))
    text: str = ""
    place: Place = Place.none
    position_covariance_px2: np.ndarray = field(default_factory=lambda: np.eye(2))


@dataclass
class Detection:
    box: Box


@dataclass
class Match:
    track: int
    detection: int
    assigned: bool = True


@dataclass
class Grid:
    cell_px: int
    relative_size: np.ndarray
    active: np.ndarray
    max_factor: float = 5.0


@dataclass
class Result:
    index: int
    time_s: float
    frame: Image
    mask: Image
    tracks: list[Track] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    background: Image | None = None
    detections: list[Detection] = field(default_factory=list)
    matches: list[Match] = field(default_factory=list)
    costs: np.ndarray | None = None
    beliefs: np.ndarray | None = None
    matrix_track_ids: list[int] = field(default_factory=list)
    vicinity: dict[int, Grid] = field(default_factory=dict)
    flow: np.ndarray | None = None
    regions: list[Any] = field(default_factory=list)
    pixels_read: int = 0


def result_of(frame: Image, index: int = 0, *tracks: Track, **more: Any) -> Result:
    """A result of 10 frames/s whose mask is the bright part of the frame."""
    brightest = frame if frame.ndim == 2 else frame.max(axis=2)
    mask = np.where(brightest > 128, 255, 0).astype(np.uint8)
    return Result(index, index / 10, frame, mask, list(tracks), **more)


class Pipeline:
    """Answers each frame `delay_frames` later; fails at `fails_at` when asked to."""

    def __init__(self, delay_frames: int = 0, fails_at: int | None = None) -> None:
        self.delay_frames, self.fails_at = delay_frames, fails_at
        self._waiting: list[Result] = []

    def process(self, frame: Image, time_s: float, index: int) -> Result | None:
        if index == self.fails_at:
            raise ValueError(f"index {index} is refused")
        track = Track(1, Box(index, 2, 4, 5))
        self._waiting.append(Result(index, time_s, frame, frame[..., 0], [track]))
        return self._waiting.pop(0) if len(self._waiting) > self.delay_frames else None

    def finish(self) -> list[Result]:
        rest, self._waiting = self._waiting, []
        return rest
