# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Made by scripts/make_stubs.py from the compiled module; change cpp/bindings instead.
"""
The C++ core of survtrack.
"""

from __future__ import annotations

import collections.abc
import enum
import typing

import numpy
import numpy.typing

__all__: list[str] = [
    "Activity",
    "ActivityKind",
    "BeliefOptions",
    "BlobOptions",
    "BlocksOptions",
    "Box",
    "BoxCenterOptions",
    "CentroidOptions",
    "ChangedPixelsOptions",
    "Cleanup",
    "CleanupOptions",
    "CloseMergeOptions",
    "ColorHistogramOptions",
    "Config",
    "ConfirmAndLoseOptions",
    "CountMedianOptions",
    "Density",
    "Detection",
    "Detections",
    "Detector",
    "DistanceOptions",
    "DroppedTrack",
    "Event",
    "EventKind",
    "Expectation",
    "ExtendedKalmanFilter",
    "ExtendedOptions",
    "FilterBank",
    "FilterConsistency",
    "FragmentMergeOptions",
    "FrameResult",
    "GaussianCostOptions",
    "GridVicinityOptions",
    "GuardOptions",
    "HistogramOptions",
    "History",
    "HistoryRecorder",
    "HornSchunckOptions",
    "HungarianOptions",
    "KalmanBank",
    "KalmanBoxOptions",
    "KalmanCaOptions",
    "KalmanCvOptions",
    "KalmanDiscreteOptions",
    "KalmanFilter",
    "KalmanPathOptions",
    "KnnOptions",
    "KolmogorovSmirnovOptions",
    "LargestOptions",
    "Link",
    "LinkOptions",
    "Linked",
    "LostCountOptions",
    "LostPlace",
    "Match",
    "MatchMatrixOptions",
    "MeanVelocityOptions",
    "MeasuredTrack",
    "MeasurementNoise",
    "MeasurementRecorder",
    "Mog2Options",
    "MovingAverageOptions",
    "NoAppearanceOptions",
    "NoGroupsOptions",
    "NoMergeOptions",
    "NoReentryOptions",
    "NoRegionsOptions",
    "NoSceneChangeOptions",
    "NoTilingOptions",
    "NoVicinityOptions",
    "NoiseEstimate",
    "NormalizedDifferenceOptions",
    "OldestFirstOptions",
    "OutputOptions",
    "ParticleFilter",
    "ParticleOptions",
    "Path",
    "PathState",
    "Paths",
    "Pattern",
    "PatternOptions",
    "Patterns",
    "Pipeline",
    "PredictedRegionsOptions",
    "PredictedTrack",
    "ProcessNoise",
    "QuadrantsOptions",
    "Random",
    "Region",
    "RegionGrowthOptions",
    "RegionKind",
    "RememberOptions",
    "RowOrderOptions",
    "SceneChange",
    "SceneChangeKind",
    "SceneGuard",
    "SceneLook",
    "SceneScale",
    "Segmenter",
    "SelectiveOptions",
    "SharedBlobOptions",
    "SingleLargestOptions",
    "StaticReferenceOptions",
    "Track",
    "TrackStatus",
    "Tracker",
    "TrackingResult",
    "UnscentedKalmanFilter",
    "UnscentedOptions",
    "VicinityGrid",
    "WholeFrameOptions",
    "assign_hungarian",
    "assign_oldest_first",
    "chi_square_quantile",
    "clean_mask",
    "color_histogram",
    "continuous_white_noise",
    "discrete_white_noise",
    "falling_velocity_factor",
    "filter_consistency",
    "find_blobs",
    "histogram_intersection",
    "horn_schunck",
    "identify_measurement_noise",
    "identify_process_noise",
    "iou",
    "learn_patterns",
    "link_tracks",
    "match_matrix",
    "nis_band",
    "numeric_jacobian",
    "options_reference",
    "order_free_beliefs",
    "predicted_region",
    "predicted_region_on_path",
    "preset",
    "preset_names",
    "preset_text",
    "published_beliefs",
    "rts_smooth",
    "systematic_resample",
    "tiled_morphology",
    "velocity_factor",
    "wrapped_difference",
]

