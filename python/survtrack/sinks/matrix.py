# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The association's matrices as JSON lines."""

import json
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from survtrack.match_table import match_table
from survtrack.sinks.base import TextSink

if TYPE_CHECKING:
    from survtrack._core import FrameResult


class MatrixLines(TextSink):
    """One JSON object a line and frame; needs config.outputs.cost_matrix.

    Keys: frame (from 1, as in tracks.txt), time_s, kind ("belief" or "cost"), track_ids (rows; 0
    is tentative), columns ("blob 1", ..., "lost"), values (row by row; null for a pair that is
    refused), assigned (a row's column from 0, or null).
    """

    def lines(self, result: "FrameResult") -> Iterable[str]:
        """The matrix of one frame."""
        table = match_table(result)
        yield json.dumps(
            {
                "frame": result.index + 1,
                "time_s": round(result.time_s, 6),
                "kind": table.kind,
                "track_ids": table.track_ids,
                "columns": table.columns,
                "values": [[_rounded(value) for value in row] for row in table.values.tolist()],
                "assigned": table.assigned,
            },
            allow_nan=False,
        )


def _rounded(value: float) -> float | None:
    return float(f"{value:.6g}") if math.isfinite(value) else None
