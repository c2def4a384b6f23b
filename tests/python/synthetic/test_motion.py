# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Ways, paces and the camera, against hand-worked numbers and difference quotients."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from worlds import quick

from survtrack.errors import UsageError
from survtrack.scenes import Pace, Path, oval, steady, surging, weave
from survtrack.scenes.perspective import Perspective

STEP = 1e-4
coordinates = st.floats(-100, 400)
pieces = st.tuples(st.floats(20, 200), st.floats(-300, 300))
paths = st.builds(
    Path,
    st.tuples(coordinates, coordinates),
    st.floats(-360, 360),
    st.lists(pieces, max_size=4).map(tuple),
)
distances = st.lists(st.floats(-200, 1000), min_size=1, max_size=9).map(np.array)


@st.composite
def paces(draw: st.DrawFn) -> Pace:
    gaps = draw(st.lists(st.floats(0.1, 3), min_size=1, max_size=5))
    speeds = draw(st.lists(st.floats(-100, 100), min_size=len(gaps), max_size=len(gaps)))
    return Pace(tuple(np.cumsum(gaps).tolist()), tuple(speeds))


@quick
@given(paths, distances)
def test_a_step_on_the_way_is_as_long_as_it_says_and_leads_ahead(
    path: Path, along: np.ndarray
) -> None:
    before, _ = path.locate(along - STEP)
    after, _ = path.locate(along + STEP)
    _, ahead = path.locate(along)
    assert np.allclose((after - before) / (2 * STEP), ahead, atol=1e-3)
    assert np.allclose(np.hypot(*ahead.T), 1)


def test_a_quarter_circle_by_hand() -> None:
    path = Path((10, 20), 0, ((50 * pi, 90),))
    points, ahead = path.locate(np.array([-10, 0, 50 * pi / 3, 50 * pi, 50 * pi + 7]))
    # Radius 100 about (10, 120), clockwise; 30 degrees on after a third.
    third = (10 + 50, 120 - 100 * np.sqrt(3) / 2)
    assert np.allclose(points, [(0, 20), (10, 20), third, (110, 120), (110, 127)])
    assert np.allclose(ahead[-1], (0, 1))


def test_an_oval_by_hand() -> None:
    track = oval((100, 50), 80, 40)
    assert track.length_px == pytest.approx(2 * 40 + 40 * pi)
    lap = track.length_px
    quarter = 20 + 10 * pi  # the rightmost point
    points, ahead = track.locate(np.array([0, quarter, lap / 2, lap, -lap / 2, 3 * lap + quarter]))
    top, right, bottom = (100, 30), (140, 50), (100, 70)
    assert np.allclose(points, [top, right, bottom, top, bottom, right])
    assert np.allclose(ahead, [(1, 0), (0, 1), (-1, 0), (1, 0), (-1, 0), (0, 1)])


@quick
@given(st.floats(-180, 180), st.floats(10, 100), st.integers(1, 5))
def test_a_weaving_way_comes_back_to_its_line(turn: float, leg: float, legs: int) -> None:
    path = weave((5, 60), 0, turn, leg, leg * legs * 0.999)
    points, ahead = path.locate(np.arange(legs + 1) * leg)
    assert np.allclose(points[:, 1], 60)
    headings = np.degrees(np.arctan2(ahead[:, 1], ahead[:, 0]))
    assert np.allclose(np.abs(headings), abs(turn) / 2)


@quick
@given(paces(), st.lists(st.floats(-5, 20), min_size=2, max_size=8))
def test_distance_is_the_integral_of_speed(pace: Pace, times: list[float]) -> None:
    # Trapezoids are exact for straight lines, when their ends are among the points.
    grid = np.unique([*times, *pace.times_s])
    speeds, gone = pace.speeds(grid), pace.distances(grid)
    assert np.allclose(np.diff(gone), np.diff(grid) * (speeds[1:] + speeds[:-1]) / 2)
    assert pace.distances(np.array(pace.times_s))[0] == 0


