# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Folders as `survtrack run` leaves them, made by hand."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from clips import walking_square
from fakes import Box, Track, result_of
from survtrack.sinks import MotText, TracksCsv

FRAME = walking_square(1)[0]


@dataclass(frozen=True)
class Walk:
    """A box of 20 x 80 px that walks to the right, 4 px a frame, at ten frames a second."""

    id: int
    first: int
    last: int
    left: float = 0.0
    top: float = 10.0
    color: tuple[float, float, float] = (100.0, 110.0, 120.0)

    def track(self, index: int) -> Track:
        """As it is in frame `index`, from 0."""
        box = Box(self.left + 4 * (index - self.first), self.top, 20, 80)
        return Track(self.id, box, velocity_px_per_s=(40.0, 0.0), mean_color=self.color)


BROKEN = (Walk(1, 0, 9), Walk(2, 15, 24, left=60), Walk(3, 5, 5, top=300))


def write_run(folder: Path, walks: Sequence[Walk] = BROKEN, count: int = 25, **facts: Any) -> Path:
    """A whole run of `count` frames, with what the link stage reads of it."""
    folder.mkdir(parents=True, exist_ok=True)
    with MotText(folder / "tracks.txt") as mot, TracksCsv(folder / "tracks.csv") as table:
        for index in range(count):
            tracks = [walk.track(index) for walk in walks if walk.first <= index <= walk.last]
            result = result_of(FRAME, index, *tracks)
            mot.write(FRAME, result)
            table.write(FRAME, result)
    said = {
        "survtrack": "0.1.0",
        "command": "run",
        "source": "clip.mp4",
        "preset": "survtrack",
        "complete": True,
        "error": None,
        "frames": {"first": 1, "last": count, "step": 1, "count": count},
        "fps": 10.0,
        "fps_origin": "container",
        "size": [96, 64],
        "outputs": ["tracks.txt", "tracks.csv"],
    }
    (folder / "run.json").write_text(json.dumps({**said, **facts}))
    return folder
