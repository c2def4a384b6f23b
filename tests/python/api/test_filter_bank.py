# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Filter banks: the Kalman ones against filterpy, all against their contract."""

import math
import warnings
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import survtrack
from survtrack import FilterBank, InputError

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    from filterpy.common import Q_continuous_white_noise
    from filterpy.kalman import KalmanFilter

Array = NDArray[np.float64]
CV = survtrack.KalmanCvOptions(
    noise_unit="px",
    velocity_noise=1.3,
    position_noise=2.1,
    initial_velocity=4.0,
    lost_damping_time=0,
)
CA = survtrack.KalmanCaOptions(
    noise_unit="px",
    acceleration_noise=0.7,
    position_noise=1.9,
    initial_velocity=3.0,
    initial_acceleration=0.8,
)
STEPS = [1.0, 1.0, 0.5, 2.0, 1.0, 0.04, 3.0, 1.0, 1.0, 0.1]
ALL_OPTIONS = [
    CV,
    CA,
    survtrack.KalmanCvOptions(),
    survtrack.KalmanCaOptions(),
    survtrack.MeanVelocityOptions(),
    survtrack.MeanVelocityOptions(extrapolate_lost=True),
    survtrack.KalmanDiscreteOptions(),
    survtrack.KalmanBoxOptions(),
    survtrack.ExtendedOptions(),
    survtrack.UnscentedOptions(),
    survtrack.ParticleOptions(),
]
TURNING = {"extended", "unscented", "particle"}


def reference(options: Any, start: Array) -> KalmanFilter:
    """The same filter by filterpy: state (x, y), then their derivatives."""
    order = 2 if isinstance(options, survtrack.KalmanCvOptions) else 3
    deviations = [options.position_noise, options.initial_velocity]
    if order == 3:
        deviations.append(options.initial_acceleration)
    other = KalmanFilter(dim_x=2 * order, dim_z=2)
    other.x = np.concatenate([start, np.zeros(2 * order - 2)])
    other.P = np.diag(np.repeat(deviations, 2) ** 2.0)
    other.R = np.eye(2) * options.position_noise**2
    other.H = np.eye(2, 2 * order)
    return other


def move(other: KalmanFilter, options: Any, dt: float) -> None:
    order = other.dim_x // 2
    one_axis = np.array([[1, dt, dt * dt / 2], [0, 1, dt], [0, 0, 1]])[:order, :order]
    noise = options.velocity_noise if order == 2 else options.acceleration_noise
    Q = Q_continuous_white_noise(order, dt, noise**2)
    other.predict(F=np.kron(one_axis, np.eye(2)), Q=np.kron(Q, np.eye(2)))


@pytest.mark.parametrize("options", [CV, CA], ids=["CV", "CA"])
def test_a_bank_is_filterpys_filters(options: Any) -> None:
    random = np.random.default_rng(5)
    starts = random.uniform(0, 500, (7, 2))
    bank = FilterBank(options)
    others = [reference(options, start) for start in starts]
    assert [bank.add(x, y) for x, y in starts] == list(range(7))
    for dt in STEPS:
        bank.predict(dt)
        measured = bank.positions + random.normal(0, 3, (7, 2))
        measured[random.random(7) < 0.3] = math.nan
        for slot, other in enumerate(others):
            move(other, options, dt)
            S = other.H @ other.P @ other.H.T + other.R
            assert bank.innovation_covariances_px2[slot] == pytest.approx(S, rel=1e-9)
            assert bank.predicted_positions[slot] == pytest.approx(other.x[:2], rel=1e-9)
            if not np.isnan(measured[slot]).any():
                other.update(measured[slot])
        bank.correct(measured)
        for slot, other in enumerate(others):
            P = bank.state_covariance(slot)
            assert bank.state(slot) == pytest.approx(other.x, rel=1e-9, abs=1e-9)
            assert pytest.approx(other.P, rel=1e-9, abs=1e-9) == P
            assert pytest.approx(P.T, rel=1e-12) == P and np.linalg.eigvalsh(P).min() > 0
            assert np.array_equal(P, P.T) or np.isnan(measured[slot]).any()
            assert np.array_equal(bank.positions[slot], bank.state(slot)[:2])
            assert np.array_equal(bank.velocities[slot], bank.state(slot)[2:4])
            assert np.array_equal(bank.position_covariances_px2[slot], P[:2, :2])
            assert np.array_equal(bank.velocity_covariances[slot], P[2:4, 2:4])
            assert np.array_equal(bank.cross_covariances[slot], P[:2, 2:4])


