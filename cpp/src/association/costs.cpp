// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/costs.hpp"

#include <cmath>

namespace survtrack {

double match_matrix_entry(const Track& track, const Detection& detection, double frame_width, double frame_height) {
  const Point d = detection.position - track.position;
  const Color& a = track.mean_color;
  const Color& b = detection.mean_color;
  return std::hypot(d.x / frame_width, d.y / frame_height) +
         std::hypot((b.red - a.red) / 255.0, (b.green - a.green) / 255.0, (b.blue - a.blue) / 255.0);
}

double squared_mahalanobis(const Innovation& innovation) {
  const Symmetric2& S = innovation.covariance_px2;
  const Point& r = innovation.residual;
  return (S.yy * r.x * r.x - 2.0 * S.xy * r.x * r.y + S.xx * r.y * r.y) / (S.xx * S.yy - S.xy * S.xy);
}

double gaussian_cost(const GaussianCostOptions& options, const Innovation& innovation, double track_area_px) {
  const double distance = squared_mahalanobis(innovation);
  if (!(distance <= options.gate)) return CostMatrix::gated;
  const Symmetric2& S = innovation.covariance_px2;
  const double spread = std::log((S.xx * S.yy - S.xy * S.xy) / (track_area_px * track_area_px));
  return distance + spread;
}

}  // namespace survtrack
