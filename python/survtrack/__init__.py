# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Explainable tracking of moving objects with one static camera.

Three nouns: a Config (from a preset) makes a Pipeline, which turns frames into FrameResults:

    import survtrack

    for frame, result in survtrack.track("video.mp4"):
        for track in result.tracks:
            print(result.index, track.id, track.box)

Each half works alone: a Detector turns frames into detections, a Tracker turns the boxes of any
detector into tracks.
"""

from typing import TYPE_CHECKING, Any

from survtrack._core import (
    BeliefOptions,
    BlobOptions,
    Box,
    BoxCenterOptions,
    CentroidOptions,
    Cleanup,
    CleanupOptions,
    CloseMergeOptions,
    Config,
    ConfirmAndLoseOptions,
    CountMedianOptions,
    Detection,
    Detections,
    Detector,
    DistanceOptions,
    DroppedTrack,
    Event,
    EventKind,
    Expectation,
    FilterBank,
    FragmentMergeOptions,
    FrameResult,
    GaussianCostOptions,
    GridVicinityOptions,
    History,
    HistoryRecorder,
    HungarianOptions,
    KalmanCaOptions,
    KalmanCvOptions,
    KnnOptions,
    Link,
    Linked,
    LinkOptions,
    LostCountOptions,
    LostPlace,
    Match,
    MatchMatrixOptions,
    MeanVelocityOptions,
    Mog2Options,
    MovingAverageOptions,
    NoMergeOptions,
    NoTilingOptions,
    NoVicinityOptions,
    OldestFirstOptions,
    OutputOptions,
    Pipeline,
    PredictedTrack,
    QuadrantsOptions,
    RowOrderOptions,
    SceneScale,
    Segmenter,
    SelectiveOptions,
    Track,
    Tracker,
    TrackingResult,
    TrackStatus,
    VicinityGrid,
    WholeFrameOptions,
    __version__,
    assign_hungarian,
    assign_oldest_first,
    clean_mask,
    find_blobs,
    iou,
    link_tracks,
    match_matrix,
    options_reference,
    preset,
    preset_names,
    preset_text,
    tiled_morphology,
)
from survtrack.errors import ConfigError, InputError, SurvtrackError, UsageError

if TYPE_CHECKING:
    from survtrack.runner import track

__all__ = [
    "BeliefOptions",
    "BlobOptions",
    "Box",
    "BoxCenterOptions",
    "CentroidOptions",
    "Cleanup",
    "CleanupOptions",
    "CloseMergeOptions",
    "Config",
    "ConfigError",
    "ConfirmAndLoseOptions",
    "CountMedianOptions",
    "Detection",
    "Detections",
    "Detector",
    "DistanceOptions",
    "DroppedTrack",
    "Event",
    "EventKind",
    "Expectation",
    "FilterBank",
    "FragmentMergeOptions",
    "FrameResult",
    "GaussianCostOptions",
    "GridVicinityOptions",
    "History",
    "HistoryRecorder",
    "HungarianOptions",
    "InputError",
    "KalmanCaOptions",
    "KalmanCvOptions",
    "KnnOptions",
    "Link",
    "LinkOptions",
    "Linked",
    "LostCountOptions",
    "LostPlace",
    "Match",
    "MatchMatrixOptions",
    "MeanVelocityOptions",
    "Mog2Options",
    "MovingAverageOptions",
    "NoMergeOptions",
    "NoTilingOptions",
    "NoVicinityOptions",
    "OldestFirstOptions",
    "OutputOptions",
    "Pipeline",
    "PredictedTrack",
    "QuadrantsOptions",
    "RowOrderOptions",
    "SceneScale",
    "Segmenter",
    "SelectiveOptions",
    "SurvtrackError",
    "Track",
    "TrackStatus",
    "Tracker",
    "TrackingResult",
    "UsageError",
    "VicinityGrid",
    "WholeFrameOptions",
    "__version__",
    "assign_hungarian",
    "assign_oldest_first",
    "clean_mask",
    "find_blobs",
    "iou",
    "link_tracks",
    "match_matrix",
    "options_reference",
    "preset",
    "preset_names",
    "preset_text",
    "tiled_morphology",
    "track",
]


def __getattr__(name: str) -> Any:
    """Imports the runner, with all that it needs, when it is first used."""
    if name == "track":
        from survtrack.runner import track

        return track
    raise AttributeError(f"module 'survtrack' has no attribute '{name}'")
