# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Noises found from measurements: the truth of synthetic scenes and of drawn tracks."""

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import survtrack
from survtrack import ConfigError, InputError, KalmanCaOptions, KalmanCvOptions, MeasuredTrack
from survtrack.offline import tune_noise
from survtrack.scenes import make_scene

Array = NDArray[np.float64]
CV = KalmanCvOptions(noise_unit="px", velocity_noise=30, position_noise=3, initial_velocity=60)


def of_scene(name: str, sigma_px: float, *, seed: int = 1, **options: Any) -> list[MeasuredTrack]:
    """What a sensor measured of a scene, an object a track, in seconds."""
    found: dict[int, list[tuple[float, tuple[float, float]]]] = {}
    scene = make_scene(name, seed=seed, size=(640, 480), frame_count=250, **options)
    for _, time_s, positions in scene.measurements(sigma_px=sigma_px):
        for id, place in positions.items():
            found.setdefault(id, []).append((time_s, place))
    return [MeasuredTrack(*map(list, zip(*rows, strict=True))) for rows in found.values()]


def drawn(seed: int, q: float, r: float, count: int = 10, steps: int = 120) -> list[MeasuredTrack]:
    """Tracks of constant velocity but for white noise of density q^2, in px, every 0.2."""
    random, dt = np.random.default_rng(seed), 0.2
    root = np.linalg.cholesky(survtrack.continuous_white_noise(2, dt, q * q))
    tracks = []
    for _ in range(count):
        state = np.array([[0, 0], random.normal(0, 40, 2)])
        places = []
        for _ in range(steps):
            places.append(state[0] + random.normal(0, r, 2))
            state = np.array([[1, dt], [0, 1]]) @ state + root @ random.normal(0, 1, (2, 2))
        tracks.append(MeasuredTrack(dt * np.arange(steps), places))
    return tracks


def test_r_of_an_object_that_stands_still() -> None:
    off = []
    R = np.array([[4.0, 1.5], [1.5, 2.0]])
    error = np.sqrt((np.outer(R.diagonal(), R.diagonal()) + R**2) / 198)
    for seed in range(30):
        random = np.random.default_rng(seed)
        places = random.multivariate_normal([300, 200], R, 200)
        times = 0.04 * np.arange(200)
        noise = survtrack.identify_measurement_noise(places + np.outer(times, [0.7, -0.2]), times)
        assert (noise.samples, noise.degrees) == (200, 198)
        off.append((noise.R - R) / error)
        assert noise.standard_error == pytest.approx(error, rel=0.4)
        slope = np.array([np.polyfit(times, places[:, axis], 1) for axis in (0, 1)])
        rest = places - (np.outer(times, slope[:, 0]) + slope[:, 1])
        assert pytest.approx(rest.T @ rest / 198, rel=1e-9) == noise.R
    assert np.abs(off).max() < 4
    assert np.sqrt(np.mean(np.square(off))) == pytest.approx(1, abs=0.3)


@pytest.mark.parametrize("sigma_px", [0.5, 2.0, 6.0])
def test_the_sensors_noise_of_a_scene_is_recovered(sigma_px: float) -> None:
    tracks = of_scene("constant", sigma_px, contacts=3)
    found = survtrack.identify_process_noise(tracks, CV)
    noise = found.position_noise
    assert abs(noise.value - sigma_px) < 3 * noise.standard_error
    assert noise.standard_error < 0.1 * sigma_px
    # They go straight: what little process noise is found is none, to its error.
    assert found.process_noise.value < 0.1 * sigma_px or not (
        found.process_noise.value > 2 * found.process_noise.standard_error
    )
    assert found.after.nis_band[0] < found.after.nis_mean < found.after.nis_band[1]


def test_both_noises_of_drawn_tracks_are_recovered_over_seeds() -> None:
    off = []
    for seed in range(12):
        found = survtrack.identify_process_noise(drawn(seed, q=12.0, r=2.0), CV)
        q, r = found.process_noise, found.position_noise
        off += [(q.value - 12) / q.standard_error, (r.value - 2) / r.standard_error]
        assert found.initial_velocity.value == pytest.approx(40, abs=30)
        assert abs(found.after.correlation) < 2 * found.after.correlation_limit
        assert isinstance(found.options, KalmanCvOptions)
        assert found.options.velocity_noise == q.value
        assert found.options.lost_damping_time == CV.lost_damping_time
    assert np.abs(off).max() < 4
    assert np.sqrt(np.mean(np.square(off))) == pytest.approx(1, abs=0.45)


def test_the_likelihood_is_that_of_a_filter_bank() -> None:
    track = drawn(3, q=12.0, r=2.0, count=1)[0]
    bank = survtrack.FilterBank(CV)
    bank.add(*track.positions[0])
    total = nis = 0.0
    for dt, place in zip(np.diff(track.times), track.positions[1:], strict=True):
        bank.predict(float(dt))
        S, y = bank.innovation_covariances_px2[0], place - bank.predicted_positions[0]
        nis += y @ np.linalg.solve(S, y)
        bank.correct([place])
        total -= 0.5 * (y @ np.linalg.solve(S, y) + math.log(np.linalg.det(2 * math.pi * S)))
    found = survtrack.filter_consistency([track], CV)
    assert found.log_likelihood == pytest.approx(total, rel=1e-10)
    assert found.nis_mean == pytest.approx(nis / found.steps, rel=1e-10)
    assert found.nis_band == survtrack.nis_band(2, found.steps)


