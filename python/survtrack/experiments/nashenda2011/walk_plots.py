# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots of the walk, in kind those of figures 14 to 22."""

from typing import TYPE_CHECKING

import numpy as np

from survtrack.experiments.following_plots import legend_below
from survtrack.experiments.nashenda2011 import published
from survtrack.experiments.nashenda2011.filters import Way
from survtrack.experiments.nashenda2011.walk import Walk
from survtrack.experiments.plotting import BLUE, GREEN, GREY, ORANGE, new_figure, plain, png

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SKY, PINK = "#56B4E9", "#CC79A7"
Q_STYLES = {
    0.0: (ORANGE, "-"), 1.0: (PINK, "--"), 10.0: (GREEN, "-."), 50.0: (SKY, "--"),
    100.0: (BLUE, ":"),
}  # fmt: skip
WAY_STYLES: dict[Way, tuple[str, str]] = {"published": (ORANGE, "--"), "corrected": (BLUE, "-")}
TRUTH = "#BBBBBB"
SHOWN = (11, 19)
AROUND = (88, 101)

WALK_TEXTS = {
    "frames_11_to_19": "In kind figures 14 to 18: x in frames 11 to 19, after the person has "
    "turned round, for each q. What leaves the panel is further off.",
    "path": "In kind figure 19: the path, q = 100.",
    "x": "In kind figure 20: x by frame, q = 100; the person is hidden in frames 93 and 94.",
    "occlusion": "In kind figure 21: x about the two hidden frames (grey), corrected. Left what "
    "the text says, a prediction; right the listing's `continue`, after which the filter starts "
    "from (0, 0).",
    "y": "In kind figure 22: y by frame, with B u and without.",
}


def walk_plots(walk: Walk) -> dict[str, bytes]:
    """PNG files by name."""
    return {
        "frames_11_to_19": png(_each_q(walk)),
        "path": png(_path(walk)),
        "x": png(_x(walk)),
        "occlusion": png(_occlusion(walk)),
        "y": png(_y(walk)),
    }


def _each_q(walk: Walk) -> "Figure":
    rows = slice(walk.row(SHOWN[0]), walk.row(SHOWN[1]) + 1)
    truth = walk.truth[rows, 0]
    figure = new_figure(4.6)
    grid = figure.subplots(2, 3, sharex=True, sharey=True)
    for axes, q in zip(grid.flat, published.SWEEP, strict=False):
        axes.plot(walk.frames[rows], truth, color=TRUTH, linewidth=5, label="truth")
        axes.plot(walk.frames[rows], walk.measured[rows, 0], ".", color=GREY, label="measured")
        for way, (color, dash) in WAY_STYLES.items():
            line = walk.estimates[way][q][rows, 0]
            axes.plot(walk.frames[rows], line, dash, color=color, linewidth=1.2, label=way)
        axes.set_title(f"q = {q:g}", fontsize="small")
        axes.set_ylim(truth.min() - 30, truth.max() + 30)
        plain(axes)
    grid.flat[-1].set_visible(False)
    for axes in (grid[1, 0], grid[1, 1], grid[0, 2]):
        axes.set_xlabel("frame")
    grid[0, 2].tick_params(labelbottom=True)
    for line in grid:
        line[0].set_ylabel("x, px")
    legend_below(figure, grid[0, 0])
    return figure


def _path(walk: Walk) -> "Figure":
    figure = new_figure(3.6)
    axes = figure.subplots()
    axes.plot(*walk.truth.T, color=TRUTH, linewidth=5, label="truth")
    axes.plot(*walk.measured.T, ".", color=GREY, markersize=3, label="measured")
    for way, (color, dash) in WAY_STYLES.items():
        axes.plot(*walk.estimates[way][100.0].T, dash, color=color, linewidth=1, label=way)
    axes.invert_yaxis()
    axes.set_xlabel("x, px")
    axes.set_ylabel("y, px")
    plain(axes)
    legend_below(figure, axes)
    return figure


def _x(walk: Walk) -> "Figure":
    figure = new_figure(3.0)
    axes = figure.subplots()
    _truth(axes, walk, 0)
    for way, (color, dash) in WAY_STYLES.items():
        line = walk.estimates[way][100.0][:, 0]
        axes.plot(walk.frames, line, dash, color=color, linewidth=1, label=way)
    axes.set_xlabel("frame")
    axes.set_ylabel("x, px")
    plain(axes)
    legend_below(figure, axes)
    return figure


def _occlusion(walk: Walk) -> "Figure":
    rows = slice(walk.row(AROUND[0]), walk.row(AROUND[1]) + 1)
    frames, truth = walk.frames[rows], walk.truth[rows, 0]
    hidden = walk.frames[np.isnan(walk.measured[:, 0])]
    figure = new_figure(3.4)
    left, right = figure.subplots(1, 2)
    for axes, of, title in (
        (left, walk.estimates["corrected"], "predicted"),
        (right, walk.skipping, "skipped, as in the listing"),
    ):
        axes.axvspan(hidden.min() - 0.5, hidden.max() + 0.5, color="#EEEEEE")
        axes.plot(frames, truth, color=TRUTH, linewidth=5, label="truth")
        for q, (color, dash) in Q_STYLES.items():
            axes.plot(frames, of[q][rows, 0], dash, color=color, linewidth=1.2, label=f"q = {q:g}")
        axes.set_title(title, fontsize="small")
        axes.set_xlabel("frame")
        plain(axes)
    left.set_ylim(truth.min() - 15, truth.max() + 15)
    left.set_ylabel("x, px")
    legend_below(figure, left)
    return figure


def _y(walk: Walk) -> "Figure":
    figure = new_figure(3.4)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, way in zip(panels, WAY_STYLES, strict=True):
        _truth(axes, walk, 1)
        for q in (0.0, 10.0, 50.0, 100.0):
            color, dash = Q_STYLES[q]
            line = walk.estimates[way][q][:, 1]
            axes.plot(walk.frames, line, dash, color=color, linewidth=1.2, label=f"q = {q:g}")
        axes.set_title(way, fontsize="small")
        axes.set_xlabel("frame")
        plain(axes)
    panels[0].set_ylim(walk.truth[:, 1].min() - 40, walk.truth[:, 1].max() + 40)
    panels[0].set_ylabel("y, px")
    legend_below(figure, panels[0])
    return figure


def _truth(axes: "Axes", walk: Walk, axis: int) -> None:
    axes.plot(walk.frames, walk.truth[:, axis], color=TRUTH, linewidth=5, label="truth")
    axes.plot(walk.frames, walk.measured[:, axis], ".", color=GREY, markersize=3, label="measured")
