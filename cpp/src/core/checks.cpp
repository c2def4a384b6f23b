// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/checks.hpp"

#include <cmath>
#include <sstream>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

const char* depth_name(int depth) {
  switch (depth) {
    case CV_8U: return "uint8";
    case CV_8S: return "int8";
    case CV_16U: return "uint16";
    case CV_16S: return "int16";
    case CV_32S: return "int32";
    case CV_32F: return "float32";
    case CV_64F: return "float64";
    default: return "another type";
  }
}

std::string describe_image(const cv::Mat& image) {
  std::ostringstream text;
  if (image.dims > 2) {
    text << image.dims << " dimensions";
  } else {
    text << image.rows << "x" << image.cols;
    if (image.channels() != 1) text << "x" << image.channels();
  }
  text << " " << depth_name(image.depth());
  return text.str();
}

}  // namespace

void check_image(const cv::Mat& image, const char* name) {
  if (image.empty() || image.dims > 2) {
    throw InputError(std::string(name) + ": " + (image.empty() ? "is empty" : "has " + describe_image(image)) +
                     "; expected HxW (grey) or HxWx3 (BGR) uint8 with at least one pixel");
  }
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throw InputError(std::string(name) + ": is " + describe_image(image) +
                     "; expected HxW (grey) or HxWx3 (BGR) uint8");
  }
}

void check_same_format(const cv::Mat& image, const cv::Size& size, int channels, const char* name) {
  if (image.size() == size && image.channels() == channels) return;
  std::ostringstream text;
  text << name << ": is " << describe_image(image) << ", the frames before were " << size.height << "x" << size.width;
  if (channels != 1) text << "x" << channels;
  text << "; one run takes one size and channel count (reset() starts another)";
  throw InputError(text.str());
}

void check_time(double time_s, std::optional<double> previous_time_s) {
  std::ostringstream text;
  text.precision(17);
  constexpr double longest_s = 1e12;  // filters stay finite over any step
  if (!std::isfinite(time_s) || std::abs(time_s) > longest_s) {
    text << "time_s: is " << time_s << "; expected a finite number of seconds within +-1e12";
    throw InputError(text.str());
  }
  if (previous_time_s && !(time_s > *previous_time_s)) {
    text << "time_s: " << time_s << " does not come after " << *previous_time_s
         << ", the time of the frame before; times must increase";
    throw InputError(text.str());
  }
}

}  // namespace survtrack