def test_paces_by_hand() -> None:
    assert steady(30, 2).distances(np.array([0.0, 2, 5])).tolist() == [-60, 0, 90]
    brake = Pace((0, 2, 4), (10, 10, 0))
    assert brake.distances(np.array([2.0, 3, 4, 9])).tolist() == [20, 27.5, 30, 30]
    wave = surging(60, 0.5, 4, from_s=1, until_s=9)
    assert wave.speeds(np.array([1.0, 2, 3, 4, 5, 9])).tolist() == [60, 90, 60, 30, 60, 60]
    assert wave.distances(np.array([5.0, 9])).tolist() == [240, 480]


def test_the_camera_by_hand() -> None:
    camera = Perspective((320, 240), 0.5)
    ground = np.array([(160.0, 0.0), (260, 120), (260, 240)])
    view = camera.view(ground, np.zeros((3, 2)))
    # Halfway on the ground: 0.5 / (1 - 0.5 / 2) = 2/3.
    assert np.allclose(view.scales, [0.5, 2 / 3, 1])
    assert np.allclose(view.positions, [(160, 0), (160 + 200 / 3, 80), (260, 240)])


@quick
@given(st.floats(0.1, 1), coordinates, st.floats(-200, 240), st.floats(-1, 1), st.floats(-1, 1))
def test_the_camera_keeps_lines_straight_and_knows_velocities(
    far_scale: float, x: float, y: float, right: float, down: float
) -> None:
    camera = Perspective((320, 240), far_scale)
    velocity = np.array([(right, down)])
    line = np.array([(x, y)]) + np.array([(-STEP,), (0,), (STEP,)]) * velocity
    view = camera.view(line, np.repeat(velocity, 3, axis=0))
    quotient = (view.positions[2] - view.positions[0]) / (2 * STEP)
    assert np.allclose(quotient, view.velocities_px_per_s[1], rtol=1e-4, atol=1e-5)
    far = camera.view(line[1] + np.array([(0,), (-3,), (-9,)]) * velocity, np.zeros((3, 2)))
    (ax, ay), (bx, by) = far.positions[1:] - far.positions[0]
    assert ax * by - ay * bx == pytest.approx(0, abs=1e-6)


def test_without_perspective_all_is_as_on_the_ground() -> None:
    points = np.array([(-500.0, -300.0), (17.25, 3.5), (1000, 5000)])
    view = Perspective((320, 240)).view(points, points)
    assert view.in_front.all()
    assert np.array_equal(view.velocities_px_per_s, points)
    assert np.allclose(view.positions, points)


def test_what_is_behind_the_camera_is_not_in_front() -> None:
    ground = np.array([(160.0, y) for y in (0, 240, 400, 479, 480, 481, 9999)])
    view = Perspective((320, 240), 0.5).view(ground, ground)
    assert view.in_front.tolist() == [True, True, True, False, False, False, False]
    assert np.isfinite(view.positions).all()


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Path((0, 0), 0, ((0, 90),)), "length_px: 0 is not allowed; above 0"),
        (lambda: Path((0, float("inf"))), "start y: inf"),
        (lambda: Path((0, 0), 0, ((100, 180),), closed=True), "not closed: it ends 63.662 px"),
        (lambda: Path((0, 0), closed=True), "not closed"),
        (lambda: oval((0, 0), 30, 40), "oval: width_px: 30 is not allowed; above 40"),
        (lambda: weave((0, 0), 0, 90, 0, 10), "leg_px: 0"),
        (lambda: weave((0, 0), 0, 90, 1e-9, 1e9), "number of legs"),
        (lambda: Pace((), ()), "0 times and 0 speeds"),
        (lambda: Pace((0, 1), (5,)), "2 times and 1 speeds"),
        (lambda: Pace((1, 1), (5, 5)), "must rise"),
        (lambda: surging(60, 1.5, 4, 0, 9), "swing: 1.5"),
        (lambda: surging(60, 0.5, 0, 0, 9), "period_s: 0"),
        (lambda: steady(float("nan")), "speeds_px_per_s: nan"),
    ],
)
def test_ways_and_paces_that_are_none(make, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        make()
