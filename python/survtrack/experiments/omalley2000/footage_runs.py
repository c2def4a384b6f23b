# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Real footage read in regions: how many pixels, what is found, and what it costs."""

from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation import TrackScores, evaluate_tracks
from survtrack.evaluation.overlap import iou_matrix
from survtrack.experiments.footage import Footage
from survtrack.experiments.trial import Variant, boxes_of, results_of

if TYPE_CHECKING:
    from survtrack._core import FrameResult

SAME_IOU = 0.5
_PREDICTED = "regions.model=predicted"
VARIANTS = {
    "whole frame": Variant("survtrack", in_frames=False),
    "1 sigma": Variant(
        "survtrack",
        (_PREDICTED, "regions.sigmas_along=1", "regions.sigmas_across=1"),
        in_frames=False,
    ),
    "2 sigmas": Variant(
        "survtrack",
        (_PREDICTED, "regions.sigmas_along=2", "regions.sigmas_across=2"),
        in_frames=False,
    ),
    "3 sigmas": Variant("survtrack", (_PREDICTED,), in_frames=False),
    "3 sigmas, border for newcomers": Variant(
        "survtrack",
        (_PREDICTED, "regions.acquisition=border", "regions.refresh_frames=20"),
        in_frames=False,
    ),
    "fixed box": Variant(
        "survtrack",
        (
            _PREDICTED,
            "regions.sigmas_along=0",
            "regions.sigmas_across=0",
            "regions.whole_object=false",
            "regions.margin=0.75",
            "regions.growth=0",
        ),
        in_frames=False,
    ),
}


@dataclass(frozen=True, eq=False)
class FootageRun:
    """What one way of reading gave.

    Attributes:
        pixels: part of all pixels that was read.
        areas_px: of each predicted region.
        held, followed: objects wholly inside the region of their track, of so many.
        found: part of the whole frame's reported boxes that this run reports too, IoU 0.5.
        tracks: number of identities.
        frame_ms: processor time of a frame in the pipeline; never the same twice.
        scores: against the truth; None without.
    """

    pixels: float
    areas_px: NDArray[np.float64]
    held: int
    followed: int
    found: float
    tracks: int
    frame_ms: float
    scores: TrackScores | None

    @property
    def hit_rate(self) -> float:
        """Whole object inside; NaN where no region was predicted."""
        return self.held / self.followed if self.followed else float("nan")

    def facts(self) -> dict[str, Any]:
        """As results.json holds them."""
        return {
            "pixels": self.pixels,
            "area_px": float(self.areas_px.mean()) if self.areas_px.size else None,
            "area_deviation_px": float(self.areas_px.std()) if self.areas_px.size else None,
            "hit_rate": self.hit_rate if self.followed else None,
            "followed": self.followed,
            "found": self.found,
            "tracks": self.tracks,
            "frame_ms": self.frame_ms,
            "scores": None if self.scores is None else self.scores.to_dict(),
        }


@dataclass(frozen=True, eq=False)
class Read:
    """All ways of reading one set, by the names in VARIANTS."""

    name: str
    objects: str
    frames: int
    runs: dict[str, FootageRun]


def measure(footage: Footage, tick: Callable[[], None]) -> Read:
    """Run all variants on a set."""
    runs: dict[str, FootageRun] = {}
    reference: list[FrameResult] | None = None
    for name, variant in VARIANTS.items():
        began = process_time()
        answers = list(results_of(footage, variant.config(footage.frame_period_s)))
        frame_ms = 1e3 * (process_time() - began) / len(answers)
        reference = reference or answers
        runs[name] = _run(footage, answers, reference, frame_ms)
        tick()
    return Read(footage.dataset.name, footage.dataset.objects, len(footage.frames), runs)


def _run(
    footage: Footage, answers: "list[FrameResult]", whole: "list[FrameResult]", frame_ms: float
) -> FootageRun:
    pixels = footage.size[0] * footage.size[1] * len(answers)
    areas = [
        region.box.area_px
        for result in answers
        for region in result.regions
        if region.kind.name == "predicted"
    ]
    held, followed = _held(answers, whole)
    scores = None
    if len(footage.truth.ids):
        scores = evaluate_tracks(footage.truth, boxes_of(iter(answers)), frames=(1, len(answers)))
    return FootageRun(
        sum(result.pixels_read for result in answers) / pixels,
        np.array(areas),
        held,
        followed,
        _found(answers, whole),
        len({track.id for result in answers for track in result.tracks if track.reported}),
        frame_ms,
        scores,
    )


def _boxes(result: "FrameResult", seen: bool) -> tuple[list[int], NDArray[np.float64]]:
    """Ids and boxes of the tracks that are reported, or only of those that are seen."""
    tracks = [
        track
        for track in result.tracks
        if track.reported and (not seen or track.status.name == "confirmed")
    ]
    boxes = np.array([list(track.box) for track in tracks], dtype=np.float64).reshape(-1, 4)
    return [track.id for track in tracks], boxes


def _found(answers: "list[FrameResult]", whole: "list[FrameResult]") -> float:
    found = total = 0
    for ours, theirs in zip(answers, whole, strict=True):
        _, wanted = _boxes(theirs, seen=True)
        _, there = _boxes(ours, seen=False)
        total += len(wanted)
        if len(wanted) and len(there):
            found += int((iou_matrix(wanted, there) > SAME_IOU).any(axis=1).sum())
    return found / total if total else float("nan")


def _held(answers: "list[FrameResult]", whole: "list[FrameResult]") -> tuple[int, int]:
    """Objects of the whole frame's run inside the region of the track that followed them before."""
    held = followed = 0
    same: dict[int, int] = {}
    for ours, theirs in zip(answers, whole, strict=True):
        ids, boxes = _boxes(theirs, seen=True)
        at = dict(zip(ids, boxes, strict=True))
        for region in ours.regions:
            box = at.get(same.get(region.track_id, 0)) if region.track_id else None
            if region.kind.name != "predicted" or box is None:
                continue
            followed += 1
            # To a pixel, and as far as it can be seen.
            x, y, width, height = box
            right = min(x + width, ours.frame.shape[1])
            bottom = min(y + height, ours.frame.shape[0])
            held += bool(
                max(x, 0) >= region.box.x - 1
                and max(y, 0) >= region.box.y - 1
                and right <= region.box.right + 1
                and bottom <= region.box.bottom + 1
            )
        same = _same(ours, ids, boxes)
    return held, followed


def _same(ours: "FrameResult", ids: list[int], boxes: NDArray[np.float64]) -> dict[int, int]:
    """Which of the whole frame's tracks each of ours is."""
    mine, where = _boxes(ours, seen=True)
    if not mine or not ids:
        return {}
    overlap = iou_matrix(where, boxes)
    return {
        one: ids[int(row.argmax())]
        for one, row in zip(mine, overlap, strict=True)
        if row.max() > SAME_IOU
    }
