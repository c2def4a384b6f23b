# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Synthetic scenes through a config, and how far its estimates are from the truth."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.runner import results
from survtrack.scenes import Scene, Truth

if TYPE_CHECKING:
    from survtrack._core import Config, Detections, Event, FrameResult, TrackingResult

Floats = NDArray[np.float64]
NEAR_PX = 40.0  # a track is that of an object when it first comes this near
# The centroid of a blob counts pixels by their index; the truth has their edges at whole numbers.
TO_EDGES = 0.5


@dataclass(frozen=True, eq=False)
class Seen:
    """What one frame left.

    positions: (x, y) of each reported track, by its id, px, as the truth counts.
    variances_px2: of their x, alike.
    detected: (x, y) of each detection, largest first.
    """

    index: int
    positions: Mapping[int, tuple[float, float]]
    variances_px2: Mapping[int, float]
    detected: Sequence[tuple[float, float]]
    events: Sequence["Event"]


def of_masks(scene: Scene, config: "Config") -> list[Seen]:
    """The scene's masks through blobs and tracker: the segmentation is perfect."""
    tracker = survtrack.Tracker(config)

    def answers() -> Iterator[Seen]:
        for index, time_s, mask in scene.frames("mask"):
            found = survtrack.find_blobs(mask, None, config.blobs, time_s=time_s, index=index)
            yield _seen(tracker.process(found), found, TO_EDGES)

    return list(answers())


def of_video(scene: Scene, config: "Config") -> list[Seen]:
    """The scene's video through the whole pipeline."""
    answers = results(scene.frames("video"), survtrack.Pipeline(config))
    return [_seen(result, result.detections, TO_EDGES) for result in answers]


def of_measurements(scene: Scene, config: "Config", sigma_px: float) -> list[Seen]:
    """True positions with Gaussian noise through the tracker, as boxes of the objects' size."""
    sides = {
        thing.id: np.array([thing.body.width_px, thing.body.height_px]) for thing in scene.objects
    }
    tracker = survtrack.Tracker(config)
    seen = []
    for index, time_s, measured in scene.measurements(sigma_px):
        boxes = [[*(np.array(at) - sides[id] / 2), *sides[id]] for id, at in measured.items()]
        found = survtrack.Detections(
            np.array(boxes).reshape(-1, 4), time_s, index=index, frame_size=scene.size
        )
        seen.append(_seen(tracker.process(found), found, 0.0))
    return seen


def _seen(
    result: "TrackingResult | FrameResult", detections: "Detections", shift_px: float
) -> Seen:
    def placed(at: tuple[float, float]) -> tuple[float, float]:
        return at[0] + shift_px, at[1] + shift_px

    reported = [track for track in result.tracks if track.reported]
    largest = sorted(detections, key=lambda one: -one.area_px)
    return Seen(
        result.index,
        {track.id: placed(track.position) for track in reported},
        {track.id: float(track.position_covariance_px2[0, 0]) for track in reported},
        [placed(one.position) for one in largest],
        list(result.events),
    )


@dataclass(frozen=True, eq=False)
class Followed:
    """One object and the track that is its.

    id, track_id: of the object; of the first track that came near, None without any.
    indices: (N,) frames of the scene in which the object is there.
    truth: (N, 2) its centre, px.
    velocity: (N, 2) its velocity, px per frame.
    estimate: (N, 2) the track's position; NaN where it is not reported.
    """

    id: int
    track_id: int | None
    indices: NDArray[np.int64]
    truth: Floats
    velocity: Floats
    estimate: Floats

    @property
    def norms(self) -> Floats:
        """(N,) length of truth - estimate, px."""
        return np.asarray(np.hypot(*(self.truth - self.estimate).T))

    @property
    def start(self) -> int | None:
        """Row of the first estimate."""
        known = np.flatnonzero(np.isfinite(self.norms))
        return int(known[0]) if known.size else None

    def settled_after(self, limit_px: float = 1.0) -> int | None:
        """Frames from the first estimate until the norm stays under the limit; None: it never does.

        A frame of the object without an estimate, after the first, is over the limit.
        """
        if self.start is None:
            return None
        norms = np.nan_to_num(self.norms[self.start :], nan=np.inf)
        over = np.flatnonzero(norms >= limit_px)
        after = int(over[-1]) + 1 if over.size else 0
        return after if after < len(norms) else None

    def rms_px(self, after_frames: int = 0) -> float:
        """Root of the mean square of the norm, so many frames after the first estimate on."""
        return rms(self.norms[(self.start or 0) + after_frames :])

    def lag(self) -> tuple[float, float, float]:
        """What is left of the error when a constant delay is taken off.

        Returns:
            (delay in frames, bias across the way in px to its right, rms of the rest in px) by
            least squares over all estimates; NaN without any.
        """
        known = np.isfinite(self.norms) & (np.hypot(*self.velocity.T) > 0)
        if not known.any():
            return float("nan"), float("nan"), float("nan")
        error, velocity = (self.estimate - self.truth)[known], self.velocity[known]
        delay = -float((error * velocity).sum() / (velocity * velocity).sum())
        rest = error + delay * velocity
        right = np.stack([-velocity[:, 1], velocity[:, 0]], axis=1)
        right /= np.hypot(*velocity.T)[:, None]
        return delay, float((rest * right).sum(axis=1).mean()), rms(np.hypot(*rest.T))


def rms(values: Floats) -> float:
    """Root of the mean square of those that are numbers; NaN without any."""
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known * known))) if known.size else float("nan")


def follow(scene: Scene, seen: Sequence[Seen]) -> list[Followed]:
    """Every object of a scene, and its track. A track belongs to the first object it met."""
    truth = scene.truth()
    taken: dict[int, int] = {}
    for one in seen:
        _take(truth.at(one.index), one, taken)
    answers = {one.index: one for one in seen}
    return [_followed(truth.of(id), id, taken.get(id), answers) for id in sorted(set(truth.ids))]


def _take(truth: Truth, seen: Seen, taken: dict[int, int]) -> None:
    """Give the nearest free track to each object that has none yet."""
    for id, at in zip(truth.ids.tolist(), truth.positions, strict=True):
        free = {
            track: float(np.hypot(*(at - there)))
            for track, there in seen.positions.items()
            if track not in taken.values()
        }
        nearest = min(free, key=free.__getitem__, default=None)
        if id not in taken and nearest is not None and free[nearest] < NEAR_PX:
            taken[id] = nearest


def _followed(truth: Truth, id: int, track: int | None, seen: Mapping[int, Seen]) -> Followed:
    nowhere = (float("nan"), float("nan"))
    estimate = [
        seen[k].positions.get(track, nowhere) if k in seen and track is not None else nowhere
        for k in truth.indices.tolist()
    ]
    period_s = float(np.diff(truth.times_s).min()) if len(truth) > 1 else 0.0
    velocity = truth.velocities_px_per_s * period_s
    return Followed(
        int(id), track, truth.indices, truth.positions, velocity, np.array(estimate).reshape(-1, 2)
    )
