# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The judge of tracks: HOTA, CLEAR MOT, identity scores and counts of errors in one call."""

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from survtrack.errors import InputError, UsageError
from survtrack.evaluation.boxes import MAX_INTEGER, Boxes
from survtrack.evaluation.clear import Clear, clear_scores
from survtrack.evaluation.comparison import compare
from survtrack.evaluation.counts import count_errors
from survtrack.evaluation.files import StrPath
from survtrack.evaluation.footage import (
    RUN_FILE,
    frame_scale,
    given_range,
    given_scale,
    processed_frames,
)
from survtrack.evaluation.hota import Hota, hota_scores
from survtrack.evaluation.identity import Identity, identity_scores
from survtrack.evaluation.readers import read_boxes
from survtrack.evaluation.scores import score, score_key


def _percent(key: str, meaning: str) -> Any:
    return score(meaning, key, percent=True)


@dataclass(frozen=True)
class TrackScores:
    """Scores of tracks against truth. Those named as in papers are percentages, 0 to 100.

    (MOTA can be negative.) Formulas and sources: modules hota, clear, identity and counts.
    """

    hota: float = _percent("HOTA", "higher order tracking accuracy")
    det_a: float = _percent("DetA", "detection accuracy")
    ass_a: float = _percent("AssA", "association accuracy")
    det_re: float = _percent("DetRe", "detection recall")
    det_pr: float = _percent("DetPr", "detection precision")
    ass_re: float = _percent("AssRe", "association recall")
    ass_pr: float = _percent("AssPr", "association precision")
    loc_a: float = _percent("LocA", "localisation accuracy")
    mota: float = _percent("MOTA", "multiple object tracking accuracy")
    motp: float = _percent("MOTP", "mean IoU of the matches")
    idf1: float = _percent("IDF1", "identity F1")
    idp: float = _percent("IDP", "identity precision")
    idr: float = _percent("IDR", "identity recall")
    id_switches: int = score("changes of an object's identity", "switches")
    fragments: int = score("times that the tracking of an object resumes")
    true_positives: int = score("output boxes that match the truth")
    false_positives: int = score("output boxes that match nothing")
    misses: int = score("truth boxes that nothing matches")
    mostly_tracked: int = score("objects matched in more than 80 % of their frames")
    partly_tracked: int = score("objects in between")
    mostly_lost: int = score("objects matched in less than 20 % of their frames")
    number_of_blobs_errors: int = score("outputs on an object beyond one, or none")
    index_errors: int = score("truth boxes found without the object's best number")
    swap_errors: int = score("changes of the number that stands for an object")
    truth_boxes: int = score("boxes to find")
    truth_ids: int = score("objects to find")
    output_boxes: int = score("boxes that are scored")
    output_ids: int = score("identities that are scored")
    ignored_outputs: int = score("boxes not scored: they match don't-care truth")
    frames: int = score("frames that are scored")
    first_frame: int = score("the first of them, in the tracks' numbering")
    last_frame: int = score("the last of them")
    offset: int = score("from a frame's number to the truth's")
    iou: float = score("overlap from which a box matches")
    scale_x: float = score("the truth's boxes were scaled by this across")
    scale_y: float = score("and by this down")

    def to_dict(self) -> dict[str, float | int]:
        """The scores by their published names (HOTA, IDF1, ...), the others by the fields'."""
        return {score_key(entry): getattr(self, entry.name) for entry in fields(self)}


