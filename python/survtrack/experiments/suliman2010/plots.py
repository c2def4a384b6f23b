# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots of the synthetic scenes."""

from typing import TYPE_CHECKING

from survtrack.experiments.following_plots import legend_below
from survtrack.experiments.plotting import BLUE, GREY, ORANGE, new_figure, plain, png
from survtrack.experiments.suliman2010.scenes import VISIBLE, Made

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PLOT_TEXTS = {
    "reentry": "The contact leaves at the right and comes back: its x and that of the marker, "
    "which is predicted while nothing is seen. Grey: the contact is out of the frame.",
    "centroid_and_estimate": "Distance to the truth of the flow's own centroid and of the filter's "
    "estimate, by frame.",
}


def plots(made: Made) -> dict[str, bytes]:
    """PNG files by name."""
    return {"reentry": png(_reentry(made)), "centroid_and_estimate": png(_compared(made))}


def _reentry(made: Made) -> "Figure":
    figure = new_figure(3.4)
    [panels] = figure.subplots(1, len(made.reentries), sharey=True, squeeze=False)
    for axes, (way, one) in zip(panels, made.reentries.items(), strict=True):
        there = one.visible >= VISIBLE
        path = one.positions[:, 0].copy()
        path[~there] = float("nan")
        axes.axvspan(one.left, one.back, color="#EEEEEE")
        axes.plot(one.indices, path, color="#BBBBBB", linewidth=6, label="truth")
        axes.plot(one.indices, one.markers[:, 0], ".", color=BLUE, markersize=3, label="marker")
        axes.axhline(384, color=GREY, linestyle=":", linewidth=0.8, label="right border")
        axes.set_title(way, fontsize="small")
        axes.set_ylim(0, 420)
        axes.set_xlabel("frame")
        plain(axes)
    panels[0].set_ylabel("x, px")
    legend_below(figure, panels[0])
    return figure


def _compared(made: Made) -> "Figure":
    figure = new_figure(2.9)
    [panels] = figure.subplots(1, len(made.trials), sharey=True, squeeze=False)
    top_px = 1.05 * max(float(errors[:, 1:].max()) for errors in made.errors.values())
    for axes, trial in zip(panels, made.trials, strict=True):
        errors = made.errors[trial.key]
        axes.plot(errors[:, 0], errors[:, 1], color=BLUE, linewidth=1, label="flow's centroid")
        axes.plot(
            errors[:, 0], errors[:, 2], "--", color=ORANGE, linewidth=1, label="filter's estimate"
        )
        axes.set_title(trial.label.replace(", ", "\n", 1), fontsize="small")
        axes.set_xlabel("frame")
        axes.set_ylim(0, top_px)
        plain(axes)
    panels[0].set_ylabel("distance to the truth, px")
    legend_below(figure, panels[0])
    return figure
