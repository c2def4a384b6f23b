# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Several pictures in one."""

from collections.abc import Sequence

import numpy as np

from survtrack.drawing.scene import Scene, as_scene
from survtrack.errors import UsageError

GAP_PX = 4
GAP_GREY = 32


def contact_sheet(images: Sequence[Scene], columns: int = 3) -> Scene:
    """Images of one size, HxW or HxWx3, row by row with a narrow gap; HxWx3 BGR.

    Raises:
        UsageError: no images, images of different sizes, or less than one column.
    """
    return grid([as_scene(image) for image in images], columns, gap_px=GAP_PX)


def grid(images: Sequence[Scene], columns: int, gap_px: int = 0) -> Scene:
    """HxWx3 images of one size, row by row; places left over are dark grey."""
    if not images:
        raise UsageError("images: at least one is needed")
    if columns < 1:
        raise UsageError(f"columns: {columns} is not allowed; 1 or more")
    sizes = {image.shape for image in images}
    if len(sizes) > 1:
        raise UsageError(f"images: sizes differ: {sorted(sizes)}")
    height, width, _ = images[0].shape
    columns = min(columns, len(images))
    rows = -(-len(images) // columns)
    down, right = height + gap_px, width + gap_px
    shape = (rows * down - gap_px, columns * right - gap_px, 3)
    sheet = np.full(shape, GAP_GREY, np.uint8)
    for k, image in enumerate(images):
        top, left = k // columns * down, k % columns * right
        sheet[top : top + height, left : left + width] = image
    return sheet
