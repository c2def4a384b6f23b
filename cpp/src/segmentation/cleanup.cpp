// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/cleanup.hpp"

#include <optional>

#include "core/check_mask.hpp"
#include "segmentation/mask_median.hpp"
#include "segmentation/mask_morphology.hpp"

namespace survtrack {

using kernels::MaskMedian;
using kernels::MaskMorphology;

struct Cleanup::Steps {
  std::optional<MaskMedian> median;
  std::optional<MaskMorphology> opening;
  std::optional<MaskMorphology> closing;
};

// A square of one pixel changes nothing.
Cleanup::Cleanup(const CleanupOptions& options) : steps_(std::make_unique<Steps>()) {
  check_fields(options);
  if (options.median_px > 1) steps_->median.emplace(options.median_px);
  if (options.open_px > 1) steps_->opening.emplace(MaskMorphology::Operation::opening, options.open_px);
  if (options.close_px > 1) steps_->closing.emplace(MaskMorphology::Operation::closing, options.close_px);
}

Cleanup::~Cleanup() = default;
Cleanup::Cleanup(Cleanup&&) noexcept = default;
Cleanup& Cleanup::operator=(Cleanup&&) noexcept = default;

void Cleanup::apply(cv::Mat& mask) {
  check_mask(mask);
  const kernels::MaskView view{mask.data, static_cast<std::size_t>(mask.cols), static_cast<std::size_t>(mask.rows),
                               mask.step[0]};
  if (steps_->median) steps_->median->apply(view);
  if (steps_->opening) steps_->opening->apply(view);
  if (steps_->closing) steps_->closing->apply(view);
}

}  // namespace survtrack
