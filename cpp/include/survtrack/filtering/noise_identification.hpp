// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "survtrack/filtering/measured_track.hpp"
#include "survtrack/filtering/options.hpp"

namespace survtrack {

/// A number found from data.
struct NoiseEstimate {
  double value = 0.0;
  double standard_error = 0.0;  ///< 0: it was given; infinite: the data do not determine it
};

/// R, from objects that stand still.
struct MeasurementNoise {
  Eigen::Matrix2d R;               ///< covariance of a measured position, in squares of the noise unit
  Eigen::Matrix2d standard_error;  ///< of each of its elements, for Gaussian noise without memory
  NoiseEstimate position_noise;    ///< root of the mean variance: the option `position_noise`
  std::int64_t samples = 0;        ///< measurements
  std::int64_t degrees = 0;        ///< of freedom: samples less 2 a track, for its place and its drift
};

/// The covariance of the measured positions about a straight line in time, one for each object, which takes away a slow
/// drift. `object_size`: residuals are divided by the track's lengths. Throws `InputError`: no track, fewer than 3
/// measurements in one, or what `check_measured_tracks` refuses.
MeasurementNoise identify_measurement_noise(const std::vector<MeasuredTrack>& still, NoiseUnit unit);

/// The filters whose noises can be identified.
using TunableOptions = std::variant<KalmanCvOptions, KalmanCaOptions>;

/// How well a filter fits measurements: tests of Bar-Shalom, Li and Kirubarajan 2001, 5.4.2, on its innovations.
struct FilterConsistency {
  std::int64_t steps = 0;       ///< innovations of 2 numbers: measurements after the first of each track
  double log_likelihood = 0.0;  ///< of all measurements after the first, in px
  double nis_mean = 0.0;        ///< mean of y' S^-1 y: 2 if Q and R fit; above: they are too small
  std::pair<double, double> nis_band;  ///< that holds it with probability 0.95 if they fit
  double correlation = 0.0;        ///< of innovations with the next one of the track, each by its deviation; 0 if they fit
  double correlation_limit = 0.0;  ///< of its size, with probability 0.95 if they fit
};

/// Runs the filter over the tracks, each from its first measurement. A missing measurement is one longer step, and
/// `lost_damping_time` counts for nothing. Throws `InputError`: no steps or more than 500000, or what
/// `check_measured_tracks` refuses; `ConfigError`: options out of bounds.
FilterConsistency filter_consistency(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options);

/// Q, by maximum likelihood.
struct ProcessNoise {
  TunableOptions options;              ///< those given, with what was found
  NoiseEstimate process_noise;         ///< `velocity_noise` or `acceleration_noise`
  NoiseEstimate position_noise;
  NoiseEstimate initial_velocity;
  NoiseEstimate initial_acceleration;  ///< of `kalman_ca`; 0 otherwise
  FilterConsistency before, after;     ///< with the options given, and with those found
};

/// Which noises maximise the sum of the logarithms of the innovations' densities over all tracks (Bar-Shalom, Li and
/// Kirubarajan 2001, 11.6.2): searched by their logarithms, without derivatives (Nelder and Mead 1965), from the options
/// given and from less and more process noise. Also fits `position_noise`, unless it is not to be touched, and the
/// deviations of a new track, so that what is not known at its start is not taken for process noise. Standard errors are
/// those of the likelihood's curvature. Throws as `filter_consistency` does, and `InputError` for fewer than 10 steps.
ProcessNoise identify_process_noise(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options,
                                    bool fit_position_noise = true);

}  // namespace survtrack
