# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One step of a track's filter without a measurement."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt

from survtrack._core import Box
from survtrack.path_file import FARTHEST_PX, nearest_place
from survtrack.replay.damping import damped
from survtrack.replay.values import StreamTrack

if TYPE_CHECKING:
    from survtrack._core import Path, Paths
    from survtrack.path_file import TrackPlace

Matrix = npt.NDArray[np.float64]
MOST_PX = 1e8  # of a position by a path; of one farther away S could be more than Path converts


class Motion(NamedTuple):
    """Where something is and how fast, in the image or along and across a path.

    place, rate: 2 numbers each, px and px/s.
    P, C, V: 2x2 covariances of the place, of place and rate, of the rate.
    q: 2x2, what V gains a second.
    """

    place: Matrix
    rate: Matrix
    P: Matrix
    C: Matrix
    V: Matrix
    q: Matrix

    def turned(self, J: Matrix) -> "Motion":
        """The same with other axes; J: 2x2, of what the place changes by when it changes here."""
        P, C, V, q = (J @ matrix @ J.T for matrix in (self.P, self.C, self.V, self.q))
        return Motion(self.place, J @ self.rate, P, C, V, q)


def moved(
    track: StreamTrack,
    passed_s: float,
    lost_damping_s: float | None,
    paths: "Paths | None" = None,
) -> StreamTrack:
    """The track after a time of 0 or more s: x = F x, P = F P F' + Q of constant velocity.

    The velocity of a lost track is damped as its filter does it; near a path both are along and
    across it. Bar-Shalom, Li and Kirubarajan 2001, 6.2.2; O'Malley 2000, 3.
    """
    damping_s = lost_damping_s if track.status.name == "lost" else None
    now = Motion(
        np.array(track.position, float),
        np.array(track.velocity_px_per_s, float),
        track.position_covariance_px2,
        track.position_velocity_covariance_px2_per_s,
        track.velocity_covariance_px2_per_s2,
        track.velocity_noise_px2_per_s3,
    )
    place = None
    if paths is not None and max(map(abs, track.position)) <= MOST_PX:
        place = nearest_place(track, paths)
    if paths is None or place is None:
        later = _stepped(now, passed_s, damping_s)
    else:
        later = _along(now, paths[place.path], place, passed_s, damping_s)
    return _as_track(track, later)


def _stepped(now: Motion, passed_s: float, damping_s: float | None) -> Motion:
    kept, way_s = damped(passed_s, damping_s)
    return Motion(
        now.place + way_s * now.rate,
        kept * now.rate,
        now.P + way_s * (now.C + now.C.T) + way_s**2 * now.V + passed_s**3 / 3 * now.q,
        kept * (now.C + way_s * now.V) + passed_s**2 / 2 * now.q,
        kept**2 * now.V + passed_s * now.q,
        now.q,
    )


def _along(
    now: Motion, path: "Path", place: "TrackPlace", passed_s: float, damping_s: float | None
) -> Motion:
    """The step by (S, T) of a path, from the directions at the old place to those at the new."""
    here = np.array([place.s_px, place.t_px])
    rate = np.array([place.v_s_px_per_s, place.v_t_px_per_s])
    by_path = now.turned(np.asarray(np.linalg.inv(_directions(path, here)), np.float64))
    later = _stepped(by_path._replace(place=here, rate=rate), passed_s, damping_s)
    there = np.clip(later.place, -FARTHEST_PX, FARTHEST_PX)
    return later.turned(_directions(path, there))._replace(place=path.to_image([there])[0])


def _directions(path: "Path", place: Matrix) -> Matrix:
    """2x2: by how many px in the image, the rows, one px of S and of T moves: the columns."""
    s = place[:1]
    along, across = path.tangents(s)[0], path.normals(s)[0]
    return np.column_stack([path.stretches([place])[0] * along, across])


def _as_track(track: StreamTrack, later: Motion) -> StreamTrack:
    (x, y), (vx, vy) = later.place.tolist(), later.rate.tolist()
    box = track.box
    # From the position on: what did not move keeps its box to the bit.
    left, top = box.x + (x - track.position[0]), box.y + (y - track.position[1])
    (xx, xy), (yx, yy) = later.C.tolist()
    return replace(
        track,
        box=Box(left, top, box.width, box.height),
        position=(x, y),
        velocity_px_per_s=(vx, vy),
        covariance_px2=_within(later.P),
        measured=None,
        rate_covariance=_within(later.V),
        cross_covariance=(xx, xy, yx, yy),
        rate_noise=_within(later.q),
    )


def _within(matrix: Matrix) -> tuple[float, float, float]:
    """(xx, xy, yy) without an eigenvalue below 0, as numbers that were rounded can give."""
    xx, yy = max(float(matrix[0, 0]), 0.0), max(float(matrix[1, 1]), 0.0)
    most = math.sqrt(xx) * math.sqrt(yy)
    return xx, min(max(float(matrix[0, 1]), -most), most), yy
