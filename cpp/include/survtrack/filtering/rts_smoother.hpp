// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>
#include <string>
#include <vector>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/covariance.hpp"

namespace survtrack {

/// A filter's output over T steps, and what it was predicted with. `FilteredRun<4>` has 4 states; `FilteredRun<>` any.
template <int N = Eigen::Dynamic>
struct FilteredRun {
  using State = Eigen::Matrix<double, N, 1>;
  using StateMatrix = Eigen::Matrix<double, N, N>;

  std::vector<State> x;        ///< states after each update
  std::vector<StateMatrix> P;  ///< and their covariances
  std::vector<StateMatrix> F;  ///< transition into each step (the first is not used), or one for all
  std::vector<StateMatrix> Q;  ///< process noise of each step, likewise
  std::vector<State> Bu;       ///< control input of each step, likewise; empty: there was none

  /// Throws `InputError` naming what does not fit.
  void check() const {
    const std::size_t steps = x.size();
    if (steps == 0) throw InputError("x: has no steps; expected at least one");
    const Eigen::Index n = x.front().size();
    check_length("P", P.size(), false);
    check_length("F", F.size(), true);
    check_length("Q", Q.size(), true);
    if (!Bu.empty()) check_length("Bu", Bu.size(), true);
    for (std::size_t k = 0; k < steps; ++k) {
      check_matrix(name_of("x", k), x[k], n, 1);
      check_covariance(name_of("P", k), P[k], n);
    }
    for (std::size_t k = 0; k < F.size(); ++k) check_matrix(name_of("F", k), F[k], n, n);
    for (std::size_t k = 0; k < Q.size(); ++k) check_covariance(name_of("Q", k), Q[k], n);
    for (std::size_t k = 0; k < Bu.size(); ++k) check_matrix(name_of("Bu", k), Bu[k], n, 1);
  }

 private:
  static std::string name_of(const char* name, std::size_t k) { return std::string(name) + "[" + std::to_string(k) + "]"; }
  void check_length(const char* name, std::size_t length, bool one_will_do) const {
    if (length == x.size() || (one_will_do && length == 1)) return;
    throw InputError(std::string(name) + ": has " + std::to_string(length) + " steps; expected " +
                     std::to_string(x.size()) + (one_will_do ? ", or one for all" : ""));
  }
};

template <int N = Eigen::Dynamic>
struct SmoothedRun {
  std::vector<Eigen::Matrix<double, N, 1>> x;
  std::vector<Eigen::Matrix<double, N, N>> P;
};

/// States and covariances given the measurements of the whole run, those that came later too: Rauch, Tung and
/// Striebel 1965 (Bar-Shalom, Li and Kirubarajan 2001, 8.6). Throws `InputError` naming what does not fit.
template <int N>
SmoothedRun<N> rts_smooth(const FilteredRun<N>& run) {
  using StateMatrix = typename FilteredRun<N>::StateMatrix;
  run.check();
  const auto into = [](const auto& values, std::size_t step) -> const auto& {
    return values.size() == 1 ? values.front() : values[step];
  };
  SmoothedRun<N> smoothed{run.x, run.P};
  for (std::size_t k = run.x.size() - 1; k-- > 0;) {
    const StateMatrix& F = into(run.F, k + 1);
    typename FilteredRun<N>::State x = F * run.x[k];
    if (!run.Bu.empty()) x += into(run.Bu, k + 1);
    const StateMatrix FP = F * run.P[k];
    const StateMatrix P = FP * F.transpose() + into(run.Q, k + 1);
    // C = P_k F' P^-1; where P is singular, the shortest of the solutions.
    const Eigen::LLT<StateMatrix> cholesky(P);
    StateMatrix C;
    if (cholesky.info() == Eigen::Success && cholesky.rcond() > 1e-14) {
      C = cholesky.solve(FP).transpose();
    } else {
      C = P.completeOrthogonalDecomposition().solve(FP).transpose();
    }
    smoothed.x[k] += C * (smoothed.x[k + 1] - x);
    const StateMatrix change = C * (smoothed.P[k + 1] - P) * C.transpose();
    smoothed.P[k] += 0.5 * (change + change.transpose());
    check_still_finite("rts_smooth", smoothed.x[k], smoothed.P[k]);
  }
  return smoothed;
}

}  // namespace survtrack
