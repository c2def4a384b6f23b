# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Plots of estimates beside the truth, of synthetic scenes and of footage."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from survtrack.evaluation import Boxes
from survtrack.experiments.following import Followed
from survtrack.experiments.plotting import BLUE, GREEN, GREY, ORANGE, new_figure, plain

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLORS = (BLUE, ORANGE, GREEN)
DASHES = ("-", "--", ":")

Lines = Mapping[str, Sequence[Followed]]


def norms_over_time(panels: Mapping[str, Lines], top_px: float, limit_px: float) -> "Figure":
    """|truth - estimate| by frame, a panel for each trial, a colour for each way.

    Args:
        panels: by the trial's label, by the way's label: its contacts.
        top_px: end of the axis; what is above is cut off.
        limit_px: a dotted line.
    """
    columns = 3
    rows = -(-len(panels) // columns)
    figure = new_figure(2.1 * rows + 0.6)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, (title, lines) in zip(grid.flat, panels.items(), strict=False):
        for (label, contacts), color, dash in zip(lines.items(), COLORS, DASHES, strict=False):
            for number, one in enumerate(contacts):
                name = label if number == 0 else None
                axes.plot(one.indices, one.norms, dash, color=color, linewidth=1.1, label=name)
        axes.axhline(limit_px, color=GREY, linestyle=":", linewidth=0.8)
        axes.set_title(_folded(title), fontsize="small")
        axes.set_ylim(0, top_px)
        plain(axes)
    for axes in grid[-1]:
        axes.set_xlabel("frame")
    for line in grid:
        line[0].set_ylabel("|truth - estimate|, px")
    legend_below(figure, grid.flat[0])
    return figure


def tracks_over_time(panels: Mapping[str, Sequence[Followed]]) -> "Figure":
    """x and y by frame, a column for each trial; truth grey and wide, estimates on it."""
    figure = new_figure(4.6)
    grid = figure.subplots(2, len(panels), sharex=True, sharey="row", squeeze=False)
    for column, (title, contacts) in enumerate(panels.items()):
        for row, name in enumerate("xy"):
            axes = grid[row, column]
            for number, one in enumerate(contacts):
                truth, estimate = one.truth[:, row], one.estimate[:, row]
                words = ("truth", "estimate") if number == 0 else (None, None)
                axes.plot(one.indices, truth, color="#BBBBBB", linewidth=5, label=words[0])
                axes.plot(
                    one.indices, estimate, color=COLORS[number % 3], linewidth=1.2, label=words[1]
                )
            if row == 0:
                axes.set_title(_folded(title), fontsize="small")
            else:
                axes.set_xlabel("frame")
            if column == 0:
                axes.set_ylabel(f"{name}, px")
            plain(axes)
    legend_below(figure, grid[0, 0])
    return figure


def markers_over_time(
    truth: Boxes, markers: Mapping[str, NDArray[np.float64]], size: tuple[int, int]
) -> "Figure":
    """x and y of every marker, a row for each configuration; the true boxes are grey bands.

    Args:
        truth: frames from 1.
        markers: (N, 4) frame, track id, x, y, of each configuration.
        size: (width, height) of the frames, px.
    """
    figure = new_figure(1.9 * len(markers) + 0.6)
    grid = figure.subplots(len(markers), 2, sharex=True, sharey="col", squeeze=False)
    for line, (name, rows) in zip(grid, markers.items(), strict=True):
        for axis, axes in enumerate(line):
            low = truth.boxes[:, axis]
            high = low + truth.boxes[:, axis + 2]
            for ignored, color in ((False, "#CCCCCC"), (True, "#EEEEEE")):
                kept = truth.ignore == ignored
                axes.vlines(truth.frames[kept], low[kept], high[kept], color=color, linewidth=1.5)
            for id in np.unique(rows[:, 1]):
                own = rows[rows[:, 1] == id]
                axes.plot(own[:, 0], own[:, 2 + axis], ".", color=COLORS[int(id) % 3], markersize=2)
            axes.set_ylim(0, size[axis])
            axes.set_title(f"{name}: {'xy'[axis]}, px", fontsize="small")
            plain(axes)
    for axes in grid[-1]:
        axes.set_xlabel("frame")
    return figure


def legend_below(figure: "Figure", *panels: "Axes") -> None:
    """One legend for all panels, of the lines of these, where it covers nothing."""
    told = [axes.get_legend_handles_labels() for axes in panels]
    handles = [handle for one, _ in told for handle in one]
    labels = [label for _, one in told for label in one]
    figure.legend(handles, labels, loc="outside lower center", ncols=4, frameon=False)


def _folded(title: str) -> str:
    """On two lines at most."""
    return title.replace(", ", "\n", 1)
