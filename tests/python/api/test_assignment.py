# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Assignment: the optimal one against scipy's, the oldest-first one against its definition."""

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

import survtrack
from survtrack import InputError, assign_hungarian, assign_oldest_first, match_matrix

Costs = NDArray[np.float64]
SHAPES = [(1, 1), (1, 7), (7, 1), (5, 5), (6, 9), (9, 6), (40, 40), (60, 25)]
REFUSED = [0.0, 0.3, 0.7, 0.95]


def random_costs(shape: tuple[int, int], refused: float, seed: int) -> Costs:
    random = np.random.default_rng(seed)
    costs = random.normal(0, 10, shape)
    costs[random.random(shape) < refused] = math.inf
    return costs


def pairs(assignment: NDArray[np.int64], costs: Costs) -> list[tuple[int, int]]:
    """The pairs that were made, each index once and none refused."""
    assert assignment.shape == (costs.shape[0],) and assignment.dtype == np.int64
    made = [(row, int(column)) for row, column in enumerate(assignment) if column >= 0]
    assert len({column for _, column in made}) == len(made)
    assert all(np.isfinite(costs[pair]) for pair in made)
    return made


def total(costs: Costs, made: list[tuple[int, int]]) -> float:
    return float(sum(costs[pair] for pair in made))


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("refused", REFUSED)
@pytest.mark.parametrize("seed", range(3))
def test_most_pairs_and_of_those_the_cheapest(
    shape: tuple[int, int], refused: float, seed: int
) -> None:
    costs = random_costs(shape, refused, seed)
    made = pairs(assign_hungarian(costs), costs)
    # In scipy a refused pair costs more than all others together, so that few are taken.
    large = 2 * np.abs(costs[np.isfinite(costs)]).sum() + 1
    rows, columns = linear_sum_assignment(np.where(np.isfinite(costs), costs, large))
    expected = [pair for pair in zip(rows, columns, strict=True) if np.isfinite(costs[pair])]
    assert len(made) == len(expected)
    assert total(costs, made) == pytest.approx(total(costs, expected), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("refused", REFUSED)
@pytest.mark.parametrize("alone", [-5.0, 0.0, 8.0])
def test_a_pair_is_made_only_where_it_lowers_the_total(
    shape: tuple[int, int], refused: float, alone: float
) -> None:
    costs = random_costs(shape, refused, 7)
    made = pairs(assign_hungarian(costs, alone), costs)
    # In scipy each row also has a column of its own, in which it stays alone.
    own = np.full((shape[0], shape[0]), 1e6)
    np.fill_diagonal(own, alone)
    wide = np.hstack([np.where(np.isfinite(costs), costs, 1e6), own])
    expected = wide[linear_sum_assignment(wide)].sum()
    ours = total(costs, made) + alone * (shape[0] - len(made))
    assert ours == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("refused", REFUSED)
def test_the_oldest_takes_its_cheapest_free_column(shape: tuple[int, int], refused: float) -> None:
    costs = random_costs(shape, refused, 11)
    free, expected = costs.copy(), []
    for row in free:
        column = int(np.argmin(row))
        expected.append(column if np.isfinite(row[column]) else -1)
        if expected[-1] >= 0:
            free[:, column] = math.inf
    assert assign_oldest_first(costs).tolist() == expected


def test_of_equal_costs_the_first() -> None:
    assert assign_oldest_first([[1, 1], [1, 1]]).tolist() == [0, 1]
    assert assign_oldest_first([[2, 1], [0, 0]]).tolist() == [1, 0]
    assert assign_hungarian([[2, 1], [0, 9]]).tolist() == [1, 0]


@pytest.mark.parametrize("assign", [assign_hungarian, assign_oldest_first])
def test_empty_and_fully_refused_matrices(assign: Any) -> None:
    assert assign(np.zeros((0, 0))).tolist() == []
    assert assign(np.zeros((0, 3))).tolist() == []
    assert assign(np.zeros((3, 0))).tolist() == [-1, -1, -1]
    assert assign(np.full((3, 2), math.inf)).tolist() == [-1, -1, -1]


@pytest.mark.parametrize("assign", [assign_hungarian, assign_oldest_first])
def test_matrices_of_any_layout(assign: Any) -> None:
    costs = np.array([[4, 1, 3], [2, 0, 5], [3, 2, 2]])
    expected = assign(costs.astype(float)).tolist()
    for laid in (costs, costs.astype(np.int8), np.asfortranarray(costs), costs.tolist()):
        assert assign(laid).tolist() == expected
    assert assign(np.repeat(costs, 2, axis=1)[:, ::2]).tolist() == expected


@pytest.mark.parametrize("assign", [assign_hungarian, assign_oldest_first])
@pytest.mark.parametrize(
    ("costs", "message"),
    [
        ([1.0, 2.0], "costs: has 1 dimensions; expected 2"),
        (np.zeros((1, 1, 1)), "costs: has 3 dimensions"),
        (3.0, "costs: has 0 dimensions"),
        ([[1.0, math.nan]], r"costs\[0, 1\]: is "),
        ([[1.0], [-math.inf]], r"costs\[1, 0\]: is "),
        ([[1e308, 1.0]], r"costs\[0, 0\]: is "),
        ([[-1e308, 1.0]], r"costs\[0, 0\]: is "),
    ],
)
def test_refused_matrices_are_named(assign: Any, costs: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        assign(costs)


@pytest.mark.parametrize("alone", [math.nan, -math.inf])
def test_a_refused_unassigned_cost_is_named(alone: float) -> None:
    with pytest.raises(InputError, match=r"^unassigned_cost: "):
        assign_hungarian([[1.0]], alone)


def test_the_match_matrix_is_distance_plus_colour() -> None:
    tracker = survtrack.Tracker(survtrack.preset("narayana2007"))
    here = survtrack.Detections([[0, 0, 10, 10], [100, 50, 20, 20]], 0.0, frame_size=(200, 100))
    tracks = tracker.process(here).tracks
    there = survtrack.Detections([[60, 0, 10, 10], [0, 40, 10, 10], [0, 0, 10, 10]], 1.0)
    matrix = match_matrix(tracks, list(there), (200, 100))
    assert matrix.shape == (2, 3)
    assert matrix[0] == pytest.approx([60 / 200, 40 / 100, 0.0])
    assert matrix[1] == pytest.approx(
        [math.hypot(45 / 200, 55 / 100), math.hypot(105 / 200, 15 / 100), math.hypot(0.525, 0.55)]
    )
    image = np.zeros((60, 80, 3), np.uint8)
    image[10:20, 10:20] = (51, 102, 153)
    (blob,) = survtrack.find_blobs(image[..., 0], image)
    black = tracks[0]
    (value,) = match_matrix([black], [blob], (200, 100)).ravel()
    place = math.hypot((14.5 - 5) / 200, (14.5 - 5) / 100)
    assert value == pytest.approx(place + math.hypot(51 / 255, 102 / 255, 153 / 255))
    assert match_matrix([], list(there), (200, 100)).shape == (0, 3)
    assert match_matrix(tracks, [], (200, 100)).shape == (2, 0)


@pytest.mark.parametrize("size", [(0, 10), (10, -1), (math.nan, 10), (10, math.inf)])
def test_a_refused_frame_size_is_named(size: tuple[float, float]) -> None:
    with pytest.raises(InputError, match=r"^frame_size: expected a positive width and height"):
        match_matrix([], [], size)
