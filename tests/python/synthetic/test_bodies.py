# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Shapes as pixels, against the rule written out pixel by pixel."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from worlds import quick

from survtrack.errors import UsageError
from survtrack.scenes import Body
from survtrack.scenes.body import SHAPES, Patch

SIDE = 48
places = st.floats(-10, SIDE + 10)
sides = st.floats(2, 30)
shapes = st.sampled_from(SHAPES)


def by_the_rule(body: Body, center: tuple[float, float], scale: float) -> np.ndarray:
    """A pixel is set when its centre is inside; on a SIDE x SIDE frame."""
    mask = np.zeros((SIDE, SIDE), bool)
    rx, ry = body.width_px * scale / 2, body.height_px * scale / 2
    for row in range(SIDE):
        for column in range(SIDE):
            dx, dy = (column + 0.5 - center[0]) / rx, (row + 0.5 - center[1]) / ry
            if body.shape == "ellipse":
                mask[row, column] = dx * dx + dy * dy <= 1
            else:
                mask[row, column] = -1 <= dx < 1 and -1 <= dy < 1
    return mask


def on_frame(patch: Patch) -> np.ndarray:
    frame = np.zeros((SIDE, SIDE), patch.values.dtype)
    clipped = patch.clipped((SIDE, SIDE))
    frame[clipped.area] = clipped.values
    return frame


@quick
@given(shapes, sides, sides, places, places, st.floats(1, 1.5))
def test_a_pixel_is_set_when_its_centre_is_inside(
    shape: str, width: float, height: float, x: float, y: float, scale: float
) -> None:
    body = Body(shape, width, height)
    patch = body.silhouette((x, y), scale)
    assert np.array_equal(on_frame(patch), by_the_rule(body, (x, y), scale))


@quick
@given(shapes, sides, sides, places, places)
def test_the_centroid_is_within_half_a_pixel(
    shape: str, width: float, height: float, x: float, y: float
) -> None:
    patch = Body(shape, width, height).silhouette((x, y))
    rows, columns = np.nonzero(patch.values)
    assert abs(columns.mean() + patch.left + 0.5 - x) <= 0.5 + 1e-9
    assert abs(rows.mean() + patch.top + 0.5 - y) <= 0.5 + 1e-9


@quick
@given(st.integers(2, 30), st.integers(2, 30), places, places)
def test_a_rectangle_of_whole_sides_has_as_many_pixels_wherever_it_is(
    width: int, height: int, x: float, y: float
) -> None:
    patch = Body("rectangle", width, height).silhouette((x, y))
    assert patch.box()[2:] == (width, height)
    assert np.count_nonzero(patch.values) == width * height


@quick
@given(shapes, sides, sides, places, places)
def test_coverage_agrees_with_area_and_centre(
    shape: str, width: float, height: float, x: float, y: float
) -> None:
    body = Body(shape, width, height)
    cover = body.coverage((x, y))
    values = cover.values.astype(np.float64)
    assert values.min() >= 0 and values.max() <= 1
    area = width * height * (np.pi / 4 if shape == "ellipse" else 1)
    assert values.sum() == pytest.approx(area, rel=0.13)
    across = values.sum(axis=0) @ (cover.left + 0.5 + np.arange(values.shape[1])) / values.sum()
    down = values.sum(axis=1) @ (cover.top + 0.5 + np.arange(values.shape[0])) / values.sum()
    assert max(abs(across - x), abs(down - y)) <= 0.126


def test_a_circle_by_hand() -> None:
    patch = Body("ellipse", 4, 4).silhouette((2, 2))
    assert patch.values.astype(int).tolist() == [
        [0, 1, 1, 0],
        [1, 1, 1, 1],
        [1, 1, 1, 1],
        [0, 1, 1, 0],
    ]
    assert patch.box() == (0, 0, 4, 4)


def test_what_is_out_of_the_frame_is_clipped_away() -> None:
    patch = Body("rectangle", 4, 6).silhouette((1, 47))
    assert patch.clipped((SIDE, SIDE)).box() == (0, 44, 3, 4)
    far = Body("rectangle", 4, 6).silhouette((-100, 500)).clipped((SIDE, SIDE))
    assert far.values.size == 0 and far.box()[2:] == (0, 0)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"shape": "star"}, 'shape: unknown "star"; one of: ellipse, rectangle'),
        ({"width_px": 1.9}, "width_px: 1.9 is not allowed; at least 2"),
        ({"height_px": float("nan")}, "height_px: nan is not allowed"),
    ],
)
def test_a_body_that_is_none(values: dict, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        Body(**values)
