# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Colours of ids are stable, bright and apart; labels are legible and inside the picture."""

import colorsys
from itertools import combinations

import numpy as np
import pytest

from survtrack.drawing import as_scene, color_of_id
from survtrack.drawing.colors import BLACK, WHITE, ink_on
from survtrack.drawing.scene import Style, draw_dashed_line, draw_label


def hue(track_id: int) -> float:
    blue, green, red = color_of_id(track_id)
    return colorsys.rgb_to_hsv(red / 255, green / 255, blue / 255)[0]


def test_an_id_has_one_colour_and_neighbours_differ() -> None:
    assert color_of_id(12) == color_of_id(12)
    for first in (1, 100, 12345):
        for a, b in combinations(range(first, first + 8), 2):
            apart = abs(hue(a) - hue(b))
            assert min(apart, 1 - apart) > 0.05
    for k in range(100):
        apart = np.abs(np.subtract(color_of_id(k), color_of_id(k + 8)))
        assert apart.max() > 60
        assert max(color_of_id(k)) == 255


def test_ink_contrasts_with_its_paper() -> None:
    assert ink_on((0, 0, 0)) == WHITE
    assert ink_on((255, 255, 255)) == BLACK
    assert ink_on((0, 255, 255)) == BLACK  # yellow
    assert ink_on((255, 0, 0)) == WHITE  # blue


@pytest.mark.parametrize("corner", [(-50, -50), (500, 500), (10, 40), (0, 0)])
@pytest.mark.parametrize("side", [60, 300, 2000])
def test_a_label_is_inside_the_picture_and_has_ink(side: int, corner: tuple[int, int]) -> None:
    scene = np.full((side, side, 3), 90, np.uint8)
    draw_label(scene, "17", corner, (0, 255, 255))
    rows, columns = np.nonzero((scene != 90).any(axis=2))
    ink = scene[..., 2] < 128
    height, width = np.ptp(rows) + 1, np.ptp(columns) + 1
    assert height >= max(9, side / 80)
    assert width >= height * 0.8
    assert ink[rows, columns].mean() > 0.05


def test_lines_grow_with_the_picture() -> None:
    sizes = [Style.of(np.zeros((side, 2 * side, 3), np.uint8)) for side in (240, 576, 2160)]
    assert [style.line for style in sizes] == [1, 2, 8]
    assert sizes[0].font_scale < sizes[1].font_scale < sizes[2].font_scale


def test_a_dashed_line_has_its_ends_and_gaps() -> None:
    scene = np.zeros((20, 101, 3), np.uint8)
    draw_dashed_line(scene, (0, 10), (100, 10), WHITE)
    drawn = scene[10, :, 0] > 0
    assert drawn[0] and drawn[100]
    assert 0.35 < drawn.mean() < 0.8
    assert np.count_nonzero(np.diff(drawn.astype(int)) == -1) >= 3


def test_a_dashed_line_of_no_length_is_a_dot() -> None:
    scene = np.zeros((9, 9, 3), np.uint8)
    draw_dashed_line(scene, (4, 4), (4, 4), WHITE)
    assert np.argwhere(scene[..., 0]).tolist() == [[4, 4]]


def test_a_scene_is_a_colour_copy() -> None:
    grey = np.arange(12, dtype=np.uint8).reshape(3, 4)
    scene = as_scene(grey)
    assert scene.shape == (3, 4, 3)
    assert (scene == grey[:, :, np.newaxis]).all()
    colour = np.zeros((3, 4, 3), np.uint8)
    as_scene(colour)[:] = 9
    assert not colour.any()
