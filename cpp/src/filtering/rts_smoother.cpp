// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/rts_smoother.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <string>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/covariance.hpp"

namespace survtrack {
namespace {

std::string name_of(const char* name, std::size_t k) { return std::string(name) + "[" + std::to_string(k) + "]"; }

void check_length(const char* name, std::size_t length, std::size_t steps, bool one_will_do) {
  if (length == steps || (one_will_do && length == 1)) return;
  throw InputError(std::string(name) + ": has " + std::to_string(length) + " steps; expected " + std::to_string(steps) +
                   (one_will_do ? ", or one for all" : ""));
}

void check_run(const FilteredRun& run) {
  const std::size_t steps = run.x.size();
  if (steps == 0) throw InputError("x: has no steps; expected at least one");
  const Eigen::Index n = run.x.front().size();
  check_length("P", run.P.size(), steps, false);
  check_length("F", run.F.size(), steps, true);
  check_length("Q", run.Q.size(), steps, true);
  if (!run.Bu.empty()) check_length("Bu", run.Bu.size(), steps, true);
  for (std::size_t k = 0; k < steps; ++k) {
    check_matrix(name_of("x", k), run.x[k], n, 1);
    check_covariance(name_of("P", k), run.P[k], n);
  }
  for (std::size_t k = 0; k < run.F.size(); ++k) check_matrix(name_of("F", k), run.F[k], n, n);
  for (std::size_t k = 0; k < run.Q.size(); ++k) check_covariance(name_of("Q", k), run.Q[k], n);
  for (std::size_t k = 0; k < run.Bu.size(); ++k) check_matrix(name_of("Bu", k), run.Bu[k], n, 1);
}

template <class Value>
const Value& into(const std::vector<Value>& values, std::size_t step) {
  return values.size() == 1 ? values.front() : values[step];
}

/// P^-1 B; where P is singular, the shortest of the solutions.
Eigen::MatrixXd solved(const Eigen::MatrixXd& P, const Eigen::MatrixXd& B) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(P);
  if (cholesky.info() == Eigen::Success && cholesky.rcond() > 1e-14) return cholesky.solve(B);
  return P.completeOrthogonalDecomposition().solve(B);
}

}  // namespace

SmoothedRun rts_smooth(const FilteredRun& run) {
  check_run(run);
  SmoothedRun smoothed{run.x, run.P};
  for (std::size_t k = run.x.size() - 1; k-- > 0;) {
    const Eigen::MatrixXd& F = into(run.F, k + 1);
    Eigen::VectorXd x = F * run.x[k];
    if (!run.Bu.empty()) x += into(run.Bu, k + 1);
    const Eigen::MatrixXd FP = F * run.P[k];
    const Eigen::MatrixXd P = FP * F.transpose() + into(run.Q, k + 1);
    const Eigen::MatrixXd C = solved(P, FP).transpose();  // P F' (F P F' + Q)^-1
    smoothed.x[k] += C * (smoothed.x[k + 1] - x);
    const Eigen::MatrixXd change = C * (smoothed.P[k + 1] - P) * C.transpose();
    smoothed.P[k] += 0.5 * (change + change.transpose());
    check_still_finite("rts_smooth", smoothed.x[k], smoothed.P[k]);
  }
  return smoothed;
}

}  // namespace survtrack
