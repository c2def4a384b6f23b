// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>

namespace survtrack {

/// A point or a displacement in the image; x to the right, y downwards, in pixels.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
  friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double s, const Point& p) { return {s * p.x, s * p.y}; }
};

/// A symmetric 2x2 matrix over (x, y): a covariance or second central moments, in px^2.
struct Symmetric2 {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  friend bool operator==(const Symmetric2& a, const Symmetric2& b) {
    return a.xx == b.xx && a.xy == b.xy && a.yy == b.yy;
  }
  friend Symmetric2 operator*(double s, const Symmetric2& m) { return {s * m.xx, s * m.xy, s * m.yy}; }
};

/// A 2x2 matrix over (x, y) that need not be symmetric: rows of the first, columns of the second; a cross covariance.
struct Matrix2 {
  double xx = 0.0;
  double xy = 0.0;
  double yx = 0.0;
  double yy = 0.0;

  friend bool operator==(const Matrix2& a, const Matrix2& b) {
    return a.xx == b.xx && a.xy == b.xy && a.yx == b.yx && a.yy == b.yy;
  }
  friend Matrix2 operator*(double s, const Matrix2& m) { return {s * m.xx, s * m.xy, s * m.yx, s * m.yy}; }
};

/// A mean colour, 0 to 255 a channel; a grey image has three equal channels.
struct Color {
  double blue = 0.0;
  double green = 0.0;
  double red = 0.0;

  friend bool operator==(const Color& a, const Color& b) {
    return a.blue == b.blue && a.green == b.green && a.red == b.red;
  }
};

/// An axis-parallel box: left and top edge and size in pixels. The box of the single pixel
/// (x, y) is {x, y, 1, 1}.
struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double area_px() const { return width * height; }
  Point center() const { return {x + 0.5 * width, y + 0.5 * height}; }
  bool contains(const Point& p) const {
    return p.x >= x && p.x < right() && p.y >= y && p.y < bottom();
  }

  static Box around(const Point& center, double width, double height) {
    return {center.x - 0.5 * width, center.y - 0.5 * height, width, height};
  }

  friend bool operator==(const Box& a, const Box& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
  }
};

/// Whether a box reaches the frame's border, to a pixel: what is cut off there is not seen.
inline bool touches_border(const Box& box, double frame_width, double frame_height) {
  return box.x <= 1.0 || box.y <= 1.0 || box.right() >= frame_width - 1.0 || box.bottom() >= frame_height - 1.0;
}

/// Area common to two boxes, in px^2; 0 when they do not meet.
inline double intersection_px(const Box& a, const Box& b) {
  const double w = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double h = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return w > 0.0 && h > 0.0 ? w * h : 0.0;
}

/// Intersection over union of two boxes, 0 to 1.
inline double iou(const Box& a, const Box& b) {
  const double common = intersection_px(a, b);
  const double total = a.area_px() + b.area_px() - common;
  return total > 0.0 ? common / total : 0.0;
}

}  // namespace survtrack
