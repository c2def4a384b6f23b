# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where tracks are along paths, as a table."""

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from survtrack.path_file import TrackPlace, places_of
from survtrack.sinks.base import TextSink

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Paths

COLUMNS = (
    "frame",
    "time_s",
    "id",
    "path",
    "s_px",
    "t_px",
    "v_s_px_per_s",
    "v_t_px_per_s",
)


class PathCsv(TextSink):
    """One row a frame, reported track and path that it is not too far from; columns are COLUMNS.

    frame counts from 1 as in tracks.txt; S and T are of the track's position, px, and their rates
    of its velocity. A track that is farther from a path than its max_distance_px has no row by it.
    """

    header = ",".join(COLUMNS) + "\n"

    def __init__(self, path: Path | str, paths: "Paths") -> None:
        """Args:
        path: the file to write.
        paths: those by which tracks are placed.
        """
        super().__init__(path)
        self._paths = paths

    def lines(self, result: "FrameResult") -> Iterable[str]:
        """Rows of one frame, by id, then in the order of the paths."""
        frame = [result.index + 1, f"{result.time_s:.6f}"]
        for track in sorted(result.tracks, key=lambda track: track.id):
            if track.reported:
                for place in places_of(track, self._paths):
                    yield _row([*frame, track.id, place.path, *_numbers(place)])


def _numbers(place: TrackPlace) -> list[str]:
    numbers = (place.s_px, place.t_px, place.v_s_px_per_s, place.v_t_px_per_s)
    return [f"{number:.3f}" for number in numbers]


def _row(values: list[object]) -> str:
    """One line of CSV: names may hold commas and quotes."""
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(values)
    return text.getvalue()
