# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The grey levels that optical flow is computed on."""

from typing import TYPE_CHECKING

from survtrack.drawing.scene import Scene

if TYPE_CHECKING:
    from survtrack._core import FrameResult


class IntensityRenderer:
    """The scene without its colours: 0.299 red + 0.587 green + 0.114 blue, as the flow's frames."""

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Turn scene, HxWx3 BGR, grey in place; return it."""
        import cv2

        scene[:] = cv2.cvtColor(scene, cv2.COLOR_BGR2GRAY)[:, :, None]
        return scene
