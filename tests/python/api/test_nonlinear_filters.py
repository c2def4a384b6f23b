# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The filters for non-linear models and for noise that is not Gaussian."""

import copy
import math
import pickle
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from survtrack import (
    ExtendedKalmanFilter,
    InputError,
    KalmanFilter,
    ParticleFilter,
    Random,
    UnscentedKalmanFilter,
    numeric_jacobian,
    systematic_resample,
    wrapped_difference,
)

Array = NDArray[np.float64]
F = np.array([[0.9, 0.3, 0.0], [-0.2, 0.8, 0.1], [0.0, 0.1, 0.7]])
H = np.array([[1.0, 0.0, 0.5], [0.0, 1.0, 0.0]])
LINEAR: dict[str, Any] = {
    "f": lambda x, u=0: F @ x + u,
    "h": lambda x: H @ x,
    "Q": 0.2 * np.eye(3),
    "R": 0.5 * np.eye(2),
    "x": [4, -2, 1],
    "P": 5 * np.eye(3),
}


@pytest.mark.parametrize(
    "ours",
    [
        ExtendedKalmanFilter(**LINEAR),
        ExtendedKalmanFilter(**LINEAR, F=lambda x, u: F, H=lambda x: H),
        UnscentedKalmanFilter(**LINEAR),
        UnscentedKalmanFilter(**LINEAR, alpha=1, beta=0, kappa=0),
    ],
    ids=["numeric EKF", "analytic EKF", "UKF", "wide UKF"],
)
def test_they_are_the_kalman_filter_where_the_model_is_linear(ours: Any) -> None:
    matrices = {name: LINEAR[name] for name in ("Q", "R", "x", "P")}
    other = KalmanFilter(F=F, H=H, B=np.eye(3), **matrices)
    random = np.random.default_rng(2)
    for _ in range(100):
        u, z = random.normal(size=3), random.normal(scale=5, size=2)
        ours.predict(u)
        other.predict(u)
        ours.update(z)
        other.update(z)
        for name in "xPyKS":
            expected = getattr(other, name)
            assert getattr(ours, name) == pytest.approx(expected, rel=1e-9, abs=1e-9), name
        assert ours.nis == pytest.approx(other.nis, rel=1e-7)
        assert ours.mahalanobis(z) == pytest.approx(other.mahalanobis(z), rel=1e-7)


PROCESS_VARIANCE = 10.0
# One measurement of ten is an outlier.
SHARES, VARIANCES = np.array([0.9, 0.1]), np.array([1.0, 100.0])


def growth(x: Array, u: Array) -> Array:
    """The univariate growth model (Gordon, Salmond and Smith 1993); u: the step's number."""
    moved: Array = 0.5 * x + 25 * x / (1 + x * x) + 8 * np.cos(1.2 * u[0])
    return moved


def squared(x: Array) -> Array:
    measured: Array = x * x / 20
    return measured


def heavy_tailed(z: Array, particles: Array) -> Array:
    away = (z[0] - squared(particles[:, 0]))[:, None]
    densities: Array = np.log(
        (SHARES / np.sqrt(VARIANCES) * np.exp(-0.5 * away**2 / VARIANCES)).sum(axis=1)
    )
    return densities


def rms_of_run(seed: int) -> list[float]:
    """Of the extended, the unscented and the particle filter over 60 steps of one run."""
    random = np.random.default_rng(seed)
    start: dict[str, Any] = {"Q": [[PROCESS_VARIANCE]], "x": [0.1], "P": [[5.0]]}
    gaussian: dict[str, Any] = {"f": growth, "h": squared, "R": [[SHARES @ VARIANCES]]}
    filters: list[Any] = [
        ExtendedKalmanFilter(**gaussian, **start),
        UnscentedKalmanFilter(**gaussian, **start, alpha=1, beta=0, kappa=2),
        ParticleFilter(f=growth, log_likelihood=heavy_tailed, **start, count=500, seed=seed),
    ]
    x = random.normal(0.1, math.sqrt(5))
    errors: list[list[float]] = [[], [], []]
    for k in range(1, 61):
        x = float(growth(np.array([x]), np.array([k]))[0])
        x += random.normal(0, math.sqrt(PROCESS_VARIANCE))
        variance = VARIANCES[int(random.random() < SHARES[1])]
        z = x * x / 20 + random.normal(0, math.sqrt(variance))
        for one, its in zip(filters, errors, strict=True):
            one.predict([k])
            one.update([z])
            its.append(one.x[0] - x)
    return [float(np.sqrt(np.mean(np.square(its)))) for its in errors]


def test_where_the_model_is_neither_linear_nor_gaussian() -> None:
    runs = np.array([rms_of_run(seed) for seed in range(100)])
    extended, unscented, particles = np.sqrt((runs**2).mean(axis=0))
    print(f"rms over 100 runs: EKF {extended:.2f}, UKF {unscented:.2f}, particles {particles:.2f}")
    assert particles < 0.8 * unscented and unscented < 0.9 * extended
    better = (runs[:, 2] < runs[:, 1]).mean()
    assert better > 0.9, f"the particle filter was the better one in {better:.0%} only"


