# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Events as JSON lines."""

import json
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from survtrack.sinks.base import TextSink

if TYPE_CHECKING:
    from survtrack._core import Event, FrameResult
    from survtrack.sources.base import Frame


class EventLines(TextSink):
    """One JSON object a line and event.

    Keys: frame (from 1, as in tracks.txt), time_s, kind, track_id, other_track_ids, position
    [x, y] and box [left, top, width, height] in pixels, position_covariance_px2 [xx, xy, yy], place
    (border, behind_object or open: where a track that ended was lost), confidence (of a track that
    came back: that it is the same, 0 to 1), text. What does not apply is null.
    """

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Append the events of one result, to be seen at once by whoever follows the file."""
        super().write(frame, result)
        if result.events:
            self._file.flush()

    def lines(self, result: "FrameResult") -> Iterable[str]:
        """Events of one frame."""
        return (json.dumps(event_as_dict(event), allow_nan=False) for event in result.events)


def event_as_dict(event: "Event") -> dict[str, object]:
    """The event as plain values."""
    box = event.box
    concerns_track = event.track_id > 0
    return {
        "frame": event.index + 1,
        "time_s": round(event.time_s, 6),
        "kind": event.kind.name,
        "track_id": event.track_id if concerns_track else None,
        "other_track_ids": list(event.other_track_ids),
        "position": _numbers(*event.position) if concerns_track else None,
        "box": _numbers(box.x, box.y, box.width, box.height) if concerns_track else None,
        "position_covariance_px2": _covariance(event) if concerns_track else None,
        "place": None if event.place.name == "none" else event.place.name,
        "confidence": _confidence(event),
        "text": event.text,
    }


def _covariance(event: "Event") -> list[float] | None:
    matrix = event.position_covariance_px2
    return _numbers(matrix[0, 0], matrix[0, 1], matrix[1, 1])


def _confidence(event: "Event") -> float | None:
    return round(event.confidence, 3) if event.kind.name == "track_reentered" else None


def _numbers(*values: float) -> list[float] | None:
    """Rounded; None when one of them is not a number, which JSON cannot say."""
    if not all(math.isfinite(value) for value in values):
        return None
    return [round(float(value), 3) for value in values]
