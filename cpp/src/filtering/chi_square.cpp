// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/chi_square.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// Probability that a gamma variable of shape a is below x: the regularised lower incomplete gamma function, by its
/// series where that converges fast, elsewhere by the continued fraction of the rest (Abramowitz and Stegun, 6.5).
double gamma_probability(double a, double x) {
  if (!(x > 0.0)) return 0.0;
  constexpr double precision = std::numeric_limits<double>::epsilon();
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (double k = a + 1.0; term > precision * sum; k += 1.0) sum += term *= x / k;
    return front * sum;
  }
  // Lentz's way to evaluate a continued fraction from its front.
  double b = x + 1.0 - a, c = 1e300, d = 1.0 / b, fraction = d;
  for (double k = 1.0;; k += 1.0) {
    const double numerator = -k * (k - a);
    b += 2.0;
    d = 1.0 / (numerator * d + b);
    c = b + numerator / c;
    const double factor = c * d;
    fraction *= factor;
    if (std::abs(factor - 1.0) < 4.0 * precision) return 1.0 - front * fraction;
  }
}

double quantile(double probability, double degrees) {
  double low = 0.0, high = degrees;
  while (gamma_probability(0.5 * degrees, 0.5 * high) < probability) high *= 2.0;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return middle;
    (gamma_probability(0.5 * degrees, 0.5 * middle) < probability ? low : high) = middle;
  }
}

void check_probability(double probability) {
  // Nearer to 1 the distribution function itself has no digits left.
  if (probability > 0.0 && probability <= 1.0 - 1e-12) return;
  throw InputError("probability: is " + text_of(probability) + "; expected a number above 0 and below 1 - 1e-12");
}

void check_degrees(const char* name, double value) {
  if (value >= 1.0 && value <= 1e6) return;
  throw InputError(std::string(name) + ": is " + std::to_string(static_cast<long long>(value)) + "; expected 1 to 1000000");
}

}  // namespace

double chi_square_quantile(double probability, int degrees) {
  check_probability(probability);
  check_degrees("degrees", degrees);
  return quantile(probability, degrees);
}

std::pair<double, double> nis_band(int degrees, int count, double probability) {
  check_probability(probability);
  check_degrees("degrees", degrees);
  check_degrees("count", count);
  check_degrees("degrees * count", static_cast<double>(degrees) * count);
  const double all = static_cast<double>(degrees) * count;
  return {quantile(0.5 - 0.5 * probability, all) / count, quantile(0.5 + 0.5 * probability, all) / count};
}

}  // namespace survtrack
