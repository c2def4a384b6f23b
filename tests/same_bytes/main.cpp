// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0
// Tracks raw frames and prints all that is known of each, numbers as hexadecimal floats, which are exact.
// usage: same_bytes PRESET WIDTH HEIGHT CHANNELS FRAMES_PER_SECOND MASKS < FRAMES
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include <survtrack/pipeline/pipeline.hpp>

namespace {

void print(const survtrack::Box& b) { std::printf(" %a %a %a %a", b.x, b.y, b.width, b.height); }
void print(const survtrack::Point& p) { std::printf(" %a %a", p.x, p.y); }
void print(const survtrack::Symmetric2& m) { std::printf(" %a %a %a", m.xx, m.xy, m.yy); }
void print(const survtrack::Matrix2& m) { std::printf(" %a %a %a %a", m.xx, m.xy, m.yx, m.yy); }
void print(const survtrack::Color& c) { std::printf(" %a %a %a", c.blue, c.green, c.red); }

void print(const survtrack::Track& t) {
  std::printf("track %lld %d %d", static_cast<long long>(t.id), static_cast<int>(t.status), t.reported ? 1 : 0);
  print(t.box);
  print(t.position);
  print(t.velocity_px_per_s);
  print(t.position_covariance_px2);
  print(t.velocity_covariance_px2_per_s2);
  print(t.position_velocity_covariance_px2_per_s);
  print(t.velocity_noise_px2_per_s3);
  print(t.predicted_position);
  print(t.mean_color);
  std::printf(" %d %d %d %d\n", t.detection, t.age_frames, t.matched_frames, t.lost_frames);
}

void print(const survtrack::FrameResult& result, std::ofstream& masks) {
  std::printf("frame %lld %a\n", static_cast<long long>(result.index), result.time_s);
  for (const survtrack::Detection& d : result.detections.items) {
    std::printf("detection");
    print(d.box);
    print(d.position);
    std::printf(" %a", d.area_px);
    print(d.mean_color);
    print(d.moments_px2);
    std::printf(" %a\n", d.confidence);
  }
  for (const survtrack::Track& t : result.tracks) print(t);
  for (const survtrack::Track& t : result.tentative) print(t);
  for (const survtrack::Match& m : result.matches.candidates) {
    std::printf("match %d %d %a %d\n", m.track, m.detection, m.cost, m.assigned ? 1 : 0);
  }
  for (const survtrack::Event& e : result.events) {
    std::printf("event %d %lld", static_cast<int>(e.kind), static_cast<long long>(e.track_id));
    print(e.box);
    print(e.position);
    std::printf("\n");
  }
  for (int y = 0; y < result.mask().rows; ++y) {
    masks.write(reinterpret_cast<const char*>(result.mask().ptr(y)), result.mask().cols);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 7) return 2;
  const int width = std::stoi(arguments[2]), height = std::stoi(arguments[3]), channels = std::stoi(arguments[4]);
  const double frames_per_second = std::stod(arguments[5]);
  std::ofstream masks(arguments[6], std::ios::binary);
  survtrack::Pipeline pipeline = survtrack::Pipeline::from_preset(arguments[1]);
  survtrack::FrameResult result;
  for (int k = 0;; ++k) {
    cv::Mat frame(height, width, CV_8UC(channels));
    std::cin.read(reinterpret_cast<char*>(frame.data), static_cast<std::streamsize>(frame.total() * frame.elemSize()));
    if (!std::cin) break;
    if (pipeline.process(frame, k / frames_per_second, result)) print(result, masks);
  }
  while (pipeline.finish(result)) print(result, masks);
  return masks.flush() ? 0 : 1;
}
