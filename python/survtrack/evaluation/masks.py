# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The judge of foreground masks: CDnet's seven scores over all pixels of a sequence.

Source: Y. Wang, P.-M. Jodoin, F. Porikli, J. Konrad, Y. Benezeth, P. Ishwar, "CDnet 2014: An
Expanded Change Detection Benchmark Dataset", CVPR workshops 2014. Of the codes in its truth 255
(moving) is positive, 0 (still) and 50 (hard shadow) are negative, 85 (outside the region of
interest) and 170 (unknown) are not scored. SBI2015's truth of 0, 170 and 255 follows the same
rule. The spatial region, ROI.bmp, is not read: the truth already says 85 outside of it.
"""

import math
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath
from survtrack.evaluation.mask_files import numbered_files, read_grey, scored_frames
from survtrack.evaluation.scores import score, score_key

NEGATIVE_CODES = (0, 50)
POSITIVE_CODE = 255
UNSCORED_CODES = (85, 170)
FOREGROUND_ABOVE = 127


@dataclass(frozen=True)
class MaskScores:
    """Scores of masks against truth: fractions from 0 to 1, but pwc a percentage.

    A ratio whose denominator is 0 is NaN (None in to_dict): precision when no pixel at all is
    foreground, recall when none moves, f_measure only when both are so.
    """

    recall: float = score("recall, TP / (TP + FN)", "Re")
    specificity: float = score("specificity, TN / (TN + FP)", "Sp")
    false_positive_rate: float = score("false positive rate, FP / (FP + TN)", "FPR")
    false_negative_rate: float = score("false negative rate, FN / (TP + FN)", "FNR")
    pwc: float = score("percentage of wrong pixels", "PWC")
    precision: float = score("precision, TP / (TP + FP)", "Pr")
    f_measure: float = score("F-measure, 2 Re Pr / (Re + Pr)", "F")
    true_positives: int = score("moving pixels found")
    false_positives: int = score("still pixels taken for moving")
    false_negatives: int = score("moving pixels missed")
    true_negatives: int = score("still pixels left alone")
    frames: int = score("frames that are scored")
    first_frame: int = score("the first of them, as the files count")
    last_frame: int = score("the last of them")

    def to_dict(self) -> dict[str, float | int | None]:
        """The scores by their published names (Re, F, ...), None for what is not defined."""
        values = {score_key(entry): getattr(self, entry.name) for entry in fields(self)}
        return {key: None if math.isnan(value) else value for key, value in values.items()}


def evaluate_masks(
    sequence_dir: StrPath, mask_dir: StrPath, *, frames: tuple[int, int] | None = None
) -> MaskScores:
    """Score a folder of masks against the truth of a CDnet or SBI sequence.

    Args:
        sequence_dir: holds `groundtruth/gtNNNNNN.png`, `temporalROI.txt` (first and last frame to
            score) and `input/`.
        mask_dir: holds one PNG a frame whose name ends in the frame's six digits, such as
            `binNNNNNN.png`; pixels above 127 are foreground.
        frames: narrows the frames to score, first and last, numbered as the files are.

    Raises:
        InputError: a missing folder or file (also one truth or mask of the frames to score),
            images that cannot be read or differ in size, codes that CDnet's truth does not have.
        UsageError: frames that are no range.
    """
    sequence, folder = Path(sequence_dir), Path(mask_dir)
    truth_dir = sequence / "groundtruth"
    chosen = scored_frames(sequence, frames)
    truth_files, mask_files = numbered_files(truth_dir), numbered_files(folder)
    counts = np.zeros((256, 2), dtype=np.int64)
    for number in chosen:
        truth_file = truth_files.get(number)
        mask_file = mask_files.get(number)
        if truth_file is None:
            raise InputError(f"{truth_dir / f'gt{number:06d}.png'}: no such file (a scored frame)")
        if mask_file is None:
            raise InputError(f"{folder / f'bin{number:06d}.png'}: no such file (a scored frame)")
        counts += _count(truth_file, mask_file)
    return _scores(counts, chosen)


def _count(truth_file: Path, mask_file: Path) -> NDArray[np.int64]:
    """(256, 2): the pixels of every truth code that the mask leaves out, and that it takes."""
    truth, mask = read_grey(truth_file), read_grey(mask_file)
    if truth.shape != mask.shape:
        sizes = [f"{image.shape[1]}x{image.shape[0]}" for image in (mask, truth)]
        raise InputError(f"{mask_file}: is {sizes[0]}, but {truth_file} is {sizes[1]}")
    joint = 2 * truth.astype(np.int64) + (mask > FOREGROUND_ABOVE)
    counts = np.bincount(joint.ravel(), minlength=512).reshape(256, 2)
    known = (*NEGATIVE_CODES, *UNSCORED_CODES, POSITIVE_CODE)
    strange = [code for code in np.flatnonzero(counts.any(axis=1)).tolist() if code not in known]
    if strange:
        raise InputError(f"{truth_file}: holds the code {strange[0]}; CDnet's are {sorted(known)}")
    return counts


def _scores(counts: NDArray[np.int64], frames: range) -> MaskScores:
    fn, tp = counts[POSITIVE_CODE].tolist()
    tn, fp = counts[list(NEGATIVE_CODES)].sum(axis=0).tolist()
    return MaskScores(
        recall=_ratio(tp, tp + fn),
        specificity=_ratio(tn, tn + fp),
        false_positive_rate=_ratio(fp, fp + tn),
        false_negative_rate=_ratio(fn, tp + fn),
        pwc=100 * _ratio(fp + fn, tp + fp + fn + tn),
        precision=_ratio(tp, tp + fp),
        f_measure=_ratio(2 * tp, 2 * tp + fp + fn),
        true_positives=tp,
        false_positives=fp,
        false_negatives=fn,
        true_negatives=tn,
        frames=len(frames),
        first_frame=frames[0],
        last_frame=frames[-1],
    )


def _ratio(part: int, whole: int) -> float:
    return part / whole if whole else math.nan
