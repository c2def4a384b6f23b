// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "filtering/innovations.hpp"

#include <cmath>

#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

/// Both axes have the same noises and do not touch each other: one covariance of one axis serves both, and the states of
/// the axes are two columns.
template <int Order>
class FilterRun final : public Innovations {
  using Matrix = Eigen::Matrix<double, Order, Order>;
  using States = Eigen::Matrix<double, Order, 2>;
  using Column = Eigen::Matrix<double, Order, 1>;

 public:
  FilterRun(const std::vector<MeasuredTrack>& tracks, NoiseUnit unit, NoiseForm form) {
    for (const MeasuredTrack& track : tracks) {
      const bool in_px = unit == NoiseUnit::px || track.lengths.empty();
      for (std::size_t i = 0; i < track.times.size(); ++i) {
        Step step;
        step.is_first = i == 0;
        step.z << track.positions[i].x, track.positions[i].y;
        step.length = in_px ? 1.0 : track.lengths[i];
        if (i > 0) set_matrices(step, track.times[i] - track.times[i - 1], form);
        steps_.push_back(step);
      }
    }
  }

  FilterConsistency judge(const Noises& noises) const override {
    constexpr double log_two_pi = 1.8378770664093453;
    FilterConsistency found;
    Eigen::RowVector2d before = Eigen::RowVector2d::Zero();
    States x = States::Zero();
    Matrix P = Matrix::Zero();
    double products = 0.0, squares = 0.0, next_squares = 0.0, logarithms = 0.0;
    for (const Step& step : steps_) {
      const double unit = step.length * step.length;
      if (step.is_first) {
        x.setZero();
        x.row(0) = step.z;
        P = unit * start(noises);
        before.setZero();
        continue;
      }
      x = (step.F * x).eval();
      P = (step.F * P * step.F.transpose() + noises.process * noises.process * unit * step.Q).eval();
      const double R = noises.position * noises.position * unit, S = P(0, 0) + R;
      const Eigen::RowVector2d y = step.z - x.row(0);
      const Column K = P.col(0) / S;
      x += K * y;
      Matrix I_KH = Matrix::Identity();
      I_KH.col(0) -= K;
      P = (I_KH * P * I_KH.transpose() + R * K * K.transpose()).eval();
      const Eigen::RowVector2d u = y / std::sqrt(S);
      const double nis = u.squaredNorm();
      found.nis_mean += nis;
      logarithms += std::log(S);
      if (before(0) != 0.0 || before(1) != 0.0) {
        products += u.dot(before);
        squares += before.squaredNorm();
        next_squares += nis;
        found.correlation_limit += 2.0;
      }
      before = u;
      ++found.steps;
    }
    const auto steps = static_cast<double>(found.steps);
    found.log_likelihood = -0.5 * found.nis_mean - logarithms - steps * log_two_pi;
    found.nis_mean /= steps;
    if (squares > 0.0 && next_squares > 0.0) found.correlation = products / std::sqrt(squares * next_squares);
    if (found.correlation_limit > 0.0) found.correlation_limit = 1.959963984540054 / std::sqrt(found.correlation_limit);
    return found;
  }

 private:
  struct Step {
    bool is_first = false;
    Eigen::RowVector2d z;
    double length = 1.0;  ///< px a unit of noise
    Matrix F = Matrix::Identity(), Q = Matrix::Zero();  ///< of one axis; Q of unit density
  };

  static void set_matrices(Step& step, double dt, NoiseForm form) {
    const auto F = MotionModel<Order>::transition(dt);
    const auto Q = MotionModel<Order>::unit_noise(dt);
    for (int i = 0; i < Order; ++i) {
      for (int j = 0; j < Order; ++j) {
        step.F(i, j) = F(2 * i, 2 * j);
        step.Q(i, j) = form == NoiseForm::continuous ? Q(2 * i, 2 * j) : (i == j ? dt : 0.0);
      }
    }
  }

  static Matrix start(const Noises& noises) {
    const double position = noises.start_position > 0.0 ? noises.start_position : noises.position;
    Column deviation;
    if constexpr (Order == 2) {
      deviation << position, noises.start_velocity;
    } else {
      deviation << position, noises.start_velocity, noises.start_acceleration;
    }
    return deviation.array().square().matrix().asDiagonal();
  }

  std::vector<Step> steps_;
};

}  // namespace

std::unique_ptr<Innovations> make_innovations(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options) {
  if (const auto* ca = std::get_if<KalmanCaOptions>(&options)) {
    return std::make_unique<FilterRun<3>>(tracks, ca->noise_unit, ca->noise_form);
  }
  return std::make_unique<FilterRun<2>>(tracks, std::get<KalmanCvOptions>(options).noise_unit, NoiseForm::continuous);
}

}  // namespace survtrack
