# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the segmentation's text. Each function answers (the print's figure, ours)."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.nashenda2011 import listing, published
from survtrack.experiments.nashenda2011.config import preset_config
from survtrack.experiments.nashenda2011.listing import Image, Mask

GROUND, SIDE_PX, BACKGROUND_FRAMES = 120, 24, 5
CORNER = (40, 60)  # row and column of the object


def darker_in_the_first_channel() -> tuple[float, float]:
    """Pixels found of an object that is darker by 60 in the first channel (red) alone."""
    return _found(np.array([-60, 0, 0]), listing.first_channel_one_sided)


def at_the_threshold() -> tuple[float, float]:
    """Pixels found where all channels differ by exactly T."""
    return _found(np.full(3, published.THRESHOLD), listing.at_least)


def _found(change: NDArray[np.int64], test: Callable[[Image, Image], Mask]) -> tuple[float, float]:
    """Both after two erosions; change: of red, green, blue within the object."""
    width, height = published.SIZE
    background = np.full((height, width, 3), GROUND, np.uint8)
    frame = background.astype(np.int64)
    row, column = CORNER
    frame[row : row + SIDE_PX, column : column + SIDE_PX] += change
    seen = frame.astype(np.uint8)
    pipeline = survtrack.Pipeline(preset_config())
    for index in range(BACKGROUND_FRAMES):
        pipeline.process(background, index * published.PERIOD_S)
    result = pipeline.process(
        np.ascontiguousarray(seen[..., ::-1]), BACKGROUND_FRAMES * published.PERIOD_S
    )
    port = listing.eroded_twice(test(seen, background))
    return float(port.sum()), float((result.mask > 0).sum())
