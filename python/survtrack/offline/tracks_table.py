# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""tracks.csv, read back."""

import csv
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from survtrack._core import History
from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath, read_bytes
from survtrack.sinks.tracks_csv import COLUMNS

KEYS = ("frame", "id")
BOX = ("left_px", "top_px", "width_px", "height_px")
SIZES = BOX[2:]
POSITION = ("x_px", "y_px")
VELOCITY = ("velocity_x_px_per_s", "velocity_y_px_per_s")
COLOR = ("mean_blue", "mean_green", "mean_red")
NUMBERS = ("time_s", *BOX, *POSITION, *VELOCITY, *COLOR)
SMALLEST_SIZE_PX = 0.001
_WHOLE = re.compile(r"[0-9]{1,15}", re.ASCII)


@dataclass(frozen=True, eq=False)
class TracksTable:
    """The rows of a tracks.csv, one a track and frame, in the file's order.

    path: the file.
    columns: its header; those of survtrack.sinks.tracks_csv.COLUMNS, and perhaps more.
    rows: the cells as they were written.
    frames: (N,) int64, counted from 1.
    ids: (N,) int64.
    numbers: (N, 12) float64, the columns NUMBERS; all finite.
    """

    path: Path
    columns: tuple[str, ...]
    rows: list[list[str]]
    frames: NDArray[np.int64]
    ids: NDArray[np.int64]
    numbers: NDArray[np.float64]

    @property
    def times_s(self) -> NDArray[np.float64]:
        """(N,) times of the rows."""
        return self.numbers[:, NUMBERS.index("time_s")]

    def history(self) -> History:
        """The tracks; raises InputError where they contradict themselves."""
        try:
            return History.from_columns(
                ids=self.ids,
                indices=self.frames - 1,
                times_s=self._columns("time_s")[:, 0],
                boxes=self._columns(*BOX),
                positions=self._columns(*POSITION),
                velocities_px_per_s=self._columns(*VELOCITY),
                mean_colors=self._columns(*COLOR),
            )
        except InputError as error:
            raise InputError(f"{self.path}: {error}") from error

    def _columns(self, *names: str) -> NDArray[np.float64]:
        return self.numbers[:, [NUMBERS.index(name) for name in names]]


def read_tracks_csv(path: StrPath) -> TracksTable:
    """Read a table of tracks as TracksCsv writes it; further columns are kept.

    Raises:
        InputError: the file is missing or not text, lacks a column, or a line has another number
            of cells than the header, holds no number where one belongs, a size below 0.001 px, or
            a track a second time in the same frame. Lines are named.
    """
    path = Path(path)
    try:
        text = read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    reader = csv.reader(text.splitlines(keepends=True), strict=True)
    try:
        columns = tuple(next(reader, ()))
        _check_header(path, columns)
        return _read_rows(path, columns, ((reader.line_num, row) for row in reader))
    except csv.Error as error:
        raise InputError(f"{path}, line {reader.line_num}: {error}") from error


def _check_header(path: Path, columns: tuple[str, ...]) -> None:
    missing = [name for name in COLUMNS if name not in columns]
    if missing:
        raise InputError(
            f"{path}, line 1: lacks the column(s) {', '.join(missing)}; a table as `survtrack run` "
            "writes it is needed"
        )
    twice = [name for name in COLUMNS if columns.count(name) > 1]
    if twice:
        raise InputError(f"{path}, line 1: has the column {twice[0]} twice")


def _read_rows(
    path: Path, columns: tuple[str, ...], lines: Iterable[tuple[int, list[str]]]
) -> TracksTable:
    places = [columns.index(name) for name in NUMBERS]
    key_places = [columns.index(name) for name in KEYS]
    rows: list[list[str]] = []
    numbers: list[list[float]] = []
    line_of: dict[tuple[int, int], int] = {}
    for line, row in lines:
        where = f"{path}, line {line}"
        if len(row) != len(columns):
            raise InputError(f"{where}: {len(row)} cell(s), but the header has {len(columns)}")
        frame, identity = (
            _whole(row[place], name, where) for place, name in zip(key_places, KEYS, strict=True)
        )
        first = line_of.setdefault((frame, identity), line)
        if first != line:
            raise InputError(
                f"{where}: track {identity} is in frame {frame} a second time (first in line "
                f"{first})"
            )
        rows.append(row)
        numbers.append(
            [_number(row[place], name, where) for place, name in zip(places, NUMBERS, strict=True)]
        )
    keys = np.array(list(line_of), dtype=np.int64).reshape(-1, 2)
    values = np.array(numbers, dtype=np.float64).reshape(-1, len(NUMBERS))
    return TracksTable(path, columns, rows, keys[:, 0], keys[:, 1], values)


def _whole(cell: str, name: str, where: str) -> int:
    if _WHOLE.fullmatch(cell) is None or int(cell) == 0:
        raise InputError(f"{where}: {name} must be a whole number from 1 on, not {cell[:40]!r}")
    return int(cell)


def _number(cell: str, name: str, where: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or "_" in cell:
        raise InputError(f"{where}: {name} must be a finite number, not {cell[:40]!r}")
    if name in SIZES and value < SMALLEST_SIZE_PX:
        raise InputError(f"{where}: {name} must be at least {SMALLEST_SIZE_PX} px, not {cell!r}")
    return value
