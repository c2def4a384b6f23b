# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Path coordinates: to the path and back, in Python."""

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import survtrack
from streets import EAST, history_of
from survtrack import InputError, Path, Paths
from survtrack.offline import paths_of
from survtrack.path_file import foot_of, read_paths, require_frame_size

settings.register_profile("survtrack", deadline=None, derandomize=True, max_examples=200)
settings.load_profile("survtrack")

SQUARE = [(0, 0), (100, 0), (100, 100), (0, 100)]
KINDS = st.sampled_from(["line", "curve"])
NUMBERS = st.floats(-1e3, 1e3)


@st.composite
def paths(draw: Any) -> Path:
    """A path round (0, 0), 50 to 100 px from it, open or closed."""
    radii = np.array(draw(st.lists(st.floats(50, 100), min_size=8, max_size=40)))
    angles = 2 * np.pi * np.arange(len(radii)) / len(radii)
    points = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    return Path(points, draw(st.booleans()), kind=draw(KINDS))


def test_a_square_by_hand() -> None:
    path = Path(SQUARE, closed=True)
    assert (path.closed, path.kind, path.length_px) == (True, "line", 400)
    assert path.max_distance_px is None
    assert np.array_equal(path.points, SQUARE)
    places = path.to_path([(50, 10), (50, -10), (110, 50), (103, -4)])
    assert np.allclose(places, [(50, 10), (50, -10), (150, -10), (100, -5)], atol=1e-12)
    assert np.allclose(path.to_image([(450, 5), (-50, -5)]), [(50, 5), (-5, 50)], atol=1e-12)
    assert np.array_equal(path.tangents([50, 150]), [(1, 0), (0, 1)])
    assert np.array_equal(path.normals([50, 150]), [(0, 1), (-1, 0)])
    assert np.allclose(path.velocities([(110, 50)], [(3, 4)]), [(4, -3)])
    assert path.wrap(-30) == 370 and path.residual(10, 390) == 20
    assert np.array_equal(path.residual(np.array([10, 390]), np.array([390, 10])), [20, -20])


def test_the_published_wrap() -> None:
    """O'Malley 2000: measured 277, state 2, length 278.586; the listing has +553.6."""
    track = Path([(0, 0), (100, 0), (100, 39.293), (0, 39.293)], closed=True)
    assert track.length_px == pytest.approx(278.586, abs=1e-9)
    assert track.residual(277, 2) == pytest.approx(-3.586, abs=1e-9)


@given(paths(), NUMBERS, NUMBERS)
def test_there_and_back_is_the_same_place(path: Path, x: float, y: float) -> None:
    place = path.to_path([(x, y)])
    assert np.isfinite(place).all()
    if path.closed:
        assert 0 <= place[0, 0] < path.length_px
    s = place[0, 0]
    before, after = path.tangents([s - 1e-7, s + 1e-7])
    at_corner = path.kind == "line" and np.abs(after - before).max() > 1e-9
    growth = path.velocities([(x, y)], path.tangents([s]))[0, 0]
    if (
        not at_corner and growth < 20
    ):  # a position abreast of a leg, and not at a centre of curvature
        assert np.abs(path.to_image(place) - (x, y)).max() < 1e-9


@given(paths(), st.floats(-1e4, 1e4))
def test_on_the_path_it_is_exact(path: Path, s: float) -> None:
    place = path.to_path(path.to_image([(path.wrap(s), 0)]))[0]
    if path.closed or 0 <= s <= path.length_px:
        assert abs(path.residual(place[0], s)) < 1e-9
        assert abs(place[1]) < 1e-9


