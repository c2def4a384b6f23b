# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The files of a CDnet-like sequence and of its masks, found by the numbers in their names."""

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import InputError
from survtrack.evaluation.files import read_bytes, require_folder
from survtrack.evaluation.footage import given_range

TEMPORAL_ROI = "temporalROI.txt"


def numbered_files(folder: Path, suffixes: tuple[str, ...] = (".png",)) -> dict[int, Path]:
    """The images of a folder by the last six digits (or fewer) before the suffix.

    Raises:
        InputError: no such folder, or two images of the same number.
    """
    found: dict[int, Path] = {}
    for path in sorted(require_folder(folder).iterdir()):
        digits = re.search(r"(\d{1,6})$", path.stem, re.ASCII)
        if digits is None or path.suffix.lower() not in suffixes:
            continue
        number = int(digits[1])
        if number in found:
            raise InputError(f"{folder}: {found[number].name} and {path.name} are both {number}")
        found[number] = path
    return found


def scored_frames(sequence: Path, frames: tuple[int, int] | None) -> range:
    """The frames of a sequence that are scored, in the numbering of its files.

    They are those of `temporalROI.txt`, narrowed to `frames`, as far as there is footage: the
    file may name a last frame that the set does not have (SBI's IBMtest2: 0 to 90, of 0 to 89).

    Raises:
        InputError: no or a broken temporalROI.txt, no footage, or nothing left to score.
        UsageError: frames that are no range.
    """
    first, last = _temporal_roi(sequence / TEMPORAL_ROI, frames is not None)
    if frames is not None:
        asked = given_range(frames, lowest=0)
        first, last = max(first, asked[0]), min(last, asked[-1])
    footage = set(numbered_files(sequence / "groundtruth"))
    if (sequence / "input").is_dir():
        footage |= set(numbered_files(sequence / "input", (".jpg", ".jpeg", ".png", ".bmp")))
    if not footage:
        raise InputError(f"{sequence / 'groundtruth'}: no truth masks (gtNNNNNN.png)")
    first, last = max(first, min(footage)), min(last, max(footage))
    if first > last:
        given = "" if frames is None else f" and frames {frames[0]}-{frames[1]}"
        raise InputError(f"{sequence}: no frame within {TEMPORAL_ROI}{given} to score")
    return range(first, last + 1)


def _temporal_roi(path: Path, optional: bool) -> tuple[int, int]:
    if not path.exists():
        if optional:
            return 0, 10**6 - 1
        raise InputError(
            f"{path}: no such file; it holds the first and last frame to score (or give "
            "--frames A-B)"
        )
    words = read_bytes(path).split()
    numbers = [int(word) for word in words if re.fullmatch(rb"[0-9]{1,9}", word)]
    if len(words) != 2 or len(numbers) != 2 or numbers[0] > numbers[1]:
        raise InputError(f"{path}: the first and last frame to score expected, such as 470 1700")
    return numbers[0], numbers[1]


def read_grey(path: Path) -> NDArray[np.uint8]:
    """An image as (height, width) uint8; colour is turned to grey."""
    import cv2

    data = np.frombuffer(read_bytes(path), np.uint8)
    try:
        image = cv2.imdecode(data, cv2.IMREAD_GRAYSCALE)
    except cv2.error:  # an empty file, or more pixels than OpenCV takes
        image = None
    if image is None:
        raise InputError(f"{path}: cannot be decoded as an image")
    return np.asarray(image, dtype=np.uint8)