def test_acceleration_is_better_told_by_its_own_model() -> None:
    tracks = of_scene("varying_speed", 0.2, contacts=3)
    start = KalmanCaOptions(noise_unit="px", position_noise=0.2, initial_velocity=60)
    ca = survtrack.identify_process_noise(tracks, start)
    cv = survtrack.identify_process_noise(tracks, CV)
    assert ca.position_noise.value == pytest.approx(0.2, abs=0.02)
    assert ca.after.log_likelihood > cv.after.log_likelihood
    assert ca.initial_acceleration.value > 0 and cv.initial_acceleration.value == 0


def test_tracks_that_stand_still_give_r() -> None:
    random = np.random.default_rng(8)
    times = 0.2 * np.arange(120)
    still = [
        MeasuredTrack(times, place + random.normal(0, 2, (120, 2)), np.full(120, 40))
        for place in ([100, 100], [300, 50])
    ]
    moving = [
        MeasuredTrack(track.times, track.positions, np.full(len(track), 40))
        for track in drawn(5, q=12.0, r=2.0)
    ]
    assert [track.stands_still() for track in [*still, *moving]] == [True] * 2 + [False] * 10
    tuned = tune_noise([*still, *moving], KalmanCvOptions())
    assert tuned.measurement is not None and tuned.still_tracks == 2
    r = tuned.noises["position_noise"]
    assert abs(r.value - 2 / 40) < 3 * r.standard_error
    assert tuned.options.position_noise == r.value
    joint = tune_noise([*still, *moving], KalmanCvOptions(), joint=True)
    assert joint.measurement is None
    assert joint.noises["position_noise"].value == pytest.approx(0.05, rel=0.1)
    assert joint.before.log_likelihood == tuned.before.log_likelihood
    assert joint.after.log_likelihood >= tuned.after.log_likelihood > tuned.before.log_likelihood


def test_a_recorder_takes_the_measurements_of_confirmed_tracks() -> None:
    config = survtrack.Config(time_unit_s=0.5)
    tracker, recorder = survtrack.Tracker(config), survtrack.MeasurementRecorder(config)
    for k in range(60):
        boxes = [[20 + 3 * k, 50, 20, 20]] if not 30 <= k < 33 else []
        seen = survtrack.Detections(boxes, 0.1 * k, index=k, frame_size=(200, 100))
        recorder.add(tracker.process(seen), seen)
    [track] = recorder.tracks()
    # Right edge 40 + 3 k: cut by the border from 199 px on.
    assert track.positions[-1].tolist() == [30 + 3 * 52, 60]
    assert recorder.used == len(track) and recorder.at_border == 60 - 53 and recorder.shared == 0
    assert track.times[0] == pytest.approx((track.positions[0][0] - 30) / 3 * 0.1 / 0.5)
    assert np.diff(track.times).max() == pytest.approx(0.4 / 0.5)
    assert track.lengths is not None and track.lengths == pytest.approx(np.full(len(track), 20))
    split = survtrack.MeasurementRecorder(config, max_gap_s=0.3)
    tracker.reset()
    for k in range(60):
        boxes = [[20 + 3 * k, 50, 20, 20]] if not 30 <= k < 33 else []
        seen = survtrack.Detections(boxes, 0.1 * k, index=k, frame_size=(200, 100))
        split.add(tracker.process(seen), seen)
    assert [len(part) for part in split.tracks()] == [len(track) - 20, 20]
    assert [len(part) for part in split.tracks(least=21)] == [len(track) - 20][: len(track) > 40]


GOOD = ([0, 1, 2], [[0, 0], [1, 0], [2, 1]])
BAD: dict[str, tuple[Any, str]] = {
    "times": (lambda: MeasuredTrack([0, 1, 1], GOOD[1]), r"tracks\[0\]\.times\[2\]: 1 is not"),
    "NaN": (lambda: MeasuredTrack(GOOD[0], [[0, 0], [1, math.nan], [2, 1]]), r"positions\[1\]: \("),
    "shape": (lambda: MeasuredTrack(GOOD[0], [1, 2, 3]), r"positions: is \(3,\); expected an Nx2"),
    "count": (lambda: MeasuredTrack([0, 1], GOOD[1]), "positions: 3 values is not allowed"),
    "length": (lambda: MeasuredTrack(*GOOD, [1, 0, 1]), r"lengths\[1\]: 0 is not allowed"),
    "none": (lambda: survtrack.identify_process_noise([], CV), "tracks: there are none"),
    "few": (
        lambda: survtrack.identify_process_noise([MeasuredTrack(*GOOD)], CV),
        "tracks: have 2 steps from one measurement to the next; expected 10 to 500000",
    ),
    "two": (
        lambda: survtrack.identify_measurement_noise([[0, 0], [1, 1]]),
        "2 measurements is not allowed; expected at least 3",
    ),
    "unit": (
        lambda: survtrack.identify_measurement_noise([MeasuredTrack(*GOOD)], "m"),
        'noise_unit: unknown "m"; one of: object_size, px',
    ),
    "gap": (
        lambda: survtrack.MeasurementRecorder(survtrack.Config(), max_gap_s=0),
        "max_gap_s: 0 is not allowed; expected a number above 0",
    ),
    "steps": (lambda: tune_noise([MeasuredTrack(*GOOD)], CV), "1 with 2 steps .* at least 50"),
}


@pytest.mark.parametrize(("call", "message"), BAD.values(), ids=BAD)
def test_bad_data_are_refused_by_name(call: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        call()


def test_objects_without_any_noise_are_refused() -> None:
    times = np.arange(200.0)
    still = MeasuredTrack(times, np.full((200, 2), 50.0), np.full(200, 10.0))
    with pytest.raises(InputError, match=r"position_noise: objects that stand still show 0"):
        tune_noise([still], KalmanCvOptions())
    with pytest.raises(ConfigError, match="other"):
        CV.replace(other=1)
