// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/segmenter.hpp"

#include "segmentation/horn_schunck_segmenter.hpp"
#include "segmentation/moving_average.hpp"
#include "segmentation/normalized_difference.hpp"
#include "segmentation/opencv_segmenters.hpp"
#include "segmentation/selective.hpp"
#include "segmentation/static_reference.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

void Segmenter::segment_regions(const cv::Mat&, const Expectation&, const ReadPlan&, cv::Mat&, std::vector<Event>&) {
  throw InputError("expectation.regions: this background model reads whole frames; expected none");
}

void Segmenter::load_background(const cv::Mat& /*picture*/) {
  throw InputError("background: this background model takes no picture; expected segmenter.model static_reference "
                   "with segmenter.source picture");
}

// Each model's own header declares a make_model for its options.
std::unique_ptr<Segmenter> make_segmenter(const SegmenterOptions& options) {
  return std::visit([](const auto& model) { return make_model(model); }, options);
}

}  // namespace survtrack
