# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One step of a track's filter without a measurement."""

import math
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from survtrack._core import Box
from survtrack.replay.damping import damped
from survtrack.replay.values import StreamTrack

Matrix = npt.NDArray[np.float64]


def moved(track: StreamTrack, passed_s: float, lost_damping_s: float | None) -> StreamTrack:
    """The track after a time of 0 or more s: x = F x, P = F P F' + Q of constant velocity.

    The velocity of a lost track is damped as its filter does it. Bar-Shalom, Li and Kirubarajan
    2001, 6.2.2.
    """
    kept, way_s = damped(passed_s, lost_damping_s if track.status.name == "lost" else None)
    P, V = track.position_covariance_px2, track.velocity_covariance_px2_per_s2
    C, q = track.position_velocity_covariance_px2_per_s, track.velocity_noise_px2_per_s3
    later_P = P + way_s * (C + C.T) + way_s**2 * V + passed_s**3 / 3 * q
    later_C = kept * (C + way_s * V) + passed_s**2 / 2 * q
    later_V = kept**2 * V + passed_s * q
    (x, y), (vx, vy), box = track.position, track.velocity_px_per_s, track.box
    (xx, xy), (yx, yy) = later_C.tolist()
    return replace(
        track,
        box=Box(box.x + way_s * vx, box.y + way_s * vy, box.width, box.height),
        position=(x + way_s * vx, y + way_s * vy),
        velocity_px_per_s=(kept * vx, kept * vy),
        covariance_px2=_within(later_P),
        measured=None,
        rate_covariance=_within(later_V),
        cross_covariance=(xx, xy, yx, yy),
    )


def _within(matrix: Matrix) -> tuple[float, float, float]:
    """(xx, xy, yy) without an eigenvalue below 0, as numbers that were rounded can give."""
    xx, yy = max(float(matrix[0, 0]), 0.0), max(float(matrix[1, 1]), 0.0)
    most = math.sqrt(xx) * math.sqrt(yy)
    return xx, min(max(float(matrix[0, 1]), -most), most), yy
