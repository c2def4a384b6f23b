# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Files of paths, and where tracks are by the paths in them."""

from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Protocol

import numpy as np

from survtrack._core import Path, Paths
from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath, read_bytes

FARTHEST_PX = 1e9  # a lost track's prediction can be anywhere; what is farther is by no path


class Moving(Protocol):
    """What is somewhere and moves: a Track, or one of a track stream."""

    @property
    def position(self) -> tuple[float, float]:
        """(x, y), px."""

    @property
    def velocity_px_per_s(self) -> tuple[float, float]:
        """(x, y)."""


@dataclass(frozen=True)
class TrackPlace:
    """Where a track is by one path.

    path: the path's name.
    s_px, t_px: along it and across it.
    v_s_px_per_s, v_t_px_per_s: how fast these change, by the track's velocity.
    """

    path: str
    s_px: float
    t_px: float
    v_s_px_per_s: float
    v_t_px_per_s: float


def read_paths(path: StrPath) -> Paths:
    """The paths of a file; raises InputError that names file and entry, also when it has none."""
    path = FilePath(path)
    try:
        text = read_bytes(path).decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    paths = Paths.from_json(text, str(path))
    if not len(paths):
        raise InputError(f"{path}.paths: is empty; expected at least one path")
    return paths


def require_frame_size(paths: Paths, size: tuple[int, int] | None, source: StrPath) -> None:
    """Raise InputError when the paths are drawn on frames of another size than (width, height)."""
    if size is not None and paths.frame_size not in (None, size):
        drawn, seen = ("x".join(map(str, each or ())) for each in (paths.frame_size, size))
        raise InputError(f"{source}: is for frames of {drawn}, the run's are {seen}")


def places_of(track: Moving, paths: Paths) -> list[TrackPlace]:
    """Where a track is by each path but those that it is too far from: see max_distance_px."""
    position, velocity = (
        np.array([each], float) for each in (track.position, track.velocity_px_per_s)
    )
    if not (np.abs([position, velocity]) <= FARTHEST_PX).all():
        return []
    places = []
    for name in paths.names:
        path = paths[name]
        (s, t), (v_s, v_t) = path.to_path(position)[0], path.velocities(position, velocity)[0]
        if np.isfinite(s):
            places.append(TrackPlace(name, float(s), float(t), float(v_s), float(v_t)))
    return places


def nearest_place(track: Moving, paths: Paths) -> TrackPlace | None:
    """Where a track is by the path nearest to it; None when it is too far from all."""
    center = np.array(track.position, float)

    def distance_px(place: TrackPlace) -> float:
        return float(np.hypot(*(center - foot_of(place, paths[place.path]))))

    return min(places_of(track, paths), key=distance_px, default=None)


def foot_of(place: TrackPlace, path: Path) -> "np.ndarray[tuple[int], np.dtype[np.float64]]":
    """(x, y) px of the point of the path, its ends included, that is nearest to the place."""
    s = place.s_px if path.closed else min(max(place.s_px, 0.0), path.length_px)
    foot: np.ndarray[tuple[int], np.dtype[np.float64]] = path.to_image([(s, 0.0)])[0]
    return foot