class Box:
    """
    An axis-parallel box: left and top edge and size, in px.
    """
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __getstate__(self) -> tuple[float, float, float, float]: ...
    def __hash__(self) -> int: ...
    def __init__(
        self,
        x: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.SupportsFloat | typing.SupportsIndex,
        width: typing.SupportsFloat | typing.SupportsIndex,
        height: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...
    def __iter__(self) -> collections.abc.Iterator[float]: ...
    def __repr__(self) -> str: ...
    def __setstate__(
        self,
        arg0: tuple[
            typing.SupportsFloat | typing.SupportsIndex,
            typing.SupportsFloat | typing.SupportsIndex,
            typing.SupportsFloat | typing.SupportsIndex,
            typing.SupportsFloat | typing.SupportsIndex,
        ],
    ) -> None: ...
    @property
    def area_px(self) -> float:
        """
        px^2
        """
    @property
    def bottom(self) -> float:
        """
        px
        """
    @property
    def center(self) -> tuple[float, float]:
        """
        (x, y), px
        """
    @property
    def height(self) -> float:
        """
        px
        """
    @property
    def right(self) -> float:
        """
        px
        """
    @property
    def width(self) -> float:
        """
        px
        """
    @property
    def x(self) -> float:
        """
        Left edge, px.
        """
    @property
    def y(self) -> float:
        """
        Top edge, px.
        """

class RegionKind(enum.Enum):
    """
    Why a part of a frame is read.
    """

    acquisition = 2
    predicted = 1
    refresh = 3
    whole_frame = 0

class Region:
    """
    A part of a frame that is read.
    """
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __getstate__(self) -> tuple[Box, RegionKind, int]: ...
    def __hash__(self) -> int: ...
    def __init__(
        self, box: Box, kind: RegionKind, track_id: typing.SupportsInt | typing.SupportsIndex = 0
    ) -> None:
        """
        box: px, finite, width and height above 0; track_id: 0 or more, and 0 of every kind but predicted. Raises
        InputError.
        """
    def __repr__(self) -> str: ...
    def __setstate__(
        self, arg0: tuple[Box, RegionKind, typing.SupportsInt | typing.SupportsIndex]
    ) -> None: ...
    @property
    def box(self) -> Box:
        """
        px
        """
    @property
    def kind(self) -> RegionKind: ...
    @property
    def track_id(self) -> int:
        """
        Of a predicted one; 0: of a tentative track, or of none.
        """

class Detection:
    """
    Something seen in one frame: a blob, or a box of your own detector.
    """
    def __repr__(self) -> str: ...
    @property
    def area_px(self) -> float:
        """
        Number of foreground pixels; a box's area for own boxes.
        """
    @property
    def box(self) -> Box:
        """
        px
        """
    @property
    def class_id(self) -> int:
        """
        -1: no class.
        """
    @property
    def confidence(self) -> float:
        """
        1 for blobs; your detector's score otherwise.
        """
    @property
    def mean_color(self) -> tuple[float, float, float]:
        """
        (blue, green, red), 0 to 255; zero when there was no image.
        """
    @property
    def moments_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2 second central moments over the pixels, px^2.
        """
    @property
    def position(self) -> tuple[float, float]:
        """
        (x, y) in px: a blob's centroid over all its pixels, else the box centre.
        """
    @property
    def shared(self) -> bool:
        """
        A share of a blob that several tracks cover.
        """

class TrackStatus(enum.Enum):
    """
    Where a track is in its life.
    """

    closed = 3
    confirmed = 1
    lost = 2
    tentative = 0

class Track:
    """
    One object followed through time, as known after one frame.
    """
    def __repr__(self) -> str: ...
    @property
    def age_frames(self) -> int:
        """
        Frames since its first detection, that one not counted.
        """
    @property
    def box(self) -> Box:
        """
        Estimated box in this frame, px.
        """
    @property
    def detection(self) -> int:
        """
        Index of this frame's matched detection, or that of its group; -1: none.
        """
    @property
    def end_index(self) -> int:
        """
        Index of the frame of its last detection.
        """
    @property
    def end_time_s(self) -> float: ...
    @property
    def group(self) -> int:
        """
        Of tracks that share one detection the id of the oldest; 0: it shares none.
        """
    @property
    def id(self) -> int:
        """
        From 1, without gaps, given again only to who comes back; 0 while tentative.
        """
    @property
    def lost_frames(self) -> int:
        """
        Frames since its last detection.
        """
    @property
    def matched_frames(self) -> int:
        """
        Frames with a detection, the first one counted.
        """
    @property
    def mean_color(self) -> tuple[float, float, float]:
        """
        (blue, green, red) of the detection last matched.
        """
    @property
    def position(self) -> tuple[float, float]:
        """
        (x, y), px
        """
    @property
    def position_covariance_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, px^2
        """
    @property
    def position_velocity_covariance_px2_per_s(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, rows of the position, columns of the velocity
        """
    @property
    def predicted_position(self) -> tuple[float, float]:
        """
        (x, y) in px: where this frame's detection was expected.
        """
    @property
    def reported(self) -> bool:
        """
        Part of the answer of this frame: written to files and drawn.
        """
    @property
    def start_index(self) -> int:
        """
        Index of the frame of its first detection.
        """
    @property
    def start_time_s(self) -> float: ...
    @property
    def status(self) -> TrackStatus: ...
    @property
    def velocity_covariance_px2_per_s2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2; zero of filters that do not know theirs (mean_velocity)
        """
    @property
    def velocity_noise_px2_per_s3(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, process noise: what the velocity's covariance gains in a second
        """
    @property
    def velocity_px_per_s(self) -> tuple[float, float]:
        """
        (x, y)
        """

class LostPlace(enum.Enum):
    """
    Where a track was when it was seen last.
    """

    behind_object = 2
    border = 1
    none = 0
    open = 3

class EventKind(enum.Enum):
    """
    What happened.
    """

    anomalous_speed = 8
    converged = 7
    merged = 5
    scene_changed = 9
    split = 6
    track_ended = 4
    track_lost = 2
    track_recovered = 3
    track_reentered = 1
    track_started = 0

class Event:
    """
    Something that happened in one frame.
    """
    def __repr__(self) -> str: ...
    @property
    def box(self) -> Box:
        """
        px
        """
    @property
    def confidence(self) -> float:
        """
        Of a track that came back: that it is the same, 0 to 1.
        """
    @property
    def index(self) -> int:
        """
        The frame's index in its source.
        """
    @property
    def kind(self) -> EventKind: ...
    @property
    def other_track_ids(self) -> list[int]:
        """
        The other tracks concerned, by id.
        """
    @property
    def place(self) -> LostPlace:
        """
        Where a track that ended was lost.
        """
    @property
    def position(self) -> tuple[float, float]:
        """
        (x, y), px
        """
    @property
    def position_covariance_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, px^2
        """
    @property
    def text(self) -> str:
        """
        One readable sentence.
        """
    @property
    def time_s(self) -> float: ...
    @property
    def track_id(self) -> int:
        """
        0: concerns no track.
        """

class VicinityGrid:
    """
    The vicinity factor: how much things move, and so how near they are, in each cell of the
    scene (Narayana 2007, 6). Arrays are rows x columns float64.
    """
    @property
    def active(self) -> numpy.typing.NDArray[numpy.bool]:
        """
        Rows x columns bool: cells where something was followed (7.2).
        """
    @property
    def cell_px(self) -> int:
        """
        Side of a cell, px.
        """
    @property
    def factor_x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Vicinity factor in X, 1 to max_factor.
        """
    @property
    def factor_y(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Vicinity factor in Y, 1 to max_factor.
        """
    @property
    def frame_size(self) -> tuple[int, int]:
        """
        (width, height), px
        """
    @property
    def max_factor(self) -> float: ...
    @property
    def mean_step_px(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Mean length of a displacement, px per time unit.
        """
    @property
    def relative_size(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Relative size of objects: sqrt(factor_y^2 + factor_x^2) (7.2).
        """
    @property
    def step_deviation_px(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Its standard deviation, px per time unit.
        """
    @property
    def updates(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Number of displacements learned.
        """

class PredictedTrack:
    """
    A track as the tracker expects to see it in the coming frame.
    """
    @property
    def box(self) -> Box:
        """
        px
        """
    @property
    def confirmed(self) -> bool: ...
    @property
    def id(self) -> int: ...
    @property
    def innovation_covariance_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, px^2, of the measurement about its predicted position
        """
    @property
    def lost_s(self) -> float:
        """
        Time since its last detection, at the coming frame.
        """
    @property
    def position(self) -> tuple[float, float]:
        """
        (x, y), px
        """
    @property
    def velocity_px_per_s(self) -> tuple[float, float]:
        """
        (x, y)
        """

class SceneScale:
    """
    How large an object should measure where its foot stands.
    """
    def height_px(self, bottom: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Expected height in px of an object whose lower edge is at row `bottom`.
        """
    @property
    def known(self) -> bool:
        """
        Enough was seen for the law to be used.
        """

class Expectation:
    """
    What the tracker expects of the coming frame.
    """
    @property
    def keep(self) -> list[Box]:
        """
        Places that the background must not learn.
        """
    @property
    def only_regions(self) -> bool:
        """
        Only regions are read, and what is refreshed in turn; else all is.
        """
    @property
    def regions(self) -> list[Region]:
        """
        Where to look.
        """
    @property
    def scale(self) -> SceneScale:
        """
        How large objects are, where.
        """
    @property
    def time_s(self) -> float: ...
    @property
    def tracks(self) -> list[PredictedTrack]: ...
    @property
    def vicinity(self) -> VicinityGrid | None:
        """
        How much things move, where; None without vicinity.model grid.
        """

class Match:
    """
    A pair of track and detection that passed the gate.
    """
    @property
    def assigned(self) -> bool:
        """
        Chosen by the assignment.
        """
    @property
    def cost(self) -> float:
        """
        The smaller, the better.
        """
    @property
    def detection(self) -> int:
        """
        Index among the frame's detections.
        """
    @property
    def track(self) -> int:
        """
        Row among the tracks open before the frame.
        """
    @property
    def track_id(self) -> int: ...

class SelectiveOptions:
    """
    selective running average with a tolerance of its own for each pixel.

    Args:
        threshold: smallest tolerance: foreground differs by more in some channel [grey levels]; between 0 and 255
        noise_gain: tolerance in mean absolute deviations of the pixel; between 0 and 16
        update_time_s: time constant of background and deviation [s]; above 0 and at most 1000000
        absorb_time_s: foreground of a steady colour becomes background after this [s]; above 0 and at most 60
        remove_shadows: what is darker but of the background's colour is no foreground; colour frames only
        shadow_darkest: a shadow keeps at least this part of the brightness; between 0 and 1
        shadow_color_tolerance: a shadow's channels differ by no more from the darkened background [grey levels]; between 0 and 255
        scene_change_fraction: when more of the frame than this differs from the background, the scene changed and the background starts anew; above 0 and at most 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "selective"
    def __copy__(self) -> SelectiveOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> SelectiveOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        threshold: float = 20.0,
        noise_gain: float = 3.0,
        update_time_s: float = 4.0,
        absorb_time_s: float = 20.0,
        remove_shadows: bool = True,
        shadow_darkest: float = 0.7,
        shadow_color_tolerance: float = 8.0,
        scene_change_fraction: float = 0.6,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> SelectiveOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def absorb_time_s(self) -> float:
        """
        foreground of a steady colour becomes background after this [s]
        """
    @absorb_time_s.setter
    def absorb_time_s(self, value: typing.Never) -> None: ...
    @property
    def noise_gain(self) -> float:
        """
        tolerance in mean absolute deviations of the pixel
        """
    @noise_gain.setter
    def noise_gain(self, value: typing.Never) -> None: ...
    @property
    def remove_shadows(self) -> bool:
        """
        what is darker but of the background's colour is no foreground; colour frames only
        """
    @remove_shadows.setter
    def remove_shadows(self, value: typing.Never) -> None: ...
    @property
    def scene_change_fraction(self) -> float:
        """
        when more of the frame than this differs from the background, the scene changed and the background starts anew
        """
    @scene_change_fraction.setter
    def scene_change_fraction(self, value: typing.Never) -> None: ...
    @property
    def shadow_color_tolerance(self) -> float:
        """
        a shadow's channels differ by no more from the darkened background [grey levels]
        """
    @shadow_color_tolerance.setter
    def shadow_color_tolerance(self, value: typing.Never) -> None: ...
    @property
    def shadow_darkest(self) -> float:
        """
        a shadow keeps at least this part of the brightness
        """
    @shadow_darkest.setter
    def shadow_darkest(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        smallest tolerance: foreground differs by more in some channel [grey levels]
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...
    @property
    def update_time_s(self) -> float:
        """
        time constant of background and deviation [s]
        """
    @update_time_s.setter
    def update_time_s(self, value: typing.Never) -> None: ...

class MovingAverageOptions:
    """
    mean of a window of frames, and a secondary background against tails (Narayana 2007, 3.1).

    Args:
        window: centred on the frame (delays by half the window) or causal; one of "centred" "causal"
        window_frames: length N of the window (eq. 3.1) [frames]; between 1 and 10000
        threshold: T1: foreground differs by more (eq. 3.2) [grey levels]; between 0 and 255
        secondary_background: also compare with the level last seen as background (eq. 3.4)
        secondary_threshold: T2 of that comparison (eq. 3.4) [grey levels]; between 0 and 255
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "moving_average"
    def __copy__(self) -> MovingAverageOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> MovingAverageOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        window: str = "centred",
        window_frames: int = 150,
        threshold: float = 10.0,
        secondary_background: bool = True,
        secondary_threshold: float = 15.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> MovingAverageOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def secondary_background(self) -> bool:
        """
        also compare with the level last seen as background (eq. 3.4)
        """
    @secondary_background.setter
    def secondary_background(self, value: typing.Never) -> None: ...
    @property
    def secondary_threshold(self) -> float:
        """
        T2 of that comparison (eq. 3.4) [grey levels]
        """
    @secondary_threshold.setter
    def secondary_threshold(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        T1: foreground differs by more (eq. 3.2) [grey levels]
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...
    @property
    def window(self) -> str:
        """
        centred on the frame (delays by half the window) or causal
        """
    @window.setter
    def window(self, value: typing.Never) -> None: ...
    @property
    def window_frames(self) -> int:
        """
        length N of the window (eq. 3.1) [frames]
        """
    @window_frames.setter
    def window_frames(self, value: typing.Never) -> None: ...

class HornSchunckOptions:
    """
    optical flow (Horn and Schunck 1981): what moved since some frames before.

    Args:
        frames_back: N: the flow is that since the N-th frame before; the first N frames have none and an empty mask [frames]; between 1 and 1000
        smoothness: a: weight of a smooth field, for grey levels in 0 to 1; between 0.0001 and 1000
        sweeps: iterations, at most; between 1 and 100000
        tolerance: no more sweeps when one changes nothing by as much; 0: never [px]; between 0 and 1000000
        derivatives: cubes of 2 x 2 x 2 as published, or Sobel's kernels; one of "hs1981" "sobel"
        magnitude_threshold: foreground moves by more between the two frames [px]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "horn_schunck"
    def __copy__(self) -> HornSchunckOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> HornSchunckOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        frames_back: int = 10,
        smoothness: float = 0.5,
        sweeps: int = 10,
        tolerance: float = 0.0,
        derivatives: str = "hs1981",
        magnitude_threshold: float = 0.03,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> HornSchunckOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def derivatives(self) -> str:
        """
        cubes of 2 x 2 x 2 as published, or Sobel's kernels
        """
    @derivatives.setter
    def derivatives(self, value: typing.Never) -> None: ...
    @property
    def frames_back(self) -> int:
        """
        N: the flow is that since the N-th frame before; the first N frames have none and an empty mask [frames]
        """
    @frames_back.setter
    def frames_back(self, value: typing.Never) -> None: ...
    @property
    def magnitude_threshold(self) -> float:
        """
        foreground moves by more between the two frames [px]
        """
    @magnitude_threshold.setter
    def magnitude_threshold(self, value: typing.Never) -> None: ...
    @property
    def smoothness(self) -> float:
        """
        a: weight of a smooth field, for grey levels in 0 to 1
        """
    @smoothness.setter
    def smoothness(self, value: typing.Never) -> None: ...
    @property
    def sweeps(self) -> int:
        """
        iterations, at most
        """
    @sweeps.setter
    def sweeps(self, value: typing.Never) -> None: ...
    @property
    def tolerance(self) -> float:
        """
        no more sweeps when one changes nothing by as much; 0: never [px]
        """
    @tolerance.setter
    def tolerance(self, value: typing.Never) -> None: ...

class Mog2Options:
    """
    OpenCV's Gaussian mixture MOG2, for comparison.

    Args:
        history_frames: length of the history [frames]; between 1 and 1000000
        variance_threshold: squared Mahalanobis distance of background; above 0 and at most 1000000
        detect_shadows: shadows are found and not counted as foreground
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "mog2"
    def __copy__(self) -> Mog2Options: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> Mog2Options: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        history_frames: int = 500,
        variance_threshold: float = 16.0,
        detect_shadows: bool = True,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> Mog2Options:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def detect_shadows(self) -> bool:
        """
        shadows are found and not counted as foreground
        """
    @detect_shadows.setter
    def detect_shadows(self, value: typing.Never) -> None: ...
    @property
    def history_frames(self) -> int:
        """
        length of the history [frames]
        """
    @history_frames.setter
    def history_frames(self, value: typing.Never) -> None: ...
    @property
    def variance_threshold(self) -> float:
        """
        squared Mahalanobis distance of background
        """
    @variance_threshold.setter
    def variance_threshold(self, value: typing.Never) -> None: ...

class KnnOptions:
    """
    OpenCV's K nearest neighbours, for comparison.

    Args:
        history_frames: length of the history [frames]; between 1 and 1000000
        squared_distance_threshold: a sample nearer than this is a neighbour [grey levels^2]; above 0 and at most 1000000
        detect_shadows: shadows are found and not counted as foreground
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "knn"
    def __copy__(self) -> KnnOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KnnOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        history_frames: int = 500,
        squared_distance_threshold: float = 400.0,
        detect_shadows: bool = True,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KnnOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def detect_shadows(self) -> bool:
        """
        shadows are found and not counted as foreground
        """
    @detect_shadows.setter
    def detect_shadows(self, value: typing.Never) -> None: ...
    @property
    def history_frames(self) -> int:
        """
        length of the history [frames]
        """
    @history_frames.setter
    def history_frames(self, value: typing.Never) -> None: ...
    @property
    def squared_distance_threshold(self) -> float:
        """
        a sample nearer than this is a neighbour [grey levels^2]
        """
    @squared_distance_threshold.setter
    def squared_distance_threshold(self, value: typing.Never) -> None: ...

class StaticReferenceOptions:
    """
    a background taken once: mean or median of the first frames, or a picture.

    Args:
        source: mean or median of the first frames, or a picture given before the first frame; one of "mean" "median" "picture"
        frames: so many first frames are collected, with an empty mask; of a picture: after a change of the scene [frames]; between 1 and 1000
        threshold_blue: T: foreground differs by more in this channel or in another (eq. 2); colour frames [grey levels]; between 0 and 255
        threshold_green: the same for green [grey levels]; between 0 and 255
        threshold_red: the same for red [grey levels]; between 0 and 255
        threshold_grey: T of grey frames, for which the other three do not count [grey levels]; between 0 and 255
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "static_reference"
    def __copy__(self) -> StaticReferenceOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> StaticReferenceOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        source: str = "mean",
        frames: int = 5,
        threshold_blue: float = 37.0,
        threshold_green: float = 37.0,
        threshold_red: float = 37.0,
        threshold_grey: float = 37.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> StaticReferenceOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def frames(self) -> int:
        """
        so many first frames are collected, with an empty mask; of a picture: after a change of the scene [frames]
        """
    @frames.setter
    def frames(self, value: typing.Never) -> None: ...
    @property
    def source(self) -> str:
        """
        mean or median of the first frames, or a picture given before the first frame
        """
    @source.setter
    def source(self, value: typing.Never) -> None: ...
    @property
    def threshold_blue(self) -> float:
        """
        T: foreground differs by more in this channel or in another (eq. 2); colour frames [grey levels]
        """
    @threshold_blue.setter
    def threshold_blue(self, value: typing.Never) -> None: ...
    @property
    def threshold_green(self) -> float:
        """
        the same for green [grey levels]
        """
    @threshold_green.setter
    def threshold_green(self, value: typing.Never) -> None: ...
    @property
    def threshold_grey(self) -> float:
        """
        T of grey frames, for which the other three do not count [grey levels]
        """
    @threshold_grey.setter
    def threshold_grey(self, value: typing.Never) -> None: ...
    @property
    def threshold_red(self) -> float:
        """
        the same for red [grey levels]
        """
    @threshold_red.setter
    def threshold_red(self, value: typing.Never) -> None: ...

class NormalizedDifferenceOptions:
    """
    difference divided by the local gradient, over a pyramid (Nashenda 2011, eq. 3).

    Args:
        reference: a running average of the frames before, or one frame some frames back; one of "running" "previous"
        frames_back: how far back that one is; the first frames have an empty mask [frames]; between 1 and 1000
        update_time_s: time constant of the running average [s]; above 0 and at most 1000000
        levels: levels of the pyramid, the frame itself included; each halves the one before, down to sides of 8 px; between 1 and 10
        neighbourhood_px: side of the square N over which is summed; 0 and 1: the pixel alone [px]; between 0 and 31, 0 or odd
        constant: c, which keeps flat places from dividing by zero: the sum of squared gradients that counts half [grey levels^2/px^2]; above 0 and at most 1000000000
        high: a level's value above this is high and replaces that of the coarser level [px]; between 0 and 1000000
        threshold: foreground has a greater value on the finest level [px]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "normalized_difference"
    def __copy__(self) -> NormalizedDifferenceOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NormalizedDifferenceOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        reference: str = "running",
        frames_back: int = 1,
        update_time_s: float = 20.0,
        levels: int = 2,
        neighbourhood_px: int = 3,
        constant: float = 400.0,
        high: float = 2.0,
        threshold: float = 2.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NormalizedDifferenceOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def constant(self) -> float:
        """
        c, which keeps flat places from dividing by zero: the sum of squared gradients that counts half [grey levels^2/px^2]
        """
    @constant.setter
    def constant(self, value: typing.Never) -> None: ...
    @property
    def frames_back(self) -> int:
        """
        how far back that one is; the first frames have an empty mask [frames]
        """
    @frames_back.setter
    def frames_back(self, value: typing.Never) -> None: ...
    @property
    def high(self) -> float:
        """
        a level's value above this is high and replaces that of the coarser level [px]
        """
    @high.setter
    def high(self, value: typing.Never) -> None: ...
    @property
    def levels(self) -> int:
        """
        levels of the pyramid, the frame itself included; each halves the one before, down to sides of 8 px
        """
    @levels.setter
    def levels(self, value: typing.Never) -> None: ...
    @property
    def neighbourhood_px(self) -> int:
        """
        side of the square N over which is summed; 0 and 1: the pixel alone [px]
        """
    @neighbourhood_px.setter
    def neighbourhood_px(self, value: typing.Never) -> None: ...
    @property
    def reference(self) -> str:
        """
        a running average of the frames before, or one frame some frames back
        """
    @reference.setter
    def reference(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        foreground has a greater value on the finest level [px]
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...
    @property
    def update_time_s(self) -> float:
        """
        time constant of the running average [s]
        """
    @update_time_s.setter
    def update_time_s(self, value: typing.Never) -> None: ...

class BlocksOptions:
    """
    part of the blocks whose mean or variance differs.

    Args:
        blocks_a_side: the frame is cut into this many columns and rows of blocks; between 1 and 64
        mean_difference: a block changed when its mean differs by more [grey levels]; between 0 and 255
        deviation_difference: or when its standard deviation, the root of its variance, does [grey levels]; between 0 and 255
        threshold: the scene changed when more of the blocks did; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "blocks"
    def __copy__(self) -> BlocksOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> BlocksOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        blocks_a_side: int = 8,
        mean_difference: float = 15.0,
        deviation_difference: float = 15.0,
        threshold: float = 0.6,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> BlocksOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def blocks_a_side(self) -> int:
        """
        the frame is cut into this many columns and rows of blocks
        """
    @blocks_a_side.setter
    def blocks_a_side(self, value: typing.Never) -> None: ...
    @property
    def deviation_difference(self) -> float:
        """
        or when its standard deviation, the root of its variance, does [grey levels]
        """
    @deviation_difference.setter
    def deviation_difference(self, value: typing.Never) -> None: ...
    @property
    def mean_difference(self) -> float:
        """
        a block changed when its mean differs by more [grey levels]
        """
    @mean_difference.setter
    def mean_difference(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        the scene changed when more of the blocks did
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...

class ChangedPixelsOptions:
    """
    part of the samples that differ in some channel.

    Args:
        difference: a sample changed when some channel differs by more [grey levels]; between 0 and 255
        threshold: the scene changed when more of the samples did; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "changed_pixels"
    def __copy__(self) -> ChangedPixelsOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> ChangedPixelsOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, difference: float = 25.0, threshold: float = 0.45) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> ChangedPixelsOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def difference(self) -> float:
        """
        a sample changed when some channel differs by more [grey levels]
        """
    @difference.setter
    def difference(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        the scene changed when more of the samples did
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...

class HistogramOptions:
    """
    1 less the intersection of the colour histograms (Swain and Ballard 1991).

    Args:
        bins: bins of each channel; all their combinations are counted; between 2 and 32
        threshold: the scene changed when the histograms have less than 1 less this in common; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "histogram"
    def __copy__(self) -> HistogramOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> HistogramOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, bins: int = 8, threshold: float = 0.45) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> HistogramOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def bins(self) -> int:
        """
        bins of each channel; all their combinations are counted
        """
    @bins.setter
    def bins(self, value: typing.Never) -> None: ...
    @property
    def threshold(self) -> float:
        """
        the scene changed when the histograms have less than 1 less this in common
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...

class KolmogorovSmirnovOptions:
    """
    greatest difference of the cumulative distributions of grey levels.

    Args:
        threshold: the scene changed when the distributions differ by more; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kolmogorov_smirnov"
    def __copy__(self) -> KolmogorovSmirnovOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KolmogorovSmirnovOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, threshold: float = 0.3) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KolmogorovSmirnovOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def threshold(self) -> float:
        """
        the scene changed when the distributions differ by more
        """
    @threshold.setter
    def threshold(self, value: typing.Never) -> None: ...

class NoSceneChangeOptions:
    """
    nothing watches the scene as a whole; a background model may do so itself.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoSceneChangeOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoSceneChangeOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoSceneChangeOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class GuardOptions:
    """
    watches for cuts, lamps, infrared, black frames and gradual changes.

    Args:
        action: the background starts anew; the same with empty masks while it learns; or only the event; one of "restart" "relearn" "report"
        measure: how two pictures of the scene are compared
        frames_back: a change within this many frames is a cut or a lamp, a slower one is gradual [frames]; between 1 and 1000
        memory_s: time constant of the long-term reference, a mean of what was seen [s]; above 0 and at most 1000000000
        samples: pixels of the frame that are looked at, at most, on a grid; between 16 and 1000000
        low_pass_px: side of the square whose mean is a sample; 0 and 1: the pixel alone [px]; between 0 and 31, 0 or odd
        relearn_s: how long masks stay empty with action relearn [s]; between 0 and 3600
        same_scene_correlation: a sudden change that leaves at least this correlation of grey levels is one of brightness, else a cut; between -1 and 1
        color_level: colour can be lost, or come back, when the mean of largest less smallest channel is this large with it [grey levels]; above 0 and at most 255
        color_part: colour is lost when less than this part of it is left; between 0 and 1
        black_level: a sample is black when no channel is above this [grey levels]; between 0 and 255
        black_part: a frame is black when at least this part of its samples is, and the reference is not; above 0 and at most 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "guard"
    def __copy__(self) -> GuardOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> GuardOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        action: str = "restart",
        measure: ChangedPixelsOptions
        | BlocksOptions
        | HistogramOptions
        | KolmogorovSmirnovOptions = ...,
        frames_back: int = 5,
        memory_s: float = 300.0,
        samples: int = 2048,
        low_pass_px: int = 3,
        relearn_s: float = 2.0,
        same_scene_correlation: float = 0.55,
        color_level: float = 6.0,
        color_part: float = 0.25,
        black_level: int = 24,
        black_part: float = 0.95,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> GuardOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def action(self) -> str:
        """
        the background starts anew; the same with empty masks while it learns; or only the event
        """
    @action.setter
    def action(self, value: typing.Never) -> None: ...
    @property
    def black_level(self) -> int:
        """
        a sample is black when no channel is above this [grey levels]
        """
    @black_level.setter
    def black_level(self, value: typing.Never) -> None: ...
    @property
    def black_part(self) -> float:
        """
        a frame is black when at least this part of its samples is, and the reference is not
        """
    @black_part.setter
    def black_part(self, value: typing.Never) -> None: ...
    @property
    def color_level(self) -> float:
        """
        colour can be lost, or come back, when the mean of largest less smallest channel is this large with it [grey levels]
        """
    @color_level.setter
    def color_level(self, value: typing.Never) -> None: ...
    @property
    def color_part(self) -> float:
        """
        colour is lost when less than this part of it is left
        """
    @color_part.setter
    def color_part(self, value: typing.Never) -> None: ...
    @property
    def frames_back(self) -> int:
        """
        a change within this many frames is a cut or a lamp, a slower one is gradual [frames]
        """
    @frames_back.setter
    def frames_back(self, value: typing.Never) -> None: ...
    @property
    def low_pass_px(self) -> int:
        """
        side of the square whose mean is a sample; 0 and 1: the pixel alone [px]
        """
    @low_pass_px.setter
    def low_pass_px(self, value: typing.Never) -> None: ...
    @property
    def measure(
        self,
    ) -> ChangedPixelsOptions | BlocksOptions | HistogramOptions | KolmogorovSmirnovOptions:
        """
        how two pictures of the scene are compared
        """
    @measure.setter
    def measure(self, value: typing.Never) -> None: ...
    @property
    def memory_s(self) -> float:
        """
        time constant of the long-term reference, a mean of what was seen [s]
        """
    @memory_s.setter
    def memory_s(self, value: typing.Never) -> None: ...
    @property
    def relearn_s(self) -> float:
        """
        how long masks stay empty with action relearn [s]
        """
    @relearn_s.setter
    def relearn_s(self, value: typing.Never) -> None: ...
    @property
    def same_scene_correlation(self) -> float:
        """
        a sudden change that leaves at least this correlation of grey levels is one of brightness, else a cut
        """
    @same_scene_correlation.setter
    def same_scene_correlation(self, value: typing.Never) -> None: ...
    @property
    def samples(self) -> int:
        """
        pixels of the frame that are looked at, at most, on a grid
        """
    @samples.setter
    def samples(self, value: typing.Never) -> None: ...

class NoTilingOptions:
    """
    no erosion and dilation with edges of their own.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoTilingOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoTilingOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoTilingOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class WholeFrameOptions:
    """
    erosion, then dilation of the whole frame, with edges of their own.

    Args:
        erode_px: edge of the erosion's element; 0 and 1 leave it out [px]; between 0 and 99
        dilate_px: edge of the dilation's element; 0 and 1 leave it out [px]; between 0 and 99
        shape: shape of both elements; one of "square" "cross" "ellipse"
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "whole"
    def __copy__(self) -> WholeFrameOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> WholeFrameOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, erode_px: int = 4, dilate_px: int = 14, shape: str = "square") -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> WholeFrameOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def dilate_px(self) -> int:
        """
        edge of the dilation's element; 0 and 1 leave it out [px]
        """
    @dilate_px.setter
    def dilate_px(self, value: typing.Never) -> None: ...
    @property
    def erode_px(self) -> int:
        """
        edge of the erosion's element; 0 and 1 leave it out [px]
        """
    @erode_px.setter
    def erode_px(self, value: typing.Never) -> None: ...
    @property
    def shape(self) -> str:
        """
        shape of both elements
        """
    @shape.setter
    def shape(self, value: typing.Never) -> None: ...

class QuadrantsOptions:
    """
    erosion, then dilation of each quarter of the frame, with edges of its own (Semko 2007).

    Args:
        overlap_px: by which a quarter reads beyond each mid-line, at least half its two edges together [px]; between 0 and 99
        shape: shape of all elements; one of "square" "cross" "ellipse"
        erode_top_left_px: edge of the erosion's element; 0 and 1 leave it out [px]; between 0 and 99
        dilate_top_left_px: edge of the dilation's element; 0 and 1 leave it out [px]; between 0 and 99
        erode_top_right_px: the same, top right [px]; between 0 and 99
        dilate_top_right_px: the same, top right [px]; between 0 and 99
        erode_bottom_left_px: the same, bottom left [px]; between 0 and 99
        dilate_bottom_left_px: the same, bottom left [px]; between 0 and 99
        erode_bottom_right_px: the same, bottom right [px]; between 0 and 99
        dilate_bottom_right_px: the same, bottom right [px]; between 0 and 99
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "quadrants"
    def __copy__(self) -> QuadrantsOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> QuadrantsOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        overlap_px: int = 10,
        shape: str = "square",
        erode_top_left_px: int = 4,
        dilate_top_left_px: int = 11,
        erode_top_right_px: int = 4,
        dilate_top_right_px: int = 14,
        erode_bottom_left_px: int = 4,
        dilate_bottom_left_px: int = 14,
        erode_bottom_right_px: int = 4,
        dilate_bottom_right_px: int = 15,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> QuadrantsOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def dilate_bottom_left_px(self) -> int:
        """
        the same, bottom left [px]
        """
    @dilate_bottom_left_px.setter
    def dilate_bottom_left_px(self, value: typing.Never) -> None: ...
    @property
    def dilate_bottom_right_px(self) -> int:
        """
        the same, bottom right [px]
        """
    @dilate_bottom_right_px.setter
    def dilate_bottom_right_px(self, value: typing.Never) -> None: ...
    @property
    def dilate_top_left_px(self) -> int:
        """
        edge of the dilation's element; 0 and 1 leave it out [px]
        """
    @dilate_top_left_px.setter
    def dilate_top_left_px(self, value: typing.Never) -> None: ...
    @property
    def dilate_top_right_px(self) -> int:
        """
        the same, top right [px]
        """
    @dilate_top_right_px.setter
    def dilate_top_right_px(self, value: typing.Never) -> None: ...
    @property
    def erode_bottom_left_px(self) -> int:
        """
        the same, bottom left [px]
        """
    @erode_bottom_left_px.setter
    def erode_bottom_left_px(self, value: typing.Never) -> None: ...
    @property
    def erode_bottom_right_px(self) -> int:
        """
        the same, bottom right [px]
        """
    @erode_bottom_right_px.setter
    def erode_bottom_right_px(self, value: typing.Never) -> None: ...
    @property
    def erode_top_left_px(self) -> int:
        """
        edge of the erosion's element; 0 and 1 leave it out [px]
        """
    @erode_top_left_px.setter
    def erode_top_left_px(self, value: typing.Never) -> None: ...
    @property
    def erode_top_right_px(self) -> int:
        """
        the same, top right [px]
        """
    @erode_top_right_px.setter
    def erode_top_right_px(self, value: typing.Never) -> None: ...
    @property
    def overlap_px(self) -> int:
        """
        by which a quarter reads beyond each mid-line, at least half its two edges together [px]
        """
    @overlap_px.setter
    def overlap_px(self, value: typing.Never) -> None: ...
    @property
    def shape(self) -> str:
        """
        shape of all elements
        """
    @shape.setter
    def shape(self, value: typing.Never) -> None: ...

class CleanupOptions:
    """
    Noise removal on the mask: temporal median, median, opening, closing, tiles.

    Args:
        median_px: side of the median's square [px]; between 0 and 31, 0 or odd
        open_px: side of the opening's square: removes what is thinner [px]; between 0 and 99, 0 or odd
        close_px: side of the closing's square: joins over narrower gaps [px]; between 0 and 99, 0 or odd
        temporal_median_frames: foreground is what is so in more than half of this many masks; comes before the other steps; 0 and 1: off [frames]; between 0 and 999, 0 or odd
        tiling: erosion, then dilation of the mask, with edges of their own; comes last
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def __copy__(self) -> CleanupOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> CleanupOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        median_px: int = 5,
        open_px: int = 0,
        close_px: int = 0,
        temporal_median_frames: int = 0,
        tiling: NoTilingOptions | WholeFrameOptions | QuadrantsOptions = ...,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> CleanupOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def close_px(self) -> int:
        """
        side of the closing's square: joins over narrower gaps [px]
        """
    @close_px.setter
    def close_px(self, value: typing.Never) -> None: ...
    @property
    def median_px(self) -> int:
        """
        side of the median's square [px]
        """
    @median_px.setter
    def median_px(self, value: typing.Never) -> None: ...
    @property
    def open_px(self) -> int:
        """
        side of the opening's square: removes what is thinner [px]
        """
    @open_px.setter
    def open_px(self, value: typing.Never) -> None: ...
    @property
    def temporal_median_frames(self) -> int:
        """
        foreground is what is so in more than half of this many masks; comes before the other steps; 0 and 1: off [frames]
        """
    @temporal_median_frames.setter
    def temporal_median_frames(self, value: typing.Never) -> None: ...
    @property
    def tiling(self) -> NoTilingOptions | WholeFrameOptions | QuadrantsOptions:
        """
        erosion, then dilation of the mask, with edges of their own; comes last
        """
    @tiling.setter
    def tiling(self, value: typing.Never) -> None: ...

class FragmentMergeOptions:
    """
    join fragments that stand above each other, up to an object's height.

    Args:
        min_fragment_fraction: smaller fragments, as a part of the frame's area, are noise; between 0 and 1
        gap: widest gap between fragments that are joined [object heights]; between 0 and 10
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "fragments"
    def __copy__(self) -> FragmentMergeOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> FragmentMergeOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, min_fragment_fraction: float = 2e-05, gap: float = 0.25) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> FragmentMergeOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def gap(self) -> float:
        """
        widest gap between fragments that are joined [object heights]
        """
    @gap.setter
    def gap(self, value: typing.Never) -> None: ...
    @property
    def min_fragment_fraction(self) -> float:
        """
        smaller fragments, as a part of the frame's area, are noise
        """
    @min_fragment_fraction.setter
    def min_fragment_fraction(self, value: typing.Never) -> None: ...

class CloseMergeOptions:
    """
    join blobs whose centroids and mean colours are close (Narayana 2007, eq. 4.1).

    Args:
        threshold_y_px: largest vertical distance of the centroids [px]; between 0 and 1000000
        threshold_x_px: largest horizontal distance of the centroids [px]; between 0 and 1000000
        color_threshold: largest difference in each mean colour channel [grey levels]; between 0 and 255
        vicinity_scaled: multiply the distances by the vicinity factor between the two (6.4); needs vicinity.model grid
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "close"
    def __copy__(self) -> CloseMergeOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> CloseMergeOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        threshold_y_px: float = 10.0,
        threshold_x_px: float = 10.0,
        color_threshold: float = 50.0,
        vicinity_scaled: bool = False,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> CloseMergeOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def color_threshold(self) -> float:
        """
        largest difference in each mean colour channel [grey levels]
        """
    @color_threshold.setter
    def color_threshold(self, value: typing.Never) -> None: ...
    @property
    def threshold_x_px(self) -> float:
        """
        largest horizontal distance of the centroids [px]
        """
    @threshold_x_px.setter
    def threshold_x_px(self, value: typing.Never) -> None: ...
    @property
    def threshold_y_px(self) -> float:
        """
        largest vertical distance of the centroids [px]
        """
    @threshold_y_px.setter
    def threshold_y_px(self, value: typing.Never) -> None: ...
    @property
    def vicinity_scaled(self) -> bool:
        """
        multiply the distances by the vicinity factor between the two (6.4); needs vicinity.model grid
        """
    @vicinity_scaled.setter
    def vicinity_scaled(self, value: typing.Never) -> None: ...

class NoMergeOptions:
    """
    every connected region is a blob of its own.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoMergeOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoMergeOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoMergeOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class BlobOptions:
    """
    Which foreground regions count as detections.

    Args:
        min_area_px: smaller blobs are dropped (S of Narayana 2007, 3.3) [px^2]; between 0 and 1000000000
        min_area_fraction: the same, as a part of the frame's area; the larger counts; between 0 and 1
        max_blobs: of more blobs in one frame the largest are kept; between 1 and 100000
        connectivity: pixels of one region meet at an edge, or at a corner too; one of "four" "eight"
        merge: which regions are one blob
        share_blobs: divide a blob that covers several expected tracks among them
        share_cover: a track is covered when more than this part of its expected box is; between 0 and 1
        share_lost_s: tracks lost for longer get no share [s]; between 0 and 1000000
        min_relative_height: unexpected blobs lower than this part of what the scene's scale says are dropped [object heights]; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def __copy__(self) -> BlobOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> BlobOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        min_area_px: float = 0.0,
        min_area_fraction: float = 0.0001,
        max_blobs: int = 500,
        connectivity: str = "eight",
        merge: FragmentMergeOptions | CloseMergeOptions | NoMergeOptions = ...,
        share_blobs: bool = True,
        share_cover: float = 0.5,
        share_lost_s: float = 1.0,
        min_relative_height: float = 0.5,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> BlobOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def connectivity(self) -> str:
        """
        pixels of one region meet at an edge, or at a corner too
        """
    @connectivity.setter
    def connectivity(self, value: typing.Never) -> None: ...
    @property
    def max_blobs(self) -> int:
        """
        of more blobs in one frame the largest are kept
        """
    @max_blobs.setter
    def max_blobs(self, value: typing.Never) -> None: ...
    @property
    def merge(self) -> FragmentMergeOptions | CloseMergeOptions | NoMergeOptions:
        """
        which regions are one blob
        """
    @merge.setter
    def merge(self, value: typing.Never) -> None: ...
    @property
    def min_area_fraction(self) -> float:
        """
        the same, as a part of the frame's area; the larger counts
        """
    @min_area_fraction.setter
    def min_area_fraction(self, value: typing.Never) -> None: ...
    @property
    def min_area_px(self) -> float:
        """
        smaller blobs are dropped (S of Narayana 2007, 3.3) [px^2]
        """
    @min_area_px.setter
    def min_area_px(self, value: typing.Never) -> None: ...
    @property
    def min_relative_height(self) -> float:
        """
        unexpected blobs lower than this part of what the scene's scale says are dropped [object heights]
        """
    @min_relative_height.setter
    def min_relative_height(self, value: typing.Never) -> None: ...
    @property
    def share_blobs(self) -> bool:
        """
        divide a blob that covers several expected tracks among them
        """
    @share_blobs.setter
    def share_blobs(self, value: typing.Never) -> None: ...
    @property
    def share_cover(self) -> float:
        """
        a track is covered when more than this part of its expected box is
        """
    @share_cover.setter
    def share_cover(self, value: typing.Never) -> None: ...
    @property
    def share_lost_s(self) -> float:
        """
        tracks lost for longer get no share [s]
        """
    @share_lost_s.setter
    def share_lost_s(self, value: typing.Never) -> None: ...

class KalmanCvOptions:
    """
    Kalman filter, constant velocity.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        velocity_noise: standard deviation of the velocity gained or lost in one time unit (root of Q's density) [length/unit]; between 1e-06 and 1000000
        position_noise: standard deviation of a measured position (root of R) [length]; between 1e-06 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        lost_damping_time: the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kalman_cv"
    def __copy__(self) -> KalmanCvOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KalmanCvOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        velocity_noise: float = 0.75,
        position_noise: float = 0.06,
        initial_velocity: float = 1.0,
        lost_damping_time: float = 2.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KalmanCvOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def lost_damping_time(self) -> float:
        """
        the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]
        """
    @lost_damping_time.setter
    def lost_damping_time(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured position (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...
    @property
    def velocity_noise(self) -> float:
        """
        standard deviation of the velocity gained or lost in one time unit (root of Q's density) [length/unit]
        """
    @velocity_noise.setter
    def velocity_noise(self, value: typing.Never) -> None: ...

class KalmanCaOptions:
    """
    Kalman filter, constant acceleration.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        acceleration_noise: standard deviation of the acceleration gained or lost in one time unit (root of Q's density) [length/unit^2]; between 1e-06 and 1000000
        noise_form: how Q is made; identity: the square of acceleration_noise is the variance that each state gains in one time unit; one of "continuous" "identity"
        position_noise: standard deviation of a measured position (root of R) [length]; between 1e-06 and 1000000
        initial_position: standard deviation of a new track's position; 0: that of a measured one [length]; between 0 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        initial_acceleration: standard deviation of a new track's acceleration [length/unit^2]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kalman_ca"
    def __copy__(self) -> KalmanCaOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KalmanCaOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        acceleration_noise: float = 0.4,
        noise_form: str = "continuous",
        position_noise: float = 0.06,
        initial_position: float = 0.0,
        initial_velocity: float = 1.0,
        initial_acceleration: float = 0.5,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KalmanCaOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def acceleration_noise(self) -> float:
        """
        standard deviation of the acceleration gained or lost in one time unit (root of Q's density) [length/unit^2]
        """
    @acceleration_noise.setter
    def acceleration_noise(self, value: typing.Never) -> None: ...
    @property
    def initial_acceleration(self) -> float:
        """
        standard deviation of a new track's acceleration [length/unit^2]
        """
    @initial_acceleration.setter
    def initial_acceleration(self, value: typing.Never) -> None: ...
    @property
    def initial_position(self) -> float:
        """
        standard deviation of a new track's position; 0: that of a measured one [length]
        """
    @initial_position.setter
    def initial_position(self, value: typing.Never) -> None: ...
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def noise_form(self) -> str:
        """
        how Q is made; identity: the square of acceleration_noise is the variance that each state gains in one time unit
        """
    @noise_form.setter
    def noise_form(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured position (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...

class MeanVelocityOptions:
    """
    mean displacement over the last steps (Narayana 2007, 3.4).

    Args:
        window_steps: steps of the mean [steps]; between 1 and 1000
        extrapolate_lost: a lost track moves on with its velocity; published: it stays frozen
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "mean_velocity"
    def __copy__(self) -> MeanVelocityOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> MeanVelocityOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, window_steps: int = 5, extrapolate_lost: bool = False) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> MeanVelocityOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def extrapolate_lost(self) -> bool:
        """
        a lost track moves on with its velocity; published: it stays frozen
        """
    @extrapolate_lost.setter
    def extrapolate_lost(self, value: typing.Never) -> None: ...
    @property
    def window_steps(self) -> int:
        """
        steps of the mean [steps]
        """
    @window_steps.setter
    def window_steps(self, value: typing.Never) -> None: ...

class KalmanDiscreteOptions:
    """
    Kalman filter, constant velocity, with the covariances of one step as given.

    Args:
        process_variances: diagonal of Q for x, y, vx, vy: what a step adds to the variances [px^2, (px/unit)^2]; 4 numbers, each between 0 and 1000000000000
        measurement_covariance: R as xx, xy, yy [px^2]; 3 numbers, each between -1000000000000 and 1000000000000
        initial_variances: diagonal of a new filter's P [px^2, (px/unit)^2]; 4 numbers, each between 0 and 1000000000000
        control_input: B u, which a step adds to x, y, vx, vy [px, px/unit]; 4 numbers, each between -1000000 and 1000000
        step_time: time of the step that Q and B u are given for [unit]; between 1e-06 and 1000000
        start: where a new filter starts; frame_center needs the frame's size; one of "detection" "frame_center"
        covariances: whether R has to be a covariance; as_published takes any, to reproduce what is printed; one of "checked" "as_published"
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kalman_discrete"
    def __copy__(self) -> KalmanDiscreteOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KalmanDiscreteOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        process_variances: collections.abc.Sequence[float] = (1.0, 1.0, 400.0, 400.0),
        measurement_covariance: collections.abc.Sequence[float] = (4.0, 0.0, 4.0),
        initial_variances: collections.abc.Sequence[float] = (4.0, 4.0, 2500.0, 2500.0),
        control_input: collections.abc.Sequence[float] = (0.0, 0.0, 0.0, 0.0),
        step_time: float = 1.0,
        start: str = "detection",
        covariances: str = "checked",
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KalmanDiscreteOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def control_input(self) -> tuple[float, float, float, float]:
        """
        B u, which a step adds to x, y, vx, vy [px, px/unit]
        """
    @control_input.setter
    def control_input(self, value: typing.Never) -> None: ...
    @property
    def covariances(self) -> str:
        """
        whether R has to be a covariance; as_published takes any, to reproduce what is printed
        """
    @covariances.setter
    def covariances(self, value: typing.Never) -> None: ...
    @property
    def initial_variances(self) -> tuple[float, float, float, float]:
        """
        diagonal of a new filter's P [px^2, (px/unit)^2]
        """
    @initial_variances.setter
    def initial_variances(self, value: typing.Never) -> None: ...
    @property
    def measurement_covariance(self) -> tuple[float, float, float]:
        """
        R as xx, xy, yy [px^2]
        """
    @measurement_covariance.setter
    def measurement_covariance(self, value: typing.Never) -> None: ...
    @property
    def process_variances(self) -> tuple[float, float, float, float]:
        """
        diagonal of Q for x, y, vx, vy: what a step adds to the variances [px^2, (px/unit)^2]
        """
    @process_variances.setter
    def process_variances(self, value: typing.Never) -> None: ...
    @property
    def start(self) -> str:
        """
        where a new filter starts; frame_center needs the frame's size
        """
    @start.setter
    def start(self, value: typing.Never) -> None: ...
    @property
    def step_time(self) -> float:
        """
        time of the step that Q and B u are given for [unit]
        """
    @step_time.setter
    def step_time(self, value: typing.Never) -> None: ...

class KalmanBoxOptions:
    """
    Kalman filter over centre, width and height of the box, constant rates.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        velocity_noise: standard deviation of the velocity gained or lost in one time unit (root of Q's density) [length/unit]; between 1e-06 and 1000000
        position_noise: standard deviation of a measured centre (root of R) [length]; between 1e-06 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        size_rate_noise: the same as velocity_noise of width and height [length/unit]; between 1e-06 and 1000000
        size_noise: standard deviation of a measured width or height [length]; between 1e-06 and 1000000
        initial_size_rate: standard deviation of a new track's rates of width and height [length/unit]; between 0 and 1000000
        lost_damping_time: the rates of an unmatched track fall by 1/e in this time; 0: they do not fall [unit]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kalman_box"
    def __copy__(self) -> KalmanBoxOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KalmanBoxOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        velocity_noise: float = 0.75,
        position_noise: float = 0.06,
        initial_velocity: float = 1.0,
        size_rate_noise: float = 0.05,
        size_noise: float = 0.15,
        initial_size_rate: float = 0.1,
        lost_damping_time: float = 2.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KalmanBoxOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def initial_size_rate(self) -> float:
        """
        standard deviation of a new track's rates of width and height [length/unit]
        """
    @initial_size_rate.setter
    def initial_size_rate(self, value: typing.Never) -> None: ...
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def lost_damping_time(self) -> float:
        """
        the rates of an unmatched track fall by 1/e in this time; 0: they do not fall [unit]
        """
    @lost_damping_time.setter
    def lost_damping_time(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured centre (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...
    @property
    def size_noise(self) -> float:
        """
        standard deviation of a measured width or height [length]
        """
    @size_noise.setter
    def size_noise(self, value: typing.Never) -> None: ...
    @property
    def size_rate_noise(self) -> float:
        """
        the same as velocity_noise of width and height [length/unit]
        """
    @size_rate_noise.setter
    def size_rate_noise(self, value: typing.Never) -> None: ...
    @property
    def velocity_noise(self) -> float:
        """
        standard deviation of the velocity gained or lost in one time unit (root of Q's density) [length/unit]
        """
    @velocity_noise.setter
    def velocity_noise(self, value: typing.Never) -> None: ...

class KalmanPathOptions:
    """
    Kalman filter along and across the nearest path (O'Malley 2000).

    Args:
        process_variances: diagonal of Q for S, T, vS, vT: what a step adds to the variances [length^2, (length/unit)^2]; 4 numbers, each between 0 and 1000000000000
        measurement_variances: diagonal of R for S, T [length^2]; 2 numbers, each between 1e-12 and 1000000000000
        initial_variances: diagonal of a new filter's P [length^2, (length/unit)^2]; 4 numbers, each between 0 and 1000000000000
        initial_velocity: vS, vT of a new filter [length/unit]; 2 numbers, each between -1000000 and 1000000
        step_time: time of the step that Q is given for [unit]; between 1e-06 and 1000000
        unit_px: length that the others are measured in [px]; between 1e-06 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "kalman_path"
    def __copy__(self) -> KalmanPathOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> KalmanPathOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        process_variances: collections.abc.Sequence[float] = (1.0, 1.0, 400.0, 25.0),
        measurement_variances: collections.abc.Sequence[float] = (4.0, 4.0),
        initial_variances: collections.abc.Sequence[float] = (4.0, 4.0, 10000.0, 100.0),
        initial_velocity: collections.abc.Sequence[float] = (0.0, 0.0),
        step_time: float = 1.0,
        unit_px: float = 1.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> KalmanPathOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def initial_variances(self) -> tuple[float, float, float, float]:
        """
        diagonal of a new filter's P [length^2, (length/unit)^2]
        """
    @initial_variances.setter
    def initial_variances(self, value: typing.Never) -> None: ...
    @property
    def initial_velocity(self) -> tuple[float, float]:
        """
        vS, vT of a new filter [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def measurement_variances(self) -> tuple[float, float]:
        """
        diagonal of R for S, T [length^2]
        """
    @measurement_variances.setter
    def measurement_variances(self, value: typing.Never) -> None: ...
    @property
    def process_variances(self) -> tuple[float, float, float, float]:
        """
        diagonal of Q for S, T, vS, vT: what a step adds to the variances [length^2, (length/unit)^2]
        """
    @process_variances.setter
    def process_variances(self, value: typing.Never) -> None: ...
    @property
    def step_time(self) -> float:
        """
        time of the step that Q is given for [unit]
        """
    @step_time.setter
    def step_time(self, value: typing.Never) -> None: ...
    @property
    def unit_px(self) -> float:
        """
        length that the others are measured in [px]
        """
    @unit_px.setter
    def unit_px(self, value: typing.Never) -> None: ...

class ExtendedOptions:
    """
    extended Kalman filter, coordinated turn.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        velocity_noise: standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]; between 1e-06 and 1000000
        turn_rate: standard deviation of the turn rate [rad/unit]; between 1e-06 and 1000
        turn_time: the turn rate is forgotten to 1/e in this time [unit]; between 0.001 and 1000000
        position_noise: standard deviation of a measured position (root of R) [length]; between 1e-06 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        lost_damping_time: the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "extended"
    def __copy__(self) -> ExtendedOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> ExtendedOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        velocity_noise: float = 0.75,
        turn_rate: float = 0.5,
        turn_time: float = 1.0,
        position_noise: float = 0.06,
        initial_velocity: float = 1.0,
        lost_damping_time: float = 2.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> ExtendedOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def lost_damping_time(self) -> float:
        """
        the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]
        """
    @lost_damping_time.setter
    def lost_damping_time(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured position (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...
    @property
    def turn_rate(self) -> float:
        """
        standard deviation of the turn rate [rad/unit]
        """
    @turn_rate.setter
    def turn_rate(self, value: typing.Never) -> None: ...
    @property
    def turn_time(self) -> float:
        """
        the turn rate is forgotten to 1/e in this time [unit]
        """
    @turn_time.setter
    def turn_time(self, value: typing.Never) -> None: ...
    @property
    def velocity_noise(self) -> float:
        """
        standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]
        """
    @velocity_noise.setter
    def velocity_noise(self, value: typing.Never) -> None: ...

class UnscentedOptions:
    """
    unscented Kalman filter, coordinated turn.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        velocity_noise: standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]; between 1e-06 and 1000000
        turn_rate: standard deviation of the turn rate [rad/unit]; between 1e-06 and 1000
        turn_time: the turn rate is forgotten to 1/e in this time [unit]; between 0.001 and 1000000
        position_noise: standard deviation of a measured position (root of R) [length]; between 1e-06 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        lost_damping_time: the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]; between 0 and 1000000
        alpha: spread of the sigma points; between 0.001 and 1
        beta: weight of the middle one in covariances; 2 is that of a Gaussian; between 1 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "unscented"
    def __copy__(self) -> UnscentedOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> UnscentedOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        velocity_noise: float = 0.75,
        turn_rate: float = 0.5,
        turn_time: float = 1.0,
        position_noise: float = 0.06,
        initial_velocity: float = 1.0,
        lost_damping_time: float = 2.0,
        alpha: float = 0.5,
        beta: float = 2.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> UnscentedOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def alpha(self) -> float:
        """
        spread of the sigma points
        """
    @alpha.setter
    def alpha(self, value: typing.Never) -> None: ...
    @property
    def beta(self) -> float:
        """
        weight of the middle one in covariances; 2 is that of a Gaussian
        """
    @beta.setter
    def beta(self, value: typing.Never) -> None: ...
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def lost_damping_time(self) -> float:
        """
        the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]
        """
    @lost_damping_time.setter
    def lost_damping_time(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured position (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...
    @property
    def turn_rate(self) -> float:
        """
        standard deviation of the turn rate [rad/unit]
        """
    @turn_rate.setter
    def turn_rate(self, value: typing.Never) -> None: ...
    @property
    def turn_time(self) -> float:
        """
        the turn rate is forgotten to 1/e in this time [unit]
        """
    @turn_time.setter
    def turn_time(self, value: typing.Never) -> None: ...
    @property
    def velocity_noise(self) -> float:
        """
        standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]
        """
    @velocity_noise.setter
    def velocity_noise(self, value: typing.Never) -> None: ...

class ParticleOptions:
    """
    particle filter, coordinated turn.

    Args:
        noise_unit: the length that noises are measured in; one of "object_size" "px"
        velocity_noise: standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]; between 1e-06 and 1000000
        turn_rate: standard deviation of the turn rate [rad/unit]; between 1e-06 and 1000
        turn_time: the turn rate is forgotten to 1/e in this time [unit]; between 0.001 and 1000000
        position_noise: standard deviation of a measured position (root of R) [length]; between 1e-06 and 1000000
        initial_velocity: standard deviation of a new track's velocity [length/unit]; between 0 and 1000000
        lost_damping_time: the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]; between 0 and 1000000
        particles: of each track [particles]; between 1 and 100000
        resample_below: drawn anew when the effective sample size falls under this share of them; 0: never; between 0 and 1
        seed: of the random numbers; each track has its own, by its turn of birth; between 0 and 2147483647
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "particle"
    def __copy__(self) -> ParticleOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> ParticleOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        noise_unit: str = "object_size",
        velocity_noise: float = 0.75,
        turn_rate: float = 0.5,
        turn_time: float = 1.0,
        position_noise: float = 0.06,
        initial_velocity: float = 1.0,
        lost_damping_time: float = 2.0,
        particles: int = 100,
        resample_below: float = 0.5,
        seed: int = 0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> ParticleOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def initial_velocity(self) -> float:
        """
        standard deviation of a new track's velocity [length/unit]
        """
    @initial_velocity.setter
    def initial_velocity(self, value: typing.Never) -> None: ...
    @property
    def lost_damping_time(self) -> float:
        """
        the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall [unit]
        """
    @lost_damping_time.setter
    def lost_damping_time(self, value: typing.Never) -> None: ...
    @property
    def noise_unit(self) -> str:
        """
        the length that noises are measured in
        """
    @noise_unit.setter
    def noise_unit(self, value: typing.Never) -> None: ...
    @property
    def particles(self) -> int:
        """
        of each track [particles]
        """
    @particles.setter
    def particles(self, value: typing.Never) -> None: ...
    @property
    def position_noise(self) -> float:
        """
        standard deviation of a measured position (root of R) [length]
        """
    @position_noise.setter
    def position_noise(self, value: typing.Never) -> None: ...
    @property
    def resample_below(self) -> float:
        """
        drawn anew when the effective sample size falls under this share of them; 0: never
        """
    @resample_below.setter
    def resample_below(self, value: typing.Never) -> None: ...
    @property
    def seed(self) -> int:
        """
        of the random numbers; each track has its own, by its turn of birth
        """
    @seed.setter
    def seed(self, value: typing.Never) -> None: ...
    @property
    def turn_rate(self) -> float:
        """
        standard deviation of the turn rate [rad/unit]
        """
    @turn_rate.setter
    def turn_rate(self, value: typing.Never) -> None: ...
    @property
    def turn_time(self) -> float:
        """
        the turn rate is forgotten to 1/e in this time [unit]
        """
    @turn_time.setter
    def turn_time(self, value: typing.Never) -> None: ...
    @property
    def velocity_noise(self) -> float:
        """
        standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density) [length/unit]
        """
    @velocity_noise.setter
    def velocity_noise(self, value: typing.Never) -> None: ...

class BoxCenterOptions:
    """
    the centre of the box; its size is a running mean, hidden edges are inferred.

    Args:
        size_time_s: time constant of the mean of width and height [s]; above 0 and at most 1000000
        shared_size_gain: weight of a share's size in that mean; between 0 and 1
        hidden_below: a share's side that is shorter than this part of the track's is partly hidden; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "box_center"
    def __copy__(self) -> BoxCenterOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> BoxCenterOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        size_time_s: float = 0.5,
        shared_size_gain: float = 0.25,
        hidden_below: float = 0.85,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> BoxCenterOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def hidden_below(self) -> float:
        """
        a share's side that is shorter than this part of the track's is partly hidden
        """
    @hidden_below.setter
    def hidden_below(self, value: typing.Never) -> None: ...
    @property
    def shared_size_gain(self) -> float:
        """
        weight of a share's size in that mean
        """
    @shared_size_gain.setter
    def shared_size_gain(self, value: typing.Never) -> None: ...
    @property
    def size_time_s(self) -> float:
        """
        time constant of the mean of width and height [s]
        """
    @size_time_s.setter
    def size_time_s(self, value: typing.Never) -> None: ...

class CentroidOptions:
    """
    the centroid of the blob; its box as it is (Narayana 2007, 3.4).

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "centroid"
    def __copy__(self) -> CentroidOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> CentroidOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> CentroidOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class GaussianCostOptions:
    """
    log likelihood of the innovation, from the predicted position.

    Args:
        gate: largest squared Mahalanobis distance; 9.21 holds 99 % of the true pairs; above 0 and at most 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "gaussian"
    def __copy__(self) -> GaussianCostOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> GaussianCostOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, gate: float = 9.21) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> GaussianCostOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def gate(self) -> float:
        """
        largest squared Mahalanobis distance; 9.21 holds 99 % of the true pairs
        """
    @gate.setter
    def gate(self, value: typing.Never) -> None: ...

class MatchMatrixOptions:
    """
    distance in the frame plus distance in colour, from the last position (Narayana 2007, eq. 3.6).

    Args:
        max_match: pairs of a larger value are refused; 0: none is; between 0 and 1000000
        velocity_break_point: difference in velocity from which the velocity factor is 5 (4.2); 0: no such factor [px/unit]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "match_matrix"
    def __copy__(self) -> MatchMatrixOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> MatchMatrixOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, max_match: float = 0.0, velocity_break_point: float = 0.0) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> MatchMatrixOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def max_match(self) -> float:
        """
        pairs of a larger value are refused; 0: none is
        """
    @max_match.setter
    def max_match(self, value: typing.Never) -> None: ...
    @property
    def velocity_break_point(self) -> float:
        """
        difference in velocity from which the velocity factor is 5 (4.2); 0: no such factor [px/unit]
        """
    @velocity_break_point.setter
    def velocity_break_point(self, value: typing.Never) -> None: ...

class BeliefOptions:
    """
    probability that a track is each of the blobs, or lost, from colour, position, velocity (Narayana 2007, 8).

    Args:
        order: whether the order of the blobs matters, as published, or not; one of "free" "published"
        velocity_break_point: difference in velocity from which the velocity factor is 0.2 (8.3.4); 0: no such factor [px/unit]; between 0 and 1000000
        color_weight: Cf: the densities of colour have the peak Cf / 30; 0: colour is not looked at; between 0 and 3000
        position_weight: Pf: the densities of position have the peak Pf / 30; 0: position is not looked at; between 0 and 3000
        size_weight: the same for the logarithm of the size; 0: size is not looked at; between 0 and 3000
        color_space: what colours are compared in; one of "bgr" "hsv" "lab"
        learn_after: the densities are learned from matches, and used from so many on; 0: those of the beginning stay [matches]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "belief"
    def __copy__(self) -> BeliefOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> BeliefOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        order: str = "free",
        velocity_break_point: float = 0.0,
        color_weight: float = 30.0,
        position_weight: float = 30.0,
        size_weight: float = 0.0,
        color_space: str = "bgr",
        learn_after: int = 200,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> BeliefOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def color_space(self) -> str:
        """
        what colours are compared in
        """
    @color_space.setter
    def color_space(self, value: typing.Never) -> None: ...
    @property
    def color_weight(self) -> float:
        """
        Cf: the densities of colour have the peak Cf / 30; 0: colour is not looked at
        """
    @color_weight.setter
    def color_weight(self, value: typing.Never) -> None: ...
    @property
    def learn_after(self) -> int:
        """
        the densities are learned from matches, and used from so many on; 0: those of the beginning stay [matches]
        """
    @learn_after.setter
    def learn_after(self, value: typing.Never) -> None: ...
    @property
    def order(self) -> str:
        """
        whether the order of the blobs matters, as published, or not
        """
    @order.setter
    def order(self, value: typing.Never) -> None: ...
    @property
    def position_weight(self) -> float:
        """
        Pf: the densities of position have the peak Pf / 30; 0: position is not looked at
        """
    @position_weight.setter
    def position_weight(self, value: typing.Never) -> None: ...
    @property
    def size_weight(self) -> float:
        """
        the same for the logarithm of the size; 0: size is not looked at
        """
    @size_weight.setter
    def size_weight(self, value: typing.Never) -> None: ...
    @property
    def velocity_break_point(self) -> float:
        """
        difference in velocity from which the velocity factor is 0.2 (8.3.4); 0: no such factor [px/unit]
        """
    @velocity_break_point.setter
    def velocity_break_point(self, value: typing.Never) -> None: ...

class DistanceOptions:
    """
    distance from the predicted position (Semko 2007).

    Args:
        max_distance_px: pairs further apart are refused; 0: none is [px]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "distance"
    def __copy__(self) -> DistanceOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> DistanceOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, max_distance_px: float = 0.0) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> DistanceOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def max_distance_px(self) -> float:
        """
        pairs further apart are refused; 0: none is [px]
        """
    @max_distance_px.setter
    def max_distance_px(self, value: typing.Never) -> None: ...

class NoAppearanceOptions:
    """
    nothing beside the cost.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoAppearanceOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoAppearanceOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoAppearanceOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class ColorHistogramOptions:
    """
    intersection with the track's colour histogram (Swain and Ballard 1991).

    Args:
        weight: what a pair without a colour in common costs more, in the cost's own unit; between 0 and 1000000
        refresh_rate: how far the track's histogram moves to that of its detection; 0: it stays the first; between 0 and 1
        min_intersection: pairs that intersect less are refused; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "color_histogram"
    def __copy__(self) -> ColorHistogramOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> ColorHistogramOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self, *, weight: float = 4.0, refresh_rate: float = 0.1, min_intersection: float = 0.0
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> ColorHistogramOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def min_intersection(self) -> float:
        """
        pairs that intersect less are refused
        """
    @min_intersection.setter
    def min_intersection(self, value: typing.Never) -> None: ...
    @property
    def refresh_rate(self) -> float:
        """
        how far the track's histogram moves to that of its detection; 0: it stays the first
        """
    @refresh_rate.setter
    def refresh_rate(self, value: typing.Never) -> None: ...
    @property
    def weight(self) -> float:
        """
        what a pair without a colour in common costs more, in the cost's own unit
        """
    @weight.setter
    def weight(self, value: typing.Never) -> None: ...

class HungarianOptions:
    """
    optimal one-to-one assignment (Kuhn 1955).

    Args:
        confirmed_first: tentative tracks get only what believed ones leave
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "hungarian"
    def __copy__(self) -> HungarianOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> HungarianOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, confirmed_first: bool = True) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> HungarianOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def confirmed_first(self) -> bool:
        """
        tentative tracks get only what believed ones leave
        """
    @confirmed_first.setter
    def confirmed_first(self, value: typing.Never) -> None: ...

class OldestFirstOptions:
    """
    tracks in order of age, each takes its best (Narayana 2007, 3.5.4).

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "oldest_first"
    def __copy__(self) -> OldestFirstOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> OldestFirstOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> OldestFirstOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class RowOrderOptions:
    """
    as many detections as tracks: from top to bottom, in order of age; else the optimal one (Semko 2007).

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "row_order"
    def __copy__(self) -> RowOrderOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> RowOrderOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> RowOrderOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class LargestOptions:
    """
    tracks in order of age, each takes the largest detection that its cost does not refuse (Nashenda 2011).

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "largest"
    def __copy__(self) -> LargestOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> LargestOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> LargestOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class ConfirmAndLoseOptions:
    """
    confirmed after some matches, predicted while lost, closed after a time.

    Args:
        confirm_matches: matches in a row before a track is believed [frames]; between 1 and 1000000
        confirm_s: age before a track is believed [s]; between 0 and 1000000
        confirm_travel: distance from its first place before a track is believed; what does not travel is no object [object sizes]; between 0 and 1000000
        report_lost_s: a lost track is reported, at its prediction, for so long [s]; between 0 and 1000000
        max_lost_s: a track lost for longer is closed [s]; between 0 and 1000000
        birth_overlap: a detection that lies in a matched track's box by more than this part of its area starts no track; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "confirm_and_lose"
    def __copy__(self) -> ConfirmAndLoseOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> ConfirmAndLoseOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        confirm_matches: int = 3,
        confirm_s: float = 0.4,
        confirm_travel: float = 0.3,
        report_lost_s: float = 0.5,
        max_lost_s: float = 2.5,
        birth_overlap: float = 0.5,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> ConfirmAndLoseOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def birth_overlap(self) -> float:
        """
        a detection that lies in a matched track's box by more than this part of its area starts no track
        """
    @birth_overlap.setter
    def birth_overlap(self, value: typing.Never) -> None: ...
    @property
    def confirm_matches(self) -> int:
        """
        matches in a row before a track is believed [frames]
        """
    @confirm_matches.setter
    def confirm_matches(self, value: typing.Never) -> None: ...
    @property
    def confirm_s(self) -> float:
        """
        age before a track is believed [s]
        """
    @confirm_s.setter
    def confirm_s(self, value: typing.Never) -> None: ...
    @property
    def confirm_travel(self) -> float:
        """
        distance from its first place before a track is believed; what does not travel is no object [object sizes]
        """
    @confirm_travel.setter
    def confirm_travel(self, value: typing.Never) -> None: ...
    @property
    def max_lost_s(self) -> float:
        """
        a track lost for longer is closed [s]
        """
    @max_lost_s.setter
    def max_lost_s(self, value: typing.Never) -> None: ...
    @property
    def report_lost_s(self) -> float:
        """
        a lost track is reported, at its prediction, for so long [s]
        """
    @report_lost_s.setter
    def report_lost_s(self, value: typing.Never) -> None: ...

class LostCountOptions:
    """
    a track a blob at once; deleted after more than L misses (Narayana 2007, 3.5.4).

    Args:
        lost_after_frames: L: the next miss in a row closes a track [frames]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "lost_count"
    def __copy__(self) -> LostCountOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> LostCountOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, lost_after_frames: int = 5) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> LostCountOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def lost_after_frames(self) -> int:
        """
        L: the next miss in a row closes a track [frames]
        """
    @lost_after_frames.setter
    def lost_after_frames(self, value: typing.Never) -> None: ...

class CountMedianOptions:
    """
    as many tracks as the running median of the detections' count (Semko 2007, IV.C.2).

    Args:
        median_frames: length of the median of the count; 0 and 1: the count itself [frames]; between 0 and 99999, 0 or odd
        max_contacts: most tracks at a time; between 1 and 100000
        keep_contacts: a missing contact is predicted for ever, and the next newcomer is taken for it (Suliman et al. 2010)
        restart_after_s: a kept contact that was missing for longer starts anew where it is seen; 0: it never does [s]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "count_median"
    def __copy__(self) -> CountMedianOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> CountMedianOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        median_frames: int = 25,
        max_contacts: int = 10,
        keep_contacts: bool = False,
        restart_after_s: float = 0.0,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> CountMedianOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def keep_contacts(self) -> bool:
        """
        a missing contact is predicted for ever, and the next newcomer is taken for it (Suliman et al. 2010)
        """
    @keep_contacts.setter
    def keep_contacts(self, value: typing.Never) -> None: ...
    @property
    def max_contacts(self) -> int:
        """
        most tracks at a time
        """
    @max_contacts.setter
    def max_contacts(self, value: typing.Never) -> None: ...
    @property
    def median_frames(self) -> int:
        """
        length of the median of the count; 0 and 1: the count itself [frames]
        """
    @median_frames.setter
    def median_frames(self, value: typing.Never) -> None: ...
    @property
    def restart_after_s(self) -> float:
        """
        a kept contact that was missing for longer starts anew where it is seen; 0: it never does [s]
        """
    @restart_after_s.setter
    def restart_after_s(self, value: typing.Never) -> None: ...

class RegionGrowthOptions:
    """
    followed from an acquisition region on; predicted while not found, up to a limit (O'Malley 2000).

    Args:
        lost_after_frames: the next miss in a row closes a track [frames]; between 0 and 1000000
        max_objects: most tracks at a time; between 1 and 100000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "region_growth"
    def __copy__(self) -> RegionGrowthOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> RegionGrowthOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, lost_after_frames: int = 15, max_objects: int = 100) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> RegionGrowthOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def lost_after_frames(self) -> int:
        """
        the next miss in a row closes a track [frames]
        """
    @lost_after_frames.setter
    def lost_after_frames(self, value: typing.Never) -> None: ...
    @property
    def max_objects(self) -> int:
        """
        most tracks at a time
        """
    @max_objects.setter
    def max_objects(self, value: typing.Never) -> None: ...

class SingleLargestOptions:
    """
    one track at a time, started by the largest detection (Nashenda 2011).

    Args:
        lost_after_frames: the next miss in a row closes the track; 0: it is predicted for ever [frames]; between 0 and 1000000
        restart_after_frames: a track that missed more starts anew where it is seen; 0: it never does [frames]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "single_largest"
    def __copy__(self) -> SingleLargestOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> SingleLargestOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self, *, lost_after_frames: int = 0, restart_after_frames: int = 0) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> SingleLargestOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def lost_after_frames(self) -> int:
        """
        the next miss in a row closes the track; 0: it is predicted for ever [frames]
        """
    @lost_after_frames.setter
    def lost_after_frames(self, value: typing.Never) -> None: ...
    @property
    def restart_after_frames(self) -> int:
        """
        a track that missed more starts anew where it is seen; 0: it never does [frames]
        """
    @restart_after_frames.setter
    def restart_after_frames(self, value: typing.Never) -> None: ...

class NoGroupsOptions:
    """
    of tracks that merge into one blob one has it, the others are lost.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoGroupsOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoGroupsOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoGroupsOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class SharedBlobOptions:
    """
    tracks that merge into one blob are a group until it divides.

    Args:
        min_cover: a track without a detection joins the one in whose detection more than this part of its predicted box lies; between 0 and 1
        join_s: only a track that was seen so shortly before, or in the frame before, joins [s]; between 0 and 1000000
        max_s: a track that is not seen by itself for longer is lost [s]; between 0 and 1000000
        color_deviation: when the blob divides: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); 0: colour does not count; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "shared_blob"
    def __copy__(self) -> SharedBlobOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> SharedBlobOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        min_cover: float = 0.5,
        join_s: float = 0.2,
        max_s: float = 10.0,
        color_deviation: float = 0.1,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> SharedBlobOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def color_deviation(self) -> float:
        """
        when the blob divides: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); 0: colour does not count
        """
    @color_deviation.setter
    def color_deviation(self, value: typing.Never) -> None: ...
    @property
    def join_s(self) -> float:
        """
        only a track that was seen so shortly before, or in the frame before, joins [s]
        """
    @join_s.setter
    def join_s(self, value: typing.Never) -> None: ...
    @property
    def max_s(self) -> float:
        """
        a track that is not seen by itself for longer is lost [s]
        """
    @max_s.setter
    def max_s(self, value: typing.Never) -> None: ...
    @property
    def min_cover(self) -> float:
        """
        a track without a detection joins the one in whose detection more than this part of its predicted box lies
        """
    @min_cover.setter
    def min_cover(self, value: typing.Never) -> None: ...

class NoReentryOptions:
    """
    who comes back is someone new.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoReentryOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoReentryOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoReentryOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class RememberOptions:
    """
    who comes back where a track ended, and looks the same, is that track.

    Args:
        max_away_s: a track that ended longer ago is forgotten [s]; between 0 and 1000000
        away_time_s: T: the weight of a track falls by 1/e in this time [s]; above 0 and at most 1000000
        place_deviation: s_d: standard deviation of the place, about the one where the track was seen last or would be by its velocity [object sizes]; above 0 and at most 1000000
        color_deviation: s_c: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); 0: colour does not count; between 0 and 1000000
        newcomer_weight: weight of being someone new; above 0 and at most 1000000
        min_confidence: an identity is given again from this confidence on; between 0 and 1
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "remember"
    def __copy__(self) -> RememberOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> RememberOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        max_away_s: float = 60.0,
        away_time_s: float = 30.0,
        place_deviation: float = 1.5,
        color_deviation: float = 0.05,
        newcomer_weight: float = 0.2,
        min_confidence: float = 0.6,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> RememberOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def away_time_s(self) -> float:
        """
        T: the weight of a track falls by 1/e in this time [s]
        """
    @away_time_s.setter
    def away_time_s(self, value: typing.Never) -> None: ...
    @property
    def color_deviation(self) -> float:
        """
        s_c: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); 0: colour does not count
        """
    @color_deviation.setter
    def color_deviation(self, value: typing.Never) -> None: ...
    @property
    def max_away_s(self) -> float:
        """
        a track that ended longer ago is forgotten [s]
        """
    @max_away_s.setter
    def max_away_s(self, value: typing.Never) -> None: ...
    @property
    def min_confidence(self) -> float:
        """
        an identity is given again from this confidence on
        """
    @min_confidence.setter
    def min_confidence(self, value: typing.Never) -> None: ...
    @property
    def newcomer_weight(self) -> float:
        """
        weight of being someone new
        """
    @newcomer_weight.setter
    def newcomer_weight(self, value: typing.Never) -> None: ...
    @property
    def place_deviation(self) -> float:
        """
        s_d: standard deviation of the place, about the one where the track was seen last or would be by its velocity [object sizes]
        """
    @place_deviation.setter
    def place_deviation(self, value: typing.Never) -> None: ...

class NoVicinityOptions:
    """
    no vicinity factor.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoVicinityOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoVicinityOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoVicinityOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class GridVicinityOptions:
    """
    how much things move in each cell of the scene (Narayana 2007, 6).

    Args:
        form: how the factor follows a displacement; one of "settling" "published_constant" "published_mean"
        cell_px: side of a cell; no larger than the frame [px]; between 1 and 100000
        max_factor: the largest factor; the smallest is 1, the first (1 + largest) / 2; between 1 and 1000
        learning_rate: alpha: how fast a factor follows; above 0 and at most 1
        anomaly_deviations: a track faster or slower by more than those before it in its cell is anomalous; 0: none is [standard deviations]; between 0 and 1000000
        anomaly_after_updates: a cell that saw fewer calls nothing anomalous [updates]; between 2 and 1000000000
        anomaly_frames: so many in a row raise the event anomalous_speed [frames]; between 1 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "grid"
    def __copy__(self) -> GridVicinityOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> GridVicinityOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        form: str = "settling",
        cell_px: int = 30,
        max_factor: float = 5.0,
        learning_rate: float = 0.1,
        anomaly_deviations: float = 4.0,
        anomaly_after_updates: int = 50,
        anomaly_frames: int = 3,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> GridVicinityOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def anomaly_after_updates(self) -> int:
        """
        a cell that saw fewer calls nothing anomalous [updates]
        """
    @anomaly_after_updates.setter
    def anomaly_after_updates(self, value: typing.Never) -> None: ...
    @property
    def anomaly_deviations(self) -> float:
        """
        a track faster or slower by more than those before it in its cell is anomalous; 0: none is [standard deviations]
        """
    @anomaly_deviations.setter
    def anomaly_deviations(self, value: typing.Never) -> None: ...
    @property
    def anomaly_frames(self) -> int:
        """
        so many in a row raise the event anomalous_speed [frames]
        """
    @anomaly_frames.setter
    def anomaly_frames(self, value: typing.Never) -> None: ...
    @property
    def cell_px(self) -> int:
        """
        side of a cell; no larger than the frame [px]
        """
    @cell_px.setter
    def cell_px(self, value: typing.Never) -> None: ...
    @property
    def form(self) -> str:
        """
        how the factor follows a displacement
        """
    @form.setter
    def form(self, value: typing.Never) -> None: ...
    @property
    def learning_rate(self) -> float:
        """
        alpha: how fast a factor follows
        """
    @learning_rate.setter
    def learning_rate(self, value: typing.Never) -> None: ...
    @property
    def max_factor(self) -> float:
        """
        the largest factor; the smallest is 1, the first (1 + largest) / 2
        """
    @max_factor.setter
    def max_factor(self, value: typing.Never) -> None: ...

class NoRegionsOptions:
    """
    every frame is read whole.

    Args:
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "none"
    def __copy__(self) -> NoRegionsOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> NoRegionsOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(self) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> NoRegionsOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """

class PredictedRegionsOptions:
    """
    only where tracks are expected, and newcomers (O'Malley 2000).

    Args:
        sigmas_along: reach of a region beyond the predicted position, along the way of the track [standard deviations]; between 0 and 100
        sigmas_across: the same across it, to both sides [standard deviations]; between 0 and 100
        forward_only: along its way a region begins where the track was, not before the prediction (O'Malley 2000)
        whole_object: a region holds the whole box wherever in it the position is; if not, each side is the box's longer one at least (O'Malley 2000)
        margin: added on every side [longer sides of the box]; between 0 and 100
        growth: added on every side for each second that a track is lost [longer sides of the box/s]; between 0 and 100
        acquisition: where newcomers are looked for; one of "border" "zones" "strip"
        border: width of the band along the border, with acquisition border [frame heights]; above 0 and at most 1
        refresh_frames: a strip a frame is read in turn, so that each place is seen once in so many; 0: none is [frames]; between 0 and 100000
        whole_above: a frame is read whole where its regions would cost more than this part of what the whole frame costs: a pixel each, and 64 more for every piece of a row, as selective takes; between 0 and 100
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    model: typing.ClassVar[str] = "predicted"
    def __copy__(self) -> PredictedRegionsOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> PredictedRegionsOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        sigmas_along: float = 3.0,
        sigmas_across: float = 3.0,
        forward_only: bool = False,
        whole_object: bool = True,
        margin: float = 0.2,
        growth: float = 1.5,
        acquisition: str = "strip",
        border: float = 0.05,
        refresh_frames: int = 10,
        whole_above: float = 0.9,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> PredictedRegionsOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def acquisition(self) -> str:
        """
        where newcomers are looked for
        """
    @acquisition.setter
    def acquisition(self, value: typing.Never) -> None: ...
    @property
    def border(self) -> float:
        """
        width of the band along the border, with acquisition border [frame heights]
        """
    @border.setter
    def border(self, value: typing.Never) -> None: ...
    @property
    def forward_only(self) -> bool:
        """
        along its way a region begins where the track was, not before the prediction (O'Malley 2000)
        """
    @forward_only.setter
    def forward_only(self, value: typing.Never) -> None: ...
    @property
    def growth(self) -> float:
        """
        added on every side for each second that a track is lost [longer sides of the box/s]
        """
    @growth.setter
    def growth(self, value: typing.Never) -> None: ...
    @property
    def margin(self) -> float:
        """
        added on every side [longer sides of the box]
        """
    @margin.setter
    def margin(self, value: typing.Never) -> None: ...
    @property
    def refresh_frames(self) -> int:
        """
        a strip a frame is read in turn, so that each place is seen once in so many; 0: none is [frames]
        """
    @refresh_frames.setter
    def refresh_frames(self, value: typing.Never) -> None: ...
    @property
    def sigmas_across(self) -> float:
        """
        the same across it, to both sides [standard deviations]
        """
    @sigmas_across.setter
    def sigmas_across(self, value: typing.Never) -> None: ...
    @property
    def sigmas_along(self) -> float:
        """
        reach of a region beyond the predicted position, along the way of the track [standard deviations]
        """
    @sigmas_along.setter
    def sigmas_along(self, value: typing.Never) -> None: ...
    @property
    def whole_above(self) -> float:
        """
        a frame is read whole where its regions would cost more than this part of what the whole frame costs: a pixel each, and 64 more for every piece of a row, as selective takes
        """
    @whole_above.setter
    def whole_above(self, value: typing.Never) -> None: ...
    @property
    def whole_object(self) -> bool:
        """
        a region holds the whole box wherever in it the position is; if not, each side is the box's longer one at least (O'Malley 2000)
        """
    @whole_object.setter
    def whole_object(self, value: typing.Never) -> None: ...

class OutputOptions:
    """
    Extras of a result that cost something.

    Args:
        background: the background picture of every frame
        contours: the outer contour of every blob
        cost_matrix: the whole matrix of costs, tracks by detections, and that of beliefs; at most a million entries
        vicinity: the vicinity grids, with vicinity.model grid
        flow: the flow field of every frame, with segmenter.model horn_schunck
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def __copy__(self) -> OutputOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> OutputOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        background: bool = False,
        contours: bool = False,
        cost_matrix: bool = False,
        vicinity: bool = False,
        flow: bool = False,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> OutputOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def background(self) -> bool:
        """
        the background picture of every frame
        """
    @background.setter
    def background(self, value: typing.Never) -> None: ...
    @property
    def contours(self) -> bool:
        """
        the outer contour of every blob
        """
    @contours.setter
    def contours(self, value: typing.Never) -> None: ...
    @property
    def cost_matrix(self) -> bool:
        """
        the whole matrix of costs, tracks by detections, and that of beliefs; at most a million entries
        """
    @cost_matrix.setter
    def cost_matrix(self, value: typing.Never) -> None: ...
    @property
    def flow(self) -> bool:
        """
        the flow field of every frame, with segmenter.model horn_schunck
        """
    @flow.setter
    def flow(self, value: typing.Never) -> None: ...
    @property
    def vicinity(self) -> bool:
        """
        the vicinity grids, with vicinity.model grid
        """
    @vicinity.setter
    def vicinity(self, value: typing.Never) -> None: ...

class Config:
    """
    All options of a pipeline; the defaults are the preset "survtrack".

    Args:
        time_unit_s: the filters' unit of time; published presets: the nominal frame period [s]; between 1e-06 and 3600
        scene_change: what is done when the whole scene changes
        segmenter: frame to foreground mask
        cleanup: noise removal on the mask
        blobs: mask to detections
        filter: how tracks move
        measurement: what of a detection a track follows
        cost: how well a detection fits a track
        appearance: what else makes a detection fit a track
        assignment: who gets which detection
        lifecycle: when tracks are born, believed, lost and closed
        groups: tracks that merge into one blob
        reentry: tracks that ended and come back
        vicinity: what the scene teaches about sizes and speeds
        regions: which parts of a frame are read
        outputs: extras of a result that cost something
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    @staticmethod
    def from_json(text: str, source: str = "config") -> Config:
        """
        Reads options from JSON on top of the defaults; `source` names the text in errors.
        """
    @staticmethod
    def from_toml(text: str, source: str = "config") -> Config:
        """
        Reads options from TOML on top of the defaults; `source` names the text in errors.
        """
    def __copy__(self) -> Config: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> Config: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        time_unit_s: float = 1.0,
        scene_change: NoSceneChangeOptions | GuardOptions = ...,
        segmenter: SelectiveOptions
        | MovingAverageOptions
        | HornSchunckOptions
        | Mog2Options
        | KnnOptions
        | StaticReferenceOptions
        | NormalizedDifferenceOptions = ...,
        cleanup: CleanupOptions = ...,
        blobs: BlobOptions = ...,
        filter: KalmanCvOptions
        | KalmanCaOptions
        | MeanVelocityOptions
        | KalmanDiscreteOptions
        | KalmanBoxOptions
        | KalmanPathOptions
        | ExtendedOptions
        | UnscentedOptions
        | ParticleOptions = ...,
        measurement: BoxCenterOptions | CentroidOptions = ...,
        cost: GaussianCostOptions | MatchMatrixOptions | BeliefOptions | DistanceOptions = ...,
        appearance: NoAppearanceOptions | ColorHistogramOptions = ...,
        assignment: HungarianOptions | OldestFirstOptions | RowOrderOptions | LargestOptions = ...,
        lifecycle: ConfirmAndLoseOptions
        | LostCountOptions
        | CountMedianOptions
        | RegionGrowthOptions
        | SingleLargestOptions = ...,
        groups: NoGroupsOptions | SharedBlobOptions = ...,
        reentry: NoReentryOptions | RememberOptions = ...,
        vicinity: NoVicinityOptions | GridVicinityOptions = ...,
        regions: NoRegionsOptions | PredictedRegionsOptions = ...,
        outputs: OutputOptions = ...,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def check(self) -> None:
        """
        Raises ConfigError unless all bounds and the rules between sections hold.
        """
    def replace(self, **options: typing.Any) -> Config:
        """
        A copy with some options changed.
        """
    def set(self, option_and_value: str) -> None:
        """
        Sets one option, as in set("filter.model=kalman_ca"). Choosing a model resets its options.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    def to_json(self) -> str:
        """
        All options as JSON.
        """
    def to_toml(self) -> str:
        """
        All options as a TOML file, each with its unit and meaning.
        """
    def update_from_json(self, text: str, source: str = "config") -> None:
        """
        Reads options from JSON on top of the present ones; an error leaves the config as it was.
        """
    def update_from_toml(self, text: str, source: str = "config") -> None:
        """
        Reads options from TOML on top of the present ones; an error leaves the config as it was.
        """
    @property
    def appearance(self) -> NoAppearanceOptions | ColorHistogramOptions:
        """
        what else makes a detection fit a track
        """
    @appearance.setter
    def appearance(self, value: NoAppearanceOptions | ColorHistogramOptions) -> None: ...
    @property
    def assignment(
        self,
    ) -> HungarianOptions | OldestFirstOptions | RowOrderOptions | LargestOptions:
        """
        who gets which detection
        """
    @assignment.setter
    def assignment(
        self, value: HungarianOptions | OldestFirstOptions | RowOrderOptions | LargestOptions
    ) -> None: ...
    @property
    def blobs(self) -> BlobOptions:
        """
        mask to detections
        """
    @blobs.setter
    def blobs(self, value: BlobOptions) -> None: ...
    @property
    def cleanup(self) -> CleanupOptions:
        """
        noise removal on the mask
        """
    @cleanup.setter
    def cleanup(self, value: CleanupOptions) -> None: ...
    @property
    def cost(self) -> GaussianCostOptions | MatchMatrixOptions | BeliefOptions | DistanceOptions:
        """
        how well a detection fits a track
        """
    @cost.setter
    def cost(
        self, value: GaussianCostOptions | MatchMatrixOptions | BeliefOptions | DistanceOptions
    ) -> None: ...
    @property
    def filter(
        self,
    ) -> (
        KalmanCvOptions
        | KalmanCaOptions
        | MeanVelocityOptions
        | KalmanDiscreteOptions
        | KalmanBoxOptions
        | KalmanPathOptions
        | ExtendedOptions
        | UnscentedOptions
        | ParticleOptions
    ):
        """
        how tracks move
        """
    @filter.setter
    def filter(
        self,
        value: KalmanCvOptions
        | KalmanCaOptions
        | MeanVelocityOptions
        | KalmanDiscreteOptions
        | KalmanBoxOptions
        | KalmanPathOptions
        | ExtendedOptions
        | UnscentedOptions
        | ParticleOptions,
    ) -> None: ...
    @property
    def groups(self) -> NoGroupsOptions | SharedBlobOptions:
        """
        tracks that merge into one blob
        """
    @groups.setter
    def groups(self, value: NoGroupsOptions | SharedBlobOptions) -> None: ...
    @property
    def lifecycle(
        self,
    ) -> (
        ConfirmAndLoseOptions
        | LostCountOptions
        | CountMedianOptions
        | RegionGrowthOptions
        | SingleLargestOptions
    ):
        """
        when tracks are born, believed, lost and closed
        """
    @lifecycle.setter
    def lifecycle(
        self,
        value: ConfirmAndLoseOptions
        | LostCountOptions
        | CountMedianOptions
        | RegionGrowthOptions
        | SingleLargestOptions,
    ) -> None: ...
    @property
    def measurement(self) -> BoxCenterOptions | CentroidOptions:
        """
        what of a detection a track follows
        """
    @measurement.setter
    def measurement(self, value: BoxCenterOptions | CentroidOptions) -> None: ...
    @property
    def outputs(self) -> OutputOptions:
        """
        extras of a result that cost something
        """
    @outputs.setter
    def outputs(self, value: OutputOptions) -> None: ...
    @property
    def reentry(self) -> NoReentryOptions | RememberOptions:
        """
        tracks that ended and come back
        """
    @reentry.setter
    def reentry(self, value: NoReentryOptions | RememberOptions) -> None: ...
    @property
    def regions(self) -> NoRegionsOptions | PredictedRegionsOptions:
        """
        which parts of a frame are read
        """
    @regions.setter
    def regions(self, value: NoRegionsOptions | PredictedRegionsOptions) -> None: ...
    @property
    def scene_change(self) -> NoSceneChangeOptions | GuardOptions:
        """
        what is done when the whole scene changes
        """
    @scene_change.setter
    def scene_change(self, value: NoSceneChangeOptions | GuardOptions) -> None: ...
    @property
    def segmenter(
        self,
    ) -> (
        SelectiveOptions
        | MovingAverageOptions
        | HornSchunckOptions
        | Mog2Options
        | KnnOptions
        | StaticReferenceOptions
        | NormalizedDifferenceOptions
    ):
        """
        frame to foreground mask
        """
    @segmenter.setter
    def segmenter(
        self,
        value: SelectiveOptions
        | MovingAverageOptions
        | HornSchunckOptions
        | Mog2Options
        | KnnOptions
        | StaticReferenceOptions
        | NormalizedDifferenceOptions,
    ) -> None: ...
    @property
    def time_unit_s(self) -> float:
        """
        the filters' unit of time; published presets: the nominal frame period [s]
        """
    @time_unit_s.setter
    def time_unit_s(self, value: float) -> None: ...
    @property
    def vicinity(self) -> NoVicinityOptions | GridVicinityOptions:
        """
        what the scene teaches about sizes and speeds
        """
    @vicinity.setter
    def vicinity(self, value: NoVicinityOptions | GridVicinityOptions) -> None: ...

class Detections:
    """
    All detections of one frame: a sequence of Detection.
    """
    def __getitem__(self, index: typing.SupportsInt | typing.SupportsIndex) -> Detection: ...
    def __init__(
        self,
        boxes: typing.Any,
        time_s: typing.SupportsFloat | typing.SupportsIndex,
        *,
        index: typing.SupportsInt | typing.SupportsIndex = 0,
        confidences: typing.Any = None,
        class_ids: typing.Any = None,
        frame_size: tuple[
            typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex
        ] = (0, 0),
        histograms: typing.Any = None,
    ) -> None:
        """
        From your own detector: boxes is Nx4 (left, top, width, height in px); confidences and class_ids have N
        numbers; frame_size is (width, height) in px, (0, 0) when unknown; histograms is Nx8x8x8, a color_histogram()
        a box, for appearance.model color_histogram.
        """
    def __iter__(self) -> collections.abc.Iterator[Detection]: ...
    def __len__(self) -> int: ...
    @property
    def array(self) -> numpy.ndarray:
        """
        All detections as one structured array.
        """
    @property
    def background(self) -> typing.Any:
        """
        The background picture, with config.outputs.background; else None.
        """
    @property
    def contours(self) -> list[numpy.typing.NDArray[numpy.int32]]:
        """
        An Nx2 int32 array (x, y) a detection, with config.outputs.contours; else empty.
        """
    @property
    def events(self) -> list[Event]:
        """
        Raised by the detector.
        """
    @property
    def flow(self) -> numpy.typing.NDArray[numpy.float32] | None:
        """
        The flow field, HxWx2 float32, px to the right and down, with config.outputs.flow; else None, as in the first
        frames, which have none.
        """
    @property
    def frame_size(self) -> tuple[int, int]:
        """
        (width, height), px
        """
    @property
    def histograms(self) -> numpy.typing.NDArray[numpy.float32]:
        """
        Nx8x8x8 float32, the color_histogram() of each, with appearance.model color_histogram; else 0x8x8x8.
        """
    @property
    def index(self) -> int: ...
    @property
    def mask(self) -> typing.Any:
        """
        HxW uint8, 0 or 255; None for your own boxes.
        """
    @property
    def pixels_read(self) -> int:
        """
        Number of pixels in them, each counted once.
        """
    @property
    def regions(self) -> list[Region]:
        """
        The parts of the frame that were read; they may overlap.
        """
    @property
    def time_s(self) -> float: ...

class TrackingResult:
    """
    What the tracker knows after one frame.
    """
    @property
    def beliefs(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Tracks x (detections + 1): probabilities, the last column for "lost", with cost.model belief
        and config.outputs.cost_matrix; else None.
        """
    @property
    def costs(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Tracks x detections, inf outside the gate, with config.outputs.cost_matrix; else None.
        """
    @property
    def events(self) -> list[Event]:
        """
        The detector's, then the tracker's.
        """
    @property
    def index(self) -> int:
        """
        The frame's index in its source.
        """
    @property
    def matches(self) -> list[Match]:
        """
        All pairs of track and detection that passed the gate, with their costs.
        """
    @property
    def matrix_track_ids(self) -> list[int]:
        """
        The rows of costs and beliefs: ids of the tracks open before the frame; 0: tentative.
        """
    @property
    def tentative(self) -> list[Track]:
        """
        Candidates, seen too few times to be believed; their id is 0.
        """
    @property
    def time_s(self) -> float: ...
    @property
    def track_array(self) -> numpy.ndarray:
        """
        The believed tracks as one structured array.
        """
    @property
    def tracks(self) -> list[Track]:
        """
        Believed tracks (confirmed, lost, or closed in this frame) in order of id.
        """
    @property
    def vicinity(self) -> dict[int, VicinityGrid]:
        """
        The VicinityGrid of each class of detections (-1: none), with config.outputs.vicinity.
        """

class FrameResult:
    """
    Everything about one processed frame.
    """
    @property
    def background(self) -> typing.Any:
        """
        The background picture, with config.outputs.background; else None.
        """
    @property
    def beliefs(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Tracks x (detections + 1): probabilities, the last column for "lost", with cost.model belief
        and config.outputs.cost_matrix; else None.
        """
    @property
    def costs(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Tracks x detections, inf outside the gate, with config.outputs.cost_matrix; else None.
        """
    @property
    def detection_array(self) -> numpy.ndarray:
        """
        All detections as one structured array.
        """
    @property
    def detections(self) -> Detections:
        """
        The frame's detections, a sequence.
        """
    @property
    def events(self) -> list[Event]:
        """
        The detector's, then the tracker's.
        """
    @property
    def flow(self) -> numpy.typing.NDArray[numpy.float32] | None:
        """
        The flow field, HxWx2 float32, px to the right and down, with config.outputs.flow; else None, as in the first
        frames, which have none.
        """
    @property
    def frame(self) -> typing.Any:
        """
        The frame: the array given to process, or a copy of it when the pipeline has a delay.
        """
    @property
    def index(self) -> int:
        """
        The frame's index in its source.
        """
    @property
    def mask(self) -> numpy.ndarray:
        """
        Foreground mask after cleanup, HxW uint8, 0 or 255.
        """
    @property
    def matches(self) -> list[Match]:
        """
        All pairs of track and detection that passed the gate, with their costs.
        """
    @property
    def matrix_track_ids(self) -> list[int]:
        """
        The rows of costs and beliefs: ids of the tracks open before the frame; 0: tentative.
        """
    @property
    def pixels_read(self) -> int:
        """
        Number of pixels in them, each counted once.
        """
    @property
    def regions(self) -> list[Region]:
        """
        The parts of the frame that were read; they may overlap.
        """
    @property
    def tentative(self) -> list[Track]:
        """
        Candidates, seen too few times to be believed; their id is 0.
        """
    @property
    def time_s(self) -> float: ...
    @property
    def track_array(self) -> numpy.ndarray:
        """
        The believed tracks as one structured array.
        """
    @property
    def tracks(self) -> list[Track]:
        """
        Believed tracks (confirmed, lost, or closed in this frame) in order of id.
        """
    @property
    def vicinity(self) -> dict[int, VicinityGrid]:
        """
        The VicinityGrid of each class of detections (-1: none), with config.outputs.vicinity.
        """

class Segmenter:
    """
    A background model alone: frame in, raw foreground mask out.
    """
    def __init__(
        self,
        options: SelectiveOptions
        | MovingAverageOptions
        | HornSchunckOptions
        | Mog2Options
        | KnnOptions
        | StaticReferenceOptions
        | NormalizedDifferenceOptions = ...,
    ) -> None:
        """
        Raises ConfigError.
        """
    def background(self) -> numpy.ndarray:
        """
        The background picture, uint8 of the frame's size.
        """
    def flow(self) -> numpy.typing.NDArray[numpy.float32] | None:
        """
        The last flow field, HxWx2 float32, px to the right and down; None while there is none.
        """
    def load_background(self, picture: typing.Any) -> None:
        """
        The picture to start from, with segmenter.source picture: HxW or HxWx3 (BGR) uint8 of the frames' size, copied.
        Before the first frame; it outlives reset(). Raises InputError.
        """
    def relearn(self) -> None:
        """
        The scene changed: learns the background anew from the coming frames.
        """
    def reset(self) -> None:
        """
        Forgets everything: the next frame is a first frame.
        """
    def segment(
        self, frame: typing.Any, time_s: typing.SupportsFloat | typing.SupportsIndex
    ) -> numpy.ndarray:
        """
        One frame on: frame is HxW or HxWx3 (BGR) uint8, time_s increases. Returns the mask before cleanup, HxW
        uint8, 0 or 255. Raises InputError and then keeps its state.
        """

class Cleanup:
    """
    Noise removal on the masks of a run, one after the other.
    """
    def __init__(self, options: CleanupOptions = ...) -> None:
        """
        Raises ConfigError.
        """
    def apply(self, mask: typing.Any) -> numpy.ndarray:
        """
        The next mask (HxW uint8, not 0 is foreground) with its noise removed, 0 or 255; the input is left alone.
        Raises InputError, for one of another size than those before it with a temporal median or for one too
        small for its tiles, and then keeps its state.
        """
    def reset(self) -> None:
        """
        Forgets the masks before: the next is a first mask.
        """

class SceneChangeKind(enum.Enum):
    """
    How a scene changed.
    """

    black = 4
    brightness = 2
    cut = 0
    gradual = 1
    infrared = 3

class SceneChange:
    """
    A change of the scene, with what showed it.
    """
    @property
    def kind(self) -> SceneChangeKind: ...
    @property
    def measure(self) -> str:
        """
        The measure's name, "color_part" or "black_part".
        """
    @property
    def threshold(self) -> float:
        """
        What it passed, 0 to 1.
        """
    @property
    def value(self) -> float:
        """
        What was measured, 0 to 1.
        """

class SceneLook:
    """
    What one look of a SceneGuard found.
    """
    @property
    def against_before(self) -> float:
        """
        The same, and the frame frames_back before.
        """
    @property
    def against_reference(self) -> float:
        """
        The measure between the frame and the long-term reference, 0 to 1.
        """
    @property
    def black(self) -> bool:
        """
        The frame is black, and the scene was not.
        """
    @property
    def black_part(self) -> float:
        """
        Part of the samples that are black, 0 to 1.
        """
    @property
    def change(self) -> SceneChange | None:
        """
        A SceneChange, or None.
        """
    @property
    def color(self) -> float:
        """
        Mean of largest less smallest channel, grey levels.
        """
    @property
    def correlation(self) -> float:
        """
        Of grey levels with those of the reference, -1 to 1.
        """
    @property
    def reference_color(self) -> float:
        """
        The same of the reference.
        """

class SceneGuard:
    """
    Watches a scene as a whole, on a grid of samples; Pipeline does so with scene_change.model guard.
    """
    def __init__(self, options: GuardOptions = ...) -> None:
        """
        Raises ConfigError.
        """
    def look(
        self, frame: typing.Any, time_s: typing.SupportsFloat | typing.SupportsIndex
    ) -> SceneLook:
        """
        The next frame: HxW or HxWx3 (BGR) uint8, all of one size; time_s increases. Raises InputError and then keeps
        its state.
        """
    def reset(self) -> None:
        """
        Forgets everything: the next frame is a first frame.
        """
    @property
    def sample_count(self) -> int:
        """
        Pixels that are samples; 0 before the first frame.
        """

class KalmanFilter:
    """
    The linear Kalman filter for any model: x = F x + B u + noise of covariance Q, z = H x + noise of covariance R.
    Joseph-form update. Letters and equations: Bar-Shalom, Li and Kirubarajan 2001, 5.2.
    """
    def __getstate__(self) -> dict[str, typing.Any]: ...
    def __init__(
        self,
        *,
        F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        H: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        B: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
        residual: collections.abc.Callable[..., typing.Any] | None = None,
        validate: bool = True,
    ) -> None:
        """
        F (n x n), H (m x n), Q (n x n), R (m x m), start x (n) of covariance P (n x n), B (n x k). residual(z, predicted)
        returns how a measurement differs from the expected one, for those that wrap; None: z - predicted. Raises
        InputError naming what has a wrong shape, is not finite, or is no covariance, with its smallest eigenvalue.
        validate=False leaves out the checks that Q, R, P and S are covariances: only to reproduce published listings
        whose matrices are none; estimates of such a filter mean nothing.
        """
    def __setstate__(self, arg0: dict[str, typing.Any]) -> None: ...
    def mahalanobis(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
        """
        The root of squared_mahalanobis.
        """
    def predict(
        self, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None
    ) -> None:
        """
        x = F x + B u, P = F P F' + Q. u: k numbers, or None for no input.
        """
    def squared_mahalanobis(
        self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> float:
        """
        How far a measurement is from the expected one, in the metric of the coming innovation's covariance, squared:
        inside the gate for a share p of the true ones if at most chi_square_quantile(p, m). Raises InputError.
        """
    def update(
        self,
        z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
    ) -> None:
        """
        Corrects by a measurement of m numbers; a missing one is simply not passed. R: the noise of this one, if another.
        Raises InputError where z is not finite or S is singular; the filter is then as before.
        """
    @property
    def B(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Effect of the control input: n x k; None if there is none.
        """
    @property
    def F(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Transition: n x n.
        """
    @F.setter
    def F(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def H(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Measured of state: m x n.
        """
    @H.setter
    def H(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def K(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Gain of the last update: n x m.
        """
    @property
    def P(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the state: n x n.
        """
    @P.setter
    def P(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def Q(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the process noise of a step: n x n.
        """
    @Q.setter
    def Q(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def R(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the measurement noise: m x m.
        """
    @R.setter
    def R(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def S(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Its covariance: m x m.
        """
    @property
    def log_likelihood(self) -> float:
        """
        Logarithm of the Gaussian density of the last innovation.
        """
    @property
    def nis(self) -> float:
        """
        Normalised innovation squared of the last update, y' S^-1 y: chi-square distributed with m
        degrees of freedom if the model fits.
        """
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        State: n numbers.
        """
    @x.setter
    def x(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def y(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Innovation of the last update: m numbers. Raises InputError before the first update.
        """

class KalmanBank:
    """
    Many Kalman filters with one model between them, predicted and updated together, side by side in the
    processor's vector registers. Equal to KalmanFilter up to rounding. In C++: KalmanArray.
    """
    def __getstate__(self) -> dict[str, typing.Any]: ...
    def __init__(
        self,
        F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        H: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
        covariances: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
        *,
        B: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
        periods: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
        validate: bool = True,
    ) -> None:
        """
        F (n x n), H (m x n), Q (n x n), R (m x m), B (n x k). Starts with N filters at states (N x n) of covariances
        (N x n x n, or n x n for all), or with none. periods (m): the lengths after which measurements wrap, 0 where they
        do not. validate as for KalmanFilter. Raises InputError naming what is wrong.
        """
    def __len__(self) -> int: ...
    def __setstate__(self, arg0: dict[str, typing.Any]) -> None: ...
    def add(
        self,
        states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        covariances: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    ) -> int:
        """
        Adds filters, as the constructor takes them; returns the slot of the first. Raises InputError, and then adds none.
        """
    def predict(
        self, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None
    ) -> None:
        """
        x = F x + B u, P = F P F' + Q for all. u: k numbers for all filters, N x k, or None for no input.
        """
    def remove(self, slot: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Ends a filter; later slots move down by one.
        """
    def squared_mahalanobis(
        self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        N x M: of each filter to each of M measurements (M x m), as KalmanFilter.squared_mahalanobis.
        """
    def update(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Corrects all filters by an N x m array; a row of NaN is missing, its filter stays as predicted. Raises InputError
        naming the filter where a row is neither finite nor missing or S is singular; the bank is then as before.
        """
    @property
    def F(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Transition: n x n.
        """
    @F.setter
    def F(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def H(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Measured of state: m x n.
        """
    @H.setter
    def H(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def Q(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the process noise of a step: n x n.
        """
    @Q.setter
    def Q(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def R(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the measurement noise: m x m.
        """
    @R.setter
    def R(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def covariances(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N x n x n.
        """
    @property
    def innovation_covariances(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N x m x m, of the last update; NaN where the measurement was missing.
        """
    @property
    def innovations(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N x m, of the last update; NaN where the measurement was missing.
        """
    @property
    def log_likelihoods(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N numbers: logarithms of the Gaussian densities of the last innovations; NaN likewise.
        """
    @property
    def nis(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N numbers: y' S^-1 y of the last update; NaN where the measurement was missing.
        """
    @property
    def states(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N x n.
        """

class ExtendedKalmanFilter:
    """
    Kalman filter for x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R, linearised where the estimate
    is: F at the estimate before the step, H at the predicted one (Bar-Shalom, Li and Kirubarajan 2001, 10.3).
    """
    def __getstate__(self) -> dict[str, typing.Any]: ...
    def __init__(
        self,
        *,
        f: collections.abc.Callable[..., typing.Any],
        h: collections.abc.Callable[..., typing.Any],
        Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        F: collections.abc.Callable[..., typing.Any] | None = None,
        H: collections.abc.Callable[..., typing.Any] | None = None,
        residual: collections.abc.Callable[..., typing.Any] | None = None,
    ) -> None:
        """
        f(x) or f(x, u) returns n numbers, h(x) m numbers; F (called as f is) and H return their derivatives, n x n and
        m x n; None: central differences. residual(z, predicted) as for KalmanFilter. Raises InputError.
        """
    def __setstate__(self, arg0: dict[str, typing.Any]) -> None: ...
    def mahalanobis(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
        """
        The root of squared_mahalanobis.
        """
    def predict(
        self, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None
    ) -> None:
        """
        Moves the state by f, which is called with u too where one is given. The exceptions of
        callables pass through; the filter is then as before.
        """
    def squared_mahalanobis(
        self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> float:
        """
        How far a measurement is from the expected one, in the metric of the coming innovation's covariance, squared:
        inside the gate for a share p of the true ones if at most chi_square_quantile(p, m). Raises InputError.
        """
    def update(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Corrects by a measurement of m numbers; a missing one is simply not passed. Raises InputError where z
        or what a callable returns is not finite or has a wrong shape, or S is singular.
        """
    @property
    def K(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Gain of the last update: n x m.
        """
    @property
    def P(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the state: n x n.
        """
    @P.setter
    def P(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def Q(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the process noise of a step: n x n.
        """
    @Q.setter
    def Q(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def R(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the measurement noise: m x m.
        """
    @R.setter
    def R(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def S(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Its covariance: m x m.
        """
    @property
    def log_likelihood(self) -> float:
        """
        Logarithm of the Gaussian density of the last innovation.
        """
    @property
    def nis(self) -> float:
        """
        Normalised innovation squared of the last update, y' S^-1 y: chi-square distributed with m
        degrees of freedom if the model fits.
        """
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        State: n numbers.
        """
    @x.setter
    def x(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def y(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Innovation of the last update: m numbers. Raises InputError before the first update.
        """

class UnscentedKalmanFilter:
    """
    Kalman filter for x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R, by sigma points that go through
    f and h (Wan and van der Merwe 2000); no derivatives are needed.
    """
    def __getstate__(self) -> dict[str, typing.Any]: ...
    def __init__(
        self,
        *,
        f: collections.abc.Callable[..., typing.Any],
        h: collections.abc.Callable[..., typing.Any],
        Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        alpha: typing.SupportsFloat | typing.SupportsIndex = 0.1,
        beta: typing.SupportsFloat | typing.SupportsIndex = 2.0,
        kappa: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        residual: collections.abc.Callable[..., typing.Any] | None = None,
    ) -> None:
        """
        f(x) or f(x, u) returns n numbers, h(x) m numbers. alpha (1e-4 to 1): spread of the points; beta: 2 for a
        Gaussian; kappa: above -n. residual(z, predicted) as for KalmanFilter, for means too. Raises InputError.
        """
    def __setstate__(self, arg0: dict[str, typing.Any]) -> None: ...
    def mahalanobis(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
        """
        The root of squared_mahalanobis.
        """
    def predict(
        self, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None
    ) -> None:
        """
        Moves the state by f, which is called with u too where one is given. The exceptions of
        callables pass through; the filter is then as before.
        """
    def squared_mahalanobis(
        self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> float:
        """
        How far a measurement is from the expected one, in the metric of the coming innovation's covariance, squared:
        inside the gate for a share p of the true ones if at most chi_square_quantile(p, m). Raises InputError.
        """
    def update(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Corrects by a measurement of m numbers; a missing one is simply not passed. Raises InputError where z
        or what a callable returns is not finite or has a wrong shape, or S is singular.
        """
    @property
    def K(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Gain of the last update: n x m.
        """
    @property
    def P(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the state: n x n.
        """
    @P.setter
    def P(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def Q(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the process noise of a step: n x n.
        """
    @Q.setter
    def Q(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def R(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance of the measurement noise: m x m.
        """
    @R.setter
    def R(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def S(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Its covariance: m x m.
        """
    @property
    def log_likelihood(self) -> float:
        """
        Logarithm of the Gaussian density of the last innovation.
        """
    @property
    def nis(self) -> float:
        """
        Normalised innovation squared of the last update, y' S^-1 y: chi-square distributed with m
        degrees of freedom if the model fits.
        """
    @property
    def sigma_points(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (2 n + 1) x n: those of the present state, the mean first.
        """
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        State: n numbers.
        """
    @x.setter
    def x(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None: ...
    @property
    def y(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Innovation of the last update: m numbers. Raises InputError before the first update.
        """

class ParticleFilter:
    """
    Bootstrap particle filter (Gordon, Salmond and Smith 1993): any motion, any noise of measurements. Systematic
    resampling when the effective sample size falls under a share. The same seed gives the same particles everywhere.
    """
    def __getstate__(self) -> dict[str, typing.Any]: ...
    def __init__(
        self,
        *,
        f: collections.abc.Callable[..., typing.Any],
        log_likelihood: collections.abc.Callable[..., typing.Any],
        Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        count: typing.SupportsInt | typing.SupportsIndex = 1000,
        resample_below: typing.SupportsFloat | typing.SupportsIndex = 0.5,
        seed: typing.SupportsInt | typing.SupportsIndex = 0,
    ) -> None:
        """
        f(particles) or f(particles, u) moves all particles at once, (count x n) to (count x n); the filter adds noise of
        covariance Q (zero: f adds its own). log_likelihood(z, particles) returns count numbers, up to a constant; -inf
        where z is impossible. The particles are drawn from the Gaussian of mean x (n) and covariance P (n x n).
        resample_below: share of count, 0 to 1. Raises InputError naming what is wrong.
        """
    def __setstate__(self, arg0: dict[str, typing.Any]) -> None: ...
    def predict(
        self, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None
    ) -> None:
        """
        Moves the particles by f and adds noise. The exceptions of callables pass through.
        """
    def update(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Weights the particles by a measurement, and resamples where needed. Raises InputError where z is not finite, or
        impossible for every particle; the filter is then as before.
        """
    @property
    def P(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Their weighted covariance: n x n.
        """
    @property
    def effective_size(self) -> float:
        """
        1 / sum of squared weights, as they are now: 1 to count.
        """
    @property
    def log_likelihood(self) -> float:
        """
        Logarithm of the likelihood of the last measurement given those before, as estimated; 0 at first.
        """
    @property
    def particles(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        count x n.
        """
    @property
    def resamplings(self) -> int:
        """
        So far.
        """
    @property
    def weights(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        count numbers, of sum 1.
        """
    @property
    def x(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Weighted mean of the particles: n numbers.
        """

class Random:
    """
    Random numbers that are the same bytes on every platform: xoshiro256++, normal numbers by Marsaglia's polar
    method.
    """
    def __init__(self, seed: typing.SupportsInt | typing.SupportsIndex = 0) -> None: ...
    def normal(
        self, count: typing.SupportsInt | typing.SupportsIndex
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        So many numbers of mean 0 and variance 1.
        """
    def uniform(
        self, count: typing.SupportsInt | typing.SupportsIndex
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        So many numbers in [0, 1).
        """

class Density:
    """
    The density of a difference between a track and its blob (Narayana 2007, 8.3.3): a table of equal bins
    over -range to range, relative to its peak, linear between the bins' middles.
    """
    @staticmethod
    def from_values(
        range: typing.SupportsFloat | typing.SupportsIndex,
        values: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    ) -> Density:
        """
        From a table of 3 or more values, at least 0, whose integral over -range to range is 1 within 1e-6. Raises
        InputError.
        """
    @staticmethod
    def two_sided_exponential(
        range: typing.SupportsFloat | typing.SupportsIndex,
        scale: typing.SupportsFloat | typing.SupportsIndex,
    ) -> Density:
        """
        exp(-abs(difference) / scale) in 401 bins: what stands in until enough was seen. Both are above 0, in the unit of
        the differences. Raises InputError.
        """
    def __call__(
        self, difference: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Relative to the peak, 0 to 1, for an array of differences of any shape; beyond the range the last bin counts.
        Raises InputError.
        """
    @property
    def range(self) -> float: ...
    @property
    def relative(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        The table, with the peak 1.
        """
    @property
    def values(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        The table, with the integral 1.
        """

class History:
    """
    All tracks of a run that is over.
    """
    @staticmethod
    def from_columns(
        *,
        ids: typing.Any,
        indices: typing.Any,
        times_s: typing.Any,
        boxes: typing.Any,
        positions: typing.Any = None,
        velocities_px_per_s: typing.Any = None,
        mean_colors: typing.Any = None,
    ) -> History:
        """
        From N points in any order: ids and indices (of frames, from 0) are N integers, times_s N numbers, boxes Nx4
        (left, top, width, height in px), positions Nx2 in px (the box centres), velocities_px_per_s Nx2 (0),
        mean_colors Nx3 (blue, green, red, 0 to 255; 0). Raises InputError that names track and frame index.
        """
    def __init__(self) -> None: ...
    def __len__(self) -> int: ...
    @property
    def array(self) -> numpy.ndarray:
        """
        All points as one structured array, track by track.
        """

class HistoryRecorder:
    """
    Collects the reported tracks of a run, frame by frame.
    """
    def __init__(self) -> None: ...
    @typing.overload
    def add(self, result: TrackingResult) -> None:
        """
        Takes the result of one frame; frames come in order.
        """
    @typing.overload
    def add(self, result: FrameResult) -> None: ...
    @property
    def history(self) -> History:
        """
        A copy of what was collected.
        """

class LinkOptions:
    """
    When two tracks are one, and which tracks are too short to be real.

    Args:
        max_gap_s: longest time between the end of a track and the start of the next; 0: none are joined [s]; between 0 and 1000000
        max_distance: largest distance between end and start, both extrapolated to the middle of the gap [object sizes]; between 0 and 1000000
        max_distance_growth: what each second of the gap adds to max_distance [object sizes/s]; between 0 and 1000000
        max_speed_difference: largest difference of the velocities before and after the gap [object sizes/s]; between 0 and 1000000
        max_color_difference: largest distance of the mean colours, 0 to 1.73 (Narayana 2007, eq. 3.6); between 0 and 1000000
        max_cost: a join costs less: the mean of gap, distance, speed and colour difference in parts of their limits; between 0 and 1
        end_s: stretch of a track from which the velocity, size and colour of its end are taken [s]; between 0 and 1000000
        min_frames: a track seen in fewer is dropped [frames]; between 0 and 1000000
        min_s: a track that lasts less is dropped [s]; between 0 and 1000000
        min_travel: a track that never gets so far from its first place is dropped; 0 where objects may stand [object sizes]; between 0 and 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def __copy__(self) -> LinkOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> LinkOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        max_gap_s: float = 3.0,
        max_distance: float = 0.75,
        max_distance_growth: float = 0.5,
        max_speed_difference: float = 1.0,
        max_color_difference: float = 0.3,
        max_cost: float = 0.5,
        end_s: float = 1.0,
        min_frames: int = 3,
        min_s: float = 0.5,
        min_travel: float = 0.5,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> LinkOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def end_s(self) -> float:
        """
        stretch of a track from which the velocity, size and colour of its end are taken [s]
        """
    @property
    def max_color_difference(self) -> float:
        """
        largest distance of the mean colours, 0 to 1.73 (Narayana 2007, eq. 3.6)
        """
    @property
    def max_cost(self) -> float:
        """
        a join costs less: the mean of gap, distance, speed and colour difference in parts of their limits
        """
    @property
    def max_distance(self) -> float:
        """
        largest distance between end and start, both extrapolated to the middle of the gap [object sizes]
        """
    @property
    def max_distance_growth(self) -> float:
        """
        what each second of the gap adds to max_distance [object sizes/s]
        """
    @property
    def max_gap_s(self) -> float:
        """
        longest time between the end of a track and the start of the next; 0: none are joined [s]
        """
    @property
    def max_speed_difference(self) -> float:
        """
        largest difference of the velocities before and after the gap [object sizes/s]
        """
    @property
    def min_frames(self) -> int:
        """
        a track seen in fewer is dropped [frames]
        """
    @property
    def min_s(self) -> float:
        """
        a track that lasts less is dropped [s]
        """
    @property
    def min_travel(self) -> float:
        """
        a track that never gets so far from its first place is dropped; 0 where objects may stand [object sizes]
        """

class Link:
    """
    Two tracks that are one, and the numbers that decided it.
    """
    def __repr__(self) -> str: ...
    @property
    def color_difference(self) -> float:
        """
        0 to 1.73.
        """
    @property
    def cost(self) -> float:
        """
        Mean of the four in parts of their limits, 0 to 1.
        """
    @property
    def distance(self) -> float:
        """
        Object sizes, both extrapolated to the middle of the gap.
        """
    @property
    def earlier_id(self) -> int: ...
    @property
    def gap_s(self) -> float:
        """
        From the last point of the one to the first of the other.
        """
    @property
    def later_id(self) -> int: ...
    @property
    def speed_difference(self) -> float:
        """
        Object sizes per second.
        """

class DroppedTrack:
    """
    A track that is too short, after joining.
    """
    def __repr__(self) -> str: ...
    @property
    def duration_s(self) -> float: ...
    @property
    def frames(self) -> int:
        """
        In which it has a point.
        """
    @property
    def id(self) -> int: ...
    @property
    def travel(self) -> float:
        """
        Object sizes; largest distance from its first place.
        """

class Linked:
    """
    What is left of a history, and why.
    """
    @property
    def dropped(self) -> list[DroppedTrack]:
        """
        By id.
        """
    @property
    def history(self) -> History:
        """
        By id.
        """
    @property
    def links(self) -> list[Link]:
        """
        In order of the earlier one's start; ids are those of the given tracks.
        """

class PatternOptions:
    """
    When tracks go the same way, and which are unusual.

    Args:
        points: points by which a way is described, evenly spaced along it; between 4 and 256
        min_travel: a track that never gets so far from its first place is standing, and neither learned from nor unusual [object sizes]; between 0.01 and 1000000
        max_distance: largest mean distance between corresponding points of a track and the way that it follows [object sizes]; above 0 and at most 1000000
        max_angle_deg: largest angle between their directions; its cosine is the mean over the way [degrees]; above 0 and at most 180
        min_tracks: what fewer tracks do is no pattern [tracks]; between 1 and 1000000
        max_speed_deviations: a track is too fast or too slow beyond this many from the pattern's mean speed [standard deviations]; above 0 and at most 1000000
        min_speed_spread: least standard deviation of a pattern's speed that counts, in parts of the mean; above 0 and at most 1000000
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def __copy__(self) -> PatternOptions: ...
    def __deepcopy__(self, memo: dict[typing.Any, typing.Any]) -> PatternOptions: ...
    def __eq__(self, other: typing.Any) -> bool: ...
    def __getstate__(self) -> str: ...
    def __init__(
        self,
        *,
        points: int = 16,
        min_travel: float = 2.0,
        max_distance: float = 1.5,
        max_angle_deg: float = 45.0,
        min_tracks: int = 3,
        max_speed_deviations: float = 3.0,
        min_speed_spread: float = 0.1,
    ) -> None:
        """
        Raises ConfigError naming the option and what is allowed.
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: str) -> None: ...
    def replace(self, **options: typing.Any) -> PatternOptions:
        """
        A copy with some options changed.
        """
    def to_dict(self) -> dict[str, typing.Any]:
        """
        All options by name, and the model's name if it is one of several.
        """
    @property
    def max_angle_deg(self) -> float:
        """
        largest angle between their directions; its cosine is the mean over the way [degrees]
        """
    @property
    def max_distance(self) -> float:
        """
        largest mean distance between corresponding points of a track and the way that it follows [object sizes]
        """
    @property
    def max_speed_deviations(self) -> float:
        """
        a track is too fast or too slow beyond this many from the pattern's mean speed [standard deviations]
        """
    @property
    def min_speed_spread(self) -> float:
        """
        least standard deviation of a pattern's speed that counts, in parts of the mean
        """
    @property
    def min_tracks(self) -> int:
        """
        what fewer tracks do is no pattern [tracks]
        """
    @property
    def min_travel(self) -> float:
        """
        a track that never gets so far from its first place is standing, and neither learned from nor unusual [object sizes]
        """
    @property
    def points(self) -> int:
        """
        points by which a way is described, evenly spaced along it
        """

class Pattern:
    """
    A way that many tracks go, and how (Narayana 2007, 11.5).
    """
    def __repr__(self) -> str: ...
    @property
    def count(self) -> int:
        """
        Tracks that it was learned from.
        """
    @property
    def duration_deviation_s(self) -> float:
        """
        Standard deviation over the tracks.
        """
    @property
    def duration_s(self) -> float:
        """
        Mean over the tracks.
        """
    @property
    def enters(self) -> tuple[float, float]:
        """
        (x, y), px: the way's first point.
        """
    @property
    def id(self) -> int:
        """
        From 1; the most frequent pattern first.
        """
    @property
    def leaves(self) -> tuple[float, float]:
        """
        (x, y), px: the way's last point.
        """
    @property
    def size_px(self) -> float:
        """
        Mean of the objects' sizes (root of the box area).
        """
    @property
    def speed_deviation_px_per_s(self) -> float:
        """
        Standard deviation over the tracks.
        """
    @property
    def speed_px_per_s(self) -> float:
        """
        Mean of the tracks' mean speeds, standing still counted.
        """
    @property
    def spread_px(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N numbers: at each point of the way the root mean square distance across it.
        """
    @property
    def time_s(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N numbers: at each point of the way the mean time since the first.
        """
    @property
    def way(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2 (x, y) in px: the mean of their ways, from where it enters to where it leaves.
        """

class ActivityKind(enum.Enum):
    """
    What a track does, seen by the patterns.
    """

    other_way = 2
    standing = 1
    too_fast = 3
    too_slow = 4
    usual = 0

class Activity:
    """
    What one track does, and the numbers that decided it.
    """
    def __repr__(self) -> str: ...
    @property
    def angle_deg(self) -> float | None:
        """
        Between the directions, 0 to 180; None as distance is.
        """
    @property
    def distance(self) -> float | None:
        """
        Mean distance from the pattern's way in object sizes; from the nearest when it follows none.
        None of a standing track, or without patterns.
        """
    @property
    def kind(self) -> ActivityKind: ...
    @property
    def partial(self) -> bool:
        """
        It follows a stretch of the pattern's way, not the whole.
        """
    @property
    def pattern(self) -> int | None:
        """
        Id of the pattern that it follows, or None.
        """
    @property
    def speed_px_per_s(self) -> float:
        """
        Length of its way by its duration.
        """
    @property
    def speed_ratio(self) -> float | None:
        """
        In parts of the pattern's mean speed, of a stretch in parts of its speed there; None without a pattern.
        """
    @property
    def track_id(self) -> int: ...
    @property
    def unusual(self) -> bool:
        """
        Neither usual nor standing.
        """

class Patterns:
    """
    The patterns of activity in a scene; len() is their number.
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    @staticmethod
    def from_json(json: str, source: str = "patterns") -> Patterns:
        """
        Reads what to_json() wrote. Raises InputError that names source, the entry and what is expected there.
        """
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...
    def classify(self, history: History) -> list[Activity]:
        """
        What each track does, by its id. A track that follows no whole way may follow a stretch of one: it may begin
        late, end early, or be still underway. Of several patterns within the limits the nearest is taken. Raises
        InputError naming track and frame index.
        """
    def to_json(self) -> str:
        """
        Text that from_json() reads back to the same patterns.
        """
    @property
    def frame_size(self) -> tuple[int, int] | None:
        """
        (width, height) in px of the frames that the tracks come from, or None. It is kept for those who load
        the patterns; classify() does not look at it.
        """
    @frame_size.setter
    def frame_size(
        self,
        arg1: tuple[
            typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex
        ]
        | None,
    ) -> None: ...
    @property
    def options(self) -> PatternOptions:
        """
        In force for classify().
        """
    @options.setter
    def options(self, arg0: PatternOptions) -> None: ...
    @property
    def patterns(self) -> list[Pattern]:
        """
        By id.
        """

class Path:
    """
    A way through the image and coordinates by it: S along and T across (O'Malley 2000, 3), both in px.

    T is positive to the right of who goes along the path, as seen in the picture. To each position belongs the
    nearest point of the path; of those at equal distance the one with the smallest S. Beyond the ends of an open path
    both go straight on. Outside of a corner S is the corner's and T the distance from it. A Path never changes.
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    @staticmethod
    def from_json(json: str, source: str = "path") -> Path:
        """
        Reads what to_json() wrote. Raises InputError that names source, the entry and what is expected there.
        """
    @staticmethod
    def from_pattern(
        pattern: Pattern,
        *,
        kind: str = "curve",
        close_within_px: typing.SupportsFloat | typing.SupportsIndex | None = None,
        max_distance_px: typing.SupportsFloat | typing.SupportsIndex | None = None,
    ) -> Path:
        """
        Along the way of a learned pattern. Closed when the way, having been twice as far away, comes back to within
        close_within_px of its start (None: the objects' size), in about the direction in which it left; what comes
        after is another lap and left out. Raises InputError, such as for a way that meets itself elsewhere.
        """
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __init__(
        self,
        points: typing.Any,
        closed: bool = False,
        *,
        kind: str = "line",
        max_distance_px: typing.SupportsFloat | typing.SupportsIndex | None = None,
    ) -> None:
        """
        points: Nx2 (x, y) in px, 2 to 2000, 3 or more when closed; the last of a closed path is not the first again.
        kind: "line", straight with corners, or "curve", a centripetal Catmull-Rom spline. max_distance_px: a position
        farther off the path gets NaN. Raises InputError that names the point: not finite or beyond 1e6 px, the same as the
        one before, where the path turns straight back, or meets itself.
        """
    def __repr__(self) -> str: ...
    def normals(
        self, s_px: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, of length 1: to the side where T is positive.
        """
    def residual(
        self,
        measured_s_px: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        predicted_s_px: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    ) -> typing.Any:
        """
        From the predicted to the measured S, numbers or arrays: of a closed path the shorter way round,
        ((d + l/2) mod l) - l/2 (O'Malley 2000).
        """
    def stretches(self, places: typing.Any) -> numpy.typing.NDArray[numpy.float64]:
        """
        How far points at Nx2 places (S, T) move along for each px of S: 1 - T / radius, kept between 0.01 and 100.
        """
    def tangents(
        self, s_px: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, of length 1: where the path goes at each S; at a corner the mean of both directions.
        """
    def to_image(self, places: typing.Any) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2 (x, y) of Nx2 (S, T), px; a closed path goes round and round. Raises InputError as to_path() does.
        """
    def to_json(self) -> str:
        """
        Text that from_json() reads back to the same path.
        """
    def to_path(self, points: typing.Any) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2 (S, T) of Nx2 (x, y), px. S of a closed path is at least 0 and below the length. Rows farther off the path than
        max_distance_px are NaN. Raises InputError for a number that is not finite or beyond 1e9.
        """
    def velocities(
        self, points: typing.Any, velocities_px_per_s: typing.Any
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2 (dS/dt, dT/dt) in px/s of points that move, both Nx2: ds/dt = (v . tangent) / (1 - T / radius), the divisor
        kept above 0.01. NaN as of to_path().
        """
    def wrap(self, s_px: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Any:
        """
        S of a closed path brought to at least 0 and below the length; a number, or an array of them.
        """
    @property
    def closed(self) -> bool: ...
    @property
    def kind(self) -> str:
        """
        "line" or "curve".
        """
    @property
    def length_px(self) -> float:
        """
        Of a closed path once round.
        """
    @property
    def max_distance_px(self) -> float | None:
        """
        Or None.
        """
    @property
    def points(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2 (x, y), px.
        """

class Paths:
    """
    The paths of a scene by name, in their order, and the file that holds them.
    """

    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    @staticmethod
    def from_json(json: str, source: str = "paths") -> Paths:
        """
        Reads a file of paths. Raises InputError that names source, the entry and what is expected there.
        """
    def __contains__(self, name: str) -> bool: ...
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __getitem__(self, name: str) -> Path:
        """
        The Path of this name.
        """
    def __init__(
        self,
        paths: dict[str, Path],
        frame_size: tuple[
            typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex
        ]
        | None = None,
    ) -> None:
        """
        paths: Path by name; frame_size: (width, height) in px of the frames that they are drawn on, or None. Raises
        InputError for a name that is not 1 to 100 bytes without control characters.
        """
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...
    def to_json(self) -> str:
        """
        Text that from_json() reads back to the same paths.
        """
    @property
    def frame_size(self) -> tuple[int, int] | None:
        """
        (width, height) in px, or None.
        """
    @property
    def names(self) -> list[str]: ...

class PathState:
    """
    What a filter along a path believes, by that path.
    """
    @property
    def covariance_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2 over (S, T), of predicted.
        """
    @property
    def path(self) -> Path:
        """
        The Path.
        """
    @property
    def place_before(self) -> tuple[float, float]:
        """
        (S, T) px: the estimate before the last prediction.
        """
    @property
    def predicted(self) -> tuple[float, float]:
        """
        (S, T) px: the estimate now; after predict the predicted one.
        """
    @property
    def velocity(self) -> tuple[float, float]:
        """
        Rates of (S, T), px per time unit.
        """

class FilterBank:
    """
    The filters of many objects in one, a slot an object; each is predicted and corrected in turn.
    """
    def __init__(
        self,
        options: KalmanCvOptions
        | KalmanCaOptions
        | MeanVelocityOptions
        | KalmanDiscreteOptions
        | KalmanBoxOptions
        | KalmanPathOptions
        | ExtendedOptions
        | UnscentedOptions
        | ParticleOptions,
        *,
        paths: Paths | None = None,
        frame_size: tuple[
            typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex
        ]
        | None = None,
    ) -> None:
        """
        paths: for kalman_path, which needs some; frame_size: (width, height) in px, for kalman_discrete with start
        frame_center, which needs it. Raises ConfigError and InputError.
        """
    def __len__(self) -> int: ...
    def add(
        self,
        x: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.SupportsFloat | typing.SupportsIndex,
        *,
        object_size_px: typing.SupportsFloat | typing.SupportsIndex = 1.0,
    ) -> int:
        """
        Starts a filter at a measured position in px; returns its slot. object_size_px is the unit of noises that
        are relative to the object's size. Raises InputError.
        """
    def correct(
        self,
        measured: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        sizes: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
    ) -> None:
        """
        Corrects all filters by an Nx2 array of positions in px; rows of NaN are missing measurements. sizes: for
        kalman_box an Nx2 array of widths and heights in px.
        """
    def path_state(self, slot: typing.SupportsInt | typing.SupportsIndex) -> PathState | None:
        """
        What is believed by the path that the object is on; None of filters without one.
        """
    def predict(self, dt: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Moves all filters on by dt time units, above 0.
        """
    def remove(self, slot: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Ends a filter; later slots move down by one.
        """
    def state(
        self, slot: typing.SupportsInt | typing.SupportsIndex
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        The raw state: positions, velocities, accelerations (x, y each); of kalman_box (x, y, w, h) and their rates, of
        kalman_path (S, T, vS, vT).
        """
    def state_covariance(
        self, slot: typing.SupportsInt | typing.SupportsIndex
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        The raw state's covariance; empty for filters without one.
        """
    @property
    def box_sizes(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, px: width and height; NaN of filters over positions
        """
    @property
    def cross_covariances(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2x2, px^2 per time unit: rows of the position, columns of the velocity
        """
    @property
    def innovation_covariances_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2x2, px^2
        """
    @property
    def position_covariances_px2(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2x2, px^2
        """
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, px
        """
    @property
    def predicted_positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, px: where the measurements are expected, after predict
        """
    @property
    def velocities(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, px per time unit
        """
    @property
    def velocity_covariances(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2x2, px^2 per time unit^2; zero for filters without one
        """
    @property
    def velocity_noises(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2x2, px^2 per time unit^3: what the velocities' covariances gain in a time unit by process noise; zero for
        kalman_ca with continuous noise, which is in the acceleration, and for filters without covariances.
        """

class Pipeline:
    """
    The whole system: frame in, tracks and events out. One object a camera.
    """
    @staticmethod
    def from_preset(name: str = "survtrack") -> Pipeline:
        """
        A pipeline with a preset's config.
        """
    def __init__(self, config: Config = ...) -> None:
        """
        Raises ConfigError.
        """
    def finish(self) -> list[FrameResult]:
        """
        The source has ended: the results still due. After it only reset() is allowed.
        """
    def learned_scene(self) -> str:
        """
        What was learned of the scene, as JSON: the law of sizes, the vicinity grids, the densities of beliefs.
        """
    def load_background(self, picture: typing.Any) -> None:
        """
        The picture to start from, with segmenter.model static_reference and source picture: HxW or HxWx3 (BGR) uint8 of
        the frames' size, copied. Before the first frame; it outlives reset(). Raises InputError.
        """
    def load_learned_scene(self, json: str, source: str = "scene") -> None:
        """
        Starts from what an earlier run learned; what this config does not use is left aside. Raises InputError,
        naming source and the entry, and then keeps its state.
        """
    def load_paths(self, paths: Paths) -> None:
        """
        The paths that filter.model kalman_path follows objects along; other filters leave them aside. reset() keeps
        them. Raises InputError when there are none, they are drawn on frames of another size, or frames were processed
        already.
        """
    def load_zones(self, zones: collections.abc.Sequence[Box]) -> None:
        """
        Where newcomers are looked for, boxes in px, with regions.acquisition zones; before the first frame. Kept by
        reset(). Raises InputError for none, for zones without size, and when the config has no use for them.
        """
    def process(
        self,
        frame: typing.Any,
        time_s: typing.SupportsFloat | typing.SupportsIndex,
        index: typing.SupportsInt | typing.SupportsIndex | None = None,
    ) -> typing.Any:
        """
        One frame on. frame: HxW (grey) or HxWx3 (BGR) uint8, one size for the whole run; time_s: increasing, in
        seconds; index: the frame's index in its source, increasing, counts on from the last by default.
        None while a delayed pipeline fills. Raises InputError and then keeps its state.
        """
    def relearn_background(self) -> None:
        """
        The scene changed: the background is learned anew from the coming frames.
        """
    def reset(self) -> None:
        """
        Forgets frames, tracks and all that was learned, but no picture that was loaded nor zones; the next frame is a
        first frame and ids start at 1.
        """
    @property
    def config(self) -> Config:
        """
        A copy of the config.
        """
    @property
    def delay_frames(self) -> int:
        """
        Frames by which results come late.
        """

class Detector:
    """
    The first half: frame in, detections out.
    """
    def __init__(self, config: Config = ...) -> None:
        """
        Raises ConfigError.
        """
    def finish(self) -> list[Detections]:
        """
        The rest of a delayed model. After it only reset() is allowed.
        """
    def load_background(self, picture: typing.Any) -> None:
        """
        The picture to start from, with segmenter.model static_reference and source picture: HxW or HxWx3 (BGR) uint8 of
        the frames' size, copied. Before the first frame; it outlives reset(). Raises InputError.
        """
    def process(
        self,
        frame: typing.Any,
        time_s: typing.SupportsFloat | typing.SupportsIndex,
        index: typing.SupportsInt | typing.SupportsIndex | None = None,
        *,
        keep: collections.abc.Sequence[Box] = [],
        regions: collections.abc.Sequence[Box] = [],
    ) -> typing.Any:
        """
        Frame in, detections out; None while a delayed model fills. Arguments as for Pipeline.process; keep: places
        that the background must not learn; regions: where to look, for models that can read parts; none: everywhere.
        """
    def relearn_background(self) -> None:
        """
        The scene changed: the background is learned anew from the coming frames.
        """
    def reset(self) -> None:
        """
        Forgets everything but a picture that was loaded.
        """
    @property
    def delay_frames(self) -> int:
        """
        Frames by which detections come late.
        """

class Tracker:
    """
    The second half: detections in, tracks out; for any detector's boxes.
    """
    def __init__(self, config: Config = ...) -> None:
        """
        Raises ConfigError.
        """
    def learned_scene(self) -> str:
        """
        What was learned of the scene, as JSON: the law of sizes, the vicinity grids, the densities of beliefs.
        """
    def load_learned_scene(self, json: str, source: str = "scene") -> None:
        """
        Starts from what an earlier run learned; what this config does not use is left aside. Raises InputError,
        naming source and the entry, and then keeps its state.
        """
    def load_paths(self, paths: Paths) -> None:
        """
        The paths that filter.model kalman_path follows objects along; other filters leave them aside. reset() keeps
        them. Raises InputError when there are none, they are drawn on frames of another size, or frames were processed
        already.
        """
    def load_zones(self, zones: collections.abc.Sequence[Box]) -> None:
        """
        Where newcomers are looked for, boxes in px, with regions.acquisition zones; before the first frame. Kept by
        reset(). Raises InputError for none, for zones without size, and when the config has no use for them.
        """
    def predict(
        self,
        time_s: typing.SupportsFloat | typing.SupportsIndex,
        *,
        frame_size: tuple[
            typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex
        ] = (0, 0),
    ) -> Expectation:
        """
        Moves all tracks on to the coming frame's time and says what is expected there. frame_size: (width, height) in
        px, needed for regions only; (0, 0): that of the frames before.
        """
    @typing.overload
    def process(self, detections: Detections) -> TrackingResult:
        """
        One frame on: predicts to detections.time_s, associates, updates.
        """
    @typing.overload
    def process(
        self, boxes: typing.Any, time_s: typing.SupportsFloat | typing.SupportsIndex
    ) -> TrackingResult:
        """
        The same with an Nx4 array: left, top, width, height in px.
        """
    def reset(self) -> None:
        """
        Forgets all tracks and all that was learned; ids start at 1 again.
        """
    def update(self, detections: Detections) -> TrackingResult:
        """
        The second step of process, after predict for the same time.
        """

class MeasuredTrack:
    """
    What was measured of one object, in order of time.
    """
    def __init__(
        self,
        times: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        lengths: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
    ) -> None:
        """
        times: N numbers that increase, in time units; positions: Nx2, px; lengths: N, the object's size in px as it was
        known before each, None: 1. Raises InputError.
        """
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...
    def stands_still(
        self,
        max_speed: typing.SupportsFloat | typing.SupportsIndex = 0.05,
        max_range: typing.SupportsFloat | typing.SupportsIndex = 0.3,
    ) -> bool:
        """
        Whether its slope is at most max_speed lengths per time unit and its range max_range lengths. Raises InputError.
        """
    @property
    def lengths(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        N, px; None: 1 each
        """
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Nx2, px
        """
    @property
    def times(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        N, time units
        """

class MeasurementRecorder:
    """
    Collects what was measured of the confirmed tracks of a run, frame by frame. Leaves out blobs that
    several tracks share, and detections that the frame's border cuts.
    """
    def __init__(
        self, config: Config, *, max_gap_s: typing.SupportsFloat | typing.SupportsIndex = 1.0
    ) -> None:
        """
        After a longer gap a track goes on as another one. Raises ConfigError, InputError.
        """
    @typing.overload
    def add(self, result: FrameResult) -> None:
        """
        Takes the result of one frame; frames come in order.
        """
    @typing.overload
    def add(self, result: TrackingResult, detections: Detections) -> None: ...
    def tracks(self, least: typing.SupportsInt | typing.SupportsIndex = 2) -> list[MeasuredTrack]:
        """
        Those of at least so many measurements; times in the config's time units, lengths the tracks' sizes before.
        """
    @property
    def at_border(self) -> int:
        """
        Left out: cut by the frame's border.
        """
    @property
    def shared(self) -> int:
        """
        Left out: blobs of several tracks.
        """
    @property
    def used(self) -> int:
        """
        Measurements taken.
        """

class NoiseEstimate:
    """
    A number found from data.
    """
    def __repr__(self) -> str: ...
    @property
    def standard_error(self) -> float:
        """
        0: it was given; inf: the data do not determine it.
        """
    @property
    def value(self) -> float: ...

class MeasurementNoise:
    """
    R, from objects that stand still.
    """
    @property
    def R(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2 covariance of a measured position, in squares of the noise unit.
        """
    @property
    def degrees(self) -> int:
        """
        Of freedom: samples less 2 a track.
        """
    @property
    def position_noise(self) -> NoiseEstimate:
        """
        Root of the mean variance: the option.
        """
    @property
    def samples(self) -> int: ...
    @property
    def standard_error(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        2x2, of each element of R, for Gaussian noise without memory.
        """

class FilterConsistency:
    """
    How well a filter fits measurements.
    """
    @property
    def correlation(self) -> float:
        """
        Of innovations with the next one of the track: 0 if they fit.
        """
    @property
    def correlation_limit(self) -> float:
        """
        Of its size, with probability 0.95 if they fit.
        """
    @property
    def log_likelihood(self) -> float: ...
    @property
    def nis_band(self) -> tuple[float, float]:
        """
        (low, high), with probability 0.95 if they fit.
        """
    @property
    def nis_mean(self) -> float:
        """
        Mean of y' S^-1 y: 2 if Q and R fit.
        """
    @property
    def steps(self) -> int:
        """
        Innovations: measurements after the first of each track.
        """

class ProcessNoise:
    """
    Q, by maximum likelihood.
    """
    @property
    def after(self) -> FilterConsistency:
        """
        The same with those found.
        """
    @property
    def before(self) -> FilterConsistency:
        """
        FilterConsistency with the options given.
        """
    @property
    def initial_acceleration(self) -> NoiseEstimate:
        """
        Of kalman_ca; 0 otherwise.
        """
    @property
    def initial_velocity(self) -> NoiseEstimate: ...
    @property
    def options(self) -> KalmanCvOptions | KalmanCaOptions:
        """
        Those given, with what was found.
        """
    @property
    def position_noise(self) -> NoiseEstimate: ...
    @property
    def process_noise(self) -> NoiseEstimate:
        """
        The option velocity_noise or acceleration_noise.
        """

def assign_hungarian(
    costs: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    unassigned_cost: typing.SupportsFloat | typing.SupportsIndex = ...,
) -> numpy.typing.NDArray[numpy.int64]:
    """
    Optimal one-to-one assignment. costs: rows x columns, inf where a pair is refused; unassigned_cost: cost of a row
    that stays alone; inf: as many pairs as possible. Returns the column of each row, -1 for none. Raises InputError.
    """

def assign_oldest_first(
    costs: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
) -> numpy.typing.NDArray[numpy.int64]:
    """
    Rows in order, each takes its cheapest free column (Narayana 2007, 3.5.4). costs: rows x columns, inf where
    a pair is refused. Returns the column of each row, -1 for none. Raises InputError.
    """

def chi_square_quantile(
    probability: typing.SupportsFloat | typing.SupportsIndex,
    degrees: typing.SupportsInt | typing.SupportsIndex,
) -> float:
    """
    What a sum of so many squared standard normal numbers stays below with this probability: 5.991 for 0.95 and 2.
    Raises InputError.
    """

def clean_mask(mask: typing.Any, options: CleanupOptions = ...) -> numpy.ndarray:
    """
    A mask (HxW uint8, 0 or 255) with its noise removed: median, opening, closing, tiles. The input is left
    alone. A temporal median has nothing to do with one mask: see Cleanup.
    """

def color_histogram(
    image: typing.Any, mask: typing.Any = None
) -> numpy.typing.NDArray[numpy.float32]:
    """
    What part of the pixels has which colour: 8x8x8 float32 over blue, green and red, 32 levels a bin, of sum 1. image:
    HxW or HxWx3 (BGR) uint8; mask: HxW uint8, pixels where it is 0 do not count; without any left all is 0. Raises
    InputError.
    """

def continuous_white_noise(
    dim: typing.SupportsInt | typing.SupportsIndex,
    dt: typing.SupportsFloat | typing.SupportsIndex,
    density: typing.SupportsFloat | typing.SupportsIndex = 1.0,
    *,
    axes: typing.SupportsInt | typing.SupportsIndex = 1,
    order: str = "by_axis",
) -> numpy.typing.NDArray[numpy.float64]:
    """
    Process noise Q over a step of dt, of continuous white noise of a spectral density in the first derivative that is
    not modelled: two steps of dt / 2 are one of dt (Bar-Shalom, Li and Kirubarajan 2001, 6.2). Arguments and errors
    as those of discrete_white_noise.
    """

def discrete_white_noise(
    dim: typing.SupportsInt | typing.SupportsIndex,
    dt: typing.SupportsFloat | typing.SupportsIndex,
    variance: typing.SupportsFloat | typing.SupportsIndex = 1.0,
    *,
    axes: typing.SupportsInt | typing.SupportsIndex = 1,
    order: str = "by_axis",
) -> numpy.typing.NDArray[numpy.float64]:
    """
    Process noise Q over a step of dt, of a highest derivative that is constant within a step and white from step to
    step (Bar-Shalom, Li and Kirubarajan 2001, 6.3). dim: 2 (position, velocity; the noise is the acceleration), 3 or
    4 derivatives; axes of them; order: by_axis (x, x', y, y') or by_derivative (x, y, x', y'). Raises InputError;
    dt is above 0 and at most 1e6.
    """

def falling_velocity_factor(
    difference: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    break_point: typing.SupportsFloat | typing.SupportsIndex,
) -> numpy.typing.NDArray[numpy.float64]:
    """
    The velocity factor of a belief (Narayana 2007, fig. 8.6): 2 - 1.8 min(difference / break_point, 1), from 2 to 0.2.
    difference: array of any shape, at least 0, in the unit of break_point (px per time unit), which is above 0.
    Returns an array of the same shape. Raises InputError.
    """

def filter_consistency(
    tracks: collections.abc.Sequence[MeasuredTrack], options: KalmanCvOptions | KalmanCaOptions
) -> FilterConsistency:
    """
    Runs the filter of KalmanCvOptions or KalmanCaOptions over MeasuredTracks, each from its first measurement, and
    tests its innovations. Raises InputError, ConfigError.
    """

def find_blobs(
    mask: typing.Any,
    frame: typing.Any = None,
    options: BlobOptions = ...,
    *,
    contours: bool = False,
    time_s: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    index: typing.SupportsInt | typing.SupportsIndex = 0,
) -> Detections:
    """
    The detections of a mask (HxW uint8, not 0 is foreground), with mean colours of `frame` (same size). For
    Tracker.process they need the frame's time in seconds, and may have its index in its source.
    """

def histogram_intersection(
    a: typing.Annotated[numpy.typing.ArrayLike, numpy.float32],
    b: typing.Annotated[numpy.typing.ArrayLike, numpy.float32],
) -> float:
    """
    The sum of the smaller parts of two color_histogram() (Swain and Ballard 1991): 1 for equal colours, 0 for none in
    common. Raises InputError for what is no histogram.
    """

def horn_schunck(
    previous: typing.Any,
    current: typing.Any,
    *,
    smoothness: typing.SupportsFloat | typing.SupportsIndex = 0.05,
    sweeps: typing.SupportsInt | typing.SupportsIndex = 100,
    tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    derivatives: str = "hs1981",
    initial: typing.Any = None,
    levels: typing.SupportsInt | typing.SupportsIndex = 1,
    warps: typing.SupportsInt | typing.SupportsIndex = 0,
) -> tuple[numpy.typing.NDArray[numpy.float32], numpy.typing.NDArray[numpy.float32]]:
    """
    Optical flow (u, v) from previous to current: how far each pixel moves to the right and down, px a frame
    pair, float32 HxW (Horn and Schunck, Determining optical flow, 1981). One thread.

    Each sweep gives every pixel, from the means of its neighbourhood,
    u = mean u - Ix (Ix mean u + Iy mean v + It) / (a^2 + Ix^2 + Iy^2), and v likewise, with grey levels in
    0 to 1 and the image's edges repeated. One level without warps is the method as published; more levels
    find movements of more than a pixel or two.

    Args:
        previous: HxW (grey) or HxWx3 (BGR, turned to grey) uint8.
        current: the later frame, of the same size.
        initial: a field (u, v) of the frames' size to start from, in place of zeros.
        smoothness: a: weight of a smooth field, for grey levels in 0 to 1; between 0.0001 and 1000
        sweeps: iterations, at most; after each warp; between 1 and 100000
        tolerance: no more sweeps when one changes nothing by as much; 0: never [px]; between 0 and 1000000
        derivatives: cubes of 2 x 2 x 2 as published, or Sobel's kernels; one of "hs1981" "sobel"
        levels: images of a pyramid, each half the size of the one before; 1: the image alone; between 1 and 30
        warps: times that the later frame is moved by the flow so far, at each level; 0: none at one level, 5 at more; between 0 and 1000

    Raises:
        InputError: frames or an initial field that do not fit, or are not finite.
        ConfigError: options out of their ranges, or more levels than the size has.
    """

@typing.overload
def identify_measurement_noise(
    still: collections.abc.Sequence[MeasuredTrack], noise_unit: str = "object_size"
) -> MeasurementNoise:
    """
    The covariance of the measured positions of objects that stand still about a straight line in time, one each.
    noise_unit: "object_size" divides by the tracks' lengths, "px" does not. Raises InputError for fewer than 3
    measurements of an object.
    """

@typing.overload
def identify_measurement_noise(
    positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    times: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
) -> MeasurementNoise:
    """
    The same of one object: Nx2 positions in px, at N times that increase (None: 0, 1, 2, ...).
    """

def identify_process_noise(
    tracks: collections.abc.Sequence[MeasuredTrack],
    options: KalmanCvOptions | KalmanCaOptions,
    *,
    fit_position_noise: bool = True,
) -> ProcessNoise:
    """
    Which noises of KalmanCvOptions or KalmanCaOptions maximise the likelihood of MeasuredTracks: the process noise,
    the deviations of a new track, and position_noise unless it is not to be fitted. Raises InputError for fewer
    than 10 steps, ConfigError.
    """

def iou(a: Box, b: Box) -> float:
    """
    Intersection over union of two boxes, 0 to 1.
    """

def learn_patterns(history: History, options: PatternOptions = ...) -> Patterns:
    """
    Groups tracks by the ways they go (Narayana 2007, 11.5). A track is described by points evenly spaced along
    its way; two go the same way when mean distance and angle are within the limits. The track with most like it
    leads the first group, of the rest again the one with most, and so on; then each track goes to the group whose
    mean way is nearest, until none changes. The order of the tracks does not matter; the time grows with the
    square of their number. Raises InputError naming track and frame index.
    """

def link_tracks(history: History, options: LinkOptions = ...) -> Linked:
    """
    Joins the pieces of broken tracks, then drops tracks that are too short (Narayana 2007, 11.2). A chain of
    pieces gets the id of its first; its gaps stay gaps. Raises InputError naming track and frame index.
    """

def match_matrix(
    tracks: collections.abc.Sequence[Track],
    detections: collections.abc.Sequence[Detection],
    frame_size: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
) -> numpy.typing.NDArray[numpy.float64]:
    """
    The match matrix of Narayana 2007, eq. 3.6: tracks x detections; frame_size is (width, height) in px.
    """

def nis_band(
    degrees: typing.SupportsInt | typing.SupportsIndex,
    count: typing.SupportsInt | typing.SupportsIndex,
    probability: typing.SupportsFloat | typing.SupportsIndex = 0.95,
) -> tuple[float, float]:
    """
    Bounds within which the mean of `count` NIS of so many degrees lies with this probability if the model fits
    (Bar-Shalom, Li and Kirubarajan 2001, 5.4.2). Raises InputError.
    """

def numeric_jacobian(
    function: collections.abc.Callable[..., typing.Any],
    x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
) -> numpy.typing.NDArray[numpy.float64]:
    """
    Derivative of function(x), which returns m numbers, at x (n numbers): m x n, by central differences. Raises
    InputError.
    """

def options_reference() -> str:
    """
    The reference of all options in Markdown.
    """

def order_free_beliefs(
    evidence: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
) -> numpy.typing.NDArray[numpy.float64]:
    """
    One row of the belief matrix (Narayana 2007, 8.3): the probabilities that a track is each of v blobs, and last that
    it is "lost"; they sum to 1. evidence: v x 4, a row a blob: the ratios p(observed | assigned) /
    p(observed | not assigned) of colour, position and size (1: not observed), and the falling velocity factor (1:
    none); 0 to 1e60. With the products w of a blob's four, b_i = w_i / (1 + sum of w), and 1 / (1 + sum of w) of
    "lost": Bayes' rule blob by blob with the velocity factor on the odds, whatever their order. Returns v + 1
    numbers. Raises InputError.
    """

def predicted_region(
    options: PredictedRegionsOptions,
    before: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
    position: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
    covariance_px2: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    box: Box,
    *,
    lost_s: typing.SupportsFloat | typing.SupportsIndex = 0.0,
) -> Box:
    """
    The part of the coming frame that must be read to see an object (O'Malley 2000, 4), a Box that is not cut to the
    frame. before: (x, y) in px in the frame before; position: the predicted one, with its 2x2 covariance; box: the
    object's at that position; lost_s: time since it was found last. Raises InputError.
    """

def predicted_region_on_path(
    options: PredictedRegionsOptions,
    path: Path,
    before: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
    place: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
    covariance_px2: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    size_px: tuple[
        typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex
    ],
    *,
    lost_s: typing.SupportsFloat | typing.SupportsIndex = 0.0,
) -> Box:
    """
    The same of an object on a path: before and place are (S, T) in px, covariance_px2 the 2x2 covariance of the
    predicted (S, T), size_px the (width, height) of its box. Raises InputError.
    """

def preset(name: str = "survtrack") -> Config:
    """
    The config of a preset.
    """

def preset_names() -> list[str]:
    """
    Names of the presets, the default one first.
    """

def preset_text(name: str) -> str:
    """
    A preset's TOML file: what differs from the defaults, with the reasons.
    """

def published_beliefs(
    evidence: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
) -> numpy.typing.NDArray[numpy.float64]:
    """
    The same as published: a row starts at 1 / (v + 1); blob after blob each ratio r makes its entry
    b' = r b / (r b + 1 - b) (eq. 8.13 to 8.17), the velocity factor f then min(f b', 1 - 1e-9), and after each step
    the other entries are multiplied by (1 - b') / (1 - b) (eq. 8.19). The order of the blobs matters as soon as there
    are velocity factors. Raises InputError.
    """

def rts_smooth(
    x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    Q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    Bu: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
    """
    States and covariances given the measurements of the whole run (Rauch, Tung and Striebel 1965). x (T x n) and P
    (T x n x n): those after each update; F and Q (n x n, or T x n x n): with which each step was predicted from the
    one before (the first is not used); Bu (n, or T x n): the control input, likewise. Returns x and P. Raises InputError.
    """

def systematic_resample(
    weights: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    offset: typing.SupportsFloat | typing.SupportsIndex,
) -> numpy.typing.NDArray[numpy.int64]:
    """
    Which of the weighted items systematic resampling draws, in order, as many as there are weights (Kitagawa 1996).
    offset: the one random number, in [0, 1). Raises InputError.
    """

def tiled_morphology(
    mask: typing.Any,
    *,
    rows: typing.SupportsInt | typing.SupportsIndex,
    columns: typing.SupportsInt | typing.SupportsIndex,
    overlap_px: typing.SupportsInt | typing.SupportsIndex,
    erode_px: typing.Any,
    dilate_px: typing.Any,
    shape: str = "square",
) -> numpy.ndarray:
    """
    Erosion, then dilation of a mask (HxW uint8, not 0 is foreground), tile by tile (Semko 2007).

    Args:
        rows, columns: of the grid, 1 to 1000; it need not divide the mask.
        overlap_px: by which a tile reads beyond its own part on each side; at least the reach of each tile,
            floor(erode_px / 2) + floor(dilate_px / 2).
        erode_px, dilate_px: edges of the elements, an integer or rows x columns of them; 0 to 255, even ones
            too: a pixel's offsets are -floor(k / 2) to k - 1 - floor(k / 2). 0 and 1 leave the step out.
        shape: "square", "cross" or "ellipse", as OpenCV's elements.

    Dilation is by the reflected element. What lies beyond the mask is neutral to both. Returns a new mask,
    0 or 255. Raises ConfigError for the grid and InputError for a mask too small for it.
    """

def velocity_factor(
    difference: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    break_point: typing.SupportsFloat | typing.SupportsIndex,
) -> numpy.typing.NDArray[numpy.float64]:
    """
    The velocity factor of a match-matrix entry (Narayana 2007, fig. 4.12): 1 / falling_velocity_factor, from 0.5 to 5.
    Arguments, result and errors are those of falling_velocity_factor.
    """

def wrapped_difference(
    difference: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    period: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
) -> typing.Any:
    """
    A difference, or an array of them, brought into [-period / 2, period / 2): the shorter way round. A period of 0
    leaves it alone. Raises InputError.
    """

__version__: str = "0.1.0"
