# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The association's matrix as a table."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from survtrack.drawing.colors import BLACK, Color, color_of_id, ink_on
from survtrack.drawing.scene import Scene, Style, draw_label
from survtrack.match_table import MatchTable, match_table

if TYPE_CHECKING:
    from survtrack._core import FrameResult

PAPER: Color = (32, 32, 32)
STRONG: Color = (90, 160, 40)  # the paper of a belief of 1
TAKEN: Color = (0, 215, 255)


@dataclass(frozen=True)
class _Layout:
    """Cells in pixels, below a line that the caption takes."""

    top: int
    head: int
    width: int
    height: int
    rows: int
    columns: int


class MatrixRenderer:
    """Rows are tracks, columns blobs and, of beliefs, "lost"; the assigned pairs are framed.

    What does not fit into the picture is counted below the table.
    """

    def annotate(self, scene: Scene, result: "FrameResult") -> Scene:
        """Draw the table over the whole scene, HxWx3 BGR, in place; return it.

        Raises:
            UsageError: the result holds no matrix.
        """
        table = match_table(result)
        scene[:] = PAPER
        layout = _layout(scene, table)
        shown = _shown_columns(table, layout.columns)
        for place, column in enumerate(shown):
            name = table.columns[column].removeprefix("blob ")
            _draw_cell(scene, layout, 0, place + 1, name, PAPER)
        for row in range(layout.rows):
            _draw_row(scene, layout, table, row, shown)
        _draw_rest(scene, table, layout)
        return scene


def _layout(scene: Scene, table: MatchTable) -> _Layout:
    import cv2

    style = Style.of(scene)
    (text, line), below = cv2.getTextSize(
        "0.00", cv2.FONT_HERSHEY_SIMPLEX, style.font_scale, style.line
    )
    width, height = text + 4 * style.margin, line + below + 3 * style.margin
    head = 2 * width
    top = 2 * height
    return _Layout(
        top=top,
        head=head,
        width=width,
        height=height,
        rows=min(len(table.track_ids), max(0, (scene.shape[0] - top) // height - 2)),
        columns=min(len(table.columns), max(0, (scene.shape[1] - head) // width)),
    )


def _shown_columns(table: MatchTable, most: int) -> list[int]:
    """The first columns, and "lost" in any case."""
    shown = list(range(most))
    if shown and table.columns[-1] == "lost":
        shown[-1] = len(table.columns) - 1
    return shown


def _draw_row(scene: Scene, layout: _Layout, table: MatchTable, row: int, shown: list[int]) -> None:
    track_id = table.track_ids[row]
    _draw_cell(
        scene, layout, row + 1, 0, table.rows[row], color_of_id(track_id) if track_id else PAPER
    )
    for place, column in enumerate(shown):
        value = table.values[row, column]
        text = f"{value:.2f}" if np.isfinite(value) else "-"
        taken = table.assigned[row] == column
        _draw_cell(
            scene, layout, row + 1, place + 1, text, _paper(table, float(value)), framed=taken
        )


def _paper(table: MatchTable, value: float) -> Color:
    """The more probable, the greener."""
    part = min(max(value, 0.0), 1.0) if table.kind == "belief" else 0.0
    blue, green, red = (
        round(weak + part * (strong - weak)) for weak, strong in zip(PAPER, STRONG, strict=True)
    )
    return blue, green, red


def _draw_cell(
    scene: Scene,
    layout: _Layout,
    row: int,
    column: int,
    text: str,
    paper: Color,
    *,
    framed: bool = False,
) -> None:
    import cv2

    style = Style.of(scene)
    left = 0 if column == 0 else layout.head + (column - 1) * layout.width
    width = layout.head if column == 0 else layout.width
    top = layout.top + row * layout.height
    end = (left + width - 2, top + layout.height - 2)
    cv2.rectangle(scene, (left, top), end, paper, cv2.FILLED)
    if framed:
        cv2.rectangle(scene, (left, top), end, TAKEN, style.line)
    origin = (left + style.margin, top + layout.height - 2 * style.margin)
    font = cv2.FONT_HERSHEY_SIMPLEX
    cv2.putText(scene, text, origin, font, style.font_scale, ink_on(paper), style.line, cv2.LINE_AA)


def _draw_rest(scene: Scene, table: MatchTable, layout: _Layout) -> None:
    rows = len(table.track_ids) - layout.rows
    columns = len(table.columns) - layout.columns
    words = [f"tracks not shown: {rows}"] * (rows > 0)
    words += [f"blobs not shown: {columns}"] * (columns > 0)
    words = words or ([] if table.track_ids else ["no track yet"])
    if words:
        bottom = layout.top + (layout.rows + 2) * layout.height
        draw_label(scene, ", ".join(words), (0, min(bottom, scene.shape[0])), BLACK)
