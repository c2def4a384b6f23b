# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Optical flow against an independent reference, known movements and Middlebury's truth."""

import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import flow_reference
from clips import Image
from survtrack import ConfigError, InputError, horn_schunck
from survtrack.evaluation import flow_error, read_flo

RANDOM = np.random.default_rng(5)
SIZES = [(1, 1), (1, 9), (9, 1), (2, 2), (3, 5), (16, 16), (17, 31), (40, 33), (61, 130)]


def noise(*shape: int) -> Image:
    return RANDOM.integers(0, 256, shape, np.uint8)


def waves(height: int, width: int, right: float = 0, down: float = 0) -> Image:
    """A smooth texture, moved."""
    y, x = np.mgrid[:height, :width].astype(float)
    x, y = x - right, y - down
    values = np.sin(x / 5) * np.cos(y / 6) + np.sin((x + 2 * y) / 9) + np.cos((2 * x - y) / 11)
    return np.round(127 + 40 * values).astype(np.uint8)


def inner(values: Any, border: int = 12) -> Any:
    return values[border:-border, border:-border]


@pytest.mark.parametrize("derivatives", ["hs1981", "sobel"])
@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
@pytest.mark.parametrize("warm", [False, True], ids=["from zeros", "from a field"])
def test_equals_the_equations(size: tuple[int, int], derivatives: str, warm: bool) -> None:
    previous, current = noise(*size), noise(*size)
    field = (RANDOM.normal(0, 2, size), RANDOM.normal(0, 2, size)) if warm else None
    for smoothness, sweeps in ((0.5, 1), (0.5, 10), (0.05, 37), (5.0, 60)):
        options = {"smoothness": smoothness, "sweeps": sweeps, "derivatives": derivatives}
        expected = flow_reference.horn_schunck(previous, current, initial=field, **options)  # type: ignore[arg-type]
        flow = horn_schunck(previous, current, initial=field, **options)  # type: ignore[arg-type]
        for ours, theirs in zip(flow, expected, strict=True):
            assert ours.shape == size and ours.dtype == np.float32
            assert np.abs(ours - theirs).max() < 1e-3


def test_views_and_colours_are_their_pixels() -> None:
    whole = noise(50, 70, 2)
    previous, current = whole[3:40:2, 5:60, 0], whole[3:40:2, 5:60, 1]
    plain = horn_schunck(np.ascontiguousarray(previous), np.ascontiguousarray(current), sweeps=12)
    assert np.array_equal(horn_schunck(previous, current, sweeps=12), plain)
    colours = noise(20, 30, 3), noise(20, 30, 3)
    greys = [cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY) for frame in colours]
    # Another release of OpenCV may round a grey level differently.
    assert np.abs(np.subtract(horn_schunck(*colours), horn_schunck(*greys))).max() < 0.2
    field = [np.asfortranarray(component) for component in plain]
    assert np.array_equal(
        horn_schunck(previous, current, initial=(field[0], field[1])),
        horn_schunck(previous, current, initial=plain),
    )


def test_the_input_is_left_alone() -> None:
    previous, current = noise(20, 30), noise(20, 30)
    field = horn_schunck(previous, current)
    before = [array.copy() for array in (previous, current, *field)]
    horn_schunck(previous, current, initial=field, levels=2)
    for array, copy in zip((previous, current, *field), before, strict=True):
        assert np.array_equal(array, copy)


@pytest.mark.parametrize("options", [{}, {"levels": 3}, {"derivatives": "sobel"}, {"warps": 2}])
def test_frames_without_change_or_without_texture_do_not_move(options: dict[str, Any]) -> None:
    still, flat = noise(40, 50), np.full((40, 50), 80, np.uint8)
    for previous, current in (
        (still, still),
        (flat, flat),
        (flat, flat + 50),
        (0 * flat, 0 * flat),
    ):
        for component in horn_schunck(previous, current, sweeps=300, **options):
            assert not component.any() and not np.isnan(component).any()


