// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>

namespace survtrack {

/// How states of several axes are ordered.
enum class StateOrder {
  by_axis,        ///< x, x', x'', y, y', y''
  by_derivative,  ///< x, y, x', y', x'', y'': that of `MotionModel`
};

/// Process noise of a highest derivative that is constant within a step of dt and white from step to step, with
/// `variance` (Bar-Shalom, Li and Kirubarajan 2001, 6.3). `dim` is 2 (position and velocity; the noise is the
/// acceleration), 3 (the noise is the change of the acceleration) or 4 (of the third derivative); `axes` of them
/// independent of each other. Unlike the continuous form, two steps of dt / 2 are not one of dt.
/// Throws `InputError`: dim; dt in (0, 1e6]; variance at least 0; axes 1 ... 1000.
Eigen::MatrixXd discrete_white_noise(int dim, double dt, double variance = 1.0, int axes = 1,
                                     StateOrder order = StateOrder::by_axis);

/// Process noise of white noise of spectral `density` in the first derivative that is not modelled, over a step of dt:
/// two steps of dt / 2 are one of dt (Bar-Shalom, Li and Kirubarajan 2001, 6.2); `MotionModel::unit_noise` is that of
/// unit density and two axes. Arguments and errors as above.
Eigen::MatrixXd continuous_white_noise(int dim, double dt, double density = 1.0, int axes = 1,
                                       StateOrder order = StateOrder::by_axis);

}  // namespace survtrack
