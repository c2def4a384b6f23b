// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace survtrack {

/// C = S + A B', of which only the upper triangle is needed: the product is symmetric but for rounding. `J`: the columns
/// before are done.
template <int J = 0, int N, int K>
void set_upper_product(Eigen::Matrix<double, N, N>& C, const Eigen::Matrix<double, N, N>& S,
                       const Eigen::Matrix<double, N, K>& A, const Eigen::Matrix<double, N, K>& B) {
  if constexpr (N == Eigen::Dynamic || K == Eigen::Dynamic || N > 8) {
    C.noalias() = S + A * B.transpose();
  } else if constexpr (J < N) {
    constexpr int rows = std::min(N, (J + 2) / 2 * 2);  // whole pairs, as registers hold them
    Eigen::Matrix<double, rows, 1> column = S.col(J).template head<rows>();
    for (int k = 0; k < K; ++k) column += B(J, k) * A.col(k).template head<rows>();
    C.col(J).template head<rows>() = column;
    set_upper_product<J + 1>(C, S, A, B);
  }
}

/// The symmetric matrix of this upper triangle.
template <int N>
Eigen::Matrix<double, N, N> mirrored(const Eigen::Matrix<double, N, N>& upper) {
  return upper.template selfadjointView<Eigen::Upper>();
}

}  // namespace survtrack
