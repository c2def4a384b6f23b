# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The general Kalman filter, its bank, smoother and noises, against filterpy and scipy."""

import copy
import math
import pickle
import warnings
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats

import survtrack
from survtrack import InputError, KalmanBank, KalmanFilter

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import filterpy.common
    import filterpy.kalman

Array = NDArray[np.float64]
Model = dict[str, Array]
I2 = np.eye(2)


def random_covariance(random: np.random.Generator, n: int) -> Array:
    root = random.normal(size=(n, n))
    return root @ root.T + 0.1 * np.eye(n)


def random_model(random: np.random.Generator, n: int) -> Model:
    """A stable model of n states: no eigenvalue of F is beyond 0.95."""
    m = int(random.integers(1, n + 1))
    F = random.normal(size=(n, n))
    return {
        "F": F * (0.95 / np.abs(np.linalg.eigvals(F)).max()),
        "H": random.normal(size=(m, n)),
        "Q": random_covariance(random, n),
        "R": random_covariance(random, m),
        "x": random.normal(size=n),
        "P": random_covariance(random, n),
        "B": random.normal(size=(n, 2)),
    }


def reference(model: Model) -> Any:
    m, n = model["H"].shape
    other = filterpy.kalman.KalmanFilter(dim_x=n, dim_z=m, dim_u=2)
    for name in "FHQRxPB":
        setattr(other, name, model[name].copy())
    return other


def simulated(model: Model, steps: int, random: np.random.Generator) -> list[Array]:
    """Measurements of a run of the model."""
    n, m = len(model["x"]), len(model["R"])
    x = random.multivariate_normal(model["x"], model["P"])
    measured = []
    for _ in range(steps):
        x = model["F"] @ x + random.multivariate_normal(np.zeros(n), model["Q"])
        measured.append(model["H"] @ x + random.multivariate_normal(np.zeros(m), model["R"]))
    return measured


@pytest.mark.parametrize("n", range(1, 13))
def test_it_is_filterpys_over_random_stable_models(n: int) -> None:
    random = np.random.default_rng(n)
    for _ in range(25):
        model = random_model(random, n)
        ours, other = KalmanFilter(**model), reference(model)
        for z in simulated(model, 12, random):
            u = random.normal(size=2)
            ours.predict(u)
            other.predict(u)
            assert ours.x == pytest.approx(other.x, rel=1e-9, abs=1e-9)
            assert pytest.approx(other.P, rel=1e-9, abs=1e-9) == ours.P
            expected = other.H @ other.P @ other.H.T + other.R
            away = z - other.H @ other.x
            distance = away @ np.linalg.solve(expected, away)
            assert ours.squared_mahalanobis(z) == pytest.approx(distance, rel=1e-8)
            ours.update(z)
            other.update(z)
            for name in "xPyKS":
                value = getattr(other, name)
                assert getattr(ours, name) == pytest.approx(value, rel=1e-9, abs=1e-9), name
            assert ours.nis == pytest.approx(distance, rel=1e-8)
            assert ours.log_likelihood == pytest.approx(other.log_likelihood, rel=1e-9, abs=1e-8)
            assert np.array_equal(ours.P, ours.P.T)


def test_the_smoother_is_filterpys() -> None:
    random = np.random.default_rng(4)
    for n in (1, 3, 6):
        model = random_model(random, n)
        ours, other = KalmanFilter(**model), reference(model)
        states, covariances = [], []
        for z in simulated(model, 30, random):
            ours.predict()
            ours.update(z)
            states.append(ours.x)
            covariances.append(ours.P)
        x, P = survtrack.rts_smooth(np.array(states), np.array(covariances), model["F"], model["Q"])
        expected = other.rts_smoother(np.array(states), np.array(covariances))
        assert x == pytest.approx(expected[0], rel=1e-8, abs=1e-8)
        assert pytest.approx(expected[1], rel=1e-8, abs=1e-8) == P
        every = survtrack.rts_smooth(states, covariances, [model["F"]] * 30, [model["Q"]] * 30)
        assert np.array_equal(every[0], x)


