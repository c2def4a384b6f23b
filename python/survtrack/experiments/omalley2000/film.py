# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Drives as pictures: a car on a noisy ground."""

from collections.abc import Iterator
from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.omalley2000 import race

Floats = NDArray[np.float64]
Image = NDArray[np.uint8]

EMPTY = 25  # frames before the car comes
NOISE_SIGMA = 2.0  # grey levels of the camera
CAR_BGR = (30, 30, 220)
GRAINS = 8  # pictures of noise, in turn
SEED = 3


def pictures(cars: Floats) -> Iterator[Image]:
    """The empty scene, then the car where it is; the same every time.

    Args:
        cars: (N, 4, 2) corners.
    """
    empty = _empty()
    for index in range(-EMPTY, len(cars)):
        picture = empty[index % GRAINS].copy()
        if index >= 0:
            sixteenths = np.round(16 * cars[index]).astype(np.int32)
            cv2.fillConvexPoly(picture, sixteenths, CAR_BGR, cv2.LINE_AA, shift=4)
        yield picture


@cache
def _empty() -> list[Image]:
    rng = np.random.default_rng(SEED)
    width, height = race.SIZE
    ground = cv2.GaussianBlur(rng.uniform(60, 140, (height, width, 3)), (0, 0), 2)
    grains = rng.normal(0, NOISE_SIGMA, (GRAINS, height, width, 3))
    return [np.clip(ground + grain, 0, 255).astype(np.uint8) for grain in grains]
