// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace survtrack {

/// The density of a difference between a track and its blob (Narayana 2007, 8.3.3): a table of equal bins over
/// -range to range, relative to its peak, linear between the bins' middles. Beyond the range the last bin counts.
class Density {
 public:
  /// Falls by 1/e every `scale`: what stands in until enough was seen.
  static Density two_sided_exponential(double range, double scale);

  /// From a table whose integral is 1. Throws `InputError`, naming `name`, for values that are negative or not
  /// finite, without mass, or not normalised to 1 within 1e-6, and for a range not above 0 or fewer than 3 values.
  static Density from_values(double range, const std::vector<double>& values, const std::string& name);

  /// Relative to the peak: 0 to 1.
  double operator()(double difference) const {
    const double place = (difference + range_) * bins_per_unit_ - 0.5;
    if (!(place > 0.0)) return relative_.front();
    if (place >= last_place_) return relative_.back();
    const int bin = static_cast<int>(place);
    const double* const at = relative_.data() + bin;
    return at[0] + (place - bin) * (at[1] - at[0]);
  }

  double range() const { return range_; }
  /// The table with integral 1.
  std::vector<double> values() const;
  const std::vector<double>& relative() const { return relative_; }

 private:
  friend class DensityLearner;
  Density(double range, std::vector<double> shape);

  double range_ = 0.0;
  double bins_per_unit_ = 0.0;
  double last_place_ = 0.0;  ///< of the last bin's middle, in bins from the first's
  std::vector<double> relative_;  ///< largest: 1
};

/// Fits a density to the differences it is given: a histogram, smoothed by a triangle of the usual width
/// (Silverman 1986, eq. 3.31), with a fifth of the height of the beginning under it, so that nothing is
/// impossible.
class DensityLearner {
 public:
  /// `start` counts until `learn_after` differences were seen; 0: for ever.
  DensityLearner(Density start, int learn_after);

  void add(double difference);
  const Density& density() const { return density_; }
  double samples() const { return samples_; }

  /// Goes on from a density that stood for `samples` differences; one of fewer than `learn_after` takes the place of
  /// the start. The number of bins and the range must be those of
  /// the start: throws `InputError`, naming `name`.
  void restore(const Density& learned, double samples, const std::string& name);

 private:
  void fit();

  Density start_;
  Density density_;
  int learn_after_;
  double samples_ = 0.0;
  int since_fit_ = 0;
  std::vector<double> counts_;  ///< of what was added, a bin
  std::vector<double> saved_;   ///< of what was restored: smooth already, and without the start beneath
};

}  // namespace survtrack
