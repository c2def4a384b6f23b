# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the pictures of optical flow share: the field, and the magnitude that is drawn in full."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import BLACK
from survtrack.drawing.scene import Scene, draw_label
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult

Flow = npt.NDArray[np.float32]
# Semko 2007: what moved less is no foreground.
THRESHOLD_PX = 0.03
# What is longer, or no number, is unknown: so say Middlebury's files.
MOST_PX = 1e9
LEAST_PX = 1e-9
# Of the magnitudes above the threshold. Most flow is far shorter than the longest, so that a scale
# for all of it would leave little to see.
PERCENTILE = 90


class FlowScale:
    """Which magnitude is drawn in full: as told, or 1, 2 or 5 times a power of ten that suits."""

    def __init__(self, full_px: float | None, threshold_px: float) -> None:
        """Args:
        full_px: the magnitude, px, 1e-9 to 1e9; None: at least the 90th percentile of those above
            the threshold. It is kept as long as that lies between a sixth of it and it, so
            that consecutive pictures can be compared.
        threshold_px: what moved by no more does not count, px; 0 or more.

        Raises:
            UsageError: a number out of its range.
        """
        if full_px is not None:
            check_full_px(full_px)
        if not 0 <= threshold_px < math.inf:
            raise UsageError(f"threshold_px: {threshold_px} is not allowed; 0 or more and finite")
        self.threshold_px = threshold_px
        self._told_px = full_px
        self._px = 0.0

    def full_px(self, magnitudes: npt.NDArray[np.floating]) -> float:
        """The magnitude for a picture of these; of any shape, px."""
        if self._told_px is not None:
            return self._told_px
        moving = magnitudes[magnitudes > self.threshold_px]
        if moving.size:
            high = max(float(np.percentile(moving, PERCENTILE)), LEAST_PX)
            if not self._px / 6 < high <= self._px:
                self._px = round_up(high)
        return self._px or 1.0


def check_full_px(full_px: float) -> None:
    """Raise UsageError when it is out of its range."""
    if not LEAST_PX <= full_px <= MOST_PX:
        raise UsageError(f"full_px: {full_px} is not allowed; {LEAST_PX:g} to {MOST_PX:g}")


def round_up(value: float) -> float:
    """The least of 1, 2 and 5 times a power of ten that is not below `value`, which is above 0."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in (1, 2, 5, 10) if step * power >= value * (1 - 1e-6))


def flow_of(scene: Scene, result: "FrameResult") -> Flow | None:
    """The result's field, HxWx2, px, with zeros where it is unknown; None when it has none.

    Raises:
        UsageError: the field is not of the scene's size.
    """
    if result.flow is None:
        return None
    height, width = scene.shape[:2]
    if result.flow.shape != (height, width, 2):
        raise UsageError(
            f"flow: has shape {result.flow.shape}, and the picture is {width}x{height}; "
            f"expected {(height, width, 2)}"
        )
    return known_flow(result.flow)


def known_flow(flow: npt.NDArray[np.floating]) -> Flow:
    """The field as float32, with zeros where a component is unknown."""
    known = (np.abs(flow) <= MOST_PX).all(axis=-1, keepdims=True)
    return np.where(known, flow, 0).astype(np.float32)


def draw_no_flow(scene: Scene) -> Scene:
    """Say on the scene that there is no field; return it."""
    draw_label(scene, "no flow yet", (0, scene.shape[0]), BLACK)
    return scene
