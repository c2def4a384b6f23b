# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Paths on the picture, with their ticks, and tracks by them."""

import numpy as np
import pytest

from clips import Image
from fakes import Box, Track, result_of
from survtrack import Path, Paths
from survtrack.drawing import PathRenderer, Views, color_of_id, draw_paths
from survtrack.drawing.paths import tick_distance_px

SIZE = (240, 320)
LEVEL = Path([(20, 100), (300, 100)])


def blank() -> Image:
    return np.zeros((*SIZE, 3), np.uint8)


def drawn(paths: dict[str, Path], *tracks: Track) -> Image:
    scene = blank()
    result = result_of(blank(), 0, *tracks)
    assert PathRenderer(Paths(paths)).annotate(scene, result) is scene
    return scene


def inked(scene: Image) -> np.ndarray:
    """HxW: where the path's colour is, full or faded."""
    return np.asarray((scene[..., 0] > 128) & (scene[..., 1] > 128) & (scene[..., 2] < 128))


@pytest.mark.parametrize(
    ("length", "tick"),
    [
        (12, 1),
        (12.1, 2),
        (280, 50),
        (278.586, 50),
        (100, 10),
        (1300, 200),
        (0.05, 0.005),
        (6e5, 5e4),
    ],
)
def test_ticks_are_round_and_no_more_than_twelve(length: float, tick: float) -> None:
    assert tick_distance_px(length) == pytest.approx(tick)


def test_the_line_is_where_the_path_is() -> None:
    ink = inked(drawn({"a": LEVEL}))
    assert ink[100, 21:300].mean() > 0.9  # arrowheads have rims
    assert not ink[:94].any()  # ticks and numbers are on the other side, arrowheads narrow
    assert not ink[:, :8].any() and not ink[:, 312:].any()


def test_ticks_stand_every_round_length_on_the_positive_side() -> None:
    ink = inked(drawn({"a": LEVEL}))
    columns = np.flatnonzero(ink[105])
    expected = [20 + 50 * k for k in range(6)]
    assert [x for x in expected if np.abs(columns - x).min() <= 1] == expected
    assert all(np.abs(np.array(expected) - x).min() <= 2 for x in columns)
    back = inked(drawn({"a": Path(np.array(LEVEL.points)[::-1])}))
    assert back[95].any() and not ink[94].any()


def test_arrowheads_point_where_s_grows() -> None:
    """Their first ones are at S = 25; each is looked at on the side without ticks."""
    there = inked(drawn({"a": LEVEL}))[95:99, 35:56].sum(axis=0)
    back = inked(drawn({"a": Path([(300, 100), (20, 100)])}))[102:106, 265:286].sum(axis=0)
    assert there.max() >= 2 and back.max() >= 2
    assert np.argmax(there) < 10 < 20 - np.argmax(back[::-1])


def test_a_closed_path_is_drawn_all_round() -> None:
    square = [(60, 60), (260, 60), (260, 180), (60, 180)]
    assert inked(drawn({"a": Path(square, closed=True)}))[70:170, 60].all()
    assert not inked(drawn({"a": Path(square)}))[130:150, 60].any()
    curve = Path(square, closed=True, kind="curve")
    ink = inked(drawn({"a": curve}))
    places = curve.to_image([(s, 0) for s in np.arange(0, curve.length_px, 3)]).round().astype(int)
    assert np.mean([ink[y, x] for x, y in places if 0 <= x < 320 and 0 <= y < 240]) > 0.9


def test_a_track_has_a_line_to_its_path_and_its_place_under_its_box() -> None:
    track = Track(3, Box(110, 130, 20, 40))  # at (120, 150)
    scene = drawn({"a": LEVEL}, track)
    assert (scene[125:145, 120] > 200).all()
    label = (scene == color_of_id(3)).all(axis=2)
    rows, columns = np.nonzero(label)
    assert rows.min() >= 168 and columns.min() >= 108
    moved = drawn({"a": LEVEL}, Track(3, Box(110, 131, 20, 40)))
    assert (moved[170:200] != scene[170:200]).any()


def test_what_is_too_far_or_not_reported_has_none() -> None:
    near = Path([(20, 100), (300, 100)], max_distance_px=30)
    alone = drawn({"a": near})
    assert np.array_equal(drawn({"a": near}, Track(3, Box(110, 130, 20, 40))), alone)
    hidden = Track(3, Box(110, 80, 20, 40), reported=False)
    assert np.array_equal(drawn({"a": near}, hidden), alone)


def test_several_paths_have_their_names() -> None:
    one, two = drawn({"a": LEVEL}), blank()
    draw_paths(two, Paths({"a": LEVEL, "b": Path([(20, 200), (300, 200)])}))
    assert (two[:100] != one[:100]).any()
    assert inked(two)[200, 21:300].mean() > 0.9


def test_without_paths_the_scene_says_so() -> None:
    scene = PathRenderer().annotate(blank(), result_of(blank()))
    assert scene[220:].any() and not scene[:200].any()


def test_the_view_has_paths_and_boxes() -> None:
    frame = blank()
    result = result_of(frame, 0, Track(3, Box(110, 130, 20, 40)))
    paths = Paths({"a": LEVEL})
    expected = PathRenderer(paths).annotate(blank(), result)
    shown = Views(["path"], paths=paths)(frame, result)
    assert np.array_equal(shown[60:110], expected[60:110])
    assert (shown[131:169, 110] == color_of_id(3)).all()


@pytest.mark.parametrize("shape", [(1, 1, 3), (16, 16, 3), (17, 90, 3)])
def test_any_picture_and_any_path_can_be_drawn(shape: tuple[int, ...]) -> None:
    scene = np.zeros(shape, np.uint8)
    far = Path([(-1e6, 5), (1e6, 7), (3, 1e6)], closed=True, kind="curve")
    draw_paths(scene, Paths({"far": far, "small": Path([(3, 3), (3.00001, 3)])}))
    track = Track(1, Box(1e8, -1e8, 5, 5))
    PathRenderer(Paths({"far": far})).annotate(scene, result_of(scene, 0, track))
    assert scene.shape == shape
