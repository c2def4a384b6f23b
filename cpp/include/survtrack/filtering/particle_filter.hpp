// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/covariance.hpp"
#include "survtrack/filtering/random.hpp"

namespace survtrack {

struct ParticleFilterOptions {
  int count = 1000;             ///< of particles, 1 ... 10 million
  double resample_below = 0.5;  ///< share of `count`, 0 ... 1; 0: never
  std::uint64_t seed = 0;
};

/// Throws `InputError` for what is out of its range.
void check_particle_options(const ParticleFilterOptions& options);
/// Throws `InputError` unless these are numbers of at least 0 with a sum above 0.
void check_particle_weights(const Eigen::VectorXd& weights);

/// Which of the weighted items are drawn, in order, by systematic resampling: as many as there are weights, item i
/// between floor(count w_i) and ceil(count w_i) times (Kitagawa 1996). `offset` in [0, 1) is the one random number.
std::vector<int> systematic_resample(const Eigen::VectorXd& weights, double offset);

/// The particle filter of Gordon, Salmond and Smith 1993 (bootstrap filter): any motion, any noise of measurements.
/// Systematic resampling, when the effective sample size 1 / sum w^2 falls under a share of the particles.
/// `ParticleFilter<4>` has 4 states; `ParticleFilter<>` takes their number from the model.
template <int N = Eigen::Dynamic>
class ParticleFilter {
 public:
  using State = Eigen::Matrix<double, N, 1>;
  using StateMatrix = Eigen::Matrix<double, N, N>;
  using Particles = Eigen::Matrix<double, N, Eigen::Dynamic>;
  using Options = ParticleFilterOptions;
  /// Moves all particles at once, a column each, without noise of covariance Q, which the filter adds.
  using Transition = std::function<Particles(const Particles& particles, const Eigen::VectorXd& u)>;
  /// The logarithm of the likelihood of z given each particle, up to a constant; -inf where z is impossible.
  using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::VectorXd& z, const Particles& particles)>;

  struct Model {
    Transition f;
    LogLikelihood log_likelihood;
    StateMatrix Q;  ///< n x n; zero: f adds noise of its own, or there is none
  };

  /// Draws the particles from the Gaussian of mean x and covariance P. Throws `InputError` naming what is wrong; a
  /// callable's exceptions pass through, and leave the filter as it was (but for the random numbers it used up).
  ParticleFilter(Model model, const State& x, const StateMatrix& P, const Options& options)
      : model_(std::move(model)), options_(options), random_(options.seed) {
    check_particle_options(options);
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

  void predict(const Eigen::VectorXd& u = {}) {
    Particles moved = model_.f(particles_, u);
    check_matrix("f", moved, particles_.rows(), particles_.cols());
    add_noise(moved, noise_root_);
    particles_ = std::move(moved);
  }
  /// Weights the particles by the likelihood of z, then resamples where needed. Throws `InputError` where z is
  /// impossible for all particles.
  void update(const Eigen::VectorXd& z);

  State x() const { return particles_ * weights_; }  ///< weighted mean
  /// Weighted covariance about it.
  StateMatrix P() const {
    const Particles away = particles_.colwise() - x();
    const StateMatrix P = away * weights_.asDiagonal() * away.transpose();
    return 0.5 * (P + P.transpose());
  }
  const Particles& particles() const { return particles_; }    ///< a column each
  const Eigen::VectorXd& weights() const { return weights_; }  ///< their sum is 1
  double effective_size() const { return 1.0 / weights_.squaredNorm(); }  ///< of the weights as they are now: 1 ... count
  double log_likelihood() const { return log_likelihood_; }  ///< of the last z given those before, as far as known
  int resamplings() const { return resamplings_; }           ///< so far

  const Model& model() const { return model_; }
  const Options& options() const { return options_; }
  const Random& random() const { return random_; }
  /// Goes on from another filter's particles, weights and random numbers. Throws `InputError`.
  void restore(const Particles& particles, const Eigen::VectorXd& weights, const Random::State& random,
               double log_likelihood, int resamplings) {
    check_matrix("particles", particles, particles_.rows(), particles_.cols());
    check_matrix("weights", weights, weights_.size(), 1);
    check_particle_weights(weights);
    particles_ = particles;
    weights_ = weights;
    random_.set_state(random);
    log_likelihood_ = log_likelihood;
    resamplings_ = resamplings;
  }

 private:
  void add_noise(Particles& particles, const StateMatrix& root) {
    if (root.isZero(0.0)) return;
    State normal = State::Zero(root.rows());
    for (Eigen::Index i = 0; i < particles.cols(); ++i) {
      for (double& number : normal) number = random_.normal();
      particles.col(i).noalias() += root * normal;
    }
  }
  void resample() {
    const std::vector<int> chosen = systematic_resample(weights_, random_.uniform());
    Particles drawn(particles_.rows(), particles_.cols());
    for (Eigen::Index i = 0; i < drawn.cols(); ++i) drawn.col(i) = particles_.col(chosen[static_cast<std::size_t>(i)]);
    particles_ = std::move(drawn);
    weights_.setConstant(1.0 / options_.count);
    ++resamplings_;
  }

  Model model_;
  Options options_;
  Random random_;
  StateMatrix noise_root_;
  Particles particles_;
  Eigen::VectorXd weights_;
  double log_likelihood_ = 0.0;
  int resamplings_ = 0;
};

template <int N>
void ParticleFilter<N>::update(const Eigen::VectorXd& z) {
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

}  // namespace survtrack
