// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <utility>

namespace survtrack {

/// The value that a sum of `degrees` squared standard normal numbers stays below with `probability`: 5.991 for 0.95
/// and 2. Throws `InputError` unless probability is in (0, 1) and degrees in 1 ... 1000000.
double chi_square_quantile(double probability, int degrees);

/// Between what bounds the mean of `count` squared innovations (NIS) of `degrees` numbers each lies with
/// `probability` if the filter's model fits (Bar-Shalom, Li and Kirubarajan 2001, 5.4.2). Throws `InputError`.
std::pair<double, double> nis_band(int degrees, int count, double probability = 0.95);

}  // namespace survtrack
