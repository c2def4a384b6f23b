# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The noises of a Kalman filter, found from what a run measured."""

from collections.abc import Sequence
from dataclasses import dataclass

from survtrack._core import (
    FilterConsistency,
    KalmanCaOptions,
    KalmanCvOptions,
    MeasuredTrack,
    MeasurementNoise,
    NoiseEstimate,
    ProcessNoise,
    filter_consistency,
    identify_measurement_noise,
    identify_process_noise,
)
from survtrack.errors import InputError

TunableOptions = KalmanCvOptions | KalmanCaOptions

STILL_SAMPLES = 100  # from fewer, R would be uncertain to more than a tenth
LEAST_STILL = 20  # measurements of an object: fewer say little about whether it stands
LEAST_STEPS = 50
SMALLEST = 1e-6  # that the options allow


@dataclass(frozen=True)
class TunedNoise:
    """What was found, and how well the filter fits with it.

    Attributes:
        options: those given, with what was found.
        noises: option -> what was found; the standard error is inf where the data do not determine
            it.
        before, after: consistency of the filter, over the same tracks, with the options given and
            with those found.
        tracks: how many there were.
        still_tracks: how many of them stood still.
        measurement: R as it was identified from these; None: there were too few, and it was fitted
            with Q.
    """

    options: TunableOptions
    noises: dict[str, NoiseEstimate]
    before: FilterConsistency
    after: FilterConsistency
    tracks: int
    still_tracks: int
    measurement: MeasurementNoise | None


def tune_noise(
    tracks: Sequence[MeasuredTrack],
    options: TunableOptions,
    *,
    joint: bool = False,
    least_steps: int = LEAST_STEPS,
) -> TunedNoise:
    """Identify R from the tracks that stand still, if there are enough, and Q from all.

    Args:
        tracks: such as those of a MeasurementRecorder.
        options: the filter as it is; the search begins there.
        joint: fit R with Q even if some stand still.
        least_steps: fewer steps from one measurement to the next are refused.

    Raises:
        InputError: too few steps, or measurements without any noise.
    """
    steps = sum(max(len(track) - 1, 0) for track in tracks)
    if steps < least_steps:
        raise InputError(
            f"tracks: {len(tracks)} with {steps} steps from one measurement to the next are too "
            f"few to identify noise; expected at least {least_steps} steps"
        )
    given = list(tracks)
    still = [track for track in given if len(track) >= LEAST_STILL and track.stands_still()]
    measurement = None
    if not joint and sum(map(len, still)) >= STILL_SAMPLES:
        measurement = identify_measurement_noise(still, options.noise_unit)
    if measurement is None:
        found = identify_process_noise(given, options)
    else:
        noise = measurement.position_noise.value
        if noise < SMALLEST:
            raise InputError(
                f"position_noise: objects that stand still show {noise:g}, less than the smallest "
                f"that is allowed, {SMALLEST:g}; fit it with the process noise instead (joint)"
            )
        known = options.replace(position_noise=noise)
        found = identify_process_noise(given, known, fit_position_noise=False)
    return TunedNoise(
        options=found.options,
        noises=_noises(found, measurement),
        before=filter_consistency(given, options),
        after=found.after,
        tracks=len(given),
        still_tracks=len(still),
        measurement=measurement,
    )


def _noises(found: ProcessNoise, measurement: MeasurementNoise | None) -> dict[str, NoiseEstimate]:
    """By the names of the options."""
    accelerates = isinstance(found.options, KalmanCaOptions)
    noises = {
        "acceleration_noise" if accelerates else "velocity_noise": found.process_noise,
        "position_noise": found.position_noise
        if measurement is None
        else measurement.position_noise,
        "initial_velocity": found.initial_velocity,
    }
    if accelerates:
        noises["initial_acceleration"] = found.initial_acceleration
    return noises
