# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A camera that looks down on the ground at a slant.

The ground has coordinates of the frame's own size: y = 0 is imaged at its top edge, y = H at its
bottom edge, and there unchanged. With f = far_scale the scale at ground y is
s = f / (1 - (1 - f) y / H), and (x, y) is imaged at (W/2 + (x - W/2) s, y s): a homography, as of
any pinhole camera, which keeps lines straight. Objects are seen s times as large.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# Ground that is nearer is not seen: it is imaged far below the frame, or lies behind the camera.
NEAREST_SCALE = 4.0


@dataclass(frozen=True)
class View:
    """How N points of the ground are seen.

    positions: (N, 2) px; velocities_px_per_s: (N, 2); scales: (N,); in_front: (N,) bool, false
        where the rest means nothing, since the point is too near to the camera or behind it.
    """

    positions: NDArray[np.float64]
    velocities_px_per_s: NDArray[np.float64]
    scales: NDArray[np.float64]
    in_front: NDArray[np.bool_]


@dataclass(frozen=True)
class Perspective:
    """The camera of a frame of size (width, height) px; far_scale above 0 and up to 1."""

    size: tuple[int, int]
    far_scale: float = 1.0

    def view(self, points: NDArray[np.float64], velocities: NDArray[np.float64]) -> View:
        """The image of (N, 2) ground points in px and their velocities in px/s."""
        middle, height = self.size[0] / 2, self.size[1]
        x, y = points[:, 0] - middle, points[:, 1]
        nearness = 1 - (1 - self.far_scale) * y / height
        in_front = nearness >= self.far_scale / NEAREST_SCALE
        scale = np.where(in_front, self.far_scale / np.where(in_front, nearness, 1.0), 1.0)
        growth = scale**2 * (1 - self.far_scale) / (self.far_scale * height) * velocities[:, 1]
        return View(
            np.stack([middle + x * scale, y * scale], axis=1),
            np.stack(
                [velocities[:, 0] * scale + x * growth, velocities[:, 1] * scale + y * growth],
                axis=1,
            ),
            scale,
            in_front,
        )
