# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""CDnet's rule, worked by hand on small masks and against plain logic on footage."""

import json
import math
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from survtrack.errors import InputError, UsageError
from survtrack.evaluation import evaluate_masks

TRUTH = np.array([[0, 50, 85, 170, 255], [0, 50, 85, 170, 255]], np.uint8)
MASK = np.array([[255, 255, 255, 255, 255], [0, 0, 0, 0, 0]], np.uint8)  # 1 TP 1 FN 2 FP 2 TN


@pytest.fixture
def sequence(tmp_path: Path) -> Path:
    """Frames 3 to 6 of 8 are scored."""
    folder = tmp_path / "sequence"
    for number in range(1, 9):
        write(folder / "groundtruth" / f"gt{number:06d}.png", TRUTH)
        write(folder / "input" / f"in{number:06d}.jpg", TRUTH)
    (folder / "temporalROI.txt").write_text("3 6\n", encoding="ascii")
    return folder


@pytest.fixture
def masks(tmp_path: Path) -> Path:
    folder = tmp_path / "masks"
    for number in range(3, 7):
        write(folder / f"bin{number:06d}.png", MASK)
    return folder


def write(path: Path, image: NDArray[np.uint8]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), image)


def test_hand_worked(sequence: Path, masks: Path) -> None:
    scores = evaluate_masks(sequence, masks)
    assert (scores.true_positives, scores.false_negatives) == (4, 4)
    assert (scores.false_positives, scores.true_negatives) == (8, 8)
    assert (scores.recall, scores.specificity, scores.precision) == (1 / 2, 1 / 2, 1 / 3)
    assert (scores.false_positive_rate, scores.false_negative_rate) == (1 / 2, 1 / 2)
    assert (scores.pwc, scores.f_measure) == (50, 2 * 4 / (2 * 4 + 8 + 4))
    assert (scores.frames, scores.first_frame, scores.last_frame) == (4, 3, 6)


def test_foreground_is_above_127(sequence: Path, masks: Path) -> None:
    grey = np.full_like(MASK, 127)
    grey[1] = 128
    for path in masks.iterdir():
        write(path, grey)
    assert evaluate_masks(sequence, masks).true_positives == 4


def test_frames_narrow_the_temporal_region(sequence: Path, masks: Path) -> None:
    scores = evaluate_masks(sequence, masks, frames=(5, 100))
    assert (scores.frames, scores.first_frame, scores.last_frame) == (2, 5, 6)
    assert scores.true_positives == 2


def test_a_temporal_region_may_end_after_the_footage(sequence: Path, masks: Path) -> None:
    (sequence / "temporalROI.txt").write_text("3 9", encoding="ascii")
    for number in (7, 8):
        write(masks / f"bin{number:06d}.png", MASK)
    assert evaluate_masks(sequence, masks).last_frame == 8


def test_without_a_temporal_region_frames_are_needed(sequence: Path, masks: Path) -> None:
    (sequence / "temporalROI.txt").unlink()
    with pytest.raises(InputError, match=r"temporalROI\.txt: no such file"):
        evaluate_masks(sequence, masks)
    assert evaluate_masks(sequence, masks, frames=(3, 6)).frames == 4


def test_what_is_not_defined_is_null(sequence: Path, masks: Path) -> None:
    for path in masks.iterdir():
        write(path, np.zeros_like(MASK))
    scores = evaluate_masks(sequence, masks)
    assert math.isnan(scores.precision)
    assert (scores.recall, scores.f_measure) == (0, 0)
    table = json.loads(json.dumps(scores.to_dict(), allow_nan=False))
    assert table["Pr"] is None
    assert {"Re", "Sp", "FPR", "FNR", "PWC", "F"} <= table.keys()
    for path in (sequence / "groundtruth").iterdir():
        write(path, np.zeros_like(TRUTH))
    still = evaluate_masks(sequence, masks)
    assert math.isnan(still.f_measure) and math.isnan(still.recall)
    assert (still.specificity, still.pwc) == (1, 0)


