# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Number-of-blobs, index and swap errors: worked by hand, by an independent reference, in kind."""

import dataclasses
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from survtrack.errors import InputError
from survtrack.evaluation import Boxes, evaluate_tracks, read_boxes
from survtrack.evaluation.counts import Counts, object_counts

Row = tuple[int, int, int, int, int, int]  # frame, id, left, top, width, height
BOX = (10, 20, 30, 40)
FIGURE_5_5: list[set[int]] = [{6}, set(), {7}, {7}, {6, 7}, {7}, {6}, {7}, {7, 8, 9}]


def boxes_of(rows: Sequence[Row], ignore: Sequence[bool] | None = None) -> Boxes:
    table = np.array(rows, dtype=float).reshape(-1, 6)
    return Boxes(table[:, 0], table[:, 1], table[:, 2:], ignore)


def counts(
    truth: Sequence[Row], tracks: Sequence[Row], ignore: Sequence[bool] | None = None
) -> tuple[int, int, int]:
    scores = evaluate_tracks(boxes_of(truth, ignore), boxes_of(tracks))
    return scores.number_of_blobs_errors, scores.index_errors, scores.swap_errors


def test_the_worked_example() -> None:
    assert object_counts(FIGURE_5_5) == Counts(4, 2, 3)


def test_the_worked_example_as_boxes() -> None:
    truth = [(frame, 1, *BOX) for frame in range(1, 10)]
    tracks = [(frame, k, *BOX) for frame, ids in enumerate(FIGURE_5_5, 1) for k in sorted(ids)]
    assert counts(truth, tracks) == (4, 2, 3)
    assert evaluate_tracks(boxes_of(truth), boxes_of(tracks)).truth_boxes == 9


@pytest.mark.parametrize(
    ("sets", "expected"),
    [
        ([], (0, 0, 0)),
        ([set(), set()], (2, 0, 0)),
        ([{1}, {2}], (0, 1, 1)),  # both in one frame: 1 is best
        ([{2}, {1}, {2}, {1}], (0, 2, 3)),
        ([{1}, {2, 3}, {3}], (1, 1, 1)),  # 3 is best, and so comes before 2
        ([{1}, set(), {1}], (1, 0, 0)),  # a gap is no change
        ([{1}, set(), {2}, {2}], (1, 1, 1)),
        ([{1}, {1, 2}, {2}, {2}], (1, 1, 1)),  # 1 stays as long as it can
        ([{5}, {3, 4}, {5}, {5}], (1, 1, 2)),
    ],
)
def test_sets_by_hand(sets: list[set[int]], expected: tuple[int, int, int]) -> None:
    assert dataclasses.astuple(object_counts(sets)) == expected


def test_an_output_over_two_objects_is_credited_to_one() -> None:
    truth = [(1, 1, 0, 0, 4, 10), (1, 2, 4, 0, 6, 10)]
    assert counts(truth, [(1, 9, 0, 0, 10, 10)]) == (1, 0, 0)
    assert counts(truth, [(1, 8, 4, 0, 6, 10), (1, 9, 0, 0, 10, 10)]) == (2, 0, 0)  # both on 2


def test_of_equal_truth_boxes_the_first_id_has_the_output() -> None:
    """Object 1 is listed last; object 2's own output tells whose the shared one is."""
    truth = [(1, 2, 5, 0, 5, 10), (1, 1, 0, 0, 5, 10)]
    shared, own = (1, 9, 0, 0, 10, 10), (1, 8, 5, 0, 5, 10)
    assert counts(truth, [shared, own]) == (0, 0, 0)


@pytest.mark.parametrize(("left", "errors"), [(5, 0), (6, 1), (-5, 0), (-6, 1)])
def test_at_least_half_of_an_output_must_be_covered(left: int, errors: int) -> None:
    assert counts([(1, 1, 0, 0, 10, 10)], [(1, 1, left, 0, 10, 10)]) == (errors, 0, 0)


def test_half_is_half_whatever_the_corners_round_to() -> None:
    truth = Boxes([1, 1], [1, 2], [[1000.1, 0, 0.3, 1], [1000.4, 0, 0.3, 1]])
    tracks = Boxes([1, 1], [1, 2], [[1000.1, 0, 0.6, 1], [1000.4, 0, 0.3, 1]])
    assert evaluate_tracks(truth, tracks).number_of_blobs_errors == 0


