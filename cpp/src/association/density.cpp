// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/density.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

constexpr std::size_t bins = 401;         // odd: one is centred on 0
constexpr double start_height = 0.2;      // of the start's shape in what is learned: one surprise must not outweigh four that fit
constexpr int refit_after = 100;          // differences
constexpr double most_samples = 20000.0;  // then the past counts half

[[noreturn]] void refuse(const std::string& name, const std::string& reason) { throw InputError(name + ": " + reason); }

double mass(const std::vector<double>& table) { return std::accumulate(table.begin(), table.end(), 0.0); }

/// Below how many bins a part of the counts lies.
double quantile(const std::vector<double>& counts, double part) {
  double rest = part * mass(counts);
  std::size_t i = 0;
  while (i + 1 < counts.size() && rest > counts[i]) rest -= counts[i++];
  return static_cast<double>(i) + (counts[i] > 0.0 ? rest / counts[i] : 0.0);
}

double standard_deviation(const std::vector<double>& counts) {
  const double total = mass(counts);
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double x = static_cast<double>(i);
    first += counts[i] * x;
    second += counts[i] * x * x;
  }
  first /= total;
  return std::sqrt(std::max(0.0, second / total - first * first));
}

/// Each count spread over its neighbours by a triangle of `reach` bins a side.
std::vector<double> smoothed(const std::vector<double>& counts, int reach) {
  std::vector<double> result(counts.size(), 0.0);
  const int size = static_cast<int>(counts.size());
  for (int i = 0; i < size; ++i) {
    const double count = counts[static_cast<std::size_t>(i)];
    if (count == 0.0) continue;
    for (int k = -reach; k <= reach; ++k) {
      const int to = std::clamp(i + k, 0, size - 1);
      result[static_cast<std::size_t>(to)] += count * (reach + 1 - std::abs(k));
    }
  }
  return result;
}

}  // namespace

Density::Density(double range, std::vector<double> shape)
    : range_(range), bins_per_unit_(static_cast<double>(shape.size()) / (2.0 * range)),
      last_place_(static_cast<double>(shape.size()) - 1.0), relative_(std::move(shape)) {
  const double peak = *std::max_element(relative_.begin(), relative_.end());
  for (double& value : relative_) value /= peak;
}

Density Density::two_sided_exponential(double range, double scale) {
  std::vector<double> shape(bins);
  for (std::size_t i = 0; i < bins; ++i) {
    const double middle = ((static_cast<double>(i) + 0.5) / static_cast<double>(bins) * 2.0 - 1.0) * range;
    shape[i] = std::exp(-std::abs(middle) / scale);
  }
  return Density(range, std::move(shape));
}

Density Density::from_values(double range, const std::vector<double>& values, const std::string& name) {
  if (!(range > 0.0) || !std::isfinite(range)) refuse(name + ".range", "is " + text_of(range) + "; expected a finite number above 0");
  if (values.size() < 3) refuse(name + ".values", "are " + std::to_string(values.size()) + "; expected at least 3");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= 0.0) || !std::isfinite(values[i])) {
      refuse(name + ".values[" + std::to_string(i) + "]",
             "is " + text_of(values[i]) + "; expected a finite number of at least 0");
    }
  }
  const double integral = mass(values) * 2.0 * range / static_cast<double>(values.size());
  if (!(integral > 0.0)) refuse(name + ".values", "have no mass; expected a density, whose integral is 1");
  if (!(std::abs(integral - 1.0) <= 1e-6)) {
    std::ostringstream text;
    text << "the integral over -range to range is " << integral << "; expected 1";
    refuse(name + ".values", text.str());
  }
  return Density(range, values);
}

std::vector<double> Density::values() const {
  std::vector<double> table = relative_;
  const double integral = mass(table) / bins_per_unit_;
  for (double& value : table) value /= integral;
  return table;
}

DensityLearner::DensityLearner(Density start, int learn_after)
    : start_(start), density_(std::move(start)), learn_after_(learn_after), counts_(start_.relative().size(), 0.0), saved_(counts_) {}

void DensityLearner::add(double difference) {
  if (learn_after_ == 0) return;
  const double place = std::floor((difference + start_.range_) * start_.bins_per_unit_);
  const double last = static_cast<double>(counts_.size()) - 1.0;
  counts_[static_cast<std::size_t>(std::clamp(place, 0.0, last))] += 1.0;
  samples_ += 1.0;
  ++since_fit_;
  if (samples_ > std::max(most_samples, 2.0 * learn_after_)) {
    samples_ *= 0.5;
    for (double& count : counts_) count *= 0.5;
    for (double& count : saved_) count *= 0.5;
  }
  const bool first = samples_ - since_fit_ < learn_after_ && samples_ >= learn_after_;
  if (samples_ >= learn_after_ && (first || since_fit_ >= refit_after)) fit();
}

void DensityLearner::fit() {
  since_fit_ = 0;
  std::vector<double> all = counts_;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] += saved_[i];
  const double quartiles = quantile(all, 0.75) - quantile(all, 0.25);
  const double width = 0.9 * std::min(standard_deviation(all), quartiles / 1.34) * std::pow(samples_, -0.2);
  const int most = static_cast<int>(counts_.size()) / 4;
  // A triangle of half-width w has the standard deviation w / sqrt(6).
  const int reach = static_cast<int>(std::clamp(std::lround(width * std::sqrt(6.0)) - 1L, 0L, static_cast<long>(most)));
  std::vector<double> shape = smoothed(counts_, reach);
  const double triangle = (reach + 1.0) * (reach + 1.0);  // its weights' sum
  for (std::size_t i = 0; i < shape.size(); ++i) shape[i] += triangle * saved_[i];
  const double peak = *std::max_element(shape.begin(), shape.end());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    shape[i] = (1.0 - start_height) * shape[i] / peak + start_height * start_.relative_[i];
  }
  density_ = Density(start_.range_, std::move(shape));
}

void DensityLearner::restore(const Density& learned, double samples, const std::string& name) {
  if (learned.range() != start_.range() || learned.relative().size() != counts_.size()) {
    std::ostringstream text;
    text << "has " << learned.relative().size() << " values over +-" << learned.range() << "; expected "
         << counts_.size() << " over +-" << start_.range();
    refuse(name, text.str());
  }
  density_ = learned;
  since_fit_ = 0;
  if (samples < learn_after_) {  // what to begin with, such as a density drawn by hand
    start_ = learned;
    samples_ = 0.0;
    std::fill(counts_.begin(), counts_.end(), 0.0);
    std::fill(saved_.begin(), saved_.end(), 0.0);
    return;
  }
  samples_ = samples;
  std::fill(counts_.begin(), counts_.end(), 0.0);
  // Were it smoothed and laid over the start once more, it would grow wider with every restart.
  for (std::size_t i = 0; i < saved_.size(); ++i) {
    saved_[i] = std::max(0.0, learned.relative()[i] - start_height * start_.relative_[i]);
  }
  const double total = mass(saved_);
  if (total > 0.0) {
    for (double& count : saved_) count *= samples / total;
  } else {  // nothing was learned that is not in the start
    for (std::size_t i = 0; i < saved_.size(); ++i) saved_[i] = samples * learned.relative()[i] / mass(learned.relative());
  }
}

}  // namespace survtrack
