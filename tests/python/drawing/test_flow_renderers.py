# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Optical flow as arrows and as colours."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from clips import Image
from fakes import result_of
from survtrack.drawing import FlowColorRenderer, FlowRenderer, flow_colors
from survtrack.drawing.flow_arrows import ARROW, _spacing
from survtrack.drawing.scene import Style
from survtrack.errors import UsageError

RED, DOWN, CYAN, UP = (0, 0, 255), (0, 255, 128), (255, 255, 0), (255, 0, 128)
MAKERS: list[Callable[..., Any]] = [FlowRenderer, FlowColorRenderer]


def blank(height: int = 60, width: int = 80, grey: int = 100) -> Image:
    return np.full((height, width, 3), grey, np.uint8)


def field(height: int = 60, width: int = 80, u: float = 0.0, v: float = 0.0) -> np.ndarray:
    flow = np.zeros((height, width, 2), np.float32)
    flow[...] = u, v
    return flow


def drawn(renderer: Any, flow: np.ndarray | None) -> Image:
    height, width = (60, 80) if flow is None else flow.shape[:2]
    scene: Image = renderer.annotate(
        blank(height, width), result_of(blank(height, width), flow=flow)
    )
    return scene


def arrow_pixels(scene: Image) -> np.ndarray:
    """(x, y) of all pixels that are about as yellow as the arrows, which have smooth edges."""
    return np.argwhere((np.abs(scene.astype(int) - ARROW) < 90).all(axis=2))[:, ::-1]


@pytest.mark.parametrize(
    ("u", "v", "color"), [(1, 0, RED), (0, 1, DOWN), (-1, 0, CYAN), (0, -1, UP)]
)
def test_directions_have_the_colours_of_the_wheel(
    u: float, v: float, color: tuple[int, int, int]
) -> None:
    assert tuple(flow_colors(field(2, 3, u, v), 1.0)[1, 2]) == color
    assert tuple(flow_colors(field(2, 3, 9 * u, 9 * v), 1.0)[0, 0]) == color
    half = flow_colors(field(2, 3, u / 2, v / 2), 1.0)[0, 0].astype(int)
    assert np.abs(half - (255 + np.array(color)) / 2).max() <= 0.5
    quarter_later = flow_colors(field(1, 1, u - v, v + u), 1.0)[0, 0]
    assert tuple(quarter_later) != color


def test_all_hues_are_those_of_hsv() -> None:
    import colorsys

    angles = np.linspace(-np.pi, np.pi, 200)
    flow = 0.7 * np.stack((np.cos(angles), np.sin(angles)), axis=-1)[np.newaxis]
    colors = flow_colors(flow, 1.0)[0].astype(float)
    expected = [colorsys.hsv_to_rgb(angle / (2 * np.pi) % 1, 0.7, 1)[::-1] for angle in angles]
    assert np.abs(colors - 255 * np.array(expected)).max() < 0.51


def test_what_stands_still_or_is_unknown_is_white() -> None:
    flow = field(1, 6)
    flow[0, 1:] = (np.nan, 1), (np.inf, 0), (3e38, 3e38), (0, -2e9), (1e9, 0)
    colors = flow_colors(flow, 1.0)
    assert (colors[0, :5] == 255).all()
    assert tuple(colors[0, 5]) == RED
    assert flow_colors(np.zeros((0, 4, 2)), 1.0).shape == (0, 4, 3)


def test_the_wheel_stands_in_the_corner_and_says_its_rim() -> None:
    flow = field(120, 160, 0.0, 1.0)
    scene = drawn(FlowColorRenderer(full_px=2.0), flow)
    assert (scene[:60] == flow_colors(flow, 2.0)[:60]).all()
    # A radius of 12 px, its middle 12 px and the margin of 4 from the last column and row.
    x, y = 160 - 1 - 12 - 4, 120 - 1 - 12 - 4
    assert (scene[y, x] == 255).all()
    for dx, dy, color in ((11, 0, RED), (0, 11, DOWN), (-11, 0, CYAN), (0, -11, UP)):
        rim = scene[y + dy, x + dx].astype(int)
        assert np.abs(rim - color).max() <= 255 / 12 + 1
    other = drawn(FlowColorRenderer(full_px=4.0), flow)
    labels = np.s_[100:, :120]
    assert (scene[labels] == 0).any()
    assert ((scene[labels] == 0) != (other[labels] == 0)).any()  # the number


def test_arrows_start_at_the_grid_and_have_the_length_of_their_magnitude() -> None:
    flow = field(u=0.0)
    flow[18, 18] = 0.5, 0.0
    flow[18, 50] = 0.0, 1.0
    flow[34, 70] = -4.0, 0.0  # cut
    # 60 x 80 px have 4 px from arrow to arrow: 12 px are the full length.
    found = arrow_pixels(drawn(FlowRenderer(full_px=1.0), flow)[:40])
    right = found[found[:, 0] < 30]
    assert sorted(right[right[:, 1] == 18][:, 0]) == list(range(18, 25))
    down = found[(found[:, 0] > 40) & (found[:, 0] < 56)]
    assert sorted(down[down[:, 0] == 50][:, 1]) == list(range(18, 31))
    left = found[found[:, 0] >= 56]
    assert sorted(left[left[:, 1] == 34][:, 0]) == list(range(58, 71))
    # Heads spread to both sides behind their points only.
    assert np.abs(found[:, 1] - 18).min() == 0 and right[:, 0].min() == 18


