// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/particle_filter.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/covariance.hpp"

namespace survtrack {
namespace {

void check_options(const ParticleFilter::Options& options) {
  if (options.count < 1 || options.count > 10'000'000) {
    throw InputError("count: is " + std::to_string(options.count) + "; expected 1 to 10000000 particles");
  }
  if (!(options.resample_below >= 0.0 && options.resample_below <= 1.0)) {
    throw InputError("resample_below: is " + std::to_string(options.resample_below) + "; expected a share, 0 to 1");
  }
}

void check_weights(const Eigen::VectorXd& weights) {
  check_matrix("weights", weights, weights.size(), 1);
  if (weights.minCoeff() < 0.0 || !(weights.sum() > 0.0) || !std::isfinite(weights.sum())) {
    throw InputError("weights: expected numbers of at least 0 with a sum above 0");
  }
}

}  // namespace

ParticleFilter::ParticleFilter(Model model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P, const Options& options)
    : model_(std::move(model)), options_(options), random_(options.seed) {
  check_options(options);
  if (!model_.f) throw InputError("f: is missing; expected the function that moves particles");
  if (!model_.log_likelihood) throw InputError("log_likelihood: is missing; expected the function that judges particles");
  check_matrix("x", x, x.size(), 1);
  check_covariance("Q", model_.Q, x.size());
  check_covariance("P", P, x.size());
  noise_root_ = covariance_root("Q", model_.Q);
  particles_ = x.replicate(1, options.count);
  add_noise(particles_, covariance_root("P", P));
  weights_ = Eigen::VectorXd::Constant(options.count, 1.0 / options.count);
}

void ParticleFilter::add_noise(Eigen::MatrixXd& particles, const Eigen::MatrixXd& root) {
  if (root.isZero(0.0)) return;
  Eigen::VectorXd normal(root.rows());
  for (Eigen::Index i = 0; i < particles.cols(); ++i) {
    for (double& number : normal) number = random_.normal();
    particles.col(i) += root * normal;
  }
}

void ParticleFilter::predict(const Eigen::VectorXd& u) {
  Eigen::MatrixXd moved = model_.f(particles_, u);
  check_matrix("f", moved, particles_.rows(), particles_.cols());
  add_noise(moved, noise_root_);
  particles_ = std::move(moved);
}

void ParticleFilter::update(const Eigen::VectorXd& z) {
  check_matrix("z", z, z.size(), 1);
  Eigen::VectorXd logs = model_.log_likelihood(z, particles_);
  if (logs.size() != options_.count) {
    throw InputError("log_likelihood: returned " + std::to_string(logs.size()) + " numbers; expected " +
                     std::to_string(options_.count) + ", one a particle");
  }
  for (Eigen::Index i = 0; i < logs.size(); ++i) {
    if (!(logs(i) < std::numeric_limits<double>::infinity())) {
      throw InputError("log_likelihood[" + std::to_string(i) + "]: is " + std::to_string(logs(i)) +
                       "; expected a finite number, or -inf where z is impossible");
    }
    logs(i) += std::log(weights_(i));
  }
  const double largest = logs.maxCoeff();
  if (!std::isfinite(largest)) {
    throw InputError("log_likelihood: z is impossible for every particle; expected a finite number for at least one");
  }
  // Relative to the largest, so that the exponentials neither overflow nor all vanish.
  const Eigen::VectorXd weights = logs.unaryExpr([&](double l) { return std::exp(l - largest); });
  const double sum = weights.sum();
  log_likelihood_ = largest + std::log(sum);
  weights_ = weights / sum;
  if (effective_size() < options_.resample_below * options_.count) resample();
}

void ParticleFilter::resample() {
  const std::vector<int> chosen = systematic_resample(weights_, random_.uniform());
  Eigen::MatrixXd drawn(particles_.rows(), particles_.cols());
  for (Eigen::Index i = 0; i < drawn.cols(); ++i) drawn.col(i) = particles_.col(chosen[static_cast<std::size_t>(i)]);
  particles_ = std::move(drawn);
  weights_.setConstant(1.0 / options_.count);
  ++resamplings_;
}

Eigen::VectorXd ParticleFilter::x() const { return particles_ * weights_; }

Eigen::MatrixXd ParticleFilter::P() const {
  const Eigen::MatrixXd away = particles_.colwise() - x();
  const Eigen::MatrixXd P = away * weights_.asDiagonal() * away.transpose();
  return 0.5 * (P + P.transpose());
}

double ParticleFilter::effective_size() const { return 1.0 / weights_.squaredNorm(); }

void ParticleFilter::restore(const Eigen::MatrixXd& particles, const Eigen::VectorXd& weights,
                             const Random::State& random, double log_likelihood, int resamplings) {
  check_matrix("particles", particles, particles_.rows(), particles_.cols());
  check_matrix("weights", weights, weights_.size(), 1);
  check_weights(weights);
  particles_ = particles;
  weights_ = weights;
  random_.set_state(random);
  log_likelihood_ = log_likelihood;
  resamplings_ = resamplings;
}

std::vector<int> systematic_resample(const Eigen::VectorXd& weights, double offset) {
  check_weights(weights);
  if (!(offset >= 0.0 && offset < 1.0)) {
    throw InputError("offset: is " + std::to_string(offset) + "; expected a number from 0 up to 1, without 1");
  }
  const Eigen::Index count = weights.size();
  const double step = weights.sum() / static_cast<double>(count);
  std::vector<int> chosen(static_cast<std::size_t>(count));
  Eigen::Index item = 0;
  double reached = weights(0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double position = (static_cast<double>(i) + offset) * step;
    // Rounding may carry the last positions past the sum: what has no weight is not chosen even then.
    while (position >= reached && item + 1 < count) reached += weights(++item);
    while (weights(item) == 0.0) --item;
    chosen[static_cast<std::size_t>(i)] = static_cast<int>(item);
  }
  return chosen;
}

}  // namespace survtrack
