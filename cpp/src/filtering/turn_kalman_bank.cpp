// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <vector>

#include "filtering/estimate_of.hpp"
#include "filtering/turn_banks.hpp"
#include "filtering/turn_motion.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"

namespace survtrack {
namespace {

using State = TurnMotion::State;
using Matrix = TurnMotion::Matrix;

/// Predicts as `ExtendedKalmanFilter` does.
struct Linearised {
  void predict(const TurnMotion& motion, const Matrix& Q, State& x, Matrix& P) const {
    const Matrix F = motion.jacobian(x);
    x = motion.moved(x);
    const Matrix predicted = F * P * F.transpose() + Q;
    P = 0.5 * (predicted + predicted.transpose());
  }
};

/// L of P = L L'. Of the correlations, whose numbers are of one size whatever those of P; what rounding leaves below 0
/// counts as 0.
Matrix root_of(const Matrix& P) {
  const State deviation = P.diagonal().cwiseMax(0.0).cwiseSqrt();
  const State inverse = deviation.unaryExpr([](double d) { return d > 0.0 ? 1.0 / d : 0.0; });
  const Matrix C = inverse.asDiagonal() * P * inverse.asDiagonal();
  Matrix L = Matrix::Zero();
  for (Eigen::Index j = 0; j < 5; ++j) {
    const double pivot = C(j, j) - L.row(j).head(j).squaredNorm();
    if (!(pivot > 1e-15)) continue;
    L(j, j) = std::sqrt(pivot);
    for (Eigen::Index i = j + 1; i < 5; ++i) L(i, j) = (C(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
  }
  return deviation.asDiagonal() * L;
}

/// Predicts as `UnscentedKalmanFilter` does, with kappa 0.
struct Unscented {
  double alpha, beta;

  void predict(const TurnMotion& motion, const Matrix& Q, State& x, Matrix& P) const {
    const double spread = 5.0 * alpha * alpha, weight = 0.5 / spread;
    const Matrix root = std::sqrt(spread) * root_of(P);
    const State center = motion.moved(x);
    Eigen::Matrix<double, 5, 10> away;
    for (Eigen::Index j = 0; j < 5; ++j) {
      away.col(j) = motion.moved(x + root.col(j)) - center;
      away.col(5 + j) = motion.moved(x - root.col(j)) - center;
    }
    const State shift = weight * away.rowwise().sum();
    x = center + shift;
    // The weighted squares about the shifted mean, the middle point's among them: equal to those about the middle point
    // plus (beta - alpha^2) shift shift'.
    const Matrix predicted = weight * away * away.transpose() + (beta - alpha * alpha) * shift * shift.transpose() + Q;
    P = 0.5 * (predicted + predicted.transpose());
  }
};

/// Kalman filters of turning objects. The measurement is linear, so that all correct alike.
template <class Prediction>
class TurnKalmanBank final : public FilterBank {
 public:
  TurnKalmanBank(const TurnNoise& noise, const Prediction& prediction) : noise_(noise), prediction_(prediction) {
    H_.setZero();
    H_(0, 0) = H_(1, 1) = 1.0;
  }

  int size() const override { return static_cast<int>(slots_.size()); }
  int add(const Point& position, double object_size_px) override {
    slots_.emplace_back();
    restart(size() - 1, position, object_size_px);
    return size() - 1;
  }
  void restart(int slot, const Point& position, double object_size_px) override {
    const double length = noise_.length(object_size_px);
    at(slot) = {turn_start(position), turn_start_covariance(noise_, length), length, false};
  }
  void remove(int slot) override { slots_.erase(slots_.begin() + slot); }
  void clear() override { slots_.clear(); }

  void predict(double dt) override {
    const TurnMotion matched(noise_, dt, false), lost(noise_, dt, true);
    for (Slot& slot : slots_) {
      const TurnMotion& motion = slot.unmatched ? lost : matched;
      State x = slot.x;
      Matrix P = slot.P;
      prediction_.predict(motion, motion.noise(slot.length), x, P);
      slot.unmatched = true;
      // After millions of steps without a measurement even a double is full: what is believed then stays as it is.
      if (x.allFinite() && P.allFinite()) slot.x = x, slot.P = P;
    }
  }

  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override {
    Slot& s = at(slot);
    const Eigen::Vector2d y(measured.x - s.x(0), measured.y - s.x(1));
    try {
      correct_linear<5, 2>(s.x, s.P, y, H_, noise_.R(s.length, extra_px2), Covariances::checked);
    } catch (const InputError&) {
      // The innovation covariance is singular but for rounding: next to what is not known the measurement is exact.
      s.x = turn_start(measured);
      s.P = turn_start_covariance(noise_, s.length);
    }
    s.unmatched = false;
  }

  void set_object_size(int slot, double object_size_px) override { at(slot).length = noise_.length(object_size_px); }

  Estimate estimate(int slot) const override {
    const Slot& s = at(slot);
    return estimate_of(s.x, s.P, round_noise(noise_.velocity_density(s.length)));
  }
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override {
    const Slot& s = at(slot);
    const Eigen::Matrix2d R = noise_.R(s.length, extra_px2);
    return {s.P(0, 0) + R(0, 0), s.P(0, 1) + R(0, 1), s.P(1, 1) + R(1, 1)};
  }
  Eigen::VectorXd state(int slot) const override { return at(slot).x; }
  Eigen::MatrixXd state_covariance(int slot) const override { return at(slot).P; }

 private:
  struct Slot {
    State x;
    Matrix P;
    double length;   ///< px a unit of noise
    bool unmatched;  ///< since the last predict
  };
  Slot& at(int slot) { return slots_[static_cast<std::size_t>(slot)]; }
  const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }

  TurnNoise noise_;
  Prediction prediction_;
  Eigen::Matrix<double, 2, 5> H_;
  std::vector<Slot> slots_;
};

}  // namespace

std::unique_ptr<FilterBank> make_bank(const ExtendedOptions& options) {
  return std::make_unique<TurnKalmanBank<Linearised>>(TurnNoise(options), Linearised{});
}

std::unique_ptr<FilterBank> make_bank(const UnscentedOptions& options) {
  return std::make_unique<TurnKalmanBank<Unscented>>(TurnNoise(options), Unscented{options.alpha, options.beta});
}

}  // namespace survtrack