def test_a_small_output_in_a_large_object_belongs_to_it() -> None:
    """It is the part of the output that counts, not the IoU: a fragment is still a find."""
    scores = evaluate_tracks(boxes_of([(1, 1, 0, 0, 90, 90)]), boxes_of([(1, 1, 9, 9, 3, 3)]))
    assert (scores.number_of_blobs_errors, scores.misses) == (0, 1)


def test_a_box_without_a_measurable_area_belongs_to_nothing() -> None:
    truth, tracks = Boxes([1], [1], [[0, 0, 9, 9]]), Boxes([1], [1], [[5, 5, 1e-30, 1e-30]])
    assert evaluate_tracks(truth, tracks).number_of_blobs_errors == 1


def test_outputs_that_belong_to_ignored_truth_are_not_counted() -> None:
    """Ignored box 2 takes the outputs that it covers most, though object 1 covers half of one."""
    truth = [(1, 1, 0, 0, 10, 10), (1, 2, 4, 0, 20, 10)]
    tracks = [(1, 7, 0, 0, 10, 10), (1, 8, 5, 0, 10, 10), (1, 9, 12, 0, 5, 5)]
    assert counts(truth, tracks) == (1, 0, 0)
    assert counts(truth, tracks, [False, True]) == (0, 0, 0)
    assert counts(truth, tracks[1:], [False, True]) == (1, 0, 0)
    assert counts(truth, [], [True, True]) == (0, 0, 0)


def test_frames_in_which_an_object_is_ignored_are_no_instances() -> None:
    truth = [(frame, 1, *BOX) for frame in (1, 2, 3)]
    tracks = [(1, 5, *BOX), (2, 6, *BOX), (3, 5, *BOX)]
    assert counts(truth, tracks) == (0, 1, 2)
    assert counts(truth, tracks, [False, True, False]) == (0, 0, 0)


def test_an_object_may_be_away() -> None:
    """Outputs while it is away are nobody's; its number before the gap is remembered."""
    truth = [(frame, 1, *BOX) for frame in (1, 2, 8, 9)]
    assert counts(truth, [(frame, 5, *BOX) for frame in range(1, 10)]) == (0, 0, 0)
    tracks = [(frame, 5 if frame < 8 else 6, *BOX) for frame in range(1, 10)]
    assert counts(truth, tracks) == (0, 2, 1)


def test_a_number_may_serve_another_object_later() -> None:
    truth = [(1, 1, *BOX), (2, 1, *BOX), (3, 2, *BOX), (4, 2, *BOX)]
    assert counts(truth, [(frame, 5, *BOX) for frame in range(1, 5)]) == (0, 0, 0)


def test_only_the_frames_that_are_scored_count() -> None:
    truth = boxes_of([(frame, 1, *BOX) for frame in range(101, 110)])
    tracks = boxes_of([(frame, 1 + (frame > 5), *BOX) for frame in range(1, 8)])
    scores = evaluate_tracks(truth, tracks, offset=100, frames=(2, 8))
    assert (scores.number_of_blobs_errors, scores.truth_boxes) == (1, 7)
    assert (scores.index_errors, scores.swap_errors) == (2, 1)


def test_iou_changes_nothing() -> None:
    truth, tracks = boxes_of([(1, 1, 0, 0, 10, 10)]), boxes_of([(1, 1, 4, 0, 10, 10)])
    for iou in (0.1, 1.0):
        assert evaluate_tracks(truth, tracks, iou=iou).number_of_blobs_errors == 0


ROW = "1,1,0,0,9,9,1,-1,-1,-1\n"


@pytest.mark.parametrize(
    ("truth", "tracks", "message"),
    [
        (ROW * 2, ROW, r"gt\.txt, line 2: id 1 appears twice in frame 1"),
        (ROW, ROW * 2, r"tracks\.txt, line 2: id 1 appears twice in frame 1"),
        ("<dataset>", ROW, r"gt\.txt: broken XML"),
        (ROW, "<dataset/>", r"tracks\.txt: is XML, but tracks are expected as MOT text"),
        (ROW, "1;1;0;0;9;9\n", r"tracks\.txt, line 1: column 1 must be a finite number"),
        (ROW, ROW + "2,1,0\n", r"tracks\.txt, line 2: 3 column\(s\), expected 6 to 10"),
        (ROW, "1,-1,0,0,9,9\n", r"tracks\.txt, line 1: id -1 .*detections, not tracks"),
        ("\n", ROW, r"gt\.txt.* holds no box to score"),
    ],
)
def test_bad_files_are_refused(tmp_path: Path, truth: str, tracks: str, message: str) -> None:
    (tmp_path / "gt.txt").write_text(truth, "ascii")
    (tmp_path / "tracks.txt").write_text(tracks, "ascii")
    with pytest.raises(InputError, match=message):
        evaluate_tracks(tmp_path / "gt.txt", tmp_path / "tracks.txt")


