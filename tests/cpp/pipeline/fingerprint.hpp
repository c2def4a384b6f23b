// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <sstream>
#include <string>

#include "survtrack/pipeline/frame_result.hpp"

namespace survtrack {

/// Results as text that differs when any bit of them does.
class Fingerprint {
 public:
  Fingerprint() { text_ << std::hexfloat; }

  Fingerprint& operator<<(const Point& p) { return add(p.x, p.y); }
  Fingerprint& operator<<(const Symmetric2& s) { return add(s.xx, s.xy, s.yy); }
  Fingerprint& operator<<(const Matrix2& m) { return add(m.xx, m.xy, m.yx, m.yy); }
  Fingerprint& operator<<(const Color& c) { return add(c.blue, c.green, c.red); }
  Fingerprint& operator<<(const Box& b) { return add(b.x, b.y, b.width, b.height); }
  Fingerprint& operator<<(const Track& t) {
    add("\ntrack", t.id, to_string(t.status), t.reported, t.detection, t.age_frames, t.matched_frames, t.lost_frames,
        t.group, t.start_index, t.end_index, t.start_time_s, t.end_time_s);
    return *this << t.box << t.position << t.velocity_px_per_s << t.position_covariance_px2
                 << t.velocity_covariance_px2_per_s2 << t.position_velocity_covariance_px2_per_s
                 << t.velocity_noise_px2_per_s3 << t.predicted_position << t.mean_color;
  }
  Fingerprint& operator<<(const Event& e) {
    add("\nevent", to_string(e.kind), e.index, e.time_s, e.track_id, e.confidence, e.text);
    for (const auto id : e.other_track_ids) add(id);
    return *this << e.position << e.box << e.position_covariance_px2;
  }
  Fingerprint& operator<<(const Detection& d) {
    add("\ndetection", d.area_px, d.confidence, d.class_id, d.shared);
    return *this << d.box << d.position << d.mean_color << d.moments_px2;
  }
  Fingerprint& operator<<(const cv::Mat& image) {
    add("\nimage", image.rows, image.cols, image.type());
    const cv::Mat whole = image.isContinuous() ? image : image.clone();
    text_.write(reinterpret_cast<const char*>(whole.data),
                static_cast<std::streamsize>(whole.total() * whole.elemSize()));
    return *this;
  }
  Fingerprint& operator<<(const Detections& d) {
    add("\ndetections", d.index, d.time_s, d.frame_width, d.frame_height, d.items.size(), d.contours.size());
    for (const Detection& item : d.items) *this << item;
    add("\npixels", d.pixels_read);
    for (const Region& region : d.regions) {
      add("\nregion", static_cast<int>(region.kind), region.track_id);
      *this << region.box;
    }
    for (const ColorHistogram& histogram : d.histograms) {
      for (const float part : histogram.parts) add(part);
    }
    for (const Event& event : d.events) *this << event;
    return *this << d.mask << d.background << d.flow;
  }
  Fingerprint& operator<<(const TrackingResult& r) {
    add("\nresult", r.index, r.time_s, r.tracks.size(), r.tentative.size(), r.events.size());
    for (const Track& track : r.tracks) *this << track;
    for (const Track& track : r.tentative) *this << track;
    for (const Event& event : r.events) *this << event;
    for (const Match& m : r.matches.candidates) add("\nmatch", m.track, m.detection, m.track_id, m.cost, m.assigned);
    add("\nassigned");
    for (const int d : r.matches.detection_of_track) add(d);
    for (const int t : r.matches.track_of_detection) add(t);
    add("\ncosts", r.costs.rows(), r.costs.columns(), "beliefs", r.beliefs.rows(), r.beliefs.columns());
    for (const CostMatrix* matrix : {&r.costs, &r.beliefs}) {
      for (int i = 0; i < matrix->rows(); ++i) {
        for (int j = 0; j < matrix->columns(); ++j) add((*matrix)(i, j));
      }
    }
    add("\nrows");
    for (const auto id : r.matrix_track_ids) add(id);
    for (const auto& [class_id, grid] : r.vicinity) {
      add("\ngrid", class_id, grid.rows, grid.columns);
      for (const VicinityCell& c : grid.cells) add(c.factor_y, c.factor_x, c.updates, c.mean_step_px, c.step_variance_px2);
    }
    return *this;
  }
  std::string text() const { return text_.str(); }

 private:
  template <class... Values>
  Fingerprint& add(const Values&... values) {
    ((text_ << values << ' '), ...);
    return *this;
  }
  std::ostringstream text_;
};

inline std::string fingerprint(const TrackingResult& result) { return (Fingerprint() << result).text(); }

inline std::string fingerprint(const Detections& detections) { return (Fingerprint() << detections).text(); }

inline std::string fingerprint(const FrameResult& result) {
  Fingerprint print;
  print << static_cast<const TrackingResult&>(result) << result.detections << result.frame;
  return print.text();
}

}  // namespace survtrack
