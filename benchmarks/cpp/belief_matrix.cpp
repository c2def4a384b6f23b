// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The belief matrix, from tracks and blobs to the assignment: microseconds a frame, and how they grow.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

#include "survtrack/association/belief_matrix.hpp"
#include "survtrack/tracking/matcher.hpp"

namespace {

using namespace survtrack;

constexpr int rounds = 51;

template <class Work>
double median_us(const Work& work) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[rounds / 2];
}

Detections blobs(int count, double time_s, std::mt19937& random) {
  std::uniform_real_distribution<double> x(0.0, 300.0), y(0.0, 220.0), level(0.0, 255.0);
  Detections detections;
  detections.time_s = time_s;
  detections.frame_width = 320;
  detections.frame_height = 240;
  for (int i = 0; i < count; ++i) {
    Detection blob = detection_of_box({x(random), y(random), 12.0, 24.0});
    blob.mean_color = {level(random), level(random), level(random)};
    detections.items.push_back(blob);
  }
  return detections;
}

/// The same blobs a little further on, in another order.
Detections moved(const Detections& before, double time_s, std::mt19937& random) {
  std::normal_distribution<double> step(0.0, 2.0);
  Detections detections = before;
  detections.time_s = time_s;
  for (Detection& blob : detections.items) {
    blob.position = blob.position + Point{step(random), step(random)};
  }
  std::shuffle(detections.items.begin(), detections.items.end(), random);
  return detections;
}

struct Times {
  double published_us, free_us, free_hungarian_us;
};

Times measure(int count) {
  const auto run = [&](BeliefOrder order, const AssignmentOptions& assignment) {
    std::mt19937 random(7);
    const Detections first = blobs(count, 0.0, random);
    const Detections second = moved(first, 1.0, random);
    const Detections third = moved(second, 2.0, random);
    BeliefOptions options;
    options.order = order;
    options.velocity_break_point = 10.0;
    options.learn_after = 0;
    TrackTable table(MeanVelocityOptions{}, CentroidOptions{}, NoReentryOptions{}, 1.0);
    table.predict(0.0);
    for (int i = 0; i < count; ++i) table.believe(table.start(i, first));
    Matcher matcher(options, assignment);
    Matches matches;
    table.predict(1.0);
    matcher.match(table, second, matches);
    for (int i = 0; i < count; ++i) {
      const int blob = matches.detection_of_track[static_cast<std::size_t>(i)];
      if (blob >= 0) table.match(i, blob, second);
    }
    table.predict(2.0);
    return median_us([&] { matcher.match(table, third, matches); });
  };
  return {run(BeliefOrder::published, OldestFirstOptions{}), run(BeliefOrder::free, OldestFirstOptions{}),
          run(BeliefOrder::free, HungarianOptions{})};
}

/// Rescaling the whole row after each step, as eq. 8.19 is printed.
void literal_beliefs(const std::vector<Evidence>& evidence, std::vector<double>& row) {
  const std::size_t blobs = evidence.size();
  row.assign(blobs + 1, 1.0 / (static_cast<double>(blobs) + 1.0));
  const auto set = [&](std::size_t i, double after) {
    const double scale = 1.0 - (after - row[i]) / (1.0 - row[i]);
    for (std::size_t m = 0; m < row.size(); ++m) {
      if (m != i) row[m] *= scale;
    }
    row[i] = after;
  };
  for (std::size_t i = 0; i < blobs; ++i) {
    for (const double ratio : {evidence[i].color, evidence[i].position}) {
      set(i, std::min(ratio * row[i] / (ratio * row[i] + 1.0 - row[i]), 1.0 - 1e-9));
    }
    set(i, std::min(row[i] * evidence[i].velocity, 1.0 - 1e-9));
  }
}

}  // namespace

int main() {
  std::printf("tracks x blobs   published   order-free   order-free, Hungarian   [us, built and assigned]\n");
  for (const int count : {10, 25, 50, 100, 200, 400}) {
    const Times t = measure(count);
    std::printf("%5d x %-5d %12.1f %12.1f %12.1f\n", count, count, t.published_us, t.free_us, t.free_hungarian_us);
  }
  std::printf("\nblobs in a row   published   order-free   literal rescaling   [us a row, given the evidence]\n");
  for (const int count : {50, 100, 200, 400, 800}) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> ratio(0.0, 3.0), factor(0.2, 2.0);
    std::vector<Evidence> evidence(static_cast<std::size_t>(count));
    for (Evidence& e : evidence) e = {ratio(random), ratio(random), 1.0, factor(random)};
    std::vector<double> row(evidence.size() + 1), scales, literal;
    const double published = median_us([&] { published_beliefs(evidence, row.data(), scales); });
    const double free = median_us([&] { order_free_beliefs(evidence, row.data()); });
    const double slow = median_us([&] { literal_beliefs(evidence, literal); });
    std::printf("%14d %11.2f %12.2f %19.2f\n", count, published, free, slow);
  }
  return 0;
}
