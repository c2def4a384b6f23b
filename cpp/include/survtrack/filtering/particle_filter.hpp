// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "survtrack/filtering/random.hpp"

namespace survtrack {

/// The particle filter of Gordon, Salmond and Smith 1993 (bootstrap filter): any motion, any noise of measurements.
/// Systematic resampling, when the effective sample size 1 / sum w^2 falls under a share of the particles.
class ParticleFilter {
 public:
  /// Moves all particles at once, a column each, without noise of covariance Q, which the filter adds.
  using Transition = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& particles, const Eigen::VectorXd& u)>;
  /// The logarithm of the likelihood of z given each particle, up to a constant; -inf where z is impossible.
  using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::VectorXd& z, const Eigen::MatrixXd& particles)>;

  struct Model {
    Transition f;
    LogLikelihood log_likelihood;
    Eigen::MatrixXd Q;  ///< n x n; zero: f adds noise of its own, or there is none
  };
  struct Options {
    int count = 1000;             ///< of particles, 1 ... 10 million
    double resample_below = 0.5;  ///< share of `count`, 0 ... 1; 0: never
    std::uint64_t seed = 0;
  };

  /// Draws the particles from the Gaussian of mean x and covariance P. Throws `InputError` naming what is wrong; a
  /// callable's exceptions pass through, and leave the filter as it was (but for the random numbers it used up).
  ParticleFilter(Model model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P, const Options& options);

  void predict(const Eigen::VectorXd& u = {});
  /// Weights the particles by the likelihood of z, then resamples where needed. Throws `InputError` where z is
  /// impossible for all particles.
  void update(const Eigen::VectorXd& z);

  Eigen::VectorXd x() const;  ///< weighted mean
  Eigen::MatrixXd P() const;  ///< weighted covariance about it
  const Eigen::MatrixXd& particles() const { return particles_; }  ///< a column each
  const Eigen::VectorXd& weights() const { return weights_; }      ///< their sum is 1
  double effective_size() const;                                   ///< of the weights as they are now: 1 ... count
  double log_likelihood() const { return log_likelihood_; }  ///< of the last z given those before, as far as known
  int resamplings() const { return resamplings_; }           ///< so far

  const Model& model() const { return model_; }
  const Options& options() const { return options_; }
  const Random& random() const { return random_; }
  /// Goes on from another filter's particles, weights and random numbers. Throws `InputError`.
  void restore(const Eigen::MatrixXd& particles, const Eigen::VectorXd& weights, const Random::State& random,
               double log_likelihood, int resamplings);

 private:
  void add_noise(Eigen::MatrixXd& particles, const Eigen::MatrixXd& root);
  void resample();

  Model model_;
  Options options_;
  Random random_;
  Eigen::MatrixXd noise_root_;
  Eigen::MatrixXd particles_;
  Eigen::VectorXd weights_;
  double log_likelihood_ = 0.0;
  int resamplings_ = 0;
};

/// Which of the weighted items are drawn, in order, by systematic resampling: as many as there are weights, item i
/// between floor(count w_i) and ceil(count w_i) times (Kitagawa 1996). `offset` in [0, 1) is the one random number.
std::vector<int> systematic_resample(const Eigen::VectorXd& weights, double offset);

}  // namespace survtrack
