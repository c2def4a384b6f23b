// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "survtrack/segmentation/cleanup_options.hpp"

namespace survtrack {

/// Removes noise from masks (CV_8UC1, 0 or 255; strided views are fine) in place: temporal median, then
/// median, opening, closing, erosion and dilation by tiles, as the options say. The border takes no part: an
/// object that touches it keeps its shape, and no gap between an object and the border is filled. Allocates
/// nothing while the size stays. With a temporal median, masks come in the order of time.
class Cleanup {
 public:
  /// Throws `ConfigError` for options out of their ranges.
  explicit Cleanup(const CleanupOptions& options);
  ~Cleanup();
  Cleanup(Cleanup&&) noexcept;
  Cleanup& operator=(Cleanup&&) noexcept;

  /// Throws `InputError` for what is no mask, is too small for the tiles (`TiledMorphology::check`) or, with a
  /// temporal median, is not of the size of the masks before; then keeps its state and the mask.
  void apply(cv::Mat& mask);

  /// Forgets the masks before; the next may be of another size.
  void reset();

 private:
  struct Steps;
  std::unique_ptr<Steps> steps_;
};

}  // namespace survtrack
