# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""tracks.csv read back: what was written, and every way it can be broken."""

from pathlib import Path

import numpy as np
import pytest

from runs import BROKEN, write_run
from survtrack import InputError, link_tracks
from survtrack.offline import read_tracks_csv
from survtrack.sinks.tracks_csv import COLUMNS


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return write_run(tmp_path) / "tracks.csv"


def test_reads_what_was_written(path: Path) -> None:
    table = read_tracks_csv(path)
    assert table.columns == COLUMNS
    assert len(table.rows) == len(table.ids) == len(table.frames) == len(table.numbers) == 21
    assert (table.ids[0], table.frames[0]) == (1, 1)
    array = table.history().array
    assert len(table.history()) == len(BROKEN)
    row = array[(array["id"] == 2) & (array["index"] == 17)][0]
    assert row.tolist() == (2, 17, 1.7, 68, 10, 20, 80, 78, 50, 40, 0, 100, 110, 120)


def test_a_table_without_rows_is_an_empty_history(tmp_path: Path) -> None:
    table = read_tracks_csv(write_run(tmp_path, walks=()) / "tracks.csv")
    assert table.numbers.shape == (0, 12)
    assert len(table.history()) == 0
    assert link_tracks(table.history()).links == []


def test_further_columns_and_other_orders_are_fine(path: Path) -> None:
    expected = read_tracks_csv(path)
    lines = [line.split(",") for line in path.read_text().splitlines()]
    text = "\n".join(",".join(reversed([*cells, "more"])) for cells in lines)
    path.write_text("\ufeff" + text, encoding="utf-8")
    table = read_tracks_csv(path)
    assert table.columns == ("more", *reversed(COLUMNS))
    assert (table.numbers == expected.numbers).all()
    assert (table.ids == expected.ids).all()
    assert np.array_equal(table.history().array, expected.history().array)


def spoil(path: Path, line: int, column: str, cell: str) -> None:
    lines = path.read_text().splitlines()
    cells = lines[line - 1].split(",")
    cells[COLUMNS.index(column)] = cell
    lines[line - 1] = ",".join(cells)
    path.write_text("\n".join(lines) + "\n")


@pytest.mark.parametrize(
    ("column", "cell", "words"),
    [
        ("frame", "0", "line 4: frame must be a whole number from 1 on, not '0'"),
        ("frame", "3.5", "line 4: frame must be a whole number"),
        ("frame", "2", "line 4: track 1 is in frame 2 a second time (first in line 3)"),
        ("id", "-1", "line 4: id must be a whole number from 1 on, not '-1'"),
        ("id", "", "line 4: id must be a whole number"),
        ("time_s", "soon", "line 4: time_s must be a finite number, not 'soon'"),
        ("left_px", "nan", "line 4: left_px must be a finite number"),
        ("x_px", "inf", "line 4: x_px must be a finite number"),
        ("top_px", "1_0", "line 4: top_px must be a finite number"),
        ("width_px", "0.000", "line 4: width_px must be at least 0.001 px, not '0.000'"),
        ("height_px", "-3", "line 4: height_px must be at least"),
        ("velocity_x_px_per_s", "", "line 4: velocity_x_px_per_s must be a finite number"),
        ("mean_red", "red", "line 4: mean_red must be a finite number"),
        ("file", '"open', "unexpected end of data"),
        ("file", "a,b", "line 4: 22 cell(s), but the header has 21"),
    ],
)
def test_a_cell_that_is_wrong_is_named(path: Path, column: str, cell: str, words: str) -> None:
    spoil(path, 4, column, cell)
    with pytest.raises(InputError) as caught:
        read_tracks_csv(path)
    assert str(caught.value).startswith(f"{path}, line")
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("column", "cell", "words"),
    [
        ("time_s", "0.05", "track 1, frame index 2: time_s 0.05 is not allowed"),
        ("mean_red", "256", "track 1, frame index 2: mean_color (100, 110, 256)"),
        ("left_px", "1e12", "track 1, frame index 2: box left and top"),
    ],
)
def test_tracks_that_contradict_themselves(path: Path, column: str, cell: str, words: str) -> None:
    spoil(path, 4, column, cell)
    with pytest.raises(InputError) as caught:
        read_tracks_csv(path).history()
    assert str(caught.value).startswith(f"{path}: {words}")


def test_columns_that_are_missing_or_double(path: Path) -> None:
    text = path.read_text()
    path.write_text(text.replace("mean_blue,mean_green", "blue,green", 1))
    with pytest.raises(InputError, match=r"line 1: lacks the column\(s\) mean_blue, mean_green;"):
        read_tracks_csv(path)
    path.write_text(text.replace("covariance_xx_px2", "id", 1))
    with pytest.raises(InputError, match="lacks the column"):
        read_tracks_csv(path)
    path.write_text(text.replace("mean_red", "mean_red,id", 1))
    with pytest.raises(InputError, match="has the column id twice"):
        read_tracks_csv(path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "line 1: lacks the column"),
        (b"1,1,0,0,30,10,1,-1,-1,-1\n", "line 1: lacks the column"),
        (b"\xff\xfe\x00", "is not UTF-8 text"),
        (b"frame,id\0", "lacks the column"),
    ],
)
def test_a_file_that_is_no_table(path: Path, content: bytes, words: str) -> None:
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        read_tracks_csv(path)
    assert words in str(caught.value)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_tracks_csv(tmp_path / "tracks.csv")
    with pytest.raises(InputError, match="is a folder"):
        read_tracks_csv(tmp_path)