def bearing(x: Array) -> list[float]:
    return [math.atan2(x[1], x[0])]


def around(z: Array, predicted: Array) -> Any:
    return wrapped_difference(z - predicted, 2 * math.pi)


@pytest.mark.parametrize("kind", [ExtendedKalmanFilter, UnscentedKalmanFilter])
def test_bearings_wrap(kind: Any) -> None:
    """An object passes in the west, where bearings jump from pi to -pi."""
    step = np.array([0, -0.5])
    model = {"f": lambda x: x + step, "h": bearing, "Q": 0.01 * np.eye(2), "R": [[1e-4]]}
    ours = kind(**model, x=[-10, 4.6], P=np.eye(2), residual=around)
    place = np.array([-10.0, 5.0])
    for _ in range(20):
        place = place + step
        ours.predict()
        ours.update(bearing(place))
        assert abs(ours.y[0]) < 0.2
    assert ours.x[1] / ours.x[0] == pytest.approx(place[1] / place[0], abs=0.01)


def test_a_jacobian_by_differences() -> None:
    x = np.array([0.7, -3.0])
    ours = numeric_jacobian(lambda x: [x[0] * x[1], math.sin(x[0]), x[1] ** 2], x)
    exact = [[-3.0, 0.7], [math.cos(0.7), 0.0], [0.0, -6.0]]
    assert ours == pytest.approx(np.array(exact), abs=1e-9)


def walking(**changes: Any) -> ParticleFilter:
    arguments: dict[str, Any] = {
        "f": shifted,
        "log_likelihood": near,
        "Q": [[0.5]],
        "x": [0],
        "P": [[4]],
        "count": 2000,
        "seed": 3,
    }
    return ParticleFilter(**(arguments | changes))


def shifted(particles: Array, u: Array | None = None) -> Array:
    return particles + (0 if u is None else u)


def near(z: Array, particles: Array) -> Array:
    close: Array = -0.5 * (z[0] - particles[:, 0]) ** 2
    return close


def test_particles_weigh_and_resample() -> None:
    ours = walking(resample_below=0)
    assert ours.particles.shape == (2000, 1) and ours.effective_size == pytest.approx(2000)
    assert ours.x == pytest.approx([0], abs=0.15) and ours.P[0, 0] == pytest.approx(4, rel=0.1)
    ours.update([1])
    expected = np.exp(near(np.array([1.0]), ours.particles))
    assert ours.weights == pytest.approx(expected / expected.sum())
    assert ours.x[0] == pytest.approx(ours.weights @ ours.particles[:, 0])
    assert ours.log_likelihood == pytest.approx(math.log(expected.mean()))
    assert ours.effective_size == pytest.approx(1 / (ours.weights**2).sum())
    assert ours.resamplings == 0
    always = walking(resample_below=1)
    always.update([1])
    assert always.resamplings == 1 and np.array_equal(np.unique(always.weights), [1 / 2000])
    assert always.x == pytest.approx(ours.x, abs=0.02)
    counts = np.bincount(systematic_resample([0.2, 0.5, 0.3, 0.0], 0.3), minlength=4)
    assert counts.tolist() == [1, 2, 1, 0]


