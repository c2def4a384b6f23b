# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Scores worked by hand, and which frames and boxes they are made over."""

import dataclasses
import json
import math
from pathlib import Path

import pytest

from survtrack.errors import InputError, UsageError
from survtrack.evaluation import Boxes, TrackScores, evaluate_tracks

BOX = [10.0, 20.0, 30.0, 40.0]


def one_object(frames: range, ids: list[int] | None = None) -> Boxes:
    """The same box in every frame."""
    return Boxes(list(frames), ids or [1] * len(frames), [BOX] * len(frames))


def write_mot(path: Path, boxes: Boxes) -> Path:
    rows = zip(boxes.frames.tolist(), boxes.ids.tolist(), boxes.boxes.tolist(), strict=True)
    lines = [f"{frame},{name},{','.join(map(str, box))},1,-1,-1,-1\n" for frame, name, box in rows]
    path.write_text("".join(lines), encoding="ascii")
    return path


def write_run(folder: Path, **frames: object) -> Path:
    path = folder / "run.json"
    path.write_text(json.dumps({"complete": True, "frames": frames}), encoding="utf-8")
    return path


def test_perfect_tracks() -> None:
    truth = one_object(range(1, 11))
    scores = evaluate_tracks(truth, truth)
    assert scores.hota == scores.det_a == scores.ass_a == pytest.approx(100)
    assert scores.mota == scores.idf1 == scores.idp == scores.idr == 100
    assert (scores.id_switches, scores.fragments, scores.misses, scores.false_positives) == (0,) * 4
    assert (scores.mostly_tracked, scores.frames, scores.first_frame, scores.last_frame) == (
        (1, 10, 1, 10)
    )


def test_an_identity_that_changes_halfway() -> None:
    """Each match shares 2 of 4 boxes: AssA 1/2, HOTA sqrt(1/2); IDF1 2*2/8; one switch of 4."""
    scores = evaluate_tracks(one_object(range(1, 5)), one_object(range(1, 5), [1, 1, 2, 2]))
    assert scores.det_a == pytest.approx(100)
    assert scores.ass_a == pytest.approx(50)
    assert scores.ass_re == pytest.approx(50)
    assert scores.ass_pr == pytest.approx(100)
    assert scores.hota == pytest.approx(100 * math.sqrt(0.5))
    assert scores.mota == 75
    assert scores.idf1 == 50
    assert (scores.id_switches, scores.fragments) == (1, 0)


def test_an_overlap_of_one_half_counts_up_to_alpha_one_half() -> None:
    """A box shifted by a third of its width has IoU 1/2: 10 of the 19 thresholds accept it."""
    truth = Boxes([1], [1], [[0, 0, 30, 10]])
    tracks = Boxes([1], [1], [[10, 0, 30, 10]])
    scores = evaluate_tracks(truth, tracks)
    assert scores.hota == pytest.approx(100 * 10 / 19)
    assert scores.mota == 100
    assert scores.motp == 50
    assert evaluate_tracks(truth, tracks, iou=0.51).mota == -100  # a miss and a false positive


def test_a_gap_is_a_fragment_and_not_a_switch() -> None:
    """5 of 9 boxes found (partly tracked), the other object keeps the gap's frames alive."""
    truth = Boxes(
        [*range(1, 10), *range(1, 10)], [1] * 9 + [2] * 9, [BOX] * 9 + [[200, 20, 30, 40]] * 9
    )
    found = [1, 2, 6, 7, 9]
    tracks = Boxes([*found, *range(1, 10)], [5] * 5 + [6] * 9, [BOX] * 5 + [[200, 20, 30, 40]] * 9)
    scores = evaluate_tracks(truth, tracks)
    assert (scores.fragments, scores.id_switches, scores.misses) == (2, 0, 4)
    assert (scores.mostly_tracked, scores.partly_tracked, scores.mostly_lost) == (1, 1, 0)
    assert scores.mota == pytest.approx(100 * 14 / 18)


def test_outputs_on_ignored_truth_are_not_scored() -> None:
    truth = Boxes([1, 1], [1, 2], [BOX, [200, 20, 30, 40]], [False, True])
    tracks = Boxes([1, 1, 1], [1, 2, 3], [BOX, [201, 20, 30, 40], [199, 20, 30, 40]])
    scores = evaluate_tracks(truth, tracks)
    assert (scores.truth_boxes, scores.output_boxes, scores.ignored_outputs) == (1, 2, 1)
    assert (scores.false_positives, scores.misses) == (1, 0)  # matching is one to one
    assert evaluate_tracks(truth, tracks, iou=0.99).ignored_outputs == 0


def test_offset_shifts_the_truth() -> None:
    truth, tracks = one_object(range(237, 247)), one_object(range(1, 11))
    scores = evaluate_tracks(truth, tracks, offset=236)
    assert scores.mota == 100
    assert (scores.frames, scores.first_frame, scores.last_frame) == (10, 1, 10)
    assert evaluate_tracks(tracks, truth, offset=-236).mota == 100