def test_what_moves_no_farther_than_the_threshold_has_no_arrow() -> None:
    for u, arrows in ((0.25, False), (0.26, True)):
        scene = drawn(FlowRenderer(threshold_px=0.25, full_px=0.5), field(u=u))
        assert bool(len(arrow_pixels(scene[:40]))) == arrows


@pytest.mark.parametrize(("scale", "line"), [(1, 1), (12, 3)])
def test_arrows_of_less_than_three_widths_of_their_line_are_left_out(scale: int, line: int) -> None:
    size = 60 * scale, 80 * scale
    assert Style.of(blank(*size)).line == line
    least = 3 * line / (3 * _spacing(size))
    for u, arrows in ((0.98 * least, False), (1.02 * least, True)):
        scene = drawn(FlowRenderer(full_px=1.0), field(*size, u))
        assert bool((scene[: 40 * scale] != 100).any()) == arrows


@pytest.mark.parametrize("shape", [(1, 1), (16, 16), (1, 9000), (288, 384), (1080, 1920)])
def test_there_are_no_more_than_two_thousand_arrows(
    shape: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    counts: list[int] = []
    monkeypatch.setattr(
        "survtrack.drawing.flow_arrows._draw_arrows",
        lambda _, feet, heads: counts.append(len(feet)),
    )
    drawn(FlowRenderer(full_px=1.0), field(*shape, 1.0, 0.0))
    assert (1 if shape == (1, 1) else 16) <= counts[0] <= 2000


def test_the_sample_arrow_has_the_full_length() -> None:
    scene = drawn(FlowRenderer(full_px=1.0), field())
    yellow = np.argwhere((scene[..., 0] < 90) & (scene[..., 1] > 128))
    rows, columns = yellow.T
    assert np.ptp(columns) == 12
    assert rows.min() > 50 and columns.max() < 20
    assert (scene[:40] == 100).all()


@pytest.mark.parametrize("make", MAKERS)
def test_a_scale_of_1_2_or_5_is_kept_while_it_suits(make: Callable[..., Any]) -> None:
    """Equal pictures of a told scale name the scale that was found."""
    renderer = make()
    for magnitude, full_px in (
        *((0.9, 1.0), (0.17, 1.0), (1.0, 1.0), (1.01, 2.0), (0.34, 2.0), (0.33, 0.5)),
        *((1e-6, 0.5), (30.0, 50.0), (0.031, 0.05)),
    ):
        flow = field(120, 160, magnitude)
        assert (drawn(renderer, flow) == drawn(make(full_px=full_px), flow)).all()


@pytest.mark.parametrize("make", MAKERS)
def test_a_few_wild_vectors_do_not_make_the_others_small(make: Callable[..., Any]) -> None:
    flow = field(u=0.9)
    flow[:5] = 1e6  # a twelfth
    assert (drawn(make(), flow) == drawn(make(full_px=1.0), flow)).all()


@pytest.mark.parametrize("make", MAKERS)
def test_a_frame_without_flow_says_so(make: Callable[..., Any]) -> None:
    scene = drawn(make(), None)
    assert (scene[:30] == 100).all()
    assert (scene[-8:, :40] == 0).any()


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize("shape", [(1, 1), (1, 30), (16, 16), (47, 300), (48, 48), (288, 384)])
@pytest.mark.parametrize("values", ["zeros", "random", "large", "huge", "nan"])
def test_any_field_can_be_drawn_twice_to_the_same_bytes(
    make: Callable[..., Any], shape: tuple[int, int], values: str
) -> None:
    flow = np.random.default_rng(1).normal(0, 1, (*shape, 2)).astype(np.float32)
    flow *= {"zeros": 0.0, "random": 1.0, "large": 1e8, "huge": 1e37, "nan": 1.0}[values]
    if values == "nan":
        flow[::2] = np.nan
        flow[:, ::3] = -np.inf
    kept = flow.copy()
    scene = drawn(make(), flow)
    assert scene.shape == (*shape, 3)
    assert (scene == drawn(make(), flow)).all()
    assert np.array_equal(flow, kept, equal_nan=True)


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize("full_px", [1e-9, 1e9, None])
def test_the_ends_of_the_scale_can_be_drawn(
    make: Callable[..., Any], full_px: float | None
) -> None:
    for magnitude in (0.0, 1e-40, 1e-9, 1e9):
        scene = drawn(make(threshold_px=0.0, full_px=full_px), field(120, 160, magnitude))
        moved = (scene[50, 50:70] != (100 if make is FlowRenderer else 255)).any()
        if full_px is not None:
            assert bool(moved) == (magnitude >= full_px)


@pytest.mark.parametrize("make", MAKERS)
def test_what_is_not_allowed_is_named(make: Callable[..., Any]) -> None:
    for bad in (0, -1.0, 1e-10, 2e9, float("nan"), float("inf")):
        with pytest.raises(
            UsageError, match=re.escape(f"full_px: {bad} is not allowed; 1e-09 to 1e+09")
        ):
            make(full_px=bad)
        with pytest.raises(
            UsageError, match=re.escape(f"full_px: {bad} is not allowed; 1e-09 to 1e+09")
        ):
            flow_colors(field(), bad)
    for bad in (-0.1, float("nan"), float("inf")):
        with pytest.raises(UsageError, match=rf"threshold_px: {bad} is not allowed"):
            make(threshold_px=bad)
    with pytest.raises(UsageError, match=r"flow: has shape \(60, 80, 2\), .* 40x30"):
        make().annotate(blank(30, 40), result_of(blank(), flow=field()))
    with pytest.raises(UsageError, match=r"flow: has shape \(60, 80\); expected HxWx2"):
        flow_colors(field()[..., 0], 1.0)
