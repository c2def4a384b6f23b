// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <functional>

namespace survtrack {

using PlaceFunction = std::function<double(const Eigen::VectorXd&)>;

/// A place where `function` is smallest, as far as the simplex of Nelder and Mead 1965 finds it from `start` with edges of
/// `step` until it is smaller than `width`. Values may be infinite (but for that of the start): a place that is refused.
Eigen::VectorXd lower_place(const PlaceFunction& function, const Eigen::VectorXd& start, double step, double width);

/// The same to 1e-5, begun anew where it ended until that no longer lowers the value by more than 1e-6.
Eigen::VectorXd lowest_place(const PlaceFunction& function, const Eigen::VectorXd& start, double step);

}  // namespace survtrack