@pytest.mark.parametrize("derivatives", ["hs1981", "sobel"])
@pytest.mark.parametrize("move", [(1.0, 0.0), (0.0, -1.0), (0.5, 0.25), (-0.6, 0.7)])
def test_a_known_translation(move: tuple[float, float], derivatives: str) -> None:
    frames = waves(90, 120), waves(90, 120, *move)
    flow = horn_schunck(*frames, smoothness=0.02, sweeps=500, derivatives=derivatives)
    for component, expected in zip(flow, move, strict=True):
        assert np.abs(inner(component) - expected).max() < 0.15
        assert abs(inner(component).mean() - expected) < 0.02


@pytest.mark.parametrize("move", [(6.0, 0.0), (0.0, 5.0), (-4.5, 7.25)])
def test_a_large_translation_needs_the_pyramid(move: tuple[float, float]) -> None:
    frames = waves(120, 160), waves(120, 160, *move)
    found = [horn_schunck(*frames, levels=levels) for levels in (1, 4)]
    away = [np.hypot(inner(u, 16) - move[0], inner(v, 16) - move[1]) for u, v in found]
    assert away[0].mean() > 0.5
    assert away[1].mean() < 0.05 and away[1].max() < 0.4


def test_warping_by_zeros_is_the_plain_method() -> None:
    frames = noise(30, 40), noise(30, 40)
    assert np.array_equal(horn_schunck(*frames, warps=1), horn_schunck(*frames))


def test_a_start_at_the_truth_finds_a_large_movement_in_one_level() -> None:
    frames = waves(90, 120), waves(90, 120, 6, 3)
    truth = np.full((90, 120), 6.0), np.full((90, 120), 3.0)
    u, v = horn_schunck(*frames, warps=1, initial=truth)
    assert np.hypot(inner(u) - 6, inner(v) - 3).max() < 0.1
    u, v = horn_schunck(*frames, levels=2, initial=truth)
    assert np.hypot(inner(u, 16) - 6, inner(v, 16) - 3).max() < 0.2


def test_sweeps_go_on_where_the_last_ones_ended() -> None:
    frames = noise(40, 50), noise(40, 50)
    half = horn_schunck(*frames, sweeps=30)
    assert np.array_equal(
        horn_schunck(*frames, sweeps=20, initial=half), horn_schunck(*frames, sweeps=50)
    )


def test_the_tolerance_stops_early_and_changes_nothing_else() -> None:
    frames = waves(40, 60), waves(40, 60, 1, 0)
    every = [horn_schunck(*frames, sweeps=n) for n in range(1, 121)]
    change = [
        max(np.abs(b - a).max() for a, b in zip(first, second, strict=True))
        for first, second in pairwise(every)
    ]
    for k in (4, 30, 90):
        tolerance = float(change[k]) * 1.001
        enough = next(i for i, one in enumerate(change) if one < tolerance) + 2  # sweeps
        assert 3 < enough <= k + 2
        stopped = horn_schunck(*frames, sweeps=120, tolerance=tolerance)
        assert np.array_equal(stopped, every[enough - 1])
        fewer = horn_schunck(*frames, sweeps=enough - 1, tolerance=tolerance)
        assert np.array_equal(fewer, every[enough - 2]), "sweeps bound it"
    assert np.array_equal(horn_schunck(*frames, sweeps=50, tolerance=1e6), every[0])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"smoothness": 0}, "smoothness: 0 is not allowed; expected between 0.0001 and 1000"),
        ({"smoothness": -0.5}, "smoothness: -0.5 is not allowed"),
        ({"smoothness": float("nan")}, "smoothness: nan is not allowed"),
        ({"smoothness": float("inf")}, "smoothness: inf is not allowed"),
        ({"sweeps": 0}, "sweeps: 0 is not allowed; expected between 1 and 100000"),
        ({"tolerance": -1}, "tolerance: -1 is not allowed"),
        ({"tolerance": float("nan")}, "tolerance: nan is not allowed"),
        ({"derivatives": "prewitt"}, 'derivatives: "prewitt" is not allowed; expected'),
        ({"levels": 0}, "levels: 0 is not allowed"),
        ({"levels": 4}, "levels: 4 is not allowed for 40x50; expected between 1 and 3"),
        ({"warps": -1}, "warps: -1 is not allowed"),
    ],
)
def test_options_out_of_range(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ConfigError, match="^" + re.escape(message)):
        horn_schunck(noise(40, 50), noise(40, 50), **options)