def reference_numbers(seed: int, count: int) -> list[float]:
    """xoshiro256++ seeded by splitmix64, in Python's integers: multiples of 2^-53."""
    mask = 2**64 - 1
    words = []
    for _ in range(4):
        seed = (seed + 0x9E3779B97F4A7C15) & mask
        word = ((seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9) & mask
        word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & mask
        words.append(word ^ (word >> 31))

    def rotated(word: int, by: int) -> int:
        return ((word << by) | (word >> (64 - by))) & mask

    numbers = []
    for _ in range(count):
        bits = (rotated((words[0] + words[3]) & mask, 23) + words[0]) & mask
        shifted = (words[1] << 17) & mask
        words[2] ^= words[0]
        words[3] ^= words[1]
        words[1] ^= words[2]
        words[0] ^= words[3]
        words[2] ^= shifted
        words[3] = rotated(words[3], 45)
        numbers.append((bits >> 11) * 2.0**-53)
    return numbers


def test_random_numbers_are_the_same_everywhere() -> None:
    uniform = reference_numbers(12345, 400)
    assert Random(12345).uniform(400).tolist() == uniform
    normal: list[float] = []
    for first, second in zip(uniform[::2], uniform[1::2], strict=True):
        a, b = 2 * first - 1, 2 * second - 1
        square = a * a + b * b
        if 0 < square < 1:
            scale = math.sqrt(-2 * math.log(square) / square)
            normal += [a * scale, b * scale]
    assert len(normal) > 250
    assert Random(12345).normal(len(normal)) == pytest.approx(normal, rel=1e-14)
    assert not np.array_equal(Random(1).normal(5), Random(2).normal(5))


def test_copies_and_pickles_go_on_alike() -> None:
    for ours in (
        ExtendedKalmanFilter(f=shifted, h=shifted, Q=[[1]], R=[[1]], x=[0], P=[[1]]),
        UnscentedKalmanFilter(f=shifted, h=shifted, Q=[[1]], R=[[1]], x=[0], P=[[1]], alpha=0.3),
        walking(),
    ):
        ours.predict()
        ours.update([1.5])
        for again in (copy.copy(ours), copy.deepcopy(ours), pickle.loads(pickle.dumps(ours))):
            once_more = copy.copy(ours)
            for one in (again, once_more):
                one.predict([0.5])
                one.update([2.0])
            assert np.array_equal(again.x, once_more.x) and np.array_equal(again.P, once_more.P)
            assert again.log_likelihood == once_more.log_likelihood
            assert not np.array_equal(again.x, ours.x)


def fails(*_: Any) -> Any:
    raise KeyError("from inside")


def test_exceptions_of_callables_pass_through_and_change_nothing() -> None:
    model = LINEAR | {"f": fails}
    for ours in (ExtendedKalmanFilter(**model), UnscentedKalmanFilter(**model), walking(f=fails)):
        before = ours.x
        with pytest.raises(KeyError, match="from inside"):
            ours.predict()
        assert np.array_equal(ours.x, before)
    particles = walking(log_likelihood=fails)
    with pytest.raises(KeyError, match="from inside"):
        particles.update([1])
    assert np.array_equal(np.unique(particles.weights), [1 / 2000])


def ekf(**changes: Any) -> ExtendedKalmanFilter:
    return ExtendedKalmanFilter(**(LINEAR | changes))


def ukf(**changes: Any) -> UnscentedKalmanFilter:
    return UnscentedKalmanFilter(**(LINEAR | changes))


BAD: dict[str, tuple[Any, str]] = {
    "f shape": (lambda: ekf(f=lambda x: x[:2]).predict(), "f: is 2x1; expected 3x1"),
    "f text": (lambda: ukf(f=lambda x: "text").predict(), "f: returned str; expected an array"),
    "f None": (lambda: ukf(f=lambda x: None).predict(), "f: returned NoneType"),
    "f NaN": (lambda: ukf(f=lambda x: x * math.nan).predict(), r"f\[0\]: is -?nan"),
    "f square": (lambda: ekf(f=lambda x: F).predict(), "f: has 2 dimensions; expected 1"),
    "h shape": (lambda: ukf(h=lambda x: x).update([1, 2]), "h: is 3x1; expected 2x1"),
    "F shape": (lambda: ekf(F=lambda x: H).predict(), "F: is 2x3; expected 3x3"),
    "H shape": (lambda: ekf(H=lambda x: F).update([1, 2]), "H: is 3x3; expected 2x3"),
    "NaN z": (lambda: ekf().update([1, math.nan]), r"z\[1\]: is nan"),
    "z shape": (lambda: ukf().update([1]), "z: is 1x1; expected 2x1"),
    "Q": (lambda: ukf(Q=-np.eye(3)), "Q: .* is -1"),
    "R": (lambda: setattr(ekf(), "R", [[1, 2], [2, 1]]), "R: .* is -1"),
    "singular": (lambda: ukf(R=np.zeros((2, 2)), P=np.zeros((3, 3))).update([1, 2]), "S: .* sing"),
    "alpha": (lambda: ukf(alpha=2), "alpha: is 2; expected 1e-4 to 1"),
    "kappa": (lambda: ukf(kappa=-3), "kappa: is -3; expected a number above -3"),
    "too early": (lambda: ekf().S, "S: there has been no update yet"),
    "count": (lambda: walking(count=0), "count: is 0; expected 1 to"),
    "share": (lambda: walking(resample_below=1.5), "resample_below: is 1.5"),
    "particles": (lambda: walking(f=lambda p: p[1:]).predict(), "f: is 1x1999; expected 1x2000"),
    "likelihoods": (
        lambda: walking(log_likelihood=lambda z, p: [0.0]).update([1]),
        "log_likelihood: returned 1 numbers; expected 2000",
    ),
    "impossible": (
        lambda: walking(log_likelihood=lambda z, p: np.full(2000, -math.inf)).update([1]),
        "log_likelihood: z is impossible",
    ),
    "offset": (lambda: systematic_resample([1, 1], 1), "offset: is 1"),
    "weights": (lambda: systematic_resample([1, -1], 0.5), "weights: expected"),
}


@pytest.mark.parametrize(("call", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_named(call: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        call()


def test_only_what_can_be_called_is_a_callable() -> None:
    for bad in (None, 3, "f"):
        with pytest.raises(TypeError):
            ekf(f=bad)
