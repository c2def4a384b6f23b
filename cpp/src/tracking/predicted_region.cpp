// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/predicted_region.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// A piece of the path is followed by points no farther apart than this, px; a very long one by `most_steps` of them.
constexpr double step_px = 4.0;
constexpr int most_steps = 256;

void require(bool holds, const char* name, const char* what = "") {
  if (!holds) throw InputError(std::string("predicted_region: ") + name + what);
}

bool finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void check_covariance(const char* name, const Symmetric2& C) {
  require(std::isfinite(C.xx) && std::isfinite(C.xy) && std::isfinite(C.yy), name, " is not finite; expected px^2");
  const double middle = 0.5 * (C.xx + C.yy), reach = std::hypot(0.5 * (C.xx - C.yy), C.xy);
  // Up to rounding, to 1e-9 of the largest eigenvalue.
  if (middle - reach >= -1e-9 * (std::abs(middle) + reach)) return;
  throw InputError(std::string("predicted_region: ") + name + " is no covariance: its smallest eigenvalue is " +
                   text_of(middle - reach) + "; expected none below 0");
}

void check(const ExpectedObject& object) {
  require(finite(object.before) && finite(object.position), "a position is not finite; expected px");
  check_covariance("covariance_px2", object.covariance_px2);
  const Box& box = object.box;
  require(std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) && std::isfinite(box.height) &&
              box.width > 0.0 && box.height > 0.0,
          "the box is not finite or has no size; expected width and height above 0 px");
  require(std::isfinite(object.lost_s) && object.lost_s >= 0.0, "lost_s is below 0 or not finite; expected 0 or more");
}

/// A place that a path can turn into a position: what is farther away is far outside of any frame too.
double within(double place_px) { return std::clamp(place_px, -Path::most_position_px, Path::most_position_px); }

/// Grows to hold points.
struct Hull {
  double left = INFINITY, top = INFINITY, right = -INFINITY, bottom = -INFINITY;

  void add(const Point& p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
};

/// The standard deviation in direction d, of length 1: root of d' C d.
double deviation(const Symmetric2& C, const Point& d) {
  return std::sqrt(std::max(0.0, d.x * d.x * C.xx + 2.0 * d.x * d.y * C.xy + d.y * d.y * C.yy));
}

Hull places(const PredictedRegionsOptions& options, const ExpectedObject& object) {
  const Point way = object.position - object.before;
  const double length = std::hypot(way.x, way.y);
  // Who stands still has no direction: x is as good as any.
  const Point along = length > 0.0 ? (1.0 / length) * way : Point{1.0, 0.0};
  const Point across{-along.y, along.x};
  const double ahead = options.sigmas_along * deviation(object.covariance_px2, along);
  const double aside = options.sigmas_across * deviation(object.covariance_px2, across);
  Hull hull;
  if (options.forward_only && length > 0.0) {
    for (const double s : {-length, ahead}) {
      for (const double t : {-aside, aside}) hull.add(object.position + s * along + t * across);
    }
    return hull;
  }
  // The box around the ellipse with these half axes.
  const Point reach{std::hypot(ahead * along.x, aside * across.x), std::hypot(ahead * along.y, aside * across.y)};
  hull.add(object.position - reach);
  hull.add(object.position + reach);
  return hull;
}

Hull places(const PredictedRegionsOptions& options, const Path& path, const ExpectedOnPath& place) {
  const double ahead = options.sigmas_along * std::sqrt(place.covariance_px2.xx);
  const double aside = options.sigmas_across * std::sqrt(place.covariance_px2.yy);
  const double way = path.residual(place.position.s_px, place.before.s_px);
  const double from = options.forward_only ? std::min(-way, ahead) : -ahead;
  const double to = options.forward_only ? std::max(-way, ahead) : ahead;
  // Round a closed path more than once says nothing more.
  const double reach = path.closed() ? std::min(to - from, path.length_px()) : to - from;
  const int steps = std::clamp(static_cast<int>(std::min(std::ceil(reach / step_px), double{most_steps})), 1, most_steps);
  Hull hull;
  for (int i = 0; i <= steps; ++i) {
    const double s = within(place.position.s_px + from + reach * i / steps);
    for (const double t : {-aside, 0.0, aside}) hull.add(path.to_image({s, within(place.position.t_px + t)}));
  }
  return hull;
}

Box with_size(const PredictedRegionsOptions& options, const ExpectedObject& object, Hull hull) {
  const Box& box = object.box;
  const double longest = std::max(box.width, box.height);
  if (options.whole_object) {
    hull.left += box.x - object.position.x;
    hull.right += box.right() - object.position.x;
    hull.top += box.y - object.position.y;
    hull.bottom += box.bottom() - object.position.y;
  }
  // O'Malley 2000: each full side at least the object's longest axis.
  const double least = options.whole_object ? 0.0 : longest;
  const double more = 2.0 * longest * (options.margin + options.growth * object.lost_s);
  const Point middle{0.5 * (hull.left + hull.right), 0.5 * (hull.top + hull.bottom)};
  return Box::around(middle, std::max(hull.right - hull.left, least) + more, std::max(hull.bottom - hull.top, least) + more);
}

}  // namespace

Box predicted_region(const PredictedRegionsOptions& options, const ExpectedObject& object) {
  check(object);
  return with_size(options, object, places(options, object));
}

Box predicted_region(const PredictedRegionsOptions& options, const ExpectedObject& object, const Path& path,
                     const ExpectedOnPath& place) {
  check(object);
  check_covariance("place.covariance_px2", place.covariance_px2);
  return with_size(options, object, places(options, path, place));
}

}  // namespace survtrack
