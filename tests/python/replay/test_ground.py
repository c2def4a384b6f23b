# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From pixels to the ground: exact at the four points, true to a camera between them."""

import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from survtrack.errors import InputError
from survtrack.replay import GroundMap, read_ground

IMAGE = [[100, 400], [540, 400], [380, 200], [260, 200]]
GROUND = [[0, 0], [4, 0], [4, 20], [0, 20]]


def test_the_four_points_are_met_exactly() -> None:
    ground = GroundMap.of_points(IMAGE, GROUND)
    assert np.allclose(ground.to_ground(IMAGE), GROUND, atol=1e-9)


def test_it_is_the_homography_of_opencv() -> None:
    matrix = cv2.getPerspectiveTransform(np.float32(IMAGE), np.float32(GROUND))
    points = np.random.default_rng(1).uniform((100, 210), (540, 470), (50, 2))
    wanted = cv2.perspectiveTransform(points[:, np.newaxis], matrix)[:, 0]
    assert np.allclose(GroundMap.of_points(IMAGE, GROUND).to_ground(points), wanted, atol=1e-4)


def test_beyond_the_horizon_there_is_no_ground() -> None:
    # The sides x = 0 and x = 4 meet at (320, 400 - 200 * 440 / 320): the horizon.
    ground = GroundMap.of_points(IMAGE, GROUND)
    horizon_y = 400 - 200 * 440 / 320
    assert np.isfinite(ground.to_ground([[320, horizon_y + 1]])).all()
    assert np.isnan(ground.to_ground([[320, horizon_y - 1], [10, 0]])).all()
    assert np.isfinite(ground.to_ground([[320, 1e9]])).all()


def test_a_covariance_is_that_of_many_points() -> None:
    ground = GroundMap.of_points(IMAGE, GROUND)
    covariance = np.array([[4.0, 1.0], [1.0, 2.0]])
    points = np.random.default_rng(2).multivariate_normal((300, 350), covariance, 200_000)
    measured = np.cov(ground.to_ground(points).T)
    predicted = ground.spread_on_ground((300.0, 350.0), covariance)
    assert np.allclose(predicted, measured, rtol=0.03, atol=1e-4)


def test_pixels_are_their_own_plan() -> None:
    ground = GroundMap.of_pixels(640, 480)
    assert (ground.unit, ground.y_up) == ("px", False)
    assert np.allclose(ground.to_ground([[12.5, 470], [-30, 900]]), [[12.5, 470], [-30, 900]])


@given(st.lists(st.tuples(st.floats(-1e9, 1e9), st.floats(-1e9, 1e9)), min_size=4, max_size=4))
def test_any_four_points_give_a_map_or_are_refused(points: Any) -> None:
    try:
        ground = GroundMap.of_points(points, GROUND)
    except InputError:
        return
    extent = np.ptp(np.array(points), axis=0).max()
    assert np.allclose(ground.to_ground(points), GROUND, atol=1e-3), extent


def test_any_point_has_a_place_or_none() -> None:
    ground = GroundMap.of_points(IMAGE, GROUND)
    places = ground.to_ground([[1e300, -1e300], [1e308, 1e308], [-1e308, 0], [0, -1e308]])
    assert (np.isnan(places) | np.isfinite(places)).all()


@pytest.mark.parametrize(
    ("image", "words"),
    [
        ([[0, 0], [1, 0], [2, 0], [0, 1]], '"image_points" has three points on a line'),
        ([[0, 0], [0, 0], [2, 0], [0, 1]], '"image_points" has three points on a line'),
        ([[5, 5]] * 4, '"image_points" has three points on a line'),
        ([[0, 0], [1, 0], [2, 0]], '"image_points" must be four points'),
        ([[0, 0], [1, 0], [2, 0], [0]], '"image_points" must be four points'),
        ([[0, 0], [1, 0], [0, 1], [1, float("nan")]], '"image_points" must be four points'),
        ([[0, 0], [1, 0], [0, 1], [1, 1e10]], '"image_points" must be four points'),
        ([[0, 0], [1, 0], [0, 1], [1, "x"]], '"image_points" must be four points'),
        ("points", '"image_points" must be four points'),
        (None, '"image_points" must be four points'),
        ([IMAGE[0], IMAGE[2], IMAGE[1], IMAGE[3]], "do not go round in the same order"),
    ],
)
def test_points_that_make_no_map_are_named(image: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        GroundMap.of_points(image, GROUND)


def test_a_unit_is_a_short_word() -> None:
    for unit in ("", "a" * 13, 5):
        with pytest.raises(InputError, match='"unit" is'):
            GroundMap.of_points(IMAGE, GROUND, unit)  # type: ignore[arg-type]


def test_a_file(tmp_path: Path) -> None:
    path = tmp_path / "ground.json"
    path.write_text(json.dumps({"image_points": IMAGE, "ground_points": GROUND}))
    assert (read_ground(path).unit, read_ground(path).y_up) == ("m", True)
    said = {"image_points": IMAGE, "ground_points": GROUND, "unit": "ft"}
    path.write_text(json.dumps(said))
    assert read_ground(path).unit == "ft"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "is not JSON"),
        ("[" * 100_000, "is not JSON"),
        ("[]", "expected an object with image_points, ground_points, unit"),
        ('{"image_points": []}', "expected an object with"),
        ('{"image_points": [], "ground_points": [], "units": "m"}', "expected an object with"),
        ('{"image_points": [], "ground_points": []}', '"image_points" must be four points'),
        ("\udcff", "is not UTF-8 text"),
    ],
)
def test_files_that_are_none_are_named(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "ground.json"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(InputError, match=words) as caught:
        read_ground(path)
    assert str(caught.value).startswith(f"{path}: ")
