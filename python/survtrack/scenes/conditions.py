# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a scene is filmed under, whatever moves in it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import UsageError
from survtrack.scenes.checks import check_number

OccluderBox = tuple[float, float, float, float]


@dataclass(frozen=True)
class Conditions:
    """Noise, light, occluders and perspective. Masks show the last two only.

    noise_sigma: standard deviation of the sensor's noise, grey levels, 0 to 255; Gaussian, new in
        each pixel, channel and frame.
    light_gain: what all grey levels are multiplied by in the end, 0 to 10; 1 is no change.
    light_at_s: when the change of light begins, seconds.
    light_over_s: how long it takes, seconds; 0 is a switch.
    occluders: (left, top, width, height) each, px; they stand still in front of everything.
    far_scale: size of an object at the top of the frame in parts of that at the bottom, above 0
        and up to 1; 1 is no perspective. See Perspective.
    """

    noise_sigma: float = 0.0
    light_gain: float = 1.0
    light_at_s: float = 4.0
    light_over_s: float = 0.0
    occluders: tuple[OccluderBox, ...] = ()
    far_scale: float = 1.0

    def __post_init__(self) -> None:
        """Raises UsageError."""
        check_number("noise_sigma", self.noise_sigma, least=0, most=255)
        check_number("light_gain", self.light_gain, least=0, most=10)
        check_number("light_at_s", self.light_at_s)
        check_number("light_over_s", self.light_over_s, least=0)
        check_number("far_scale", self.far_scale, above=0, most=1)
        object.__setattr__(self, "occluders", tuple(_occluder(box) for box in self.occluders))

    def gains(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """(N,) what grey levels are multiplied by at (N,) seconds."""
        since = times_s - self.light_at_s
        if self.light_over_s > 0:
            share = np.clip(since / self.light_over_s, 0.0, 1.0)
        else:
            share = (since >= 0).astype(np.float64)
        return np.asarray(1 + share * (self.light_gain - 1))


def _occluder(box: OccluderBox) -> OccluderBox:
    """The box as four floats; UsageError when it is none."""
    if not isinstance(box, (tuple, list)) or len(box) != 4:
        raise UsageError(f"occluders: {box} is not allowed; left, top, width, height in px")
    for name, value in zip(("left", "top", "width", "height"), box, strict=True):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise UsageError(f"occluders: {name}: {value!r} is not a number")
        check_number(f"occluders: {name}", value, above=0 if name in ("width", "height") else None)
    left, top, width, height = box
    return float(left), float(top), float(width), float(height)
