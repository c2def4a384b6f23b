# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The vicinity factor as a heat map over the scene."""

from typing import TYPE_CHECKING

import numpy as np

from survtrack.drawing.colors import BLACK, WHITE
from survtrack.drawing.scene import Scene, Style
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult, VicinityGrid

OPACITY = 0.5
NO_CLASS = -1


class VicinityRenderer:
    """Cells coloured by relative size (Narayana 2007, 7.2): dark is far, bright is near.

    Each cell names its factor; those that nothing was followed in are left as they are.
    """

    def __init__(self, class_id: int = NO_CLASS) -> None:
        """Args:
        class_id: of which detections the grid is drawn; -1: those without class.
        """
        self._class_id = class_id

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it.

        Raises:
            UsageError: the result has no grid, or none of this class.
        """
        grid = result.vicinity.get(self._class_id)
        if grid is None:
            raise UsageError(
                "vicinity: cannot be shown: vicinity.model is none, outputs.vicinity is false, "
                f"or nothing of class {self._class_id} was seen"
            )
        _shade(scene, grid)
        _name(scene, grid)
        return scene


def _shade(scene: Scene, grid: "VicinityGrid") -> None:
    import cv2

    least, most = np.sqrt(2.0), np.sqrt(2.0) * max(grid.max_factor, 1.0 + 1e-9)
    heat = np.clip(255 * (grid.relative_size - least) / (most - least), 0, 255).astype(np.uint8)
    size = grid.cell_px
    colors = cv2.applyColorMap(heat, cv2.COLORMAP_VIRIDIS)
    height, width = scene.shape[:2]
    full = colors.repeat(size, axis=0).repeat(size, axis=1)[:height, :width]
    active = grid.active.repeat(size, axis=0).repeat(size, axis=1)[:height, :width]
    mixed = cv2.addWeighted(scene, 1 - OPACITY, np.ascontiguousarray(full), OPACITY, 0)
    scene[active] = mixed[active]
    scene[::size] = scene[::size] // 2
    scene[:, ::size] = scene[:, ::size] // 2


def _name(scene: Scene, grid: "VicinityGrid") -> None:
    """The factor of each active cell, where it can be read."""
    import cv2

    style = Style.of(scene)
    scale = 0.9 * style.font_scale
    font = cv2.FONT_HERSHEY_SIMPLEX
    (width, height), _ = cv2.getTextSize("0.0", font, scale, 1)
    if width > grid.cell_px:
        return
    sizes = grid.relative_size
    for row, column in np.argwhere(grid.active).tolist():
        left = column * grid.cell_px + (grid.cell_px - width) // 2
        bottom = row * grid.cell_px + (grid.cell_px + height) // 2
        text = f"{sizes[row, column]:.1f}"
        cv2.putText(scene, text, (left, bottom), font, scale, BLACK, 2, cv2.LINE_AA)
        cv2.putText(scene, text, (left, bottom), font, scale, WHITE, 1, cv2.LINE_AA)