@given(paths(), st.lists(st.tuples(NUMBERS, NUMBERS), min_size=1, max_size=20))
def test_no_sample_of_the_path_is_nearer(path: Path, points: list[tuple[float, float]]) -> None:
    samples = path.to_image([(s, 0) for s in np.linspace(0, path.length_px, 500)])
    s = path.to_path(points)[:, 0]
    on_path = s if path.closed else np.clip(s, 0, path.length_px)
    feet = path.to_image(np.column_stack([on_path, np.zeros_like(s)]))
    gaps = np.hypot(*(np.array(points)[:, np.newaxis] - samples).transpose(2, 0, 1)).min(axis=1)
    assert (np.hypot(*(feet - points).T) <= gaps + 1e-6).all()


@given(paths(), NUMBERS, NUMBERS)
def test_residuals_wrap(path: Path, measured: float, predicted: float) -> None:
    residual = path.residual(measured, predicted)
    if not path.closed:
        assert residual == measured - predicted
        return
    half = path.length_px / 2
    assert -half <= residual <= half
    laps = (measured - predicted - residual) / path.length_px
    assert laps == pytest.approx(round(laps), abs=1e-9)


def test_far_off_is_nan() -> None:
    path = Path([(0, 0), (100, 0)], max_distance_px=20)
    places = path.to_path([(50, 20), (50, 21)])
    assert np.allclose(places[0], (50, 20), atol=1e-12) and np.isnan(places[1]).all()
    assert np.isnan(path.velocities([(50, 21)], [(1, 1)])).all()


def test_arrays_of_any_kind_and_order_are_taken() -> None:
    path = Path(np.array(SQUARE, np.float32)[::-1][::-1], closed=True)
    wide = np.zeros((6, 4), np.int32)
    wide[:, 1] = 10
    assert np.array_equal(path.to_path(wide[::2, :2]), path.to_path([(0, 10)] * 3))
    assert path.to_path([]).shape == (0, 2)
    assert path.to_path(np.empty((0, 2))).shape == (0, 2)


