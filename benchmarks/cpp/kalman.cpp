// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// One step of a Kalman filter, predict and update: nanoseconds, of fixed sizes, of sizes known at run time, and of many
// filters at once.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

#include "survtrack/filtering/extended_kalman_filter.hpp"
#include "survtrack/filtering/kalman_array.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"
#include "survtrack/filtering/unscented_kalman_filter.hpp"

namespace {

using namespace survtrack;

constexpr int rounds = 101;
constexpr int steps = 2000;
constexpr int filters = 1000;

struct Spread {
  double median_ns, fastest_ns;
};

/// Of rounds of `work`, each of which is `count` steps.
template <class Work>
Spread time_of(int count, const Work& work) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const auto taken = std::chrono::steady_clock::now() - begin;
    times.push_back(std::chrono::duration<double, std::nano>(taken).count() / count);
  }
  std::sort(times.begin(), times.end());
  return {times[rounds / 2], times.front()};
}

std::vector<Eigen::Vector2d> walk() {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<Eigen::Vector2d> places;
  for (int k = 0; k < steps; ++k) places.emplace_back(k + noise(random), -0.5 * k + noise(random));
  return places;
}

template <int Order, int N, int M>
typename KalmanFilter<N, M>::Model model_of() {
  using Motion = MotionModel<Order>;
  typename KalmanFilter<N, M>::Model model;
  model.F = Motion::transition(1.0);
  model.Q = 0.1 * Motion::unit_noise(1.0);
  model.H = Eigen::MatrixXd::Identity(2, Motion::state_size);
  model.R = Eigen::MatrixXd::Identity(2, 2);
  return model;
}

/// The state at the end, so that nothing is left out as unused.
double end = 0.0;

template <class Filter>
Spread walked(Filter filter, const std::vector<Eigen::Vector2d>& places) {
  const typename Filter::State x = filter.x();
  return time_of(steps, [&] {
    filter.set_x(x);
    for (const Eigen::Vector2d& z : places) {
      filter.predict();
      filter.update(z);
    }
    end += filter.x()(0) + filter.last().nis;
  });
}

template <int n, class Filter>
typename Filter::State start() {
  return Eigen::VectorXd::Zero(n);
}

template <int n, class Filter>
typename Filter::StateMatrix start_covariance() {
  return 10.0 * Eigen::MatrixXd::Identity(n, n);
}

template <int Order, int N, int M>
Spread single(const std::vector<Eigen::Vector2d>& places) {
  constexpr int n = MotionModel<Order>::state_size;
  using Filter = KalmanFilter<N, M>;
  return walked(Filter(model_of<Order, N, M>(), start<n, Filter>(), start_covariance<n, Filter>()), places);
}

/// The same model by functions, for the filters that take any.
template <int Order, int N, int M>
NonlinearModel<N, M> functions_of() {
  const auto model = model_of<Order, N, M>();
  return {[F = model.F](const auto& x, const Eigen::VectorXd&) { return F * x; }, [H = model.H](const auto& x) { return H * x; },
          model.Q, model.R};
}

template <int Order, int N, int M>
Spread extended(const std::vector<Eigen::Vector2d>& places) {
  constexpr int n = MotionModel<Order>::state_size;
  using Filter = ExtendedKalmanFilter<N, M>;
  const auto model = model_of<Order, N, M>();
  return walked(Filter(functions_of<Order, N, M>(), start<n, Filter>(), start_covariance<n, Filter>(),
                       [F = model.F](const auto&, const Eigen::VectorXd&) { return F; }, [H = model.H](const auto&) { return H; }),
                places);
}

template <int Order, int N, int M>
Spread unscented(const std::vector<Eigen::Vector2d>& places) {
  constexpr int n = MotionModel<Order>::state_size;
  using Filter = UnscentedKalmanFilter<N, M>;
  return walked(Filter(functions_of<Order, N, M>(), start<n, Filter>(), start_covariance<n, Filter>()), places);
}

template <int Order>
Spread together(const std::vector<Eigen::Vector2d>& places) {
  constexpr int n = MotionModel<Order>::state_size;
  const auto model = model_of<Order, Eigen::Dynamic, Eigen::Dynamic>();
  KalmanArray array({model.F, model.H, model.Q, model.R});
  for (int i = 0; i < filters; ++i) array.add(Eigen::VectorXd::Zero(n), 10.0 * Eigen::MatrixXd::Identity(n, n));
  Eigen::MatrixXd z(2, filters);
  for (int i = 0; i < filters; ++i) z.col(i) = places[static_cast<std::size_t>(i)];
  return time_of(filters, [&] {
    array.predict();
    array.update(z);
    end += array.state_data()[0];
  });
}

void print(const char* what, const Spread& cv, const Spread& ca) {
  std::printf("%-40s %8.1f %8.1f %8.1f %8.1f\n", what, cv.median_ns, cv.fastest_ns, ca.median_ns, ca.fastest_ns);
}

}  // namespace

int main() {
  const auto places = walk();
  std::printf("predict and update, 2 measured numbers     4 states           6 states   [ns a filter: median, fastest]\n");
  constexpr int dynamic = Eigen::Dynamic;
  print("KalmanFilter<4, 2>, KalmanFilter<6, 2>", single<2, 4, 2>(places), single<3, 6, 2>(places));
  print("KalmanFilter<>", single<2, dynamic, dynamic>(places), single<3, dynamic, dynamic>(places));
  print("ExtendedKalmanFilter<4, 2>, <6, 2>", extended<2, 4, 2>(places), extended<3, 6, 2>(places));
  print("ExtendedKalmanFilter<>", extended<2, dynamic, dynamic>(places), extended<3, dynamic, dynamic>(places));
  print("UnscentedKalmanFilter<4, 2>, <6, 2>", unscented<2, 4, 2>(places), unscented<3, 6, 2>(places));
  print("UnscentedKalmanFilter<>", unscented<2, dynamic, dynamic>(places), unscented<3, dynamic, dynamic>(places));
  print("KalmanArray of 1000", together<2>(places), together<3>(places));
  return end == end ? 0 : 1;
}
