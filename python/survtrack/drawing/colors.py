# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One colour an id, the same in every picture."""

import colorsys

Color = tuple[int, int, int]

WHITE: Color = (255, 255, 255)
BLACK: Color = (0, 0, 0)

# Steps of the golden section round the circle of hues keep consecutive ids apart. Hues that are 8
# or 13 steps apart come close; there the saturation differs.
GOLDEN_SECTION = 0.6180339887498949
SATURATIONS = (0.95, 0.55)


def color_of_id(track_id: int) -> Color:
    """Bright BGR colour of a track id."""
    hue = (track_id * GOLDEN_SECTION) % 1.0
    saturation = SATURATIONS[track_id // 8 % 2]
    red, green, blue = colorsys.hsv_to_rgb(hue, saturation, 1.0)
    return round(255 * blue), round(255 * green), round(255 * red)


def ink_on(paper: Color) -> Color:
    """Black or white, whichever reads better on `paper` (BGR), by its luma (ITU-R BT.601)."""
    blue, green, red = paper
    luma = 0.114 * blue + 0.587 * green + 0.299 * red
    return BLACK if luma > 140 else WHITE