def evaluate_tracks(
    truth: StrPath | Boxes,
    tracks: StrPath | Boxes,
    *,
    frames: tuple[int, int] | None = None,
    offset: int = 0,
    iou: float = 0.5,
    scale: tuple[float, float] | None = None,
) -> TrackScores:
    """Score tracks against truth; equal to TrackEval in every score that it has too.

    Args:
        truth: a file of MOT text or CVML, or boxes. Boxes marked `ignore` (CVML: inactive) are
            don't-care: outputs matched to them, at the same `iou`, are removed first; the counts
            of number-of-blobs, index and swap errors go by coverage instead (module counts).
        tracks: a file of MOT text, or boxes.
        frames: the first and last frame to score, in the tracks' numbering from 1. None: the
            frames that a `run.json` beside the tracks' file lists as processed; without one, all
            from frame 1 to the last that truth or tracks have.
        offset: frame f of the tracks is scored against frame f + offset of the truth, both
            counted from 1.
        iou: from 0 (excluded) to 1, the overlap from which a box matches, for the CLEAR and
            identity scores. HOTA averages over 19 thresholds of its own.
        scale: the truth's boxes are scaled by this, across and down. None: as a `run.json` beside
            the tracks' file says that the frames were (--resize); without one (1, 1).

    Raises:
        InputError: a file that cannot be used, an empty truth, tracks in frames that their
            `run.json` does not list.
        UsageError: frames, offset, iou or scale outside their range.
    """
    if not 0 < iou <= 1:
        raise UsageError(f"iou {iou}: must be above 0 and at most 1")
    if not abs(offset) <= MAX_INTEGER:
        raise UsageError(f"offset {offset}: must be within +-{MAX_INTEGER}")
    chosen = None if frames is None else given_range(frames, lowest=1)
    right = truth if isinstance(truth, Boxes) else read_boxes(truth, truth=True)
    judged = tracks if isinstance(tracks, Boxes) else read_boxes(tracks)
    if judged.ignore.any():
        raise InputError("boxes of the tracks are marked `ignore`; only truth can be don't-care")
    if scale is None:
        scale = (1.0, 1.0) if isinstance(tracks, Boxes) else _told_scale(Path(tracks))
    right = right if scale == (1.0, 1.0) else right.scaled(given_scale(scale))
    if chosen is None and not isinstance(tracks, Boxes):
        chosen = _listed_frames(Path(tracks), judged)
    if chosen is None:
        ends = [0, *(judged.frames.max(initial=0), right.frames.max(initial=0) - offset)]
        chosen = range(1, int(max(ends)) + 1)
    return _scores(right, judged, chosen, offset, iou, scale)


def _told_scale(tracks: Path) -> tuple[float, float]:
    """How much the run which wrote the tracks has scaled its frames, when it left word of it."""
    run_file = tracks.parent / RUN_FILE
    return frame_scale(run_file) if run_file.exists() else (1.0, 1.0)


def _listed_frames(tracks: Path, boxes: Boxes) -> range | None:
    """The frames that the run which wrote the tracks has processed, when it left word of them."""
    run_file = tracks.parent / RUN_FILE
    if not run_file.exists():
        return None
    listed = processed_frames(run_file)
    strange = [frame for frame in np.unique(boxes.frames).tolist() if frame not in listed]
    if strange:
        raise InputError(
            f"{tracks}: has boxes in frame {strange[0]}, which {run_file} does not list as "
            "processed; name the frames to score (--frames A-B)"
        )
    return listed


def _scores(
    truth: Boxes,
    tracks: Boxes,
    frames: range,
    offset: int,
    iou: float,
    scale: tuple[float, float],
) -> TrackScores:
    comparison = compare(truth, tracks, frames=frames, offset=offset, iou=iou)
    return TrackScores(
        **_percentages(hota_scores(comparison)),
        **_percentages(clear_scores(comparison, iou)),
        **_percentages(identity_scores(comparison, iou)),
        **vars(count_errors(truth, tracks, frames=frames, offset=offset)),
        truth_boxes=comparison.truth_boxes,
        truth_ids=comparison.truth_ids,
        output_boxes=comparison.output_boxes,
        output_ids=comparison.output_ids,
        ignored_outputs=comparison.ignored_outputs,
        frames=len(frames),
        first_frame=frames.start,
        last_frame=frames.start + (len(frames) - 1) * frames.step,
        offset=offset,
        iou=iou,
        scale_x=scale[0],
        scale_y=scale[1],
    )


def _percentages(part: Hota | Clear | Identity) -> dict[str, Any]:
    """The fields of a score's parts, fractions as percentages, counts as they are."""
    return {
        name: 100 * value if isinstance(value, float) else value
        for name, value in vars(part).items()
    }