@pytest.mark.parametrize(
    ("previous", "current", "message"),
    [
        (noise(4, 5).astype(np.float32), noise(4, 5), r"previous: is \(4, 5\) float32; expected"),
        (noise(4, 5), noise(4, 5, 4), r"current: is \(4, 5, 4\) uint8; expected"),
        (noise(4, 5), "frame", r"current: is str; expected"),
        (noise(0, 5), noise(0, 5), r"previous: is \(0, 5\) uint8; expected"),
        (noise(4, 5), noise(5, 4), "current: is 5x4; expected the size of previous, 4x5"),
    ],
)
def test_frames_that_do_not_fit(previous: Any, current: Any, message: str) -> None:
    with pytest.raises(InputError, match="^" + message):
        horn_schunck(previous, current)


def holding(value: float) -> np.ndarray:
    field = np.zeros((4, 5))
    field[2, 3] = value
    return field


@pytest.mark.parametrize(
    ("initial", "message"),
    [
        (7, "initial: is int; expected a pair"),
        ((np.zeros((4, 5)),), "initial: is tuple; expected a pair"),
        ((np.zeros((4, 5)), np.zeros((5, 4))), "initial.v: is 5x4; expected .* frames' size, 4x5"),
        ((np.zeros((4, 5, 1)),) * 2, r"initial.u: is \(4, 5, 1\) float64; expected"),
        ((np.zeros((4, 5), int),) * 2, r"initial.u: is \(4, 5\) int64; expected"),
        (([[0.0]], [[0.0]]), "initial.u: is list; expected"),
        ((np.zeros((0, 0)),) * 2, "initial: is empty"),
        (
            (np.zeros((4, 5)), holding(np.nan)),
            "initial.v: is -?nan at row 2, column 3; expected fi",
        ),
        ((holding(np.inf), np.zeros((4, 5))), "initial.u: is inf at row 2, column 3"),
        ((holding(-2e6), np.zeros((4, 5))), "initial.u: is -2000000.0* at row 2"),
    ],
)
def test_initial_fields_that_do_not_fit(initial: Any, message: str) -> None:
    with pytest.raises(InputError, match="^" + message):
        horn_schunck(noise(4, 5), noise(4, 5), initial=initial)


@pytest.mark.parametrize("name", ["Dimetrodon", "Grove2", "RubberWhale", "Venus"])
def test_middlebury(data: Path, name: str) -> None:
    """The figures of docs/flow.md."""
    folder = data / "flow" / name
    previous, current = (cv2.imread(str(folder / f"frame{k}.png")) for k in (10, 11))
    truth = read_flo(folder / "flow10.flo")
    assert truth[0].shape == previous.shape[:2]
    nothing = np.zeros_like(truth[0])
    zero = flow_error((nothing, nothing), truth)
    plain = flow_error(horn_schunck(previous, current), truth)
    pyramid = flow_error(horn_schunck(previous, current, levels=5), truth)
    errors = (zero, plain, pyramid)
    print(name, "zero, one level, five:", *(f"{error.endpoint_px:.3f} px" for error in errors))
    assert plain.endpoint_px < zero.endpoint_px
    assert pyramid.endpoint_px < zero.endpoint_px / 4
    assert pyramid.angular_deg < 10
