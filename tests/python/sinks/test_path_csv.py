# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where tracks are along paths, as a table."""

import csv
from pathlib import Path
from typing import Any

import numpy as np

from clips import walking_square
from fakes import Box, Track, result_of
from survtrack import Path as ImagePath
from survtrack import Paths
from survtrack.path_file import nearest_place
from survtrack.sinks import PathCsv

FRAME = walking_square(1)[0]
PATHS = Paths(
    {
        "lane, left": ImagePath([(0, 50), (300, 50)], max_distance_px=30),
        "back": ImagePath([(300, 90), (0, 90)]),
    }
)


def at(track_id: int, x: float, y: float, **more: Any) -> Track:
    return Track(track_id, Box(x - 10, y - 20, 20, 40), **more)


def rows_of(folder: Path, *results: Any) -> list[dict[str, str]]:
    with PathCsv(folder / "path.csv", PATHS) as sink:
        for result in results:
            sink.write(FRAME, result)
    assert sink.outputs == ["path.csv"]
    with (folder / "path.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_row_a_track_and_path(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, result_of(FRAME, 4, at(7, 120, 60, velocity_px_per_s=(30.0, -5.0))))
    assert rows == [
        {
            "frame": "5",
            "time_s": "0.400000",
            "id": "7",
            "path": "lane, left",
            "s_px": "120.000",
            "t_px": "10.000",
            "v_s_px_per_s": "30.000",
            "v_t_px_per_s": "-5.000",
        },
        {
            "frame": "5",
            "time_s": "0.400000",
            "id": "7",
            "path": "back",
            "s_px": "180.000",
            "t_px": "30.000",
            "v_s_px_per_s": "-30.000",
            "v_t_px_per_s": "5.000",
        },
    ]


def test_rows_come_by_id_and_only_of_what_is_reported_and_near(tmp_path: Path) -> None:
    hidden = at(2, 10, 50, reported=False)
    frame = result_of(FRAME, 0, at(3, 10, 81), hidden, at(1, 10, 50))
    rows = rows_of(tmp_path, frame, result_of(FRAME, 1))
    assert [(row["id"], row["path"]) for row in rows] == [
        ("1", "lane, left"),
        ("1", "back"),
        ("3", "back"),
    ]


def test_a_prediction_at_the_end_of_the_world_is_by_no_path(tmp_path: Path) -> None:
    assert rows_of(tmp_path, result_of(FRAME, 0, at(1, 1e12, 50), at(2, np.nan, 50))) == []


def test_the_nearest_path_of_a_track() -> None:
    assert getattr(nearest_place(at(1, 10, 69), PATHS), "path", None) == "lane, left"  # type: ignore[arg-type]
    assert getattr(nearest_place(at(1, 10, 71), PATHS), "path", None) == "back"  # type: ignore[arg-type]
    lane = Paths({"lane": PATHS["lane, left"]})
    assert nearest_place(at(1, 10, 90), lane) is None  # type: ignore[arg-type]
    # Beside the line beyond its end: the distance is that from the end.
    two = Paths({"short": ImagePath([(0, 0), (100, 0)]), "long": ImagePath([(0, 40), (300, 40)])})
    assert getattr(nearest_place(at(1, 200, 5), two), "path", None) == "long"  # type: ignore[arg-type]
