// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/kalman_array.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "filtering/kalman_lanes.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"
#include "survtrack/filtering/ldl.hpp"

namespace survtrack {
namespace {

using Index = Eigen::Index;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Moves rows of `before` numbers apart, to rows of `after`.
void widen(std::vector<double>& values, Index rows, Index before, Index after) {
  std::vector<double> wide(static_cast<std::size_t>(rows * after), 0.0);
  for (Index r = 0; r < rows; ++r) std::copy_n(values.data() + r * before, before, wide.data() + r * after);
  values = std::move(wide);
}

}  // namespace

KalmanArray::KalmanArray(Model model, Covariances covariances) : model_(std::move(model)), covariances_(covariances) {
  check_matrix("F", model_.F, n(), n());
  check_matrix("H", model_.H, m(), n());
  check_covariance("Q", model_.Q, n(), covariances_);
  check_covariance("R", model_.R, m(), covariances_);
  if (model_.B.size() != 0) check_matrix("B", model_.B, n(), model_.B.cols());
  if (model_.periods.size() == 0) return;
  check_matrix("periods", model_.periods, m(), 1);
  for (const double period : model_.periods) wrapped_difference(0.0, period);  // throws
}

void KalmanArray::reserve(int filters) {
  if (filters <= stride_) return;
  constexpr Index lanes = KalmanLanes::width;
  const Index wanted = std::max<Index>(filters, stride_ + stride_ / 2);
  const Index stride = (wanted + lanes - 1) / lanes * lanes;
  const Index upper_n = n() * (n() + 1) / 2;
  widen(x_, n(), stride_, stride);
  widen(P_, upper_n, stride_, stride);
  widen(last_, m() + m() * (m() + 1) / 2 + 1, stride_, stride);
  next_x_.resize(x_.size());
  next_P_.resize(P_.size());
  next_last_.resize(last_.size());
  z_.resize(static_cast<std::size_t>(m() * stride));
  faults_.resize(static_cast<std::size_t>(stride));
  stride_ = stride;
}

int KalmanArray::add(const Eigen::VectorXd& x, const Eigen::MatrixXd& P) {
  check_matrix("x", x, n(), 1);
  check_covariance("P", P, n(), covariances_);
  if (size_ == 10'000'000) throw InputError("KalmanArray: has 10000000 filters; expected no more");
  reserve(size_ + 1);
  const auto put = [this](std::vector<double>& values, Index row, double value) {
    values[static_cast<std::size_t>(row * stride_ + size_)] = value;
  };
  for (Index i = 0; i < n(); ++i) {
    put(x_, i, x(i));
    for (Index j = i; j < n(); ++j) put(P_, KalmanLanes::upper(n(), i, j), 0.5 * (P(i, j) + P(j, i)));
  }
  // As if its measurement had been missing.
  for (Index row = 0; row < nis_row() + 1; ++row) put(last_, row, nan);
  return size_++;
}

void KalmanArray::check_slot(int slot) const {
  if (slot >= 0 && slot < size_) return;
  throw InputError("slot: " + std::to_string(slot) + " is not allowed; there are " + std::to_string(size_) +
                   " filters, counted from 0");
}

void KalmanArray::remove(int slot) {
  check_slot(slot);
  for (std::vector<double>* values : {&x_, &P_, &last_}) {
    const Index rows = static_cast<Index>(values->size()) / stride_;
    for (Index r = 0; r < rows; ++r) {
      double* const row = values->data() + r * stride_;
      std::copy(row + slot + 1, row + size_, row + slot);
    }
  }
  --size_;
}

KalmanLanes KalmanArray::lanes() {
  double* const last = next_last_.data();
  return {n(), m(), size_, stride_, x_.data(), P_.data(), z_.data(), next_x_.data(), next_P_.data(),
          last, last + m() * stride_, last + nis_row() * stride_};
}

LaneFaults KalmanArray::first_faults() const {
  LaneFaults faults;
  for (Index k = 0; k < size_; ++k) {
    const double fault = faults_[static_cast<std::size_t>(k)];
    if (fault == 0.0) continue;
    Index& first = fault == 1.0 ? faults.singular : faults.overflow;
    if (first < 0) first = k;
  }
  return faults;
}

void KalmanArray::predict(const Eigen::MatrixXd& u) {
  const bool for_all = u.cols() == 1;
  std::vector<double> shift;
  if (u.rows() != 0) {
    check_matrix("u", u, model_.B.cols(), for_all ? 1 : size_);
    const Eigen::MatrixXd Bu = model_.B * u;
    shift.resize(static_cast<std::size_t>(n() * (for_all ? 1 : stride_)), 0.0);
    for (Index i = 0; i < n(); ++i) {
      for (Index k = 0; k < Bu.cols(); ++k) shift[static_cast<std::size_t>(for_all ? i : i * stride_ + k)] = Bu(i, k);
    }
  }
  LaneFaults faults;
  if (shift.empty() && predict_fixed(lanes(), model_.F, model_.Q, faults_.data())) {
    faults = first_faults();
  } else {
    faults = predict_lanes(lanes(), SparseRows(model_.F), model_.Q, shift.empty() ? nullptr : shift.data(),
                           shift.empty() || for_all ? 0 : stride_);
  }
  if (faults.overflow >= 0) throw_overflow("predict[" + std::to_string(faults.overflow) + "]");
  x_.swap(next_x_);
  P_.swap(next_P_);
}

void KalmanArray::update(const Eigen::MatrixXd& z) {
  if (z.rows() != m() || z.cols() != size_) {
    throw InputError("z: is " + std::to_string(z.rows()) + "x" + std::to_string(z.cols()) + "; expected " +
                     std::to_string(m()) + "x" + std::to_string(size_) + ", a measurement a filter");
  }
  if (size_ == 0) return;
  bool whole = true;
  for (Index c = 0; c < m(); ++c) {
    double* const row = z_.data() + c * stride_;
    const double* const given = z.data() + c;
    for (Index k = 0; k < size_; ++k) {
      row[k] = given[k * m()];
      whole = whole & (row[k] - row[k] == 0.0);
    }
    std::fill(row + size_, row + stride_, nan);  // where there is no filter there is no measurement either
  }
  for (Index k = 0; !whole && k < size_; ++k) {
    if (z.col(k).array().isNaN().all() || z.col(k).allFinite()) continue;
    throw InputError("z: that of filter " + std::to_string(k) + " is neither finite nor missing (all NaN)");
  }
  LaneFaults faults;
  const bool checked = covariances_ == Covariances::checked;
  if (model_.periods.size() == 0 && update_fixed(lanes(), model_.H, model_.R, checked, faults_.data())) {
    faults = first_faults();
  } else {
    faults = update_lanes(lanes(), SparseRows(model_.H), model_.R, model_.periods, checked);
  }
  if (faults.singular >= 0) {
    throw_singular("S[" + std::to_string(faults.singular) + "]", expected_covariance(static_cast<int>(faults.singular)));
  }
  if (faults.overflow >= 0) throw_overflow("update[" + std::to_string(faults.overflow) + "]");
  x_.swap(next_x_);
  P_.swap(next_P_);
  last_.swap(next_last_);
}

Eigen::MatrixXd KalmanArray::rows_of(const std::vector<double>& values, Index first, Index rows) const {
  using Rows = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  return Rows(values.data() + first * stride_, size_, rows, Eigen::OuterStride<>(stride_)).transpose();
}

Eigen::MatrixXd KalmanArray::symmetric_of(const std::vector<double>& values, Index first, Index order, int slot) const {
  check_slot(slot);
  Eigen::MatrixXd matrix(order, order);
  for (Index i = 0; i < order; ++i) {
    for (Index j = 0; j < order; ++j) {
      matrix(i, j) = values[static_cast<std::size_t>((first + KalmanLanes::upper(order, i, j)) * stride_ + slot)];
    }
  }
  return matrix;
}

Eigen::MatrixXd KalmanArray::states() const { return rows_of(x_, 0, n()); }
Eigen::MatrixXd KalmanArray::covariance(int slot) const { return symmetric_of(P_, 0, n(), slot); }
Eigen::MatrixXd KalmanArray::innovations() const { return rows_of(last_, 0, m()); }
Eigen::VectorXd KalmanArray::nis() const { return rows_of(last_, nis_row(), 1).transpose(); }

Eigen::MatrixXd KalmanArray::innovation_covariance(int slot) const {
  const Eigen::MatrixXd S = symmetric_of(last_, m(), m(), slot);
  if (std::isnan(last_[static_cast<std::size_t>(slot)])) return Eigen::MatrixXd::Constant(m(), m(), nan);
  return S;
}

Eigen::VectorXd KalmanArray::log_likelihoods() const {
  const Eigen::MatrixXd y = innovations();
  const Eigen::VectorXd distances = nis();
  Eigen::VectorXd logs = Eigen::VectorXd::Constant(size_, nan);
  for (int k = 0; k < size_; ++k) {
    if (std::isnan(y(0, k))) continue;
    const Correction<> correction{y.col(k), innovation_covariance(k), {}, distances(k)};
    logs(k) = correction.log_likelihood();
  }
  return logs;
}

Eigen::MatrixXd KalmanArray::expected_covariance(int slot) const {
  return model_.H * covariance(slot) * model_.H.transpose() + model_.R;
}

Eigen::MatrixXd KalmanArray::squared_mahalanobis(const Eigen::MatrixXd& z) const {
  Eigen::MatrixXd distances(size_, z.cols());
  if (z.cols() == 0 && z.rows() == m()) return distances;
  check_matrix("z", z, m(), z.cols());
  const Eigen::MatrixXd expected = model_.H * states();
  for (int slot = 0; slot < size_; ++slot) {
    const Ldl<Eigen::Dynamic> factors(expected_covariance(slot), covariances_);
    for (Index k = 0; k < z.cols(); ++k) {
      Eigen::VectorXd y = z.col(k) - expected.col(slot);
      for (Index c = 0; c < model_.periods.size(); ++c) y(c) = wrapped_difference(y(c), model_.periods(c));
      distances(slot, k) = factors.squared_distance(y);
    }
  }
  return distances;
}

void KalmanArray::set_F(const Eigen::MatrixXd& F) {
  check_matrix("F", F, n(), n());
  model_.F = F;
}

void KalmanArray::set_H(const Eigen::MatrixXd& H) {
  check_matrix("H", H, m(), n());
  model_.H = H;
}

void KalmanArray::set_Q(const Eigen::MatrixXd& Q) {
  check_covariance("Q", Q, n(), covariances_);
  model_.Q = Q;
}

void KalmanArray::set_R(const Eigen::MatrixXd& R) {
  check_covariance("R", R, m(), covariances_);
  model_.R = R;
}

}  // namespace survtrack
