# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a replay predicts over a gap is what the run's own filter would have predicted."""

import numpy as np
import pytest

from predictions import (
    MATRICES,
    config_of,
    exact,
    through_a_stream,
    tracked,
    without_detection,
)
from survtrack.replay import lost_damping_s, predicted


def box_at(k: int) -> list[float]:
    """A walker of 20 x 50 px who speeds up and turns."""
    return [50 + 4 * k + 0.05 * k * k, 200 + 30 * np.sin(k / 9), 20, 50]


FILTERS = [
    ("filter.model=kalman_cv", "time_unit_s=0.1", "filter.velocity_noise=0.1"),
    ("filter.model=kalman_cv",),
    (
        *("filter.noise_unit=px", "filter.velocity_noise=40"),
        *("filter.position_noise=2", "filter.initial_velocity=60"),
    ),
    ("filter.model=kalman_cv", "filter.lost_damping_time=0"),
    ("filter.model=kalman_box",),
]


@pytest.mark.parametrize("settings", FILTERS)
@pytest.mark.parametrize("lost", [0, 3])
@pytest.mark.parametrize("gap_s", [0.03, 0.4, 2.0])
def test_a_gap_is_a_step_of_the_filter(settings: tuple[str], lost: int, gap_s: float) -> None:
    config = config_of(*settings)
    tracker, at = tracked(config, 30, lost, box_at)
    assert at.track.status.name == ("lost" if lost else "confirmed")
    later_s = at.time_s + gap_s
    [ours] = predicted(exact(at), later_s, lost_damping_s(config)).tracks
    filters = without_detection(tracker, later_s)
    assert ours.position == pytest.approx(filters.position, rel=1e-12)
    assert ours.velocity_px_per_s == pytest.approx(filters.velocity_px_per_s, rel=1e-9)
    for name in MATRICES:
        wanted = getattr(filters, name)
        assert np.abs(getattr(ours, name) - wanted).max() < 1e-9 * np.abs(wanted).max(), name


@pytest.mark.parametrize("settings", FILTERS)
@pytest.mark.parametrize("lost", [0, 3])
@pytest.mark.parametrize("gap_s", [0.03, 0.4, 2.0])
def test_so_it_is_through_a_stream_to_its_steps(
    settings: tuple[str], lost: int, gap_s: float
) -> None:
    config = config_of(*settings)
    tracker, at = tracked(config, 30, lost, box_at)
    frame, damping_s = through_a_stream(at, config)
    [ours] = predicted(frame, at.time_s + gap_s, damping_s).tracks
    filters = without_detection(tracker, at.time_s + gap_s)
    assert ours.position == pytest.approx(filters.position, abs=1 / 32 + gap_s / 8)
    # Half a step of each standard deviation is 4.5 %, of a correlation 1/64.
    ratio = ours.position_covariance_px2.diagonal() / filters.position_covariance_px2.diagonal()
    assert (np.abs(ratio - 1) < 0.11).all(), ratio


def test_a_frozen_track_stays_and_one_that_is_extrapolated_does_not() -> None:
    for settings, moves in (((), False), (("filter.extrapolate_lost=true",), True)):
        config = config_of("filter.model=mean_velocity", "cost.model=distance", *settings)
        tracker, at = tracked(config, 30, 2, box_at)
        frame, damping_s = through_a_stream(at, config)
        [ours] = predicted(frame, at.time_s + 0.5, damping_s).tracks
        filters = without_detection(tracker, at.time_s + 0.5)
        assert ours.position == pytest.approx(filters.position, abs=0.1)
        assert (abs(ours.position[0] - frame.tracks[0].position[0]) > 10) is moves
        assert ours.covariance_px2 == (0, 0, 0)


# After so long: the least and the largest ratio of variances, and the largest distance of places in
# px. docs/replay.md has them.
OTHERS = [
    ("kalman_ca", 0.1, (0.96, 0.97), 0.2),
    ("kalman_ca", 0.5, (0.56, 0.58), 4.8),
    ("kalman_ca", 2.0, (0.08, 0.09), 77.0),
    ("extended", 0.1, (0.95, 1.0), 0.1),
    ("extended", 0.5, (0.69, 0.99), 1.8),
    ("extended", 2.0, (0.58, 0.99), 16.0),
    ("unscented", 0.1, (0.95, 1.0), 0.1),
    ("unscented", 0.5, (0.69, 0.99), 1.9),
    ("unscented", 2.0, (0.58, 0.96), 16.5),
    ("particle", 0.1, (0.95, 1.0), 0.1),
    ("particle", 0.5, (0.71, 0.99), 1.7),
    ("particle", 2.0, (0.62, 0.98), 15.0),
    ("kalman_discrete", 0.1, (1.0, 1.01), 1e-9),
    ("kalman_discrete", 0.5, (1.42, 1.43), 1e-9),
    ("kalman_discrete", 2.0, (1.76, 1.77), 1e-9),
]


@pytest.mark.parametrize(("model", "gap_s", "bounds", "most_px"), OTHERS)
def test_of_other_filters_it_is_so_near(
    model: str, gap_s: float, bounds: tuple[float, float], most_px: float
) -> None:
    ratios, distances_px = [], []
    for seen in (20, 30, 40, 50):
        config = config_of(f"filter.model={model}")
        tracker, at = tracked(config, seen, 0, box_at)
        [ours] = predicted(exact(at), at.time_s + gap_s, lost_damping_s(config)).tracks
        filters = without_detection(tracker, at.time_s + gap_s)
        own, wanted = (each.position_covariance_px2.diagonal() for each in (ours, filters))
        ratios.extend(own / wanted)
        distances_px.append(np.hypot(*np.subtract(ours.position, filters.position)))
    print(
        f"{model} after {gap_s} s: variances {min(ratios):.3f} to {max(ratios):.3f} of the", end=" "
    )
    print(f"filter's, places {min(distances_px):.2f} to {max(distances_px):.2f} px off")
    assert bounds[0] <= min(ratios) and max(ratios) <= bounds[1]
    assert 0.9 * most_px - 1e-9 <= max(distances_px) + 0.05 <= most_px + 0.1


DAMPING: list[tuple[tuple[str, ...], float | None]] = [
    (("filter.lost_damping_time=3", "time_unit_s=0.2"), 0.6),
    (("filter.lost_damping_time=0",), None),
    (("filter.model=extended", "filter.lost_damping_time=1.5"), 1.5),
    (("filter.model=kalman_ca",), None),
    (("filter.model=kalman_discrete",), None),
    (("filter.model=mean_velocity",), 0.0),
    (("filter.model=mean_velocity", "filter.extrapolate_lost=true"), None),
    (("filter.lost_damping_time=1e6", "time_unit_s=3000"), None),
]


@pytest.mark.parametrize(("settings", "wanted"), DAMPING)
def test_the_damping_is_the_configs(settings: tuple[str, ...], wanted: float | None) -> None:
    damping_s = lost_damping_s(config_of(*settings))
    assert damping_s == (None if wanted is None else pytest.approx(wanted))
