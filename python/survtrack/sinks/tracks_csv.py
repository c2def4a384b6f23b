# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Tracks as a table with everything that is known of them."""

import csv
import io
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from survtrack.sinks.base import TextSink

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Track

COLUMNS = (
    "frame",
    "time_s",
    "file",
    "id",
    "status",
    "left_px",
    "top_px",
    "width_px",
    "height_px",
    "x_px",
    "y_px",
    "velocity_x_px_per_s",
    "velocity_y_px_per_s",
    "covariance_xx_px2",
    "covariance_xy_px2",
    "covariance_yy_px2",
    "age_frames",
    "lost_frames",
    "mean_blue",
    "mean_green",
    "mean_red",
)


class TracksCsv(TextSink):
    """One row a reported track and frame; the columns are COLUMNS.

    frame counts from 1 as in tracks.txt; file is the image's name, empty for a video; the mean
    colour, 0 to 255 a channel, is that of the detection last matched.
    """

    header = ",".join(COLUMNS) + "\n"

    def __init__(
        self, path: Path | str, file_name: Callable[[int], str | None] = lambda index: None
    ) -> None:
        """Args:
        path: the file to write.
        file_name: from a frame's index to its file's name, as Source.file_name.
        """
        super().__init__(path)
        self._file_name = file_name

    def lines(self, result: "FrameResult") -> Iterable[str]:
        """Rows of one frame, by id."""
        frame = [result.index + 1, f"{result.time_s:.6f}", self._file_name(result.index) or ""]
        for track in sorted(result.tracks, key=lambda track: track.id):
            if track.reported:
                yield _row([*frame, track.id, track.status.name, *_measures(track)])


def _measures(track: "Track") -> list[object]:
    box, covariance = track.box, track.position_covariance_px2
    numbers = (
        *(box.x, box.y, box.width, box.height),
        *track.position,
        *track.velocity_px_per_s,
        *(covariance[0, 0], covariance[0, 1], covariance[1, 1]),
    )
    color = [f"{channel:.3f}" for channel in track.mean_color]
    ages = [track.age_frames, track.lost_frames]
    return [*(f"{number:.3f}" for number in numbers), *ages, *color]


def _row(values: list[object]) -> str:
    """One line of CSV: names of files may hold commas and quotes."""
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(values)
    return text.getvalue()
