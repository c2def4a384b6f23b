# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Beliefs, velocity factors and densities one by one: published numbers, and any numbers."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from numpy.typing import NDArray

from survtrack import (
    Density,
    InputError,
    falling_velocity_factor,
    order_free_beliefs,
    published_beliefs,
    velocity_factor,
)

Row = NDArray[np.float64]
Rule = Callable[[Any], Row]
RULES = [order_free_beliefs, published_beliefs]
VELOCITY = 0.86 / 0.70
RATIOS = st.one_of(
    st.sampled_from([0.0, 1e-300, 1e-12, 0.1, 1.0, 10.0, 1e6, 1e60]), st.floats(0, 1e60)
)
EVIDENCE = st.integers(0, 12).flatmap(lambda blobs: arrays(float, (blobs, 4), elements=RATIOS))


def seen(color: float, position: float = 1.0, velocity: float = 1.0) -> list[list[float]]:
    """What the first of two blobs has shown; the other shows nothing."""
    return [[color, position, 1, velocity], [1, 1, 1, 1]]


@pytest.mark.parametrize(
    ("evidence", "printed"),
    [
        (seen(1.0), [0.33, 0.33, 0.33]),
        (seen(2.0), [0.50, 0.25, 0.25]),
        (seen(2.0, 7 / 3), [0.70, 0.15, 0.15]),
        (seen(2.0, 7 / 3, VELOCITY), [0.86, 0.07, 0.07]),
    ],
)
def test_published_beliefs_are_those_of_figure_8_7(
    evidence: list[list[float]], printed: list[float]
) -> None:
    assert published_beliefs(evidence) == pytest.approx(np.array(printed), abs=0.005)


def test_order_free_beliefs_put_the_velocity_factor_on_the_odds() -> None:
    needed = (0.86 / 0.14) / (0.70 / 0.30)
    assert order_free_beliefs(seen(2, 7 / 3, needed)) == pytest.approx(
        np.array([0.86, 0.07, 0.07]), abs=0.005
    )
    assert order_free_beliefs(seen(2, 7 / 3, VELOCITY))[0] < 0.75


@given(EVIDENCE)
def test_order_free_beliefs_are_the_closed_form(evidence: Row) -> None:
    products = evidence.prod(axis=1)
    expected = np.append(products, 1.0) / (1 + products.sum())
    assert order_free_beliefs(evidence) == pytest.approx(expected, rel=1e-9, abs=1e-300)


@pytest.mark.parametrize("rule", RULES)
@given(evidence=EVIDENCE)
def test_a_row_is_probabilities_whatever_the_evidence(rule: Rule, evidence: Row) -> None:
    row = rule(evidence)
    assert row.shape == (len(evidence) + 1,) and row.dtype == np.float64
    assert ((row >= 0) & (row <= 1)).all()  # and none is a NaN
    assert row.sum() == pytest.approx(1, abs=1e-9)


@given(EVIDENCE, st.randoms(use_true_random=False))
def test_the_order_of_blobs_does_not_matter_to_the_order_free_rule(
    evidence: Row, random: Any
) -> None:
    order = list(range(len(evidence)))
    random.shuffle(order)
    row, mixed = order_free_beliefs(evidence), order_free_beliefs(evidence[order])
    assert mixed == pytest.approx(row[[*order, len(order)]], rel=1e-9, abs=1e-300)


def test_the_order_of_blobs_matters_to_the_published_rule_through_velocity() -> None:
    evidence = np.array([[3.0, 2, 1, 1], [2, 4, 1, 1]])
    assert published_beliefs(evidence)[0] == pytest.approx(published_beliefs(evidence[::-1])[1])
    evidence[0, 3] = 1.5
    assert abs(published_beliefs(evidence)[0] - published_beliefs(evidence[::-1])[1]) > 0.01