@pytest.mark.parametrize("dim", [2, 3, 4])
def test_the_noises_are_filterpys(dim: int) -> None:
    for dt in (0.04, 1.0, 2.5):
        ours = survtrack.discrete_white_noise(dim, dt, 1.7)
        other = filterpy.common.Q_discrete_white_noise(dim, dt, 1.7)
        assert ours == pytest.approx(other, rel=1e-12)
        ours = survtrack.discrete_white_noise(dim, dt, 1.7, axes=2)
        other = filterpy.common.Q_discrete_white_noise(dim, dt, 1.7, block_size=2)
        assert ours == pytest.approx(other, rel=1e-12)
        by_derivative = survtrack.discrete_white_noise(dim, dt, 1.7, axes=2, order="by_derivative")
        one = survtrack.discrete_white_noise(dim, dt, 1.7)
        assert by_derivative == pytest.approx(np.kron(one, I2), rel=1e-12)
        continuous = survtrack.continuous_white_noise(dim, dt, 1.7)
        other = filterpy.common.Q_continuous_white_noise(dim, dt, 1.7)
        assert continuous == pytest.approx(other, rel=1e-12)


def test_quantiles_are_scipys() -> None:
    for degrees in (1, 2, 3, 10, 200, 100_000):
        for probability in (1e-6, 0.025, 0.5, 0.95, 0.999):
            ours = survtrack.chi_square_quantile(probability, degrees)
            assert ours == pytest.approx(stats.chi2.ppf(probability, degrees), rel=1e-9)
    low, high = survtrack.nis_band(2, 300)
    assert (low * 300, high * 300) == pytest.approx(stats.chi2.interval(0.95, 600), rel=1e-9)


def test_nis_of_matched_models_is_inside_its_band() -> None:
    """95 of 100 runs are expected inside; fewer than 88 would come by chance once in 1000."""
    random = np.random.default_rng(12)
    inside = 0
    for _ in range(100):
        model = random_model(random, int(random.integers(1, 7)))
        ours = KalmanFilter(**model)
        nis = []
        for z in simulated(model, 100, random):
            ours.predict()
            ours.update(z)
            nis.append(ours.nis)
        low, high = survtrack.nis_band(len(model["R"]), 100)
        inside += low < np.mean(nis) < high
    print(f"NIS inside the 95 % band in {inside} of 100 runs")
    assert 88 <= inside < 100


@pytest.mark.parametrize("n", [1, 2, 4, 6, 9])
def test_a_bank_is_as_many_filters(n: int) -> None:
    random = np.random.default_rng(n)
    model = random_model(random, n)
    count, m = 21, len(model["R"])
    states = random.normal(size=(count, n))
    covariances = np.array([random_covariance(random, n) for _ in range(count)])
    shared = {name: model[name] for name in "FHQRB"}
    bank = KalmanBank(**shared, states=states, covariances=covariances)
    filters = [KalmanFilter(**shared, x=x, P=P) for x, P in zip(states, covariances, strict=True)]
    for step in range(15):
        u = random.normal(size=2) if step % 2 else random.normal(size=(count, 2))
        z = random.normal(size=(count, m))
        z[random.random(count) < 0.3] = math.nan
        bank.predict(u)
        distances = bank.squared_mahalanobis(np.zeros((3, m)))
        for slot, one in enumerate(filters):
            one.predict(u if step % 2 else u[slot])
            assert distances[slot, 2] == pytest.approx(one.squared_mahalanobis(np.zeros(m)))
        bank.update(z)
        for slot, one in enumerate(filters):
            missing = math.isnan(z[slot, 0])
            assert np.isnan(bank.innovations[slot]).all() == missing
            assert np.isnan(bank.innovation_covariances[slot]).all() == missing
            if not missing:
                one.update(z[slot])
                assert bank.nis[slot] == pytest.approx(one.nis, rel=1e-8)
                assert bank.log_likelihoods[slot] == pytest.approx(one.log_likelihood, rel=1e-8)
                assert bank.innovations[slot] == pytest.approx(one.y, rel=1e-9, abs=1e-9)
            assert bank.states[slot] == pytest.approx(one.x, rel=1e-9, abs=1e-9)
            assert bank.covariances[slot] == pytest.approx(one.P, rel=1e-9, abs=1e-9)


