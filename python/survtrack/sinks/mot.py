# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Tracks as MOT Challenge text."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from survtrack.sinks.base import TextSink

if TYPE_CHECKING:
    from survtrack._core import FrameResult


class MotText(TextSink):
    """One row a reported track and frame: frame, id, left, top, width, height, 1, -1, -1, -1.

    Frames count the source's frames from 1, whatever start and step; the rest is pixels. The
    confidence is 1 throughout, as in the results of the benchmark: a row stands because the track
    is part of the answer.
    """

    def lines(self, result: "FrameResult") -> Iterable[str]:
        """Rows of one frame, by id."""
        for track in sorted(result.tracks, key=lambda track: track.id):
            if track.reported:
                box = track.box
                yield (
                    f"{result.index + 1},{track.id},{box.x:.3f},{box.y:.3f},"
                    f"{box.width:.3f},{box.height:.3f},1,-1,-1,-1"
                )