def test_truth_before_the_first_frame_of_the_tracks_does_not_count() -> None:
    scores = evaluate_tracks(one_object(range(1, 21)), one_object(range(1, 11)), offset=10)
    assert (scores.truth_boxes, scores.misses, scores.frames) == (10, 0, 10)


def test_frames_are_inclusive_and_in_the_numbering_of_the_tracks() -> None:
    truth, tracks = one_object(range(101, 121)), one_object(range(1, 11))
    scores = evaluate_tracks(truth, tracks, offset=100, frames=(9, 12))
    assert (scores.truth_boxes, scores.output_boxes, scores.misses) == (4, 2, 2)
    assert (scores.frames, scores.first_frame, scores.last_frame) == (4, 9, 12)


def test_only_frames_that_the_run_processed_count(tmp_path: Path) -> None:
    truth = write_mot(tmp_path / "gt.txt", one_object(range(1, 101)))
    run = tmp_path / "run"
    run.mkdir()
    tracks = write_mot(run / "tracks.txt", one_object(range(11, 20, 4)))
    assert evaluate_tracks(truth, tracks).truth_boxes == 100
    write_run(run, first=11, last=19, step=4, count=3)
    scores = evaluate_tracks(truth, tracks)
    assert (scores.truth_boxes, scores.mota, scores.frames) == (3, 100, 3)
    assert (scores.first_frame, scores.last_frame) == (11, 19)
    assert evaluate_tracks(truth, tracks, frames=(11, 19)).misses == 6  # named frames all count


@pytest.mark.parametrize(
    ("frames", "message"),
    [
        ({"first": 1, "last": 10, "step": 1}, 'no "frames" with first, last, step and count'),
        ({"first": 1, "last": 10, "step": 1, "count": 9}, "contradict themselves"),
        ({"first": 0, "last": 9, "step": 1, "count": 10}, "contradict themselves"),
        ({"first": 1, "last": "10", "step": 1, "count": 10}, "contradict themselves"),
        ({"first": None, "last": None, "step": 1, "count": 0}, "has processed no frame"),
        ({"first": 1, "last": 5, "step": 1, "count": 5}, "boxes in frame 6, which .* not list"),
    ],
)
def test_a_run_that_does_not_fit_is_refused(
    tmp_path: Path, frames: dict[str, object], message: str
) -> None:
    tracks = write_mot(tmp_path / "tracks.txt", one_object(range(1, 11)))
    run_file = write_run(tmp_path, **frames)
    with pytest.raises(InputError, match=message) as error:
        evaluate_tracks(one_object(range(1, 11)), tracks)
    assert str(run_file) in str(error.value)
    assert evaluate_tracks(one_object(range(1, 11)), tracks, frames=(1, 10)).mota == 100


@pytest.mark.parametrize("text", ["", "[]", "{", '{"frames": 3}', "\x00"])
def test_a_run_file_that_is_none(tmp_path: Path, text: str) -> None:
    tracks = write_mot(tmp_path / "tracks.txt", one_object(range(1, 3)))
    (tmp_path / "run.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r'run\.json: no "frames"'):
        evaluate_tracks(one_object(range(1, 3)), tracks)


@pytest.mark.parametrize("iou", [0, -0.5, 1.01, math.nan])
def test_iou_out_of_range(iou: float) -> None:
    with pytest.raises(UsageError, match=r"iou .* above 0 and at most 1"):
        evaluate_tracks(one_object(range(1, 3)), one_object(range(1, 3)), iou=iou)


@pytest.mark.parametrize("frames", [(0, 5), (5, 4), (1, 2**60)])
def test_frames_that_are_no_range(frames: tuple[int, int]) -> None:
    with pytest.raises(UsageError, match=f"frames {frames[0]}-{frames[1]}"):
        evaluate_tracks(one_object(range(1, 3)), one_object(range(1, 3)), frames=frames)


def test_offset_out_of_range() -> None:
    with pytest.raises(UsageError, match="offset"):
        evaluate_tracks(one_object(range(1, 3)), one_object(range(1, 3)), offset=2**60)


def test_tracks_cannot_be_ignored() -> None:
    tracks = Boxes([1], [1], [BOX], [True])
    with pytest.raises(InputError, match="only truth can be don't-care"):
        evaluate_tracks(one_object(range(1, 3)), tracks)


def test_nothing_at_all_scores_zero_over_no_frames() -> None:
    nothing = Boxes([], [], [])
    scores = evaluate_tracks(nothing, nothing)
    assert (scores.hota, scores.mota, scores.idf1) == (0, 0, 0)
    assert (scores.frames, scores.first_frame, scores.last_frame) == (0, 1, 0)


def test_to_dict_uses_published_names_and_is_json() -> None:
    scores = evaluate_tracks(one_object(range(1, 5)), one_object(range(1, 5), [1, 1, 2, 2]))
    table = json.loads(json.dumps(scores.to_dict(), allow_nan=False))
    published = {"HOTA", "DetA", "AssA", "MOTA", "IDF1", "switches", "fragments"}
    assert published <= table.keys()
    assert (table["MOTA"], table["IDF1"], table["switches"]) == (75, 50, 1)
    assert len(table) == len(dataclasses.fields(TrackScores))