def cv(**changes: Any) -> KalmanFilter:
    arguments: dict[str, Any] = {
        "F": [[1, 1], [0, 1]],
        "H": [[1, 0]],
        "Q": 0.1 * I2,
        "R": [[2.0]],
        "x": [0, 1],
        "P": I2,
    }
    return KalmanFilter(**(arguments | changes))


def test_a_residual_wraps() -> None:
    def around(z: Array, predicted: Array) -> Array:
        wrapped: Array = survtrack.wrapped_difference(z - predicted, 360.0)
        return wrapped

    ours = cv(x=[359, 0], residual=around)
    ours.update([2])
    assert ours.y == pytest.approx([3]) and 359 < ours.x[0] < 362
    bank = KalmanBank([[1]], [[1]], [[0.1]], [[1]], [[359.0]], [[1.0]], periods=[360])
    bank.update([[2.0]])
    assert bank.innovations.tolist() == [[3.0]]
    assert survtrack.wrapped_difference([-7.0, 0.0, 6.0], 10).tolist() == [3.0, 0.0, -4.0]


def test_copies_and_pickles_go_on_alike() -> None:
    ours = cv(B=[[0.5], [1]])
    bank = KalmanBank([[1, 1], [0, 1]], [[1, 0]], I2, [[1]], np.zeros((3, 2)), I2, periods=[9])
    for one in (ours, bank):
        one.predict()
    ours.update([1.5])
    bank.update([[1.0], [2.0], [math.nan]])
    for again in (copy.copy(ours), copy.deepcopy(ours), pickle.loads(pickle.dumps(ours))):
        assert (again.nis, again.log_likelihood) == (ours.nis, ours.log_likelihood)
        again.predict([2.0])
        assert again.x != pytest.approx(ours.x)
        expected = copy.copy(ours)
        expected.predict([2.0])
        assert np.array_equal(again.x, expected.x) and np.array_equal(again.P, expected.P)
    other = pickle.loads(pickle.dumps(bank))
    assert np.array_equal(other.states, bank.states) and len(other) == 3
    assert np.array_equal(other.covariances, bank.covariances)


def test_slots_of_a_bank_move_down() -> None:
    bank = KalmanBank([[1]], [[1]], [[1]], [[1]])
    assert len(bank) == 0 and bank.states.shape == (0, 1) and bank.covariances.shape == (0, 1, 1)
    bank.predict()
    bank.update(np.zeros((0, 1)))
    assert bank.add([[1.0], [2.0], [3.0]], [[4.0]]) == 0
    assert bank.add([[5.0]], [[[1.0]]]) == 3
    bank.remove(1)
    assert bank.states.ravel().tolist() == [1, 3, 5]
    assert bank.covariances.ravel().tolist() == [4, 4, 1]
    with pytest.raises(InputError, match=r"^P: .* is -1"):
        bank.add([[1.0], [2.0]], [[[1.0]], [[-1.0]]])
    assert len(bank) == 3


PUBLISHED = [[0.2877, 1.1909], [1.1909, 1.1465]]  # Nashenda 2011, 5.1

