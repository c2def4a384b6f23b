# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Our scores equal TrackEval's, on random scenes full of ties and on real footage's truth."""

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from evaluation.trackeval_reference import Row, trackeval_scores
from survtrack.evaluation import Boxes, evaluate_tracks, read_cvml, read_mot

IOUS = (0.1, 0.3, 0.5, 0.75, 1.0)


def boxes_of(rows: Sequence[Row], ignore: Sequence[bool] | None = None) -> Boxes:
    table = np.array(rows, dtype=float).reshape(-1, 6)
    return Boxes(table[:, 0], table[:, 1], table[:, 2:], ignore)


def assert_equal(
    truth: Sequence[Row], tracks: Sequence[Row], iou: float, ignore: Sequence[bool] = ()
) -> None:
    ours = evaluate_tracks(boxes_of(truth, ignore or None), boxes_of(tracks), iou=iou)
    with tempfile.TemporaryDirectory() as folder:
        theirs = trackeval_scores(Path(folder), truth, tracks, iou=iou, ignore=ignore)
    assert len(theirs) == 25
    for name, value in theirs.items():
        assert getattr(ours, name) == pytest.approx(value, rel=0, abs=1e-9), name
    assert ours.ignored_outputs == len(tracks) - ours.output_boxes


@st.composite
def scenes(draw: st.DrawFn, highest_id: int) -> list[Row]:
    """Boxes on a coarse grid, so that equal overlaps and exact thresholds are common."""
    places = draw(
        st.lists(st.tuples(st.integers(1, 6), st.integers(0, highest_id)), unique=True, max_size=16)
    )
    side = st.integers(0, 4).map(lambda k: 2.5 * k)
    size = st.sampled_from([5.0, 10.0])
    return [(*place, draw(side), draw(side), draw(size), draw(size)) for place in places]


@settings(max_examples=150, deadline=None, derandomize=True, database=None)
@given(truth=scenes(3), tracks=scenes(5), iou=st.sampled_from(IOUS))
def test_small_scenes(truth: list[Row], tracks: list[Row], iou: float) -> None:
    assert_equal(truth, tracks, iou)


@settings(max_examples=100, deadline=None, derandomize=True, database=None)
@given(truth=scenes(4), tracks=scenes(4), choices=st.data())
def test_small_scenes_with_ignored_truth(
    truth: list[Row], tracks: list[Row], choices: st.DataObject
) -> None:
    ignore = choices.draw(
        st.lists(st.booleans(), min_size=len(truth), max_size=len(truth)).filter(any)
        if truth
        else st.just([])
    )
    assert_equal(truth, tracks, 0.5, ignore)


def perturbed(truth: Boxes, seed: int) -> list[Row]:
    """What a tracker might make of the truth: jitter, gaps, false boxes, identities that change."""
    random = np.random.default_rng(seed)
    rows: list[Row] = []
    swap = {int(name): int(name) for name in np.unique(truth.ids)}
    for frame in np.unique(truth.frames).tolist():
        if random.random() < 0.1:
            one, two = random.choice(list(swap), 2)
            swap[one], swap[two] = swap[two], swap[one]
        if random.random() < 0.05:
            continue
        for row in np.flatnonzero(truth.frames == frame):
            box = truth.boxes[row] + random.normal(0, 0.08, 4) * truth.boxes[row, 2:].mean()
            box[2:] = np.maximum(box[2:], 1)
            if random.random() < 0.85:
                rows.append((frame, swap[int(truth.ids[row])], *box.tolist()))
            if random.random() < 0.1:
                rows.append((frame, 1000 + len(rows), *np.add(box, [15, 5, 0, 0]).tolist()))
    return rows


def rows_of(boxes: Boxes) -> list[Row]:
    columns = (boxes.frames.tolist(), boxes.ids.tolist(), boxes.boxes.tolist())
    return [(frame, name, *box) for frame, name, box in zip(*columns, strict=True)]


def random_walks(seed: int) -> Boxes:
    """Eight objects that walk about, come late and leave early."""
    random = np.random.default_rng(seed)
    rows: list[Row] = []
    for name in range(8):
        position = random.uniform(0, 200, 2)
        first, last = sorted(random.integers(1, 61, 2).tolist())
        for frame in range(first, last + 1):
            position = position + random.normal(0, 4, 2)
            rows.append((frame, name, *position.tolist(), 30.0, 60.0))
    return boxes_of(rows)


@pytest.mark.parametrize("iou", IOUS)
@pytest.mark.parametrize("seed", range(4))
def test_random_walks(seed: int, iou: float) -> None:
    truth = random_walks(seed)
    assert_equal(rows_of(truth), perturbed(truth, seed), iou)


def test_ignored_objects_among_random_walks() -> None:
    truth = random_walks(9)
    ignore = ((truth.ids % 3 == 0) | (truth.frames > 40)).tolist()
    assert_equal(rows_of(truth), perturbed(truth, 9), 0.5, ignore)


@pytest.mark.parametrize(
    ("truth", "tracks"),
    [
        ([(1, 1, 0, 0, 9, 9), (2, 1, 0, 0, 9, 9)], []),
        ([], [(1, 1, 0, 0, 9, 9), (2, 1, 0, 0, 9, 9)]),
        ([(1, 1, 0, 0, 9, 9)], [(1, 1, 50, 50, 9, 9)]),
        ([(1, 1, 0, 0, 9, 9)], [(2, 1, 0, 0, 9, 9)]),
    ],
    ids=["no outputs", "no truth", "no overlap", "no common frame"],
)
def test_nothing_to_match(truth: list[Row], tracks: list[Row]) -> None:
    assert_equal(truth, tracks, 0.5)


@pytest.mark.parametrize("name", ["PETS09-S2L1", "TUD-Campus"])
@pytest.mark.parametrize("iou", [0.3, 0.5, 0.7])
def test_perturbed_truth_of_footage(data: Path, name: str, iou: float) -> None:
    truth = read_mot(data / "mot" / name / "gt" / "gt.txt", truth=True)
    assert_equal(rows_of(truth), perturbed(truth, 1), iou)


def test_public_detections_with_made_up_identities(data: Path) -> None:
    folder = data / "mot" / "PETS09-S2L1"
    truth = read_mot(folder / "gt" / "gt.txt", truth=True)
    detections = np.loadtxt(folder / "det" / "det.txt", delimiter=",")[:, :6]
    detections[:, 1] = 0
    for frame in np.unique(detections[:, 0]):  # counted from the left: they switch all the time
        here = detections[:, 0] == frame
        detections[here, 1] = np.argsort(np.argsort(detections[here, 2]))
    assert_equal(rows_of(truth), detections.tolist(), 0.5)


@pytest.mark.parametrize("name", ["Walk1/wk1gt.xml", "OneLeaveShop1cor/cols1gt.xml"])
def test_inactive_people_of_caviar(data: Path, name: str) -> None:
    truth = read_cvml(data / "caviar" / name)
    assert truth.ignore.any()
    assert_equal(rows_of(truth), perturbed(truth, 2), 0.5, truth.ignore.tolist())
