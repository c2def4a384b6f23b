# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""People who walk two streets that cross, as tracks."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import survtrack
from runs import write_run
from survtrack.sinks.tracks_csv import COLUMNS

SIZE = (480, 400)
Place = tuple[float, float]
EAST: tuple[Place, Place] = ((40, 200), (440, 200))
WEST: tuple[Place, Place] = ((440, 200), (40, 200))
SOUTH: tuple[Place, Place] = ((240, 40), (240, 360))
NORTH: tuple[Place, Place] = ((240, 360), (240, 40))
USUAL = [EAST] * 6 + [WEST] * 5 + [SOUTH] * 4 + [NORTH] * 3
JAYWALKER: tuple[Place, Place] = ((380, 100), (380, 300))


def points_between(way: tuple[Place, Place], speed: float = 40.0) -> np.ndarray:
    """Nx2 positions from one place to the other at ten frames a second and `speed` px/s."""
    start, end = np.array(way, dtype=float)
    length = float(np.hypot(*(end - start)))
    steps = np.arange(round(10 * length / speed) + 1) * speed / 10 / length
    return start + steps[:, np.newaxis] * (end - start)


def history_of(
    ways: Sequence[tuple[Place, Place]], speeds: Sequence[float] = (), first_id: int = 1
) -> survtrack.History:
    """One track of a box of 20 x 80 px a way, at its speed in px/s (40); all start at once."""
    places = [
        points_between(way, speed)
        for way, speed in zip(ways, [*speeds, *[40.0] * (len(ways) - len(speeds))], strict=True)
    ]
    ids = [first_id + k for k, place in enumerate(places) for _ in place]
    frames = np.concatenate([np.arange(len(place)) for place in places])
    centres = np.concatenate(places)
    boxes = np.column_stack([centres - (10, 40), np.full_like(centres, (20, 80))])
    return survtrack.History.from_columns(ids=ids, indices=frames, times_s=frames / 10, boxes=boxes)


def write_streets(
    folder: Path,
    ways: Sequence[tuple[Place, Place]],
    speeds: Sequence[float] = (),
    **facts: Any,
) -> Path:
    """A run whose tracks go these ways."""
    write_run(folder, walks=(), size=list(SIZE), **facts)
    rows = []
    for point in history_of(ways, speeds).array:
        cells = dict.fromkeys(COLUMNS, "0")
        cells |= {
            "frame": str(point["index"] + 1),
            "time_s": f"{point['time_s']:.6f}",
            "id": str(point["id"]),
            "left_px": f"{point['x']:.3f}",
            "top_px": f"{point['y']:.3f}",
            "width_px": "20.000",
            "height_px": "80.000",
            "x_px": f"{point['position_x']:.3f}",
            "y_px": f"{point['position_y']:.3f}",
        }
        rows.append(",".join(cells.values()))
    (folder / "tracks.csv").write_text("\n".join([",".join(COLUMNS), *rows]) + "\n")
    return folder
