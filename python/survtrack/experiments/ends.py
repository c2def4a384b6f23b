# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Lost contacts against the ends of true tracks."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from survtrack.evaluation.overlap import best_matching
from survtrack.experiments.footage import Footage

WITHIN_S = 1.0


@dataclass(frozen=True)
class End:
    """A track that was said to be lost.

    Attributes:
        frame: of its last measurement, from 1.
        told_frame: of the event.
        position: (x, y) of the last measurement, px.
        place: border, behind_object or open.
    """

    frame: int
    told_frame: int
    position: tuple[float, float]
    place: str


@dataclass(frozen=True)
class Ends:
    """How they compare.

    Attributes:
        true_ends: true tracks that end before the footage does.
        told: events of ended tracks.
        matched: pairs of both, one to one: the last measurement within WITHIN_S of the true end,
            and no further from the centre of the last true box than that box is high.
        distance_px: median distance of those; NaN without any.
        latency_frames: median from the last measurement to the event, of all events; NaN without.
        places: how many events name each place.
    """

    true_ends: int
    told: int
    matched: int
    distance_px: float
    latency_frames: float
    places: dict[str, int]


def compare_ends(footage: Footage, ends: Sequence[End]) -> Ends:
    """Match what was told with the truth, closest pairs first."""
    truth, within = footage.truth, WITHIN_S * footage.fps
    last: list[tuple[int, float, float, float]] = []
    for id in np.unique(truth.ids[~truth.ignore]):
        rows = np.flatnonzero(truth.ids == id)
        row = rows[np.argmax(truth.frames[rows])]
        left, top, width, height = truth.boxes[row]
        if truth.frames[row] < len(footage.frames):
            centre = (left + width / 2, top + height / 2)
            last.append((int(truth.frames[row]), *centre, height))
    fit = np.zeros((len(last), len(ends)))
    away = np.zeros_like(fit)
    for row, (frame, x, y, height) in enumerate(last):
        for column, end in enumerate(ends):
            away[row, column] = np.hypot(end.position[0] + 0.5 - x, end.position[1] + 0.5 - y)
            if abs(end.frame - frame) <= within and away[row, column] <= height:
                fit[row, column] = 2 - away[row, column] / height
    rows, columns = best_matching(fit) if fit.size else (np.array([], int), np.array([], int))
    latencies = [end.told_frame - end.frame for end in ends]
    places = dict.fromkeys(("border", "behind_object", "open"), 0)
    for end in ends:
        places[end.place] = places.get(end.place, 0) + 1
    return Ends(
        len(last),
        len(ends),
        len(rows),
        float(np.median(away[rows, columns])) if len(rows) else float("nan"),
        float(np.median(latencies)) if latencies else float("nan"),
        places,
    )
