# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots of the artificial trials."""

from typing import TYPE_CHECKING

from survtrack.experiments.following_plots import (
    COLORS,
    legend_below,
    norms_over_time,
    tracks_over_time,
)
from survtrack.experiments.plotting import GREY, new_figure, plain, png
from survtrack.experiments.semko2007.artificial import LIMIT_PX, Made
from survtrack.experiments.semko2007.trials import REMOVED

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PLOT_TEXTS = {
    "norms": "Norm of truth - estimate by frame, of each contact: masks without noise, and "
    "measurements with a noise of 1 px a coordinate. Dotted: 1 px.",
    "tracks_one": "x and y of the one contact, masks; the truth is the wide grey line.",
    "tracks_three": "The same of three contacts at once.",
    "flow": "Norm of truth - estimate by frame, video through the optical flow.",
    "lost": "The contact that is removed: it is predicted until 13 of the last 25 counts are "
    "lower, then the event comes (dashed).",
}


def plots(made: Made) -> dict[str, bytes]:
    """PNG files by name."""
    both = {
        trial.label: {
            "masks": made.runs[trial.key]["masks"].followed,
            "measurement noise, 1 px": made.runs[trial.key]["noise"].followed,
        }
        for trial in made.trials
    }
    flow = {
        trial.label: {"optical flow": made.runs[trial.key]["flow"].followed}
        for trial in made.trials
    }
    masks = {trial.label: made.runs[trial.key]["masks"].followed for trial in made.trials}
    one = {label: each for label, each in masks.items() if len(each) == 1}
    three = {label: each for label, each in masks.items() if len(each) == 3}
    return {
        "norms": png(norms_over_time(both, 5.0, LIMIT_PX)),
        "tracks_one": png(tracks_over_time(one)),
        "tracks_three": png(tracks_over_time(three)),
        "flow": png(norms_over_time(flow, 40.0, LIMIT_PX)),
        "lost": png(_lost(made)),
    }


def _lost(made: Made) -> "Figure":
    figure = new_figure(3.0)
    axes = figure.subplots()
    run = made.lost["removed, masks"]
    for number, one in enumerate(run.followed):
        name = "truth" if number == 0 else None
        axes.plot(one.indices, one.truth[:, 0], color="#BBBBBB", linewidth=5, label=name)
    for number, path in enumerate(run.paths.values()):
        name = "estimate" if number == 0 else None
        axes.plot(path[:, 0], path[:, 1], color=COLORS[number % len(COLORS)], label=name)
    axes.axvline(REMOVED, color=GREY, linestyle=":", label="removed")
    for event in run.ended:
        axes.axvline(event.index, color=GREY, linestyle="--", label="event")
        axes.plot([event.index], [event.position[0] + 0.5], "kx", label="its place")
    axes.set_xlabel("frame")
    axes.set_ylabel("x, px")
    plain(axes)
    legend_below(figure, axes)
    return figure
