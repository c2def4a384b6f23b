// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "filtering/simplex_search.hpp"

#include <algorithm>
#include <vector>

namespace survtrack {
namespace {

struct Corner {
  Eigen::VectorXd x;
  double value;
};

Corner at(const PlaceFunction& function, const Eigen::VectorXd& x) { return {x, function(x)}; }

Corner search(const PlaceFunction& function, const Eigen::VectorXd& start, double step, double smallest_width) {
  std::vector<Corner> corners{at(function, start)};
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    corners.push_back(at(function, start + step * Eigen::VectorXd::Unit(start.size(), i)));
  }
  const auto lower = [](const Corner& a, const Corner& b) { return a.value < b.value; };
  for (int pass = 0; pass < 1000; ++pass) {
    std::stable_sort(corners.begin(), corners.end(), lower);
    double width = 0.0;
    for (const Corner& corner : corners) width = std::max(width, (corner.x - corners[0].x).cwiseAbs().maxCoeff());
    if (width < smallest_width) break;
    Eigen::VectorXd center = Eigen::VectorXd::Zero(start.size());
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) center += corners[i].x;
    center /= static_cast<double>(start.size());
    Corner& highest = corners.back();
    const Eigen::VectorXd across = center - highest.x;
    const Corner mirrored = at(function, center + across);
    const double second = corners[corners.size() - 2].value;
    if (mirrored.value < corners[0].value) {
      const Corner beyond = at(function, center + 2.0 * across);
      highest = beyond.value < mirrored.value ? beyond : mirrored;
    } else if (mirrored.value < second) {
      highest = mirrored;
    } else {
      const bool outside = mirrored.value < highest.value;
      const Corner nearer = at(function, center + (outside ? 0.5 : -0.5) * across);
      if (nearer.value < std::min(mirrored.value, highest.value)) {
        highest = nearer;
      } else {
        for (std::size_t i = 1; i < corners.size(); ++i) {
          corners[i] = at(function, 0.5 * (corners[0].x + corners[i].x));
        }
      }
    }
  }
  return *std::min_element(corners.begin(), corners.end(), lower);
}

}  // namespace

Eigen::VectorXd lower_place(const PlaceFunction& function, const Eigen::VectorXd& start, double step, double width) {
  return search(function, start, step, width).x;
}

Eigen::VectorXd lowest_place(const PlaceFunction& function, const Eigen::VectorXd& start, double step) {
  constexpr double width = 1e-5;
  Corner best = search(function, start, step, width);
  // A simplex may become flat before it is at the bottom; a new one finds out.
  for (int round = 0; round < 10; ++round) {
    const Corner again = search(function, best.x, 0.5 * step, width);
    const bool done = !(again.value < best.value - 1e-6);
    if (again.value < best.value) best = again;
    if (done) break;
  }
  return best.x;
}

}  // namespace survtrack
