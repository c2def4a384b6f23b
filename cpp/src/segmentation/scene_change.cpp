// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/scene_change.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "segmentation/scene_measures.hpp"
#include "segmentation/scene_sample.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {

const char* to_string(SceneChangeKind kind) {
  switch (kind) {
    case SceneChangeKind::cut: return "cut";
    case SceneChangeKind::gradual: return "gradual";
    case SceneChangeKind::brightness: return "brightness";
    case SceneChangeKind::infrared: return "infrared";
    case SceneChangeKind::black: return "black";
  }
  return "";
}

std::string describe(const SceneChange& change, SceneAction action) {
  const char* kind = "";
  switch (change.kind) {
    case SceneChangeKind::cut: kind = "cut, another scene"; break;
    case SceneChangeKind::gradual: kind = "gradual"; break;
    case SceneChangeKind::brightness: kind = "brightness, a lamp"; break;
    case SceneChangeKind::infrared: kind = "infrared, colour went or came back"; break;
    case SceneChangeKind::black: kind = "black frame"; break;
  }
  const char* done = "nothing is done.";
  if (action != SceneAction::report) {
    done = change.kind == SceneChangeKind::black  ? "the background is kept and masks are empty while it lasts."
           : action == SceneAction::relearn ? "the background is learned anew, with empty masks at first."
                                            : "the background starts anew from this frame.";
  }
  char numbers[64];
  const char* const side = change.kind == SceneChangeKind::infrared ? "below" : "beyond";
  std::snprintf(numbers, sizeof numbers, "%.3f is %s %.3f", change.value, side, change.threshold);
  return "The scene changed (" + std::string(kind) + "): " + change.measure + " " + numbers + "; " + done;
}

struct SceneGuard::State {
  explicit State(const GuardOptions& given) : options(given) { check_fields(options); }

  /// The difference by the measure that is chosen.
  double difference(const SceneSample& a, const SceneSample& b) const {
    return std::visit([&](const auto& measure) { return scene_difference(measure, a, b); }, options.measure);
  }

  SceneLook look(const cv::Mat& frame, double time_s) {
    check_image(frame);
    if (channels != 0) check_same_format(frame, size, channels);
    check_time(time_s, channels != 0 ? std::optional(previous_s) : std::nullopt);
    const bool first = channels == 0;
    if (first) {
      size = frame.size();
      channels = frame.channels();
      grid = scene_grid(size, options.samples);
    }
    take_sample(frame, grid, options.low_pass_px, now);
    if (first) begin(time_s);
    SceneLook found = measure();
    found.change = change_in(found);
    if (!found.black) {
      if (found.change) {
        begin(time_s);
      } else {
        learn(time_s);
      }
    }
    was_black = found.black;
    previous_s = time_s;
    return found;
  }

  SceneLook measure() const {
    SceneLook found;
    found.against_reference = difference(now, reference);
    found.against_before = difference(now, history[next % history.size()]);
    found.correlation = correlation(now, reference);
    found.color = color_of(now);
    found.reference_color = color_of(reference);
    found.black_part = black_part_of(now, options.black_level);
    // A scene that is mostly black itself has no black frames.
    found.black = found.black_part >= options.black_part && black_part_of(reference, options.black_level) < 0.5 * options.black_part;
    return found;
  }

  std::optional<SceneChange> change_in(const SceneLook& found) const {
    if (found.black) {
      if (was_black) return std::nullopt;
      return SceneChange{SceneChangeKind::black, "black_part", found.black_part, options.black_part};
    }
    const double more_color = std::max(found.color, found.reference_color);
    const double less_color = std::min(found.color, found.reference_color);
    if (more_color >= options.color_level && less_color < options.color_part * more_color) {
      return SceneChange{SceneChangeKind::infrared, "color_part", less_color / more_color, options.color_part};
    }
    const auto [name, threshold] = std::visit(
        [](const auto& measure) { return std::pair<const char*, double>(measure.model, measure.threshold); }, options.measure);
    if (!(found.against_reference > threshold)) return std::nullopt;
    SceneChange change{SceneChangeKind::cut, name, found.against_reference, threshold};
    if (!(found.against_before > threshold)) {
      change.kind = SceneChangeKind::gradual;
    } else if (found.correlation >= options.same_scene_correlation) {
      change.kind = SceneChangeKind::brightness;
    }
    return change;
  }

  /// This frame is all that is known.
  void begin(double time_s) {
    start_s = time_s;
    previous_s = time_s;
    reference = now;
    means.assign(now.levels.begin(), now.levels.end());
    history.assign(1, now);
    next = 0;
  }

  /// A plain mean at first, later one with the time constant: what passed through the first frames fades soon. Frames
  /// before are a ring, the oldest next.
  void learn(double time_s) {
    const double elapsed_s = time_s - previous_s;
    const double rate = elapsed_s > 0.0 ? std::min(1.0, elapsed_s / std::min(options.memory_s, time_s - start_s)) : 0.0;
    const auto part = static_cast<float>(rate);
    for (std::size_t i = 0; i < means.size(); ++i) {
      means[i] += part * (static_cast<float>(now.levels[i]) - means[i]);
      reference.levels[i] = static_cast<std::uint8_t>(means[i] + 0.5F);
    }
    if (history.size() < static_cast<std::size_t>(options.frames_back)) {
      history.push_back(now);
    } else {
      history[next % history.size()] = now;
      next = (next + 1) % history.size();
    }
  }

  GuardOptions options;
  cv::Size size;
  int channels = 0;  ///< 0: no frame yet
  double start_s = 0.0;
  double previous_s = 0.0;
  bool was_black = false;
  SceneGrid grid;
  SceneSample now;
  SceneSample reference;     ///< `means`, rounded
  std::vector<float> means;  ///< of what was seen since the last change
  std::vector<SceneSample> history;
  std::size_t next = 0;      ///< the oldest of a full history
};

SceneGuard::SceneGuard(const GuardOptions& options) : state_(std::make_unique<State>(options)) {}
SceneGuard::~SceneGuard() = default;
SceneGuard::SceneGuard(SceneGuard&&) noexcept = default;
SceneGuard& SceneGuard::operator=(SceneGuard&&) noexcept = default;

SceneLook SceneGuard::look(const cv::Mat& frame, double time_s) { return state_->look(frame, time_s); }

int SceneGuard::sample_count() const { return state_->channels == 0 ? 0 : static_cast<int>(state_->grid.count()); }

void SceneGuard::reset() {
  state_->channels = 0;
  state_->was_black = false;
}

}  // namespace survtrack
