// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <vector>

namespace survtrack {

/// A filter's output over T steps, and what it was predicted with.
struct FilteredRun {
  std::vector<Eigen::VectorXd> x;   ///< states after each update
  std::vector<Eigen::MatrixXd> P;   ///< and their covariances
  std::vector<Eigen::MatrixXd> F;   ///< transition into each step (the first is not used), or one for all
  std::vector<Eigen::MatrixXd> Q;   ///< process noise of each step, likewise
  std::vector<Eigen::VectorXd> Bu;  ///< control input of each step, likewise; empty: there was none
};

struct SmoothedRun {
  std::vector<Eigen::VectorXd> x;
  std::vector<Eigen::MatrixXd> P;
};

/// States and covariances given the measurements of the whole run, those that came later too: Rauch, Tung and
/// Striebel 1965 (Bar-Shalom, Li and Kirubarajan 2001, 8.6). Throws `InputError` naming what does not fit.
SmoothedRun rts_smooth(const FilteredRun& run);

}  // namespace survtrack