def test_noises_relative_to_the_objects_size_scale_all() -> None:
    relative = CV.replace(noise_unit="object_size")
    one, large = FilterBank(CV), FilterBank(relative)
    one.add(0, 0)
    large.add(0, 0, object_size_px=8)
    for dt, x in zip(STEPS, range(10), strict=True):
        one.predict(dt)
        large.predict(dt)
        one.correct([[x, -x]])
        large.correct([[8 * x, -8 * x]])
        assert large.state(0) == pytest.approx(8 * one.state(0), rel=1e-9)
        assert large.state_covariance(0) == pytest.approx(64 * one.state_covariance(0), rel=1e-9)
        density = CV.velocity_noise**2
        assert one.velocity_noises[0] == pytest.approx(density * np.eye(2), rel=1e-12)
        assert large.velocity_noises[0] == pytest.approx(64 * density * np.eye(2), rel=1e-12)


def test_the_velocity_of_a_lost_track_falls() -> None:
    bank = FilterBank(survtrack.KalmanCvOptions(lost_damping_time=2.0))
    bank.add(0, 0, object_size_px=10)
    for k in range(1, 30):
        bank.predict(1)
        bank.correct([[5.0 * k, 0]])
    bank.predict(1)  # the first step is still a matched track's
    speed = bank.velocities[0, 0]
    assert speed == pytest.approx(5, abs=0.1)
    bank.predict(2)
    assert bank.velocities[0, 0] == pytest.approx(speed / math.e, rel=1e-12)


def test_the_mean_velocity_of_the_last_steps() -> None:
    bank = FilterBank(survtrack.MeanVelocityOptions(window_steps=3))
    bank.add(0, 0)
    places = [(1, 0), (3, 0), (6, 3), (10, 6)]
    for place in places:
        bank.predict(1)
        bank.correct([place])
        assert bank.positions.tolist() == [list(place)]
    assert bank.velocities.tolist() == [[(10 - 1) / 3, 6 / 3]]
    bank.predict(1)
    assert bank.predicted_positions.tolist() == [[13, 8]]
    bank.predict(1)
    assert bank.predicted_positions.tolist() == [[13, 8]], "a lost track's prediction stays"
    assert bank.positions.tolist() == [[10, 6]]
    bank.correct([[19, 6]])  # after two units
    assert bank.velocities.tolist() == pytest.approx(np.array([[16 / 4, 6 / 4]]))
    assert bank.state_covariance(0).shape == (0, 0)
    for none in (bank.velocity_covariances, bank.cross_covariances, bank.velocity_noises):
        assert not none.any()


@pytest.mark.parametrize("options", ALL_OPTIONS, ids=lambda options: options.model)
def test_all_banks_converge_and_stay_finite(options: Any) -> None:
    bank = FilterBank(options)
    bank.add(0, 0, object_size_px=20)
    bank.correct([[0.0, 0.0]])  # a second look at the same time
    for k in range(1, 200):
        bank.predict(0.5)
        bank.correct([[1.5 * k, -0.5 * k]])
    # The mean over the headings of what may turn is a little short.
    near = 0.1 if options.model in TURNING else 1e-3
    assert bank.positions == pytest.approx(np.array([[1.5 * 199, -0.5 * 199]]), abs=near)
    assert bank.velocities == pytest.approx(np.array([[3.0, -1.0]]), abs=near)
    for _ in range(1000):
        bank.predict(10)
    values = (bank.positions, bank.velocities, bank.state(0), bank.innovation_covariances_px2)
    assert all(np.isfinite(value).all() for value in values)


