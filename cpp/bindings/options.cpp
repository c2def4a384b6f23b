// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "options_class.hpp"

#include "survtrack/pipeline/config.hpp"

namespace survtrack::bindings {

void bind_options(py::module_& module) {
  bind_model_options<SelectiveOptions>(module, "SelectiveOptions");
  bind_model_options<MovingAverageOptions>(module, "MovingAverageOptions");
  bind_model_options<HornSchunckOptions>(module, "HornSchunckOptions");
  bind_model_options<Mog2Options>(module, "Mog2Options");
  bind_model_options<KnnOptions>(module, "KnnOptions");
  bind_model_options<StaticReferenceOptions>(module, "StaticReferenceOptions");
  bind_model_options<NormalizedDifferenceOptions>(module, "NormalizedDifferenceOptions");
  bind_model_options<BlocksOptions>(module, "BlocksOptions");
  bind_model_options<ChangedPixelsOptions>(module, "ChangedPixelsOptions");
  bind_model_options<HistogramOptions>(module, "HistogramOptions");
  bind_model_options<KolmogorovSmirnovOptions>(module, "KolmogorovSmirnovOptions");
  bind_model_options<NoSceneChangeOptions>(module, "NoSceneChangeOptions");
  bind_model_options<GuardOptions>(module, "GuardOptions");
  bind_model_options<NoTilingOptions>(module, "NoTilingOptions");
  bind_model_options<WholeFrameOptions>(module, "WholeFrameOptions");
  bind_model_options<QuadrantsOptions>(module, "QuadrantsOptions");
  bind_frozen_options<CleanupOptions>(module, "CleanupOptions",
                                      "Noise removal on the mask: temporal median, median, opening, closing, tiles");
  bind_model_options<FragmentMergeOptions>(module, "FragmentMergeOptions");
  bind_model_options<CloseMergeOptions>(module, "CloseMergeOptions");
  bind_model_options<NoMergeOptions>(module, "NoMergeOptions");
  bind_frozen_options<BlobOptions>(module, "BlobOptions", "Which foreground regions count as detections");
  bind_model_options<KalmanCvOptions>(module, "KalmanCvOptions");
  bind_model_options<KalmanCaOptions>(module, "KalmanCaOptions");
  bind_model_options<MeanVelocityOptions>(module, "MeanVelocityOptions");
  bind_model_options<KalmanDiscreteOptions>(module, "KalmanDiscreteOptions");
  bind_model_options<KalmanBoxOptions>(module, "KalmanBoxOptions");
  bind_model_options<KalmanPathOptions>(module, "KalmanPathOptions");
  bind_model_options<ExtendedOptions>(module, "ExtendedOptions");
  bind_model_options<UnscentedOptions>(module, "UnscentedOptions");
  bind_model_options<ParticleOptions>(module, "ParticleOptions");
  bind_model_options<BoxCenterOptions>(module, "BoxCenterOptions");
  bind_model_options<CentroidOptions>(module, "CentroidOptions");
  bind_model_options<GaussianCostOptions>(module, "GaussianCostOptions");
  bind_model_options<MatchMatrixOptions>(module, "MatchMatrixOptions");
  bind_model_options<BeliefOptions>(module, "BeliefOptions");
  bind_model_options<DistanceOptions>(module, "DistanceOptions");
  bind_model_options<NoAppearanceOptions>(module, "NoAppearanceOptions");
  bind_model_options<ColorHistogramOptions>(module, "ColorHistogramOptions");
  bind_model_options<HungarianOptions>(module, "HungarianOptions");
  bind_model_options<OldestFirstOptions>(module, "OldestFirstOptions");
  bind_model_options<RowOrderOptions>(module, "RowOrderOptions");
  bind_model_options<LargestOptions>(module, "LargestOptions");
  bind_model_options<ConfirmAndLoseOptions>(module, "ConfirmAndLoseOptions");
  bind_model_options<LostCountOptions>(module, "LostCountOptions");
  bind_model_options<CountMedianOptions>(module, "CountMedianOptions");
  bind_model_options<RegionGrowthOptions>(module, "RegionGrowthOptions");
  bind_model_options<SingleLargestOptions>(module, "SingleLargestOptions");
  bind_model_options<NoGroupsOptions>(module, "NoGroupsOptions");
  bind_model_options<SharedBlobOptions>(module, "SharedBlobOptions");
  bind_model_options<NoReentryOptions>(module, "NoReentryOptions");
  bind_model_options<RememberOptions>(module, "RememberOptions");
  bind_model_options<NoVicinityOptions>(module, "NoVicinityOptions");
  bind_model_options<GridVicinityOptions>(module, "GridVicinityOptions");
  bind_model_options<NoRegionsOptions>(module, "NoRegionsOptions");
  bind_model_options<PredictedRegionsOptions>(module, "PredictedRegionsOptions");
  bind_frozen_options<OutputOptions>(module, "OutputOptions", "Extras of a result that cost something");
}

}  // namespace survtrack::bindings
