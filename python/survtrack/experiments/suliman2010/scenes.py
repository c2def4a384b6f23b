# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One contact on synthetic scenes: its marker, and the flow's centroid beside the estimate."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.following import Followed, Seen, follow, of_masks, of_video, rms
from survtrack.experiments.semko2007.trials import SIZE, Trial, trials
from survtrack.scenes import Scene, make_scene

PRESET = "suliman2010"
VISIBLE = 0.25  # less of a contact cannot be asked for

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Reentry:
    """A contact that leaves and comes back.

    Attributes:
        indices, positions, boxes, visible: of the truth, a row a frame.
        markers: (N, 2) of the only track, NaN where it is not reported.
        track_ids: all that were ever reported.
        left, back: first frame in which less than VISIBLE is seen, and the first after with more.
    """

    indices: NDArray[np.int64]
    positions: Floats
    boxes: Floats
    visible: Floats
    markers: Floats
    track_ids: set[int]
    left: int
    back: int

    @property
    def on_contact(self) -> NDArray[np.bool_]:
        """Of each row, whether the marker is in the contact's box."""
        low, high = self.boxes[:, :2], self.boxes[:, :2] + self.boxes[:, 2:]
        return np.asarray(((self.markers >= low) & (self.markers <= high)).all(axis=1))

    @property
    def given_again_after(self) -> int | None:
        """Frames from the return until the marker is on the contact; None: never."""
        hits = np.flatnonzero(self.on_contact & (self.indices >= self.back))
        return int(self.indices[hits[0]]) - self.back if hits.size else None

    def share(self, after: bool) -> float:
        """Part of the frames before it leaves, or after it is back, with the marker on it."""
        seen = self.visible >= VISIBLE
        kept = seen & ((self.indices >= self.back) if after else (self.indices < self.left))
        marked = kept & np.isfinite(self.markers[:, 0])
        first = int(self.indices[marked][0]) if marked.any() else 0
        kept &= self.indices >= first
        return float(self.on_contact[kept].mean()) if kept.any() else 0.0


@dataclass(frozen=True)
class Compared:
    """The flow's own centroid and the filter's estimate, both against the truth.

    Attributes:
        frames: in which both are known.
        centroid_px, estimate_px: rms of the distance to the true centre.
        centroid_lag, estimate_lag: delay in frames of each.
        centroid_rest_px, estimate_rest_px: rms of what is left without that delay.
    """

    frames: int
    centroid_px: float
    estimate_px: float
    centroid_lag: float
    estimate_lag: float
    centroid_rest_px: float
    estimate_rest_px: float


@dataclass(frozen=True, eq=False)
class Made:
    """All synthetic runs; errors: (N, 3) frame, centroid's, estimate's, by key."""

    trials: list[Trial]
    compared: dict[str, Compared]
    errors: dict[str, Floats]
    reentries: dict[str, Reentry]


def reentry_scene() -> Scene:
    """One that crosses the frame, is away for 2 s, and comes back."""
    return make_scene("reentry", size=SIZE, frame_count=240, width_px=28.0, height_px=56.0)


def scenes() -> list[Trial]:
    """Those in which the centroid and the estimate are compared."""
    return [trial for trial in trials() if len(trial.scene.objects) == 1]


def measure(tick: Callable[[int], None]) -> Made:
    """Run everything; `tick` gets the number of frames of each run."""
    config = survtrack.preset(PRESET)
    compared, errors, reentries = {}, {}, {}
    for trial in scenes():
        seen = of_video(trial.scene, config)
        compared[trial.key], errors[trial.key] = compare(trial.scene, seen)
        tick(trial.scene.frame_count)
    scene = reentry_scene()
    for way, run in (("masks", of_masks), ("flow", of_video)):
        reentries[way] = reenter(scene, run(scene, config))
        tick(scene.frame_count)
    return Made(scenes(), compared, errors, reentries)


def frames() -> int:
    """Of all runs."""
    return sum(trial.scene.frame_count for trial in scenes()) + 2 * reentry_scene().frame_count


def compare(scene: Scene, seen: list[Seen]) -> tuple[Compared, Floats]:
    """The only blob's centroid and the estimate, in frames with both; of one contact."""
    [followed] = follow(scene, seen)
    nowhere = (float("nan"), float("nan"))
    found = {one.index: one.detected[0] if one.detected else nowhere for one in seen}
    centroid = np.array([found.get(k, nowhere) for k in followed.indices.tolist()])
    both = np.isfinite(centroid).all(axis=1) & np.isfinite(followed.norms)
    ways = [
        Followed(
            followed.id,
            followed.track_id,
            followed.indices[both],
            followed.truth[both],
            followed.velocity[both],
            estimate[both],
        )
        for estimate in (centroid, followed.estimate)
    ]
    (lag, _, rest), (filter_lag, _, filter_rest) = (way.lag() for way in ways)
    errors = np.stack([ways[0].indices, ways[0].norms, ways[1].norms], axis=1)
    figures = Compared(
        int(both.sum()), rms(errors[:, 1]), rms(errors[:, 2]), lag, filter_lag, rest, filter_rest
    )
    return figures, errors


def reenter(scene: Scene, seen: list[Seen]) -> Reentry:
    """What became of the marker in a scene of one contact that leaves and comes back."""
    truth = scene.truth()
    nowhere = (float("nan"), float("nan"))
    answers = {one.index: one for one in seen}
    markers = [
        next(iter(answers[k].positions.values()), nowhere) if k in answers else nowhere
        for k in truth.indices.tolist()
    ]
    there = truth.visible >= VISIBLE
    came = int(np.flatnonzero(there)[0])
    left = came + int(np.flatnonzero(~there[came:])[0])
    back = left + int(np.flatnonzero(there[left:])[0])
    return Reentry(
        truth.indices,
        truth.positions,
        truth.boxes,
        truth.visible,
        np.array(markers),
        {id for one in seen for id in one.positions},
        int(truth.indices[left]),
        int(truth.indices[back]),
    )
