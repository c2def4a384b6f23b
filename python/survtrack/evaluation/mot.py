# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Boxes from MOTChallenge text: frame, id, left, top, width, height, confidence, ...

Source: L. Leal-Taixe, A. Milan, I. Reid, S. Roth, K. Schindler, "MOTChallenge 2015: Towards a
Benchmark for Multi-Target Tracking", arXiv:1504.01942, section 3.3 (data format).
"""

import math
import re
from pathlib import Path

import numpy as np

from survtrack.errors import InputError
from survtrack.evaluation.boxes import Boxes
from survtrack.evaluation.files import StrPath, read_bytes

MAX_COLUMNS = 10
LAYOUT = "frame,id,left,top,width,height,confidence,-1,-1,-1"
# float() alone would also take "1_000", "nan" and digits of other scripts.
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)


def read_mot(path: StrPath, *, truth: bool = False) -> Boxes:
    """Read a MOTChallenge text file, one box a line, columns separated by commas.

    Args:
        path: the file; blank lines are allowed, header lines are not.
        truth: whether it is ground truth. Then the seventh column, the confidence, must be
            there, and rows of confidence 0 are left out: they are marked as not to be scored.
            In tracks the confidence means nothing here, and six columns are enough.

    Returns:
        The boxes in the file's order; none for an empty file of tracks.

    Raises:
        InputError: the file is missing or not text, a line has another number of columns than
            6 (truth 7) to 10 or than the lines before it, holds something else than finite
            numbers, or breaks a rule of Boxes; a truth without any box to score. Lines are named.
    """
    path = Path(path)
    rows, lines = _parse(path, columns=7 if truth else 6)
    if truth:
        scored = [row[6] != 0 for row in rows]
        rows = [row for row, keep in zip(rows, scored, strict=True) if keep]
        lines = [line for line, keep in zip(lines, scored, strict=True) if keep]
        if not rows:
            raise InputError(f"{path}: the truth holds no box to score (empty, or confidence 0)")
    values = np.array([row[:6] for row in rows], dtype=np.float64).reshape(-1, 6)
    return Boxes(
        values[:, 0], values[:, 1], values[:, 2:], where=lambda row: f"{path}, line {lines[row]}"
    )


def _parse(path: Path, columns: int) -> tuple[list[list[float]], list[int]]:
    """All rows of numbers, and the line (counted from 1) that each stands on."""
    try:
        text = read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not MOT text ({LAYOUT}), but binary data") from error
    rows: list[list[float]] = []
    lines: list[int] = []
    for number, line in enumerate(text.split("\n"), start=1):
        if not line.strip():
            continue
        where = f"{path}, line {number}"
        cells = [cell.strip() for cell in line.split(",")]
        row = [_number(cell, column, where) for column, cell in enumerate(cells, start=1)]
        if not columns <= len(row) <= MAX_COLUMNS:
            raise InputError(
                f"{where}: {len(row)} column(s), expected {columns} to {MAX_COLUMNS}: {LAYOUT}"
            )
        if rows and len(row) != len(rows[0]):
            raise InputError(
                f"{where}: {len(row)} columns, but the lines before it have {len(rows[0])}"
            )
        rows.append(row)
        lines.append(number)
    return rows, lines


def _number(cell: str, column: int, where: str) -> float:
    value = float(cell) if _NUMBER.fullmatch(cell) else math.nan
    if not math.isfinite(value):
        raise InputError(
            f"{where}: column {column} must be a finite number, not {cell[:40]!r}; MOT text is "
            f"{LAYOUT}"
        )
    return value