@pytest.mark.parametrize("options", ALL_OPTIONS, ids=lambda options: options.model)
def test_slots_move_down_when_one_is_removed(options: Any) -> None:
    bank = FilterBank(options)
    assert (len(bank), bank.positions.shape, bank.velocities.shape) == (0, (0, 2), (0, 2))
    assert bank.position_covariances_px2.shape == bank.innovation_covariances_px2.shape == (0, 2, 2)
    assert bank.velocity_covariances.shape == bank.cross_covariances.shape == (0, 2, 2)
    assert bank.velocity_noises.shape == (0, 2, 2)
    bank.predict(1)
    bank.correct(np.zeros((0, 2)))
    for slot in range(4):
        assert bank.add(slot, 10 * slot) == slot
    bank.remove(1)
    assert len(bank) == 3 and bank.positions.tolist() == [[0, 0], [2, 20], [3, 30]]
    assert bank.add(7, 70) == 3
    alone = FilterBank(options)
    for _ in range(3):  # random numbers go by the turn of birth
        alone.add(2, 20)
    alone.remove(0)
    alone.remove(0)
    for k in range(5):
        bank.predict(1)
        alone.predict(1)
        bank.correct([[0, 0], [2 + k, 20], [3, 30], [7, 70]])
        alone.correct([[2 + k, 20]])
    assert np.array_equal(bank.state(1), alone.state(0))
    assert np.array_equal(bank.state_covariance(1), alone.state_covariance(0))


BAD_CALLS: dict[str, tuple[Any, str]] = {
    "position": (lambda bank: bank.add(math.nan, 0), "position: expected finite"),
    "infinite": (lambda bank: bank.add(0, math.inf), "position: expected finite"),
    "size": (lambda bank: bank.add(0, 0, object_size_px=0), "object_size_px: 0.0+ is not allowed"),
    "NaN size": (lambda bank: bank.add(0, 0, object_size_px=math.nan), "object_size_px: nan"),
    "dt 0": (lambda bank: bank.predict(0), "dt: 0 is not allowed; expected a number above 0"),
    "dt -1": (lambda bank: bank.predict(-1), "dt: -1 is not allowed"),
    "dt NaN": (lambda bank: bank.predict(math.nan), "dt: nan is not allowed"),
    "long dt": (lambda bank: bank.predict(1e9), "dt: .* at most 1e6"),
    "rows": (lambda bank: bank.correct(np.zeros((3, 2))), r"measured: .* shape \(2, 2\)"),
    "columns": (lambda bank: bank.correct(np.zeros((2, 3))), r"measured: .* shape \(2, 2\)"),
    "flat": (lambda bank: bank.correct([1.0, 2.0]), r"measured: .* shape \(2, 2\)"),
    "inf row": (lambda bank: bank.correct([[1, 2], [math.inf, 2]]), "measured: row 1 is "),
    "half a row": (lambda bank: bank.correct([[math.nan, 2], [1, 2]]), "measured: row 0 is "),
    "slot 2": (lambda bank: bank.state(2), "slot: 2 is not allowed; the bank has 2 filters"),
    "slot -1": (lambda bank: bank.state_covariance(-1), "slot: -1 is not allowed"),
    "remove 2": (lambda bank: bank.remove(2), "slot: 2 is not allowed"),
}


@pytest.mark.parametrize(("call", "message"), BAD_CALLS.values(), ids=BAD_CALLS)
def test_bad_calls_are_refused_and_change_nothing(call: Any, message: str) -> None:
    bank = FilterBank(CV)
    bank.add(1, 2)
    bank.add(3, 4)
    bank.predict(1)
    before = [bank.state(0), bank.state(1), bank.state_covariance(0), bank.state_covariance(1)]
    with pytest.raises(InputError, match=f"^{message}"):
        call(bank)
    after = [bank.state(0), bank.state(1), bank.state_covariance(0), bank.state_covariance(1)]
    assert all(np.array_equal(a, b) for a, b in zip(before, after, strict=True))
    assert len(bank) == 2


def test_only_filter_options_make_a_bank() -> None:
    for options in (survtrack.HungarianOptions(), survtrack.Config(), "kalman_cv", None):
        with pytest.raises(TypeError, match="KalmanCvOptions"):
            FilterBank(options)  # type: ignore[arg-type]


def filterpy_discrete(options: survtrack.KalmanDiscreteOptions, start: Array) -> KalmanFilter:
    other = KalmanFilter(dim_x=4, dim_z=2)
    other.x = np.array([*start, 0, 0])
    other.P = np.diag(options.initial_variances)
    xx, xy, yy = options.measurement_covariance
    other.R = np.array([[xx, xy], [xy, yy]])
    other.H = np.eye(2, 4)
    other.F = np.eye(4) + options.step_time * np.eye(4, k=2)
    other.Q = np.diag(options.process_variances)
    return other


