// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "filtering/straight_line.hpp"
#include "survtrack/filtering/noise_identification.hpp"

namespace survtrack {

MeasurementNoise identify_measurement_noise(const std::vector<MeasuredTrack>& still, NoiseUnit unit) {
  check_measured_tracks(still, 3);
  MeasurementNoise noise;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const MeasuredTrack& track : still) {
    const StraightLine line(track);
    const bool in_px = unit == NoiseUnit::px || track.lengths.empty();
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      const Point off = (1.0 / (in_px ? 1.0 : track.lengths[i])) * line.residual(track.times[i], track.positions[i]);
      const Eigen::Vector2d y(off.x, off.y);
      sum += y * y.transpose();
    }
    noise.samples += static_cast<std::int64_t>(track.times.size());
    noise.degrees += static_cast<std::int64_t>(track.times.size()) - 2;
  }
  const auto degrees = static_cast<double>(noise.degrees);
  const Eigen::Matrix2d R = sum / degrees;
  noise.R = R;
  // Of a Wishart matrix: var R_ij = (R_ii R_jj + R_ij^2) / degrees.
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 2; ++j) {
      noise.standard_error(i, j) = std::sqrt((R(i, i) * R(j, j) + R(i, j) * R(i, j)) / degrees);
    }
  }
  // The mean of both variances has the variance tr(R^2) / (2 degrees), and its root the error of that by 2 of itself.
  noise.position_noise.value = std::sqrt(0.5 * R.trace());
  const double error = std::sqrt(0.5 * R.squaredNorm() / degrees);
  if (noise.position_noise.value > 0.0) noise.position_noise.standard_error = 0.5 * error / noise.position_noise.value;
  return noise;
}

}  // namespace survtrack