@pytest.mark.parametrize("name", ["masks/bin000004.png", "sequence/groundtruth/gt000005.png"])
def test_a_missing_or_broken_file_is_named(
    tmp_path: Path, sequence: Path, masks: Path, name: str
) -> None:
    path = tmp_path / name
    whole = path.read_bytes()
    for content in (b"", b"no image", whole[: len(whole) // 2]):
        path.write_bytes(content)
        with pytest.raises(InputError, match=f"{path.name}: cannot be decoded"):
            evaluate_masks(sequence, masks)
    path.unlink()
    with pytest.raises(InputError, match=f"{path.name}: no such file"):
        evaluate_masks(sequence, masks)


def test_a_mask_of_another_size(sequence: Path, masks: Path) -> None:
    write(masks / "bin000005.png", MASK[:1])
    with pytest.raises(InputError, match=r"bin000005\.png: is 5x1, but .*gt000005\.png is 5x2"):
        evaluate_masks(sequence, masks)


def test_truth_with_a_code_of_its_own(sequence: Path, masks: Path) -> None:
    write(sequence / "groundtruth" / "gt000005.png", np.full_like(TRUTH, 128))
    with pytest.raises(InputError, match=r"gt000005\.png: holds the code 128"):
        evaluate_masks(sequence, masks)


def test_two_masks_of_one_frame(sequence: Path, masks: Path) -> None:
    write(masks / "fg000005.png", MASK)
    with pytest.raises(InputError, match=r"bin000005\.png and fg000005\.png are both 5"):
        evaluate_masks(sequence, masks)


@pytest.mark.parametrize("text", ["", "3", "6 3", "-1 5", "a b", "1 2 3", "1.5 2"])
def test_a_temporal_region_that_is_none(sequence: Path, masks: Path, text: str) -> None:
    (sequence / "temporalROI.txt").write_text(text, encoding="ascii")
    with pytest.raises(InputError, match=r"temporalROI\.txt: the first and last frame"):
        evaluate_masks(sequence, masks)


def test_folders_that_are_none(tmp_path: Path, sequence: Path, masks: Path) -> None:
    with pytest.raises(InputError, match="nowhere: no such folder"):
        evaluate_masks(sequence, tmp_path / "nowhere")
    with pytest.raises(InputError, match="nowhere"):
        evaluate_masks(tmp_path / "nowhere", masks)
    with pytest.raises(InputError, match=r"temporalROI\.txt: is a file, a folder is needed"):
        evaluate_masks(sequence, sequence / "temporalROI.txt")


def test_frames_outside_of_everything(sequence: Path, masks: Path) -> None:
    with pytest.raises(InputError, match=r"no frame within .* and frames 7-8"):
        evaluate_masks(sequence, masks, frames=(7, 8))
    with pytest.raises(UsageError, match="frames 6-3"):
        evaluate_masks(sequence, masks, frames=(6, 3))


@pytest.mark.parametrize(
    ("name", "first", "last"),
    [
        ("cdnet/highway", 470, 1000),
        ("cdnet/pedestrians", 300, 800),
        ("cdnet/canoe", 800, 1189),
        ("sbi/IBMtest2", 0, 89),
        ("sbi/CAVIAR2", 0, 459),
    ],
)
def test_shifted_truth_of_footage(
    data: Path, tmp_path: Path, name: str, first: int, last: int
) -> None:
    """Masks are the truth moved by a few pixels; the reference counts each kind of pixel apart."""
    tp = fp = fn = tn = 0
    for number in range(first, last + 1):
        truth = cv2.imread(str(data / name / "groundtruth" / f"gt{number:06d}.png"))[..., 0]
        mask = np.roll(truth, (2, 3), axis=(0, 1)) == 255
        write(tmp_path / f"bin{number:06d}.png", mask.astype(np.uint8) * 255)
        still, moving = np.isin(truth, (0, 50)), truth == 255
        tp, fn = tp + int((mask & moving).sum()), fn + int((~mask & moving).sum())
        fp, tn = fp + int((mask & still).sum()), tn + int((~mask & still).sum())
    scores = evaluate_masks(data / name, tmp_path)
    assert (scores.first_frame, scores.last_frame) == (first, last)
    assert (scores.true_positives, scores.false_negatives) == (tp, fn)
    assert (scores.false_positives, scores.true_negatives) == (fp, tn)
    recall, precision = tp / (tp + fn), tp / (tp + fp)
    assert scores.f_measure == pytest.approx(2 * recall * precision / (recall + precision))
    assert scores.pwc == pytest.approx(100 * (fp + fn) / (tp + fp + fn + tn))
    assert 0.5 < scores.f_measure < 0.95
