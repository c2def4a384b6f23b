# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What all renderers share: the scene, its scale, lines and labels."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
import numpy.typing as npt

from survtrack.drawing.colors import Color, ink_on

if TYPE_CHECKING:
    from survtrack._core import FrameResult

Scene = npt.NDArray[np.uint8]
Point = tuple[int, int]


class Renderer(Protocol):
    """Draws one thing of a result on a picture."""

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw on scene, HxWx3 BGR, in place; return it."""


@dataclass(frozen=True)
class Style:
    """Sizes in pixels that suit a picture: thin on small pictures, visible on large ones."""

    line: int
    font_scale: float
    margin: int

    @staticmethod
    def of(scene: Scene) -> "Style":
        """Style for a picture's height and width."""
        side = min(scene.shape[0], scene.shape[1])
        return Style(
            line=max(1, round(0.5 + side / 300)),
            font_scale=max(0.4, side / 1300),
            margin=max(2, round(side / 250)),
        )


def as_scene(image: Scene) -> Scene:
    """A fresh HxWx3 BGR picture of a grey or colour image, to be drawn on."""
    if image.ndim == 3:
        return image.copy()
    return np.repeat(image[:, :, np.newaxis], 3, axis=2)


def label_size(scene: Scene, text: str) -> tuple[int, int]:
    """Width and height of the box that draw_label() fills, px."""
    import cv2

    style = Style.of(scene)
    font = cv2.FONT_HERSHEY_SIMPLEX
    (width, height), below = cv2.getTextSize(text, font, style.font_scale, style.line)
    return width + 2 * style.margin, height + below + style.margin


def draw_label(scene: Scene, text: str, corner: Point, paper: Color) -> None:
    """Write text on a filled box whose lower left corner is `corner`, moved to be inside."""
    import cv2

    style = Style.of(scene)
    font = cv2.FONT_HERSHEY_SIMPLEX
    _, below = cv2.getTextSize(text, font, style.font_scale, style.line)
    width, height = label_size(scene, text)
    left = max(0, min(corner[0], scene.shape[1] - width))
    bottom = max(height, min(corner[1], scene.shape[0]))
    cv2.rectangle(scene, (left, bottom - height), (left + width, bottom), paper, cv2.FILLED)
    origin = (left + style.margin, bottom - below - style.margin // 2)
    ink = ink_on(paper)
    cv2.putText(scene, text, origin, font, style.font_scale, ink, style.line, cv2.LINE_AA)


def draw_dashed_line(scene: Scene, start: Point, end: Point, color: Color) -> None:
    """A line of dashes; both its ends are drawn."""
    import cv2

    line = Style.of(scene).line
    length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
    # An odd number of pieces: dashes at both ends, gaps between.
    pieces = 2 * max(1, round(length / (12 * line))) - 1
    corners = np.linspace(start, end, pieces + 1).round().astype(int)
    for k in range(0, pieces, 2):
        cv2.line(scene, corners[k].tolist(), corners[k + 1].tolist(), color, line)
