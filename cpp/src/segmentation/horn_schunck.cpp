// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/horn_schunck.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "segmentation/flow_pyramid.hpp"
#include "segmentation/flow_solver.hpp"
#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

using namespace kernels;

constexpr int usual_warps = 5;
constexpr int least_side_px = 8;       // of a pyramid's smallest image
constexpr float longest_px = 1e6f;     // of an initial field: its squares stay finite

cv::Mat grey(const cv::Mat& frame) {
  if (frame.channels() == 1) return frame;
  cv::Mat levels;
  cv::cvtColor(frame, levels, cv::COLOR_BGR2GRAY);
  return levels;
}

std::string size_text(const cv::Size& size) { return std::to_string(size.height) + "x" + std::to_string(size.width); }

void check_frames(const cv::Mat& previous, const cv::Mat& current) {
  check_image(previous, "previous");
  check_image(current, "current");
  if (previous.size() != current.size()) {
    throw InputError("current: is " + size_text(current.size()) + "; expected the size of previous, " +
                     size_text(previous.size()));
  }
}

void check_levels(int levels, const cv::Size& size) {
  int most = 1;
  for (int side = std::min(size.width, size.height); (side + 1) / 2 >= least_side_px; side = (side + 1) / 2) ++most;
  if (levels <= most) return;
  throw ConfigError("levels: " + std::to_string(levels) + " is not allowed for " + size_text(size) +
                    "; expected between 1 and " + std::to_string(most) + ", as the smallest image has at least " +
                    std::to_string(least_side_px) + " px a side");
}

void check_initial(const cv::Mat& field, const char* name, const cv::Size& size) {
  if (field.size() != size || field.type() != CV_32FC1) {
    const char* const type = field.type() == CV_32FC1 ? "" : " and not CV_32FC1";
    throw InputError(std::string(name) + ": is " + size_text(field.size()) + type +
                     "; expected float32 of the frames' size, " + size_text(size));
  }
  for (int y = 0; y < field.rows; ++y) {
    for (int x = 0; x < field.cols; ++x) {
      const float number = field.at<float>(y, x);
      if (std::abs(number) <= longest_px) continue;
      throw InputError(std::string(name) + ": is " + std::to_string(number) + " at row " + std::to_string(y) +
                       ", column " + std::to_string(x) + "; expected finite numbers within +-1e6 px");
    }
  }
}

/// `Level`: std::uint8_t or float.
template <class Level>
void fill_plane(const cv::Mat& image, FlowPlane& plane) {
  plane.create(image.cols, image.rows);
  for (int y = 0; y < image.rows; ++y) {
    std::transform(image.ptr<Level>(y), image.ptr<Level>(y) + image.cols, plane.row(y),
                   [](Level level) { return static_cast<float>(level); });
    plane.repeat_edges(y);
  }
}

FlowRows rows_of(FlowField& flow) {
  return {flow.u.ptr<float>(), flow.v.ptr<float>(), static_cast<std::ptrdiff_t>(flow.u.step1()),
          static_cast<std::ptrdiff_t>(flow.v.step1()), false};
}
GreyRows rows_of(const FlowPlane& image) { return {nullptr, image.row(0), image.stride()}; }
GreyRows rows_of(const cv::Mat& image) {
  return {image.ptr<std::uint8_t>(), nullptr, static_cast<std::ptrdiff_t>(image.step1())};
}

FlowProblem problem_of(const FlowOptions& options, std::ptrdiff_t width, std::ptrdiff_t height) {
  FlowProblem problem;
  problem.width = width;
  problem.height = height;
  problem.derivatives = options.derivatives;
  problem.smoothness = options.smoothness;
  problem.sweeps = options.sweeps;
  problem.tolerance_px = options.tolerance;
  return problem;
}

struct Level {
  FlowPlane previous;
  FlowPlane current;
};

/// From the coarsest level to the image itself; `field` is where it starts, already of the coarsest size.
void descend(const std::vector<Level>& levels, const FlowOptions& options, FlowPlanes field, FlowField& flow) {
  const int warps = options.warps > 0 ? options.warps : usual_warps;
  FlowSolver solver;
  FlowPlane warped;
  FlowPlanes next;
  for (std::size_t k = levels.size(); k-- > 0;) {
    const Level& level = levels[k];
    if (k + 1 < levels.size()) {
      finer_field(field, level.previous.width(), level.previous.height(), next);
      std::swap(field, next);
    }
    next.create(level.previous.width(), level.previous.height());
    FlowProblem problem = problem_of(options, level.previous.width(), level.previous.height());
    problem.previous = rows_of(level.previous);
    problem.about = problem.from = &field;
    for (int i = 0; i < warps; ++i) {
      warp(level.previous, level.current, field, warped);
      problem.current = rows_of(warped);
      const bool last = k == 0 && i == warps - 1;
      solver.solve(problem, last ? rows_of(flow) : kernels::rows_of(next));
      std::swap(field, next);
    }
  }
}

}  // namespace

void horn_schunck(const cv::Mat& previous, const cv::Mat& current, const FlowOptions& options, FlowField& flow,
                  const FlowField& initial) {
  check_fields(options);
  check_frames(previous, current);
  const cv::Size size = previous.size();
  check_levels(options.levels, size);
  const bool warm = !initial.u.empty() || !initial.v.empty();
  FlowPlanes field;
  if (warm) {
    check_initial(initial.u, "initial.u", size);
    check_initial(initial.v, "initial.v", size);
    fill_plane<float>(initial.u, field.u);
    fill_plane<float>(initial.v, field.v);
  }
  const cv::Mat before = grey(previous);
  const cv::Mat now = grey(current);
  flow.u.create(size, CV_32FC1);
  flow.v.create(size, CV_32FC1);
  if (options.levels == 1 && options.warps == 0) {
    FlowProblem problem = problem_of(options, size.width, size.height);
    problem.previous = rows_of(before);
    problem.current = rows_of(now);
    problem.from = warm ? &field : nullptr;
    FlowSolver().solve(problem, rows_of(flow));
    return;
  }
  std::vector<Level> levels(static_cast<std::size_t>(options.levels));
  fill_plane<std::uint8_t>(before, levels[0].previous);
  fill_plane<std::uint8_t>(now, levels[0].current);
  if (!warm) field.create(size.width, size.height);
  for (std::size_t k = 1; k < levels.size(); ++k) {
    halve(levels[k - 1].previous, levels[k].previous);
    halve(levels[k - 1].current, levels[k].current);
    FlowPlanes coarse;
    halve(field.u, coarse.u, 0.5f);
    halve(field.v, coarse.v, 0.5f);
    field = std::move(coarse);
  }
  descend(levels, options, std::move(field), flow);
}

}  // namespace survtrack
