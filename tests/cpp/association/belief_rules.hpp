// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "survtrack/association/belief_matrix.hpp"

namespace survtrack {

constexpr double most_belief = 1.0 - 1e-9;

// Near 1 a belief has few digits left: these are more than twice as long.
#ifdef __SIZEOF_FLOAT128__
__extension__ using Long = __float128;
#else
using Long = long double;
#endif

/// One row of the belief matrix, word for word (Narayana 2007, 8.3): each step changes one entry and rescales all
/// others, which costs O(v) a step and O(v^2) a row.
class LiteralRow {
 public:
  explicit LiteralRow(std::size_t blobs) : beliefs_(blobs + 1, Long(1) / (Long(blobs) + Long(1))) {}

  /// Eq. 8.16 and 8.17, with the present belief as p(Assign).
  void observe(std::size_t blob, double ratio) {
    const Long b = beliefs_[blob];
    set(blob, ratio * b / (ratio * b + (Long(1) - b)));
  }
  void multiply(std::size_t blob, double factor) {
    set(blob, std::min<Long>(beliefs_[blob] * factor, most_belief));
  }
  void multiply_odds(std::size_t blob, double factor) { observe(blob, factor); }

  std::vector<double> beliefs() const {
    std::vector<double> row;
    for (const Long belief : beliefs_) row.push_back(static_cast<double>(belief));
    return row;
  }

 private:
  void set(std::size_t blob, Long after) {
    const Long before = beliefs_[blob];
    beliefs_[blob] = after;
    for (std::size_t m = 0; m < beliefs_.size(); ++m) {
      if (m != blob) beliefs_[m] *= Long(1) - (after - before) / (Long(1) - before);  // eq. 8.19
    }
  }

  std::vector<Long> beliefs_;
};

inline std::vector<double> literal_published_beliefs(const std::vector<Evidence>& evidence) {
  LiteralRow row(evidence.size());
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    row.observe(i, evidence[i].color);
    row.observe(i, evidence[i].position);
    row.observe(i, evidence[i].size);
    row.multiply(i, evidence[i].velocity);
  }
  return row.beliefs();
}

/// The same with the velocity factor on the odds.
inline std::vector<double> literal_beliefs_of_odds(const std::vector<Evidence>& evidence) {
  LiteralRow row(evidence.size());
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    row.observe(i, evidence[i].color);
    row.observe(i, evidence[i].position);
    row.observe(i, evidence[i].size);
    row.multiply_odds(i, evidence[i].velocity);
  }
  return row.beliefs();
}

inline std::vector<double> order_free(const std::vector<Evidence>& evidence) {
  std::vector<double> row(evidence.size() + 1, std::nan(""));
  order_free_beliefs(evidence, row.data());
  return row;
}

inline std::vector<double> published(const std::vector<Evidence>& evidence) {
  std::vector<double> row(evidence.size() + 1, std::nan("")), scales;
  published_beliefs(evidence, row.data(), scales);
  return row;
}

/// Ratios evenly spread over a logarithmic scale.
class RandomEvidence {
 public:
  explicit RandomEvidence(unsigned seed) : random_(seed) {}

  /// Nothing here says much: 0.2 to 5.
  std::vector<Evidence> mild(std::size_t blobs) {
    return make(blobs, [&] { return std::pow(5.0, 2.0 * unit() - 1.0); });
  }
  /// Much that is impossible, nothing that is nearly certain.
  std::vector<Evidence> small(std::size_t blobs) {
    const double choices[] = {0.0, 1e-300, 1e-12, 1e-3, 0.1, 1.0, 1.0, 3.0};
    return make(blobs, [&] { return choices[random_() % 8]; });
  }
  /// Among ordinary ratios the smallest and the largest.
  std::vector<Evidence> extreme(std::size_t blobs) {
    const double choices[] = {0.0, 1e-300, 1e-12, 1e-3, 0.1, 1.0, 1.0, 10.0, 1e3, 1e6};
    return make(blobs, [&] { return choices[random_() % 10]; });
  }

 private:
  double unit() { return static_cast<double>(random_()) / static_cast<double>(std::mt19937::max()); }

  template <class Ratio>
  std::vector<Evidence> make(std::size_t blobs, Ratio&& ratio) {
    std::vector<Evidence> evidence(blobs);
    for (Evidence& e : evidence) {
      e.color = ratio();
      e.position = ratio();
      e.size = ratio();
      e.velocity = 0.2 + 1.8 * unit();
    }
    return evidence;
  }

  std::mt19937 random_;
};

}  // namespace survtrack