BAD: dict[str, tuple[Any, str]] = {
    "indefinite R": (
        lambda: cv(H=I2, R=PUBLISHED),
        r"R: is not positive semi-definite, its smallest eigenvalue is -0\.548849",
    ),
    "indefinite Q": (lambda: setattr(cv(), "Q", PUBLISHED), r"Q: .* is -0\.548849"),
    "indefinite P": (lambda: setattr(cv(), "P", PUBLISHED), r"P: .* is -0\.548849"),
    "skew": (lambda: cv(Q=[[1, 0.5], [0, 1]]), r"Q: is not symmetric, \[0, 1\] is 0\.5"),
    "shape of H": (lambda: cv(H=[[1, 0, 0]]), "H: is 1x3; expected 1x2"),
    "shape of R": (lambda: cv(R=I2), "R: is 2x2; expected 1x1"),
    "shape of F": (lambda: cv(F=[1, 2]), "F: has 1 dimensions; expected 2"),
    "nothing": (lambda: cv(x=[]), "x: is empty"),
    "no measurement": (lambda: cv(H=np.zeros((0, 2))), "H: is empty"),
    "inf in F": (lambda: cv(F=[[1, math.inf], [0, 1]]), r"F\[0, 1\]: is inf"),
    "NaN z": (lambda: cv().update([math.nan]), r"z\[0\]: is nan; expected a finite"),
    "long z": (lambda: cv().update([1, 2]), "z: is 2x1; expected 1x1"),
    "u": (lambda: cv().predict([1]), "u: the filter has no B"),
    "singular": (lambda: cv(R=[[0]], P=0 * I2).update([1]), "S: .* singular"),
    "too early": (lambda: cv().nis, "nis: there has been no update yet"),
    "residual": (lambda: cv(residual=lambda z, p: None).update([1]), "residual: returned NoneTy"),
    "residual shape": (lambda: cv(residual=lambda z, p: [1, 2]).update([1]), "residual: is 2x1"),
    "dt 0": (lambda: survtrack.discrete_white_noise(2, 0), "dt: is 0; expected a time above 0"),
    "dt < 0": (lambda: survtrack.discrete_white_noise(2, -1), "dt: is -1"),
    "dt huge": (lambda: survtrack.continuous_white_noise(2, 1e7), "dt: is 1e.07; .* at most 1e6"),
    "dt NaN": (lambda: survtrack.continuous_white_noise(2, math.nan), "dt: is nan"),
    "dt inf": (lambda: survtrack.continuous_white_noise(2, math.inf), "dt: is inf"),
    "dim": (lambda: survtrack.discrete_white_noise(1, 1), "dim: is 1; expected 2, 3 or 4"),
    "order": (lambda: survtrack.discrete_white_noise(2, 1, order="x"), 'order: is "x"'),
    "bank z": (
        lambda: KalmanBank([[1]], [[1]], [[1]], [[1]], [[0.0]], [[1]]).update([[math.inf]]),
        "z: that of filter 0 is neither",
    ),
    "bank shape": (
        lambda: KalmanBank([[1]], [[1]], [[1]], [[1]]).update([[1.0]]),
        "z: is 1x1; expected 1x0",
    ),
    "bank P": (
        lambda: KalmanBank([[1]], [[1]], [[1]], [[1]], [[0.0]], np.ones((2, 1, 1))),
        "covariances: has 2 matrices; expected 1",
    ),
    "period": (
        lambda: KalmanBank([[1]], [[1]], [[1]], [[1]], periods=[-1]),
        "period: is -1",
    ),
    "smoother": (lambda: survtrack.rts_smooth([[1.0]], [I2], I2, I2), r"P\[0\]: is 2x2"),
    "quantile": (lambda: survtrack.chi_square_quantile(1, 2), "probability: is 1"),
}


@pytest.mark.parametrize(("call", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_named(call: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        call()


def test_a_refused_value_changes_nothing() -> None:
    ours = cv()
    ours.predict()
    before = (ours.x, ours.P, ours.Q, ours.F)
    for name, value in (("Q", -I2), ("P", [[1, 2], [2, 1]]), ("F", I2 * math.nan), ("x", [1])):
        with pytest.raises(ValueError, match=f"^{name}"):
            setattr(ours, name, value)
    with pytest.raises(ValueError, match=r"^z"):
        ours.update([math.nan])
    after = (ours.x, ours.P, ours.Q, ours.F)
    assert all(np.array_equal(a, b) for a, b in zip(before, after, strict=True))


def test_published_listings_run_unvalidated() -> None:
    """Nashenda 2011, 5.1.3: R is no covariance, B u as printed; K after the last frame."""
    dt = 0.2685
    F = np.eye(4) + dt * np.eye(4, k=2)
    ours = KalmanFilter(
        F=F,
        H=np.eye(2, 4),
        Q=10 * np.eye(4),
        R=PUBLISHED,
        x=[192, 144, 0, 0],
        P=100 * np.eye(4),
        B=[[0], [0], [0], [8]],
        validate=False,
    )
    for _ in range(121):
        ours.predict([1])
        ours.update([367, 274])
    printed = [[0.9946, -0.0748], [-0.0748, 0.9406], [0.8690, -0.0827], [-0.0827, 0.8093]]
    assert pytest.approx(np.array(printed), abs=0.51e-4) == ours.K