@pytest.mark.parametrize("rule", RULES)
def test_evidence_of_any_layout(rule: Rule) -> None:
    evidence = np.array([[2, 3, 1, 1], [1, 1, 4, 2]])
    expected = rule(evidence.astype(float)).tolist()
    for laid in (evidence, evidence.astype(np.uint8), np.asfortranarray(evidence)):
        assert rule(laid).tolist() == expected
    assert rule(np.repeat(evidence, 2, axis=0)[::2].tolist()).tolist() == expected
    assert rule(np.empty((0, 4))).tolist() == [1.0]


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(
    ("evidence", "message"),
    [
        ([1.0, 1, 1, 1], r"evidence: has the shape \(4,\); expected \(blobs, 4\)"),
        (np.ones((2, 3)), r"evidence: has the shape \(2, 3\)"),
        (np.ones((1, 2, 4)), r"evidence: has the shape \(1, 2, 4\)"),
        (1.0, r"evidence: has the shape \(\)"),
        ([[1, 1, 1, 1], [1, math.nan, 1, 1]], r"evidence\[1, 1\]: is nan; expected a ratio"),
        ([[1, 1, 1, -0.1]], r"evidence\[0, 3\]: is -0.1"),
        ([[math.inf, 1, 1, 1]], r"evidence\[0, 0\]: is inf"),
        ([[1e61, 1, 1, 1]], r"evidence\[0, 0\]: is 1e\+61"),
    ],
)
def test_evidence_that_is_wrong_is_named(rule: Rule, evidence: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        rule(evidence)


def test_velocity_factors_are_those_of_the_figures() -> None:
    # Narayana 2007, fig. 8.6 and 4.12.
    assert falling_velocity_factor([0, 6, 12, 100], 12) == pytest.approx([2, 1.1, 0.2, 0.2])
    assert velocity_factor([0, 6, 12, 1e300], 12) == pytest.approx([0.5, 1 / 1.1, 5, 5])
    assert float(velocity_factor(6, 12)) == pytest.approx(1 / 1.1)


@given(
    arrays(float, array_shapes(min_dims=0, min_side=0), elements=st.floats(0, 1e300)),
    st.floats(1e-100, 1e100),
)
def test_velocity_factors_keep_shape_and_range(differences: Row, break_point: float) -> None:
    falling = falling_velocity_factor(differences, break_point)
    rising = velocity_factor(differences, break_point)
    assert falling.shape == rising.shape == differences.shape
    assert ((falling >= 0.2 - 1e-12) & (falling <= 2)).all()
    assert ((rising >= 0.5) & (rising <= 5 + 1e-9)).all()
    assert falling * rising == pytest.approx(np.ones(differences.shape))


@pytest.mark.parametrize("factor", [velocity_factor, falling_velocity_factor])
@pytest.mark.parametrize(
    ("difference", "break_point", "message"),
    [
        ([[1, math.nan]], 12, r"difference\[0, 1\]: is nan; expected a number between 0 and 1e300"),
        (-1, 12, "difference: is -1.0"),
        ([math.inf], 12, r"difference\[0\]: is inf"),
        ([1], 0, "break_point: is 0.0; expected a number between 1e-100 and 1e100"),
        ([1], math.nan, "break_point: is nan"),
        ([1], -3, "break_point: is -3.0"),
    ],
)
def test_arguments_of_velocity_factors_that_are_wrong_are_named(
    factor: Callable[[Any, float], Row], difference: Any, break_point: float, message: str
) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        factor(difference, break_point)


def stairs() -> Density:
    """Five bins of width 2, with the middles -4, -2, 0, 2, 4, and the integral 1."""
    return Density.from_values(5, [0.05, 0.1, 0.2, 0.1, 0.05])


def test_a_density_is_linear_between_the_middles_of_its_bins() -> None:
    assert stairs()([-4, -3.5, -2, 0, 1]) == pytest.approx([0.25, 0.3125, 0.5, 1, 0.75])
    assert stairs()([[-1e300, 99]]) == pytest.approx(np.array([[0.25, 0.25]]))
    assert float(stairs()(2)) == pytest.approx(0.5)
    assert stairs().range == 5
    assert stairs().values == pytest.approx([0.05, 0.1, 0.2, 0.1, 0.05])
    assert stairs().relative == pytest.approx([0.25, 0.5, 1, 0.5, 0.25])


def test_the_exponential_falls_by_one_eth_every_scale() -> None:
    density = Density.two_sided_exponential(255, 15)
    differences = np.array([-45.0, -15, 0, 15, 30, 60])
    assert density(differences) == pytest.approx(np.exp(-np.abs(differences) / 15), rel=0.01)
    assert len(density.values) == 401
    assert density.values.sum() * 2 * 255 / 401 == pytest.approx(1)


@given(
    st.floats(1e-100, 1e100),
    st.floats(1e-100, 1e100),
    arrays(float, array_shapes(min_dims=0, min_side=0), elements=st.floats(-1e300, 1e300)),
)
def test_densities_keep_shape_and_range(scale: float, reach: float, differences: Row) -> None:
    values = Density.two_sided_exponential(reach, scale)(differences)
    assert values.shape == differences.shape
    assert ((values >= 0) & (values <= 1)).all()


@given(st.floats(1e-100, 1e100), st.floats(1e-100, 1e100))
def test_a_density_survives_its_own_table(scale: float, reach: float) -> None:
    density = Density.two_sided_exponential(reach, scale)
    again = Density.from_values(density.range, density.values)
    assert again.relative == pytest.approx(density.relative)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Density.two_sided_exponential(0, 1), "range: is 0.0"),
        (lambda: Density.two_sided_exponential(1, math.inf), "scale: is inf"),
        (lambda: Density.two_sided_exponential(math.nan, 1), "range: is nan"),
        (lambda: Density.from_values(5, [[0.1, 0.1, 0.1]]), "values: has 2 dimensions; expected 1"),
        (lambda: Density.from_values(5, [0.1, 0.1]), "Density.values: are 2; expected at least 3"),
        (lambda: Density.from_values(5, [0, 0, 0]), "Density.values: have no mass"),
        (lambda: Density.from_values(5, [0.1, -1, 0.1]), r"Density.values\[1\]: is "),
        (lambda: Density.from_values(5, [0.1, math.nan, 0.1]), r"Density.values\[1\]: is "),
        (lambda: Density.from_values(-5, [0.1, 0.1, 0.1]), "Density.range: is "),
        (lambda: Density.from_values(5, [1, 1, 1]), "Density.values: the integral .* is 10; exp"),
        (lambda: stairs()([0, math.nan]), r"difference\[1\]: is nan; expected a number within"),
    ],
)
def test_densities_that_are_wrong_are_named(make: Callable[[], Any], message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        make()
