// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "filtering/innovations.hpp"
#include "filtering/simplex_search.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/chi_square.hpp"

namespace survtrack {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest = 1e-6, largest = 1e6;  ///< of noises, as the options' bounds are

Noises noises_of(const KalmanCvOptions& o) { return {o.velocity_noise, o.position_noise, 0.0, o.initial_velocity, 0.0}; }
Noises noises_of(const KalmanCaOptions& o) {
  return {o.acceleration_noise, o.position_noise, o.initial_position, o.initial_velocity, o.initial_acceleration};
}
void set_noises(KalmanCvOptions& o, const Noises& n) {
  o.velocity_noise = n.process;
  o.position_noise = n.position;
  o.initial_velocity = n.start_velocity;
}
void set_noises(KalmanCaOptions& o, const Noises& n) {
  o.acceleration_noise = n.process;
  o.position_noise = n.position;
  o.initial_velocity = n.start_velocity;
  o.initial_acceleration = n.start_acceleration;
}
Noises noises_of(const TunableOptions& options) {
  return std::visit([](const auto& o) { return noises_of(o); }, options);
}

std::int64_t checked_steps(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options, std::int64_t least) {
  std::visit([](const auto& o) { check_fields(o, "options"); }, options);
  check_measured_tracks(tracks, 1);
  std::int64_t steps = 0;
  for (const MeasuredTrack& track : tracks) steps += static_cast<std::int64_t>(track.times.size()) - 1;
  if (steps >= least && steps <= 500'000) return steps;
  throw InputError("tracks: have " + std::to_string(steps) + " steps from one measurement to the next; expected " +
                   std::to_string(least) + " to 500000");
}

/// The noises that are searched, by their logarithms.
struct Search {
  const Innovations& innovations;
  Noises noises;
  std::vector<double Noises::*> fitted;

  Noises at(const Eigen::VectorXd& logs) const {
    Noises here = noises;
    for (std::size_t i = 0; i < fitted.size(); ++i) here.*fitted[i] = std::exp(logs(static_cast<Eigen::Index>(i)));
    return here;
  }
  Eigen::VectorXd logs() const {
    Eigen::VectorXd logs(static_cast<Eigen::Index>(fitted.size()));
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      logs(static_cast<Eigen::Index>(i)) = std::log(std::clamp(noises.*fitted[i], smallest, largest));
    }
    return logs;
  }
  double cost(const Eigen::VectorXd& logs) const {
    const double value = -innovations.judge(at(logs)).log_likelihood;
    return std::isfinite(value) ? value : infinity;
  }
  double bounded_cost(const Eigen::VectorXd& logs) const {
    constexpr double rounding = 1e-9;
    if (logs.minCoeff() < std::log(smallest) - rounding || logs.maxCoeff() > std::log(largest) + rounding) return infinity;
    return cost(logs);
  }
};

Eigen::VectorXd best_logs(const Search& search) {
  const auto cost = [&](const Eigen::VectorXd& logs) { return search.bounded_cost(logs); };
  Eigen::VectorXd best;
  double lowest = infinity;
  for (const double more : {0.0, -3.0, 3.0}) {
    Eigen::VectorXd start = search.logs();
    start(0) = std::clamp(start(0) + more, std::log(smallest), std::log(largest));
    const Eigen::VectorXd found = lower_place(cost, start, 0.7, 0.05);
    const double value = cost(found);
    if (best.size() != 0 && !(value < lowest)) continue;
    best = found;
    lowest = value;
  }
  return lowest_place(cost, best, 0.1);
}

/// Deviations of the logarithms: the roots of the diagonal of the inverse of the second derivatives, by differences.
/// Infinite for those on which nothing depends.
Eigen::VectorXd deviations(const Search& search, const Eigen::VectorXd& logs) {
  constexpr double h = 0.02;
  const Eigen::Index n = logs.size();
  const auto cost = [&](Eigen::Index i, double at_i, Eigen::Index j, double at_j) {
    Eigen::VectorXd x = logs;
    x(i) += at_i;
    x(j) += at_j;
    return search.cost(x);
  };
  Eigen::MatrixXd second(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      second(i, j) = (cost(i, h, j, h) - cost(i, h, j, -h) - cost(i, -h, j, h) + cost(i, -h, j, -h)) / (4.0 * h * h);
    }
  }
  std::vector<Eigen::Index> determined;
  for (Eigen::Index i = 0; i < n; ++i) {
    // Below one it would be known to no better than a factor of e.
    const bool inside = logs(i) > std::log(smallest) + 0.05 && logs(i) < std::log(largest) - 0.05;
    if (inside && second(i, i) > 1.0) determined.push_back(i);
  }
  Eigen::VectorXd result = Eigen::VectorXd::Constant(n, infinity);
  const auto m = static_cast<Eigen::Index>(determined.size());
  Eigen::MatrixXd part(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      part(i, j) = second(determined[static_cast<std::size_t>(i)], determined[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(0.5 * (part + part.transpose()));
  if (m == 0 || cholesky.info() != Eigen::Success) return result;
  const Eigen::MatrixXd covariance = cholesky.solve(Eigen::MatrixXd::Identity(m, m));
  for (Eigen::Index i = 0; i < m; ++i) result(determined[static_cast<std::size_t>(i)]) = std::sqrt(covariance(i, i));
  return result;
}

FilterConsistency judged(const Innovations& innovations, const TunableOptions& options) {
  FilterConsistency found = innovations.judge(noises_of(options));
  found.nis_band = nis_band(2, static_cast<int>(found.steps));
  return found;
}

}  // namespace

FilterConsistency filter_consistency(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options) {
  checked_steps(tracks, options, 1);
  return judged(*make_innovations(tracks, options), options);
}

ProcessNoise identify_process_noise(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options,
                                    bool fit_position_noise) {
  checked_steps(tracks, options, 10);
  const auto innovations = make_innovations(tracks, options);
  Search search{*innovations, noises_of(options), {&Noises::process, &Noises::start_velocity}};
  if (std::holds_alternative<KalmanCaOptions>(options)) search.fitted.push_back(&Noises::start_acceleration);
  if (fit_position_noise) search.fitted.push_back(&Noises::position);

  ProcessNoise found;
  found.options = options;
  found.before = judged(*innovations, options);
  const Eigen::VectorXd logs = best_logs(search);
  const Eigen::VectorXd errors = deviations(search, logs);
  Noises noises = search.at(logs), standard_errors;
  for (std::size_t i = 0; i < search.fitted.size(); ++i) {
    double& value = noises.*search.fitted[i];
    value = std::clamp(value, smallest, largest);
    standard_errors.*search.fitted[i] = value * errors(static_cast<Eigen::Index>(i));
  }
  std::visit([&](auto& o) { set_noises(o, noises); }, found.options);
  found.process_noise = {noises.process, standard_errors.process};
  found.position_noise = {noises.position, standard_errors.position};
  found.initial_velocity = {noises.start_velocity, standard_errors.start_velocity};
  found.initial_acceleration = {noises.start_acceleration, standard_errors.start_acceleration};
  found.after = judged(*innovations, found.options);
  return found;
}

}  // namespace survtrack