@st.composite
def scenes(draw: st.DrawFn) -> list[Row]:
    """Boxes on a coarse grid, so that equal coverages and exact halves are common."""
    places = draw(
        st.lists(st.tuples(st.integers(1, 5), st.integers(0, 3)), unique=True, max_size=14)
    )
    side, size = st.integers(0, 4), st.sampled_from([2, 4])
    return [(*place, draw(side), draw(side), draw(size), draw(size)) for place in places]


def owner(output: Row, truth: Sequence[Row]) -> int | None:
    """The truth id that the output belongs to, in exact arithmetic."""
    frame, _, left, top, width, height = output
    covered, areas = {}, {}
    for row in truth:
        if row[0] == frame:
            across = min(left + width, row[2] + row[4]) - max(left, row[2])
            down = min(top + height, row[3] + row[5]) - max(top, row[3])
            covered[row[1]] = Fraction(max(across, 0) * max(down, 0), width * height)
            areas[row[1]] = row[4] * row[5]
    most = max(covered.values(), default=Fraction(0))
    if most < Fraction(1, 2):
        return None
    # Of equal intersections the smallest box has the highest IoU.
    return min((areas[k], k) for k in covered if covered[k] == most)[1]


def reference(
    truth: Sequence[Row], tracks: Sequence[Row], ignore: Sequence[bool]
) -> tuple[int, int, int]:
    blobs = index = swaps = 0
    instances = sorted(row[:2] for row, marked in zip(truth, ignore, strict=True) if not marked)
    for name in {name for _, name in instances}:
        here = [
            [row[1] for row in tracks if row[0] == frame and owner(row, truth) == name]
            for frame, who in instances
            if who == name
        ]
        blobs += sum(len(ids) - 1 if ids else 1 for ids in here)
        every = [number for ids in here for number in ids]
        best = max(sorted(every), key=every.count, default=None)
        index += sum(best not in ids for ids in here if ids)
        last = None
        for ids in here:
            if ids and last not in ids:
                number = best if best in ids else min(ids)
                swaps += last is not None
                last = number
    return blobs, index, swaps


@settings(max_examples=300, deadline=None, derandomize=True, database=None)
@given(truth=scenes(), tracks=scenes(), data=st.data())
def test_equal_to_the_reference(truth: list[Row], tracks: list[Row], data: st.DataObject) -> None:
    ignore = data.draw(st.lists(st.booleans(), min_size=len(truth), max_size=len(truth)))
    ours = counts(truth, tracks, ignore)
    assert ours == reference(truth, tracks, ignore)
    assert min(ours) >= 0


@settings(max_examples=100, deadline=None, derandomize=True, database=None)
@given(truth=scenes(), tracks=scenes(), names=st.sets(st.integers(0, 10**6), min_size=4))
def test_only_the_order_of_output_ids_matters(
    truth: list[Row], tracks: list[Row], names: set[int]
) -> None:
    ordered = sorted(names)
    renamed = [(frame, ordered[k], *box) for frame, k, *box in tracks]
    assert counts(truth, renamed) == counts(truth, tracks)


@settings(max_examples=100, deadline=None, derandomize=True, database=None)
@given(scene=scenes())
def test_perfect_and_empty_outputs(scene: list[Row]) -> None:
    apart = [(frame, k, left + 100 * k, *rest) for frame, k, left, *rest in scene]
    assert counts(apart, apart) == (0, 0, 0)
    assert counts(apart, []) == (len(apart), 0, 0)
    assert counts([], apart) == (0, 0, 0)


@pytest.mark.parametrize("name", ["PETS09-S2L1", "TUD-Campus"])
def test_the_truth_of_footage_as_output(data: Path, name: str) -> None:
    """Boxes wholly within others cover them too; the one that fits decides."""
    truth = read_boxes(data / "mot" / name / "gt" / "gt.txt", truth=True)
    scores = evaluate_tracks(truth, truth)
    assert scores.number_of_blobs_errors == 0
    assert (scores.index_errors, scores.swap_errors) == (0, 0)
