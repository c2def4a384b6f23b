// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/filter_bank.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "filtering/estimate_of.hpp"
#include "filtering/turn_banks.hpp"
#include "survtrack/filtering/box_bank.hpp"
#include "survtrack/filtering/discrete_bank.hpp"
#include "survtrack/filtering/kalman_bank.hpp"
#include "survtrack/filtering/mean_velocity_bank.hpp"
#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

/// Kalman filters over a position: constant velocity (Order 2) or constant acceleration (Order 3).
template <int Order>
class KalmanFilterBank final : public FilterBank {
  using Model = MotionModel<Order>;
  using Bank = KalmanBank<Model::state_size, 2>;
  using State = typename Bank::State;
  using Covariance = typename Bank::Covariance;

 public:
  struct Noise {
    NoiseUnit unit;
    double density_root;
    NoiseForm form;
    double position;
    State initial_deviation;
    double lost_damping_time;
  };

  explicit KalmanFilterBank(const Noise& noise) : noise_(noise) {
    H_.setZero();
    H_(0, 0) = H_(1, 1) = 1.0;
  }

  int size() const override { return bank_.size(); }

  int add(const Point& position, double object_size_px) override {
    lengths_.push_back(0.0);
    unmatched_.push_back(0);
    const int slot = bank_.add(State::Zero(), Covariance::Zero());
    restart(slot, position, object_size_px);
    return slot;
  }

  void restart(int slot, const Point& position, double object_size_px) override {
    lengths_[at(slot)] = length(object_size_px);
    unmatched_[at(slot)] = 0;
    bank_.x(slot) = State::Zero();
    bank_.x(slot).template head<2>() << position.x, position.y;
    const State deviation = lengths_[at(slot)] * noise_.initial_deviation;
    bank_.P(slot) = deviation.array().square().matrix().asDiagonal();
  }

  void remove(int slot) override {
    bank_.remove(slot);
    lengths_.erase(lengths_.begin() + slot);
    unmatched_.erase(unmatched_.begin() + slot);
  }

  void clear() override {
    bank_.clear();
    lengths_.clear();
    unmatched_.clear();
  }

  void predict(double dt) override {
    const typename Model::Matrix F = Model::transition(dt);
    const typename Model::Matrix Q =
        noise_.form == NoiseForm::continuous ? Model::unit_noise(dt) : typename Model::Matrix(dt * Model::Matrix::Identity());
    typename Model::Matrix F_lost = F;
    if (noise_.lost_damping_time > 0.0) {
      // v' = -v / tau: the way to a standstill is tau v, and two steps of dt / 2 are one of dt.
      const double tau = noise_.lost_damping_time;
      F_lost.template block<2, 2>(2, 2) *= std::exp(-dt / tau);
      F_lost.template block<2, 2>(0, 2) *= -std::expm1(-dt / tau) * tau / dt;
    }
    for (int slot = 0; slot < bank_.size(); ++slot) {
      const double deviation = noise_.density_root * lengths_[at(slot)];
      bank_.predict(slot, unmatched_[at(slot)] != 0 ? F_lost : F, deviation * deviation * Q);
      unmatched_[at(slot)] = 1;
    }
  }

  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override {
    bank_.correct(slot, Eigen::Vector2d(measured.x, measured.y), H_, R(slot, extra_px2));
    unmatched_[at(slot)] = 0;
  }

  void set_object_size(int slot, double object_size_px) override { lengths_[at(slot)] = length(object_size_px); }

  Estimate estimate(int slot) const override {
    const double deviation = noise_.density_root * lengths_[at(slot)];
    // Noise in the acceleration is not one in the velocity.
    const bool direct = Order == 2 || noise_.form == NoiseForm::identity;
    return estimate_of(bank_.x(slot), bank_.P(slot), round_noise(direct ? deviation * deviation : 0.0));
  }
  Point predicted_position(int slot) const override { return {bank_.x(slot)(0), bank_.x(slot)(1)}; }

  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override {
    const Eigen::Matrix2d S = bank_.innovation_covariance(slot, H_, R(slot, extra_px2));
    return {S(0, 0), S(0, 1), S(1, 1)};
  }

  Eigen::VectorXd state(int slot) const override { return bank_.x(slot); }
  Eigen::MatrixXd state_covariance(int slot) const override { return bank_.P(slot); }

 private:
  static std::size_t at(int slot) { return static_cast<std::size_t>(slot); }
  double length(double object_size_px) const { return noise_.unit == NoiseUnit::px ? 1.0 : object_size_px; }

  Eigen::Matrix2d R(int slot, const Symmetric2& extra_px2) const {
    const double deviation = noise_.position * lengths_[at(slot)];
    const double variance = deviation * deviation;
    Eigen::Matrix2d R;
    R << variance + extra_px2.xx, extra_px2.xy, extra_px2.xy, variance + extra_px2.yy;
    return R;
  }

  Noise noise_;
  typename Bank::MeasurementMatrix H_;
  Bank bank_;
  std::vector<double> lengths_;   ///< px a unit of noise, a slot
  std::vector<char> unmatched_;  ///< since the last predict, a slot
};

struct MakeBank {
  std::unique_ptr<FilterBank> operator()(const KalmanCvOptions& o) const {
    const double p = o.position_noise, v = o.initial_velocity;
    using Bank = KalmanFilterBank<2>;
    return std::make_unique<Bank>(
        Bank::Noise{o.noise_unit, o.velocity_noise, NoiseForm::continuous, p, Eigen::Vector4d(p, p, v, v), o.lost_damping_time});
  }
  std::unique_ptr<FilterBank> operator()(const KalmanCaOptions& o) const {
    const double p = o.position_noise, v = o.initial_velocity, a = o.initial_acceleration;
    Eigen::Matrix<double, 6, 1> deviation;
    const double start = o.initial_position > 0.0 ? o.initial_position : p;
    deviation << start, start, v, v, a, a;
    using Bank = KalmanFilterBank<3>;
    return std::make_unique<Bank>(Bank::Noise{o.noise_unit, o.acceleration_noise, o.noise_form, p, deviation, 0.0});
  }
  std::unique_ptr<FilterBank> operator()(const MeanVelocityOptions& o) const {
    return std::make_unique<MeanVelocityBank>(o);
  }
  std::unique_ptr<FilterBank> operator()(const KalmanDiscreteOptions& o) const { return std::make_unique<DiscreteBank>(o); }
  std::unique_ptr<FilterBank> operator()(const KalmanBoxOptions& o) const { return std::make_unique<BoxBank>(o); }
  std::unique_ptr<FilterBank> operator()(const KalmanPathOptions&) const {
    throw ConfigError("filter.model: \"kalman_path\" needs paths, which this bank has no place for; expected another, or a "
                      "PathBank");
  }
  std::unique_ptr<FilterBank> operator()(const ExtendedOptions& o) const { return make_bank(o); }
  std::unique_ptr<FilterBank> operator()(const UnscentedOptions& o) const { return make_bank(o); }
  std::unique_ptr<FilterBank> operator()(const ParticleOptions& o) const { return make_bank(o); }
};

}  // namespace

void check_filter(const FilterOptions& options, const std::string& path) {
  std::visit([&](const auto& o) { check_fields(o, path); }, options);
  if (const auto* discrete = std::get_if<KalmanDiscreteOptions>(&options)) check_measurement_covariance(*discrete, path);
}

std::unique_ptr<FilterBank> make_filter_bank(const FilterOptions& options) {
  check_filter(options, "filter");
  return std::visit(MakeBank{}, options);
}

}  // namespace survtrack
