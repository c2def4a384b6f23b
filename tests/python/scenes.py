# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Runs of a pipeline over made footage, and all that they say in one comparable value."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

import survtrack
from clips import Image, walking_square

FPS = 10.0
# Presets that need nothing beside their options; the others need paths and zones.
PRESETS = [
    name
    for name in survtrack.preset_names()
    if survtrack.preset(name).filter.model != "kalman_path"
]
MODELS: dict[str, tuple[type[Any], ...]] = {
    "segmenter": (
        survtrack.SelectiveOptions,
        survtrack.MovingAverageOptions,
        survtrack.Mog2Options,
        survtrack.KnnOptions,
        survtrack.HornSchunckOptions,
        survtrack.StaticReferenceOptions,
        survtrack.NormalizedDifferenceOptions,
    ),
    "scene_change": (survtrack.NoSceneChangeOptions, survtrack.GuardOptions),
    "filter": (
        survtrack.KalmanCvOptions,
        survtrack.KalmanCaOptions,
        survtrack.MeanVelocityOptions,
        survtrack.KalmanDiscreteOptions,
        survtrack.KalmanBoxOptions,
        survtrack.KalmanPathOptions,
        survtrack.ExtendedOptions,
        survtrack.UnscentedOptions,
        survtrack.ParticleOptions,
    ),
    "measurement": (survtrack.BoxCenterOptions, survtrack.CentroidOptions),
    "cost": (
        survtrack.GaussianCostOptions,
        survtrack.MatchMatrixOptions,
        survtrack.BeliefOptions,
        survtrack.DistanceOptions,
    ),
    "appearance": (survtrack.NoAppearanceOptions, survtrack.ColorHistogramOptions),
    "assignment": (
        survtrack.HungarianOptions,
        survtrack.OldestFirstOptions,
        survtrack.RowOrderOptions,
        survtrack.LargestOptions,
    ),
    "lifecycle": (
        survtrack.ConfirmAndLoseOptions,
        survtrack.LostCountOptions,
        survtrack.CountMedianOptions,
        survtrack.RegionGrowthOptions,
        survtrack.SingleLargestOptions,
    ),
    "groups": (survtrack.NoGroupsOptions, survtrack.SharedBlobOptions),
    "reentry": (survtrack.NoReentryOptions, survtrack.RememberOptions),
    "vicinity": (survtrack.NoVicinityOptions, survtrack.GridVicinityOptions),
    "regions": (survtrack.NoRegionsOptions, survtrack.PredictedRegionsOptions),
}
MERGES: tuple[type[Any], ...] = (
    survtrack.FragmentMergeOptions,
    survtrack.CloseMergeOptions,
    survtrack.NoMergeOptions,
)
MEASURES: tuple[type[Any], ...] = (
    survtrack.BlocksOptions,
    survtrack.ChangedPixelsOptions,
    survtrack.HistogramOptions,
    survtrack.KolmogorovSmirnovOptions,
)
TILINGS: tuple[type[Any], ...] = (
    survtrack.NoTilingOptions,
    survtrack.WholeFrameOptions,
    survtrack.QuadrantsOptions,
)
PARTS: dict[str, type[Any]] = {
    "cleanup": survtrack.CleanupOptions,
    "blobs": survtrack.BlobOptions,
    "outputs": survtrack.OutputOptions,
}
CLASSES: list[type[Any]] = [
    *(one for models in MODELS.values() for one in models),
    *MERGES,
    *MEASURES,
    *TILINGS,
    *PARTS.values(),
]


def scene(count: int = 40) -> list[Image]:
    """A ground that is empty for ten frames, then a square that walks."""
    return walking_square(count, still=10)


def config_of(**changes: object) -> survtrack.Config:
    """The default config with other parts: config_of(segmenter=survtrack.KnnOptions())."""
    return survtrack.Config(**changes)


def run(
    pipeline: survtrack.Pipeline, frames: Iterable[Image], fps: float = FPS
) -> list[survtrack.FrameResult]:
    """The results of all frames, late ones too."""
    given = [pipeline.process(frame, index / fps) for index, frame in enumerate(frames)]
    return [result for result in given if result is not None] + pipeline.finish()


def rows(array: np.ndarray) -> bytes:
    """The bytes of a structured array without those between its fields."""
    return b"".join(array[name].tobytes() for name in array.dtype.names or ())


def answer(results: Sequence[survtrack.FrameResult]) -> list[tuple[object, ...]]:
    """Everything that results say, to the bit."""
    return [
        (
            result.index,
            result.time_s,
            result.mask.tobytes(),
            rows(result.detection_array),
            rows(result.track_array),
            [(match.track, match.detection, match.cost) for match in result.matches],
            [(event.kind, event.track_id, event.text) for event in result.events],
            [repr(track) for track in result.tentative],
        )
        for result in results
    ]
