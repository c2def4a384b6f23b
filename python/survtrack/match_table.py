# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The matrix of one frame's association, with names for its rows and columns."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult, TrackingResult


@dataclass(frozen=True, eq=False)
class MatchTable:
    """Who could be who, and who was taken for whom.

    kind: "belief" (probabilities; Narayana 2007, 8) or "cost" (the smaller, the better).
    track_ids: of the rows, the tracks open before the frame; 0 is a tentative track.
    columns: "blob 1", "blob 2", ... in the order of the frame's detections; beliefs end with
        "lost".
    values: rows x columns; a refused pair costs inf.
    assigned: of each row the column that it was assigned; None without one.
    """

    kind: str
    track_ids: list[int]
    columns: list[str]
    values: npt.NDArray[np.float64]
    assigned: list[int | None]

    @property
    def rows(self) -> list[str]:
        """Names of the rows: "track 7", "tentative"."""
        return [f"track {track_id}" if track_id else "tentative" for track_id in self.track_ids]


def match_table(result: "FrameResult | TrackingResult") -> MatchTable:
    """The table of one result.

    Raises:
        UsageError: the result holds no matrix.
    """
    values = result.costs if result.beliefs is None else result.beliefs
    if values is None:
        raise UsageError("matrix: this result has none; outputs.cost_matrix is false")
    kind = "cost" if result.beliefs is None else "belief"
    blobs = values.shape[1] - (kind == "belief")
    assigned: list[int | None] = [None] * len(values)
    for match in result.matches:
        if match.assigned:
            assigned[match.track] = match.detection
    return MatchTable(
        kind=kind,
        track_ids=list(result.matrix_track_ids),
        columns=[f"blob {k + 1}" for k in range(blobs)] + ["lost"] * (kind == "belief"),
        values=values,
        assigned=assigned,
    )