@pytest.mark.parametrize(
    ("points", "closed", "message"),
    [
        ([], False, r"points: has 0; expected 2 to 2000"),
        ([(1, 1)], False, r"points: has 1; expected 2"),
        ([(1, 1), (2, 2)], True, r"points: has 2; expected 3"),
        ([(0, 0), (np.nan, 1)], False, r"points\[1\]: is \(nan, 1\)"),
        ([(0, 0), (0, 0)], False, r"points\[1\]: \(0, 0\) is the same as points\[0\]"),
        ([(0, 0), (9, 9), (9, 0), (0, 9)], False, r"meets itself near \(4.5, 4.5\)"),
        ([1, 2], False, r"points: expected Nx2 numbers, not an array of shape \(2,\)"),
        ([(1, 2, 3)], False, r"points: expected Nx2 numbers"),
        ("ab", False, r"points: expected Nx2 numbers"),
        ([("a", "b")], False, r"points: expected Nx2 numbers"),
    ],
)
def test_what_is_no_path_is_named(points: Any, closed: bool, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Path(points, closed)


def test_other_bad_values_are_named() -> None:
    path = Path(SQUARE)
    with pytest.raises(InputError, match='kind: "bow" is not allowed; expected line or curve'):
        Path(SQUARE, kind="bow")
    with pytest.raises(InputError, match="max_distance_px: is -1"):
        Path(SQUARE, max_distance_px=-1)
    with pytest.raises(InputError, match=r"points\[1\]: is \(inf, 0\)"):
        path.to_path([(0, 0), (np.inf, 0)])
    with pytest.raises(InputError, match=r"places\[0\]: is \(nan, 0\)"):
        path.to_image([(np.nan, 0)])
    with pytest.raises(InputError, match="velocities_px_per_s: has 2 rows; expected 1"):
        path.velocities([(0, 0)], [(1, 1), (2, 2)])
    with pytest.raises(InputError, match="s_px"):
        path.residual(np.nan, 0)
    with pytest.raises(InputError, match="s_px: expected a list of numbers"):
        path.tangents([[1, 2]])


def test_a_path_of_a_pattern() -> None:
    patterns = survtrack.learn_patterns(history_of([EAST] * 3))
    path = Path.from_pattern(patterns.patterns[0], max_distance_px=60)
    assert not path.closed and path.kind == "curve" and path.max_distance_px == 60
    assert np.array_equal(path.points, patterns.patterns[0].way)
    assert np.allclose(path.to_path([(140, 230)]), [(100, 30)], atol=1e-6)
    straight = Path.from_pattern(patterns.patterns[0], kind="line")
    assert (straight.kind, straight.max_distance_px) == ("line", None)


def test_ways_that_are_no_path_are_said() -> None:
    straight = survtrack.learn_patterns(history_of([EAST] * 3), survtrack.PatternOptions(points=4))
    learned = json.loads(straight.to_json())
    learned["patterns"].append({**learned["patterns"][0], "id": 2})
    learned["patterns"][1]["way"] = [[0, 0], [90, 90], [90, 0], [0, 90]]
    paths, refused = paths_of(survtrack.Patterns.from_json(json.dumps(learned)))
    assert paths.names == ["pattern 1"]
    assert paths["pattern 1"].max_distance_px == pytest.approx(1.5 * 40)  # object sizes of 40 px
    assert list(refused) == [2] and "the path meets itself near" in refused[2]


def test_paths_by_name_are_saved_and_loaded(tmp_path: Any) -> None:
    given_paths = {"lane": Path([(0, 5), (9, 7)]), "ring": Path(SQUARE, True, kind="curve")}
    named = Paths(given_paths, frame_size=(640, 480))
    assert named.names == ["lane", "ring"] and len(named) == 2 and "ring" in named
    assert named["ring"] == given_paths["ring"] != named["lane"]
    assert (named.frame_size, Paths({}).frame_size) == ((640, 480), None)
    file = tmp_path / "paths.json"
    file.write_text(named.to_json())
    assert read_paths(file) == named
    assert json.loads(named.to_json())["paths"][1]["closed"] is True
    assert Path.from_json(named["ring"].to_json()) == named["ring"]
    with pytest.raises(KeyError, match='no path "road"; there are: lane, ring'):
        named["road"]


def test_what_is_wrong_with_a_file_is_named(tmp_path: Any) -> None:
    file = tmp_path / "p.json"
    for text, message in (
        ("{", "p.json: is not JSON, at byte 2; expected paths"),
        ('{"paths": []}', r"p.json.paths: is empty; expected at least one path"),
        ('{"paths": [{"name": "a", "points": [[0, 0]]}]}', r"p.json.paths\[0\].points: has 1"),
        ('{"paths": [{"name": "a", "point": []}]}', r'p.json.paths\[0\]: has an unknown entry "po'),
    ):
        file.write_text(text)
        with pytest.raises(InputError, match=message):
            read_paths(file)
    file.write_bytes(b"\xff")
    with pytest.raises(InputError, match=r"p.json: is not UTF-8 text"):
        read_paths(file)
    with pytest.raises(InputError, match=r"none.json: no such file"):
        read_paths(tmp_path / "none.json")
    with pytest.raises(InputError, match="frame_size: \\(0, 5\\) is not allowed"):
        Paths({}, frame_size=(0, 5))
    with pytest.raises(InputError, match="paths: 'a': 3 is not allowed; expected a text and its"):
        Paths({"a": 3})  # type: ignore[dict-item]
    with pytest.raises(InputError, match="p: is for frames of 640x480, the run's are 320x240"):
        require_frame_size(Paths({}, (640, 480)), (320, 240), "p")
    require_frame_size(Paths({}), (320, 240), "p")


def test_a_foot_beyond_the_end_is_the_end() -> None:
    from survtrack.path_file import TrackPlace

    path = Path([(0, 0), (100, 0)])
    assert foot_of(TrackPlace("a", -20, 3, 0, 0), path).tolist() == [0, 0]
    assert foot_of(TrackPlace("a", 120, 3, 0, 0), path).tolist() == [100, 0]
    assert foot_of(TrackPlace("a", 20, 3, 0, 0), path).tolist() == [20, 0]
