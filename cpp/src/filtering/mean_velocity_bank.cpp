// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/mean_velocity_bank.hpp"

namespace survtrack {

int MeanVelocityBank::add(const Point& position, double) {
  slots_.push_back(started_at(position));
  return size() - 1;
}

void MeanVelocityBank::restart(int slot, const Point& position, double) {
  slots_[static_cast<std::size_t>(slot)] = started_at(position);
}

MeanVelocityBank::Slot MeanVelocityBank::started_at(const Point& position) {
  Slot slot;
  slot.measured = slot.predicted = position;
  return slot;
}

void MeanVelocityBank::predict(double dt) {
  for (Slot& slot : slots_) {
    // The first prediction after a match looks one step ahead; a frozen track's then stays as it is.
    const bool moves = slot.waited == 0.0 || options_.extrapolate_lost;
    if (moves) slot.predicted = slot.predicted + dt * slot.velocity;
    slot.waited += dt;
  }
}

void MeanVelocityBank::correct(int slot, const Point& measured, const Symmetric2&) {
  Slot& s = slots_[static_cast<std::size_t>(slot)];
  if (s.waited <= 0.0) {  // measured again at the same time: that is no step
    s.measured = s.predicted = measured;
    return;
  }
  s.steps.push_back({measured - s.measured, s.waited});
  if (static_cast<int>(s.steps.size()) > options_.window_steps) s.steps.pop_front();
  Point path;
  double time = 0.0;
  for (const Step& step : s.steps) {
    path = path + step.displacement;
    time += step.dt;
  }
  s.velocity = (1.0 / time) * path;
  s.measured = s.predicted = measured;
  s.waited = 0.0;
}

Estimate MeanVelocityBank::estimate(int slot) const {
  const Slot& s = at(slot);
  return {options_.extrapolate_lost ? s.predicted : s.measured, s.velocity, {}, {}, {}, {}};
}

Eigen::VectorXd MeanVelocityBank::state(int slot) const {
  const Estimate now = estimate(slot);
  return Eigen::Vector4d(now.position.x, now.position.y, now.velocity.x, now.velocity.y);
}

}  // namespace survtrack
