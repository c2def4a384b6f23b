// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "filtering/estimate_of.hpp"
#include "filtering/turn_banks.hpp"
#include "filtering/turn_motion.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"
#include "survtrack/filtering/particle_filter.hpp"
#include "survtrack/filtering/random.hpp"

namespace survtrack {
namespace {

using State = TurnMotion::State;
using Matrix = TurnMotion::Matrix;

/// A turn rate, and the Kalman filter of (x, y, vx, vy) that goes with it and with those before it.
struct Particle {
  double turn_rate;
  double weight;
  Eigen::Vector4d x;
  Eigen::Matrix4d P;
};

/// The particles of one track, and their mean and covariance.
class Swarm {
 public:
  Swarm(const ParticleOptions& options, std::uint64_t seed)
      : resample_below_(options.resample_below), random_(seed), particles_(static_cast<std::size_t>(options.particles)) {}

  /// All begin with the same belief but for their turn rates; what is believed of them together is known exactly.
  void start(const TurnNoise& noise, const Point& position, double length) {
    x_ = turn_start(position);
    P_ = turn_start_covariance(noise, length);
    for (Particle& particle : particles_) {
      particle = {noise.turn_rate * random_.normal(), 1.0 / count(), x_.head<4>(), P_.topLeftCorner<4, 4>()};
    }
  }

  void predict(const TurnMotion& motion, const Matrix& Q) {
    const double turn_noise = std::sqrt(motion.turn_variance());
    for (Particle& particle : particles_) {
      const Eigen::Matrix4d F = motion.transition(particle.turn_rate);
      const Eigen::Vector4d x = F * particle.x;
      const Eigen::Matrix4d P = F * particle.P * F.transpose() + Q.topLeftCorner<4, 4>();
      particle.turn_rate = motion.turn_kept() * particle.turn_rate + turn_noise * random_.normal();
      // As in the other banks: full doubles stay as they are.
      if (x.allFinite() && P.allFinite()) particle.x = x, particle.P = 0.5 * (P + P.transpose());
    }
    take_moments();
  }

  /// Each is corrected, and weighted by the likelihood that it gave the measurement. Throws `InputError` where the
  /// innovation covariance of one is singular.
  void correct(const Eigen::Vector2d& z, const Eigen::Matrix2d& R) {
    static const Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Identity();
    Eigen::VectorXd logs(static_cast<Eigen::Index>(particles_.size()));
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      Particle& particle = particles_[i];
      const Eigen::Vector2d y = z - particle.x.head<2>();
      const auto c = correct_linear<4, 2>(particle.x, particle.P, y, H, R, Covariances::checked);
      logs(static_cast<Eigen::Index>(i)) = std::log(particle.weight) + c.log_likelihood();
    }
    // Relative to the largest, so that the exponentials do not all vanish.
    const Eigen::VectorXd weights = (logs.array() - logs.maxCoeff()).exp();
    const double sum = weights.sum();
    if (!std::isfinite(sum)) throw InputError("measured: is too far away for every particle");
    for (std::size_t i = 0; i < particles_.size(); ++i) particles_[i].weight = weights(static_cast<Eigen::Index>(i)) / sum;
    take_moments();
    const double effective = sum * sum / weights.squaredNorm();
    if (effective < resample_below_ * count()) resample(weights / sum);
  }

  const State& x() const { return x_; }
  const Matrix& P() const { return P_; }

 private:
  double count() const { return static_cast<double>(particles_.size()); }

  void resample(const Eigen::VectorXd& weights) {
    const std::vector<int> chosen = systematic_resample(weights, random_.uniform());
    drawn_.clear();
    for (const int i : chosen) drawn_.push_back(particles_[static_cast<std::size_t>(i)]);
    for (Particle& particle : drawn_) particle.weight = 1.0 / count();
    particles_.swap(drawn_);
  }

  void take_moments() {
    const auto whole = [](const Particle& particle) {
      State x;
      x << particle.x, particle.turn_rate;
      return x;
    };
    // About the first one, so that places far from 0 lose no digits.
    const State center = whole(particles_.front());
    State shift = State::Zero();
    for (const Particle& particle : particles_) shift += particle.weight * (whole(particle) - center);
    x_ = center + shift;
    Matrix P = Matrix::Zero();
    for (const Particle& particle : particles_) {
      const State away = whole(particle) - x_;
      P += particle.weight * away * away.transpose();
      P.topLeftCorner<4, 4>() += particle.weight * particle.P;
    }
    P_ = 0.5 * (P + P.transpose());
  }

  double resample_below_;
  Random random_;
  std::vector<Particle> particles_, drawn_;
  State x_ = State::Zero();
  Matrix P_ = Matrix::Zero();
};

class TurnParticleBank final : public FilterBank {
 public:
  explicit TurnParticleBank(const ParticleOptions& options) : options_(options), noise_(options) {}

  int size() const override { return static_cast<int>(slots_.size()); }
  int add(const Point& position, double object_size_px) override {
    const std::uint64_t seed = (static_cast<std::uint64_t>(options_.seed) << 32) + births_++;
    slots_.push_back({Swarm(options_, seed), 0.0, false});
    restart(size() - 1, position, object_size_px);
    return size() - 1;
  }
  void restart(int slot, const Point& position, double object_size_px) override {
    Slot& s = at(slot);
    s.length = noise_.length(object_size_px);
    s.unmatched = false;
    s.swarm.start(noise_, position, s.length);
  }
  void remove(int slot) override { slots_.erase(slots_.begin() + slot); }
  void clear() override {
    slots_.clear();
    births_ = 0;
  }

  void predict(double dt) override {
    const TurnMotion matched(noise_, dt, false), lost(noise_, dt, true);
    for (Slot& slot : slots_) {
      const TurnMotion& motion = slot.unmatched ? lost : matched;
      slot.swarm.predict(motion, motion.noise(slot.length));
      slot.unmatched = true;
    }
  }

  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override {
    Slot& s = at(slot);
    try {
      s.swarm.correct({measured.x, measured.y}, noise_.R(s.length, extra_px2));
    } catch (const InputError&) {
      // As in the other banks: nothing is left to correct.
      s.swarm.start(noise_, measured, s.length);
    }
    s.unmatched = false;
  }

  void set_object_size(int slot, double object_size_px) override { at(slot).length = noise_.length(object_size_px); }

  Estimate estimate(int slot) const override {
    const Slot& s = at(slot);
    return estimate_of(s.swarm.x(), s.swarm.P(), round_noise(noise_.velocity_density(s.length)));
  }
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override {
    const Matrix& P = at(slot).swarm.P();
    const Eigen::Matrix2d R = noise_.R(at(slot).length, extra_px2);
    return {P(0, 0) + R(0, 0), P(0, 1) + R(0, 1), P(1, 1) + R(1, 1)};
  }
  Eigen::VectorXd state(int slot) const override { return at(slot).swarm.x(); }
  Eigen::MatrixXd state_covariance(int slot) const override { return at(slot).swarm.P(); }

 private:
  struct Slot {
    Swarm swarm;
    double length;   ///< px a unit of noise
    bool unmatched;  ///< since the last predict
  };
  Slot& at(int slot) { return slots_[static_cast<std::size_t>(slot)]; }
  const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }

  ParticleOptions options_;
  TurnNoise noise_;
  std::uint64_t births_ = 0;  ///< tracks have no ids while they are tentative
  std::vector<Slot> slots_;
};

}  // namespace

std::unique_ptr<FilterBank> make_bank(const ParticleOptions& options) {
  return std::make_unique<TurnParticleBank>(options);
}

}  // namespace survtrack