def test_given_covariances_are_filterpys_and_missing_frames_are_as_many_steps() -> None:
    """Nashenda 2011 with R as a covariance, and a control input."""
    options = survtrack.KalmanDiscreteOptions(
        process_variances=[10] * 4,
        measurement_covariance=(0.2877, 0.1, 1.1465),
        initial_variances=[100] * 4,
        control_input=(0.5, 0, 0, 8),
        step_time=0.2685,
    )
    bank = FilterBank(options)
    bank.add(192, 144)
    other = filterpy_discrete(options, np.array([192.0, 144.0]))
    random = np.random.default_rng(1)
    for steps in [1, 1, 3, 1, 2, 1, 7, 1]:
        for _ in range(steps):
            other.predict()
            other.x = other.x + options.control_input
        bank.predict(steps * 0.2685)
        S = other.H @ other.P @ other.H.T + other.R
        assert bank.innovation_covariances_px2[0] == pytest.approx(S, rel=1e-9)
        measured = bank.positions + random.normal(0, 3, (1, 2))
        other.update(measured[0])
        bank.correct(measured)
        assert bank.state(0) == pytest.approx(other.x, rel=1e-9)
        assert bank.state_covariance(0) == pytest.approx(other.P, rel=1e-9)


def test_a_filter_over_boxes_takes_sizes() -> None:
    bank = FilterBank(survtrack.KalmanBoxOptions())
    bank.add(0, 0, object_size_px=20)
    bank.add(90, 0, object_size_px=20)
    for k in range(1, 40):
        bank.predict(1)
        bank.correct([[k, 0], [math.nan] * 2], [[20 + k, 10], [math.nan] * 2])
    assert bank.box_sizes[0] == pytest.approx((59, 10), abs=1)
    assert bank.box_sizes[1].tolist() == [20, 20]
    assert bank.state(0).shape == (8,) and bank.state_covariance(0).shape == (8, 8)
    assert bank.state(0)[6] == pytest.approx(1, abs=0.1)
    assert np.isnan(FilterBank(CV).box_sizes).all()
    bank.correct([[1, 1], [2, 2]])  # without sizes too
    for sizes in ([[1, 1]], [[1, 0], [1, 1]], [[1, 1], [1, math.nan]], [[1, 1e9], [1, 1]], [1, 1]):
        with pytest.raises(InputError, match=r"^sizes: "):
            bank.correct([[1, 1], [2, 2]], sizes)


def test_a_filter_along_a_path_says_where_it_is_on_it() -> None:
    lane = survtrack.Path([(0, 50), (100, 50), (100, 150)], kind="curve", max_distance_px=20)
    bank = FilterBank(survtrack.KalmanPathOptions(), paths=survtrack.Paths({"lane": lane}))
    bank.add(10, 55)
    for k in range(1, 12):
        bank.predict(1)
        bank.correct(lane.to_image([(10 + 8.0 * k, 5)]))
    before = bank.path_state(0)
    bank.predict(2)
    state = bank.path_state(0)
    assert before is not None and state is not None
    assert state.path == lane and state.place_before == before.predicted
    assert state.predicted == pytest.approx((10 + 8 * 13, 5), abs=0.5)
    assert state.velocity == pytest.approx((8, 0), abs=0.2)
    assert state.covariance_px2[0, 0] == bank.state_covariance(0)[0, 0]
    assert bank.state(0) == pytest.approx([*state.predicted, *state.velocity])
    assert bank.positions[0] == pytest.approx(lane.to_image([state.predicted])[0])
    speed = lane.stretches([state.predicted])[0] * state.velocity[0]
    velocity = speed * lane.tangents([state.predicted[0]])[0]
    velocity += state.velocity[1] * lane.normals([state.predicted[0]])[0]
    assert bank.velocities[0] == pytest.approx(velocity)
    other = FilterBank(CV)
    other.add(0, 0)
    assert other.path_state(0) is None
    with pytest.raises(InputError, match=r"^position: is too far off every path"):
        bank.add(10, 90)
    assert len(bank) == 1
    with pytest.raises(InputError, match=r'^filter.model: "kalman_path" has no paths'):
        FilterBank(survtrack.KalmanPathOptions())


def test_the_frames_centre_needs_the_frames_size() -> None:
    options = survtrack.KalmanDiscreteOptions(start="frame_center")
    with pytest.raises(InputError, match=r"^frame: its size is not known"):
        FilterBank(options)
    bank = FilterBank(options, frame_size=(200, 100))
    bank.add(110, 52)
    assert 100 < bank.positions[0, 0] < 110 and 50 < bank.positions[0, 1] < 52
