# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots, in kind those of figures 5 to 9."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.following_plots import legend_below
from survtrack.experiments.omalley2000 import published
from survtrack.experiments.omalley2000.measured import Made, raw_velocities
from survtrack.experiments.plotting import BLUE, GREY, ORANGE, new_figure, plain, png

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TRUTH = "#BBBBBB"
PLOT_TEXTS = {
    "s": "In kind figure 5: S predicted and measured.",
    "s_difference": "In kind figure 6: predicted less measured S, by the values of the text and by "
    "identified ones. Dotted: 1.4 % of the length, the largest that is printed.",
    "v_s": "In kind figure 7: raw and filtered velocity along the track.",
    "v_t": "In kind figure 8: raw and filtered velocity across it; the truth is 0.",
    "regions": "Area and hit rate by the number of sigmas, whole object, identified values.",
    "t": "In kind figure 9: measured and filtered T.",
}


def plots(made: Made) -> dict[str, bytes]:
    """PNG files by name."""
    velocities = raw_velocities(made.race.measured)
    predicted = made.runs["text"].predicted
    return {
        "s": png(_s(made)),
        "s_difference": png(_difference(made)),
        "v_s": png(
            _compared(made, velocities[:, 0], predicted[:, 2], made.race.truth[:, 2], "vS, per s")
        ),
        "v_t": png(
            _compared(made, velocities[:, 1], predicted[:, 3], made.race.truth[:, 3], "vT, per s")
        ),
        "regions": png(_regions(made)),
        "t": png(
            _compared(made, made.race.measured[:, 1], predicted[:, 1], made.race.truth[:, 1], "T")
        ),
    }


def _s(made: Made) -> "Figure":
    figure = new_figure(3.0)
    axes = figure.subplots()
    times = made.race.times_s[: published.SHOWN]
    predicted = np.mod(made.runs["text"].predicted[: published.SHOWN, 0], published.LENGTH)
    measured = made.race.measured[: published.SHOWN, 0]
    axes.plot(times, measured, ".", color=ORANGE, markersize=4, label="measured")
    broken = np.where(np.abs(np.diff(predicted, prepend=predicted[0])) > 100, np.nan, predicted)
    axes.plot(times, broken, "--", color=BLUE, linewidth=1.1, label="predicted")
    _finish(figure, axes, "S")
    return figure


def _difference(made: Made) -> "Figure":
    figure = new_figure(3.0)
    axes = figure.subplots()
    times = made.race.times_s[: published.SHOWN]
    for name, color, dash in (("text", ORANGE, "--"), ("identified", BLUE, "-")):
        off = -made.runs[name].innovations[: published.SHOWN, 0]
        axes.plot(times, off, dash, color=color, linewidth=1.1, label=name)
    for side in (-1, 1):
        limit = side * published.LARGEST_ERROR * published.LENGTH
        axes.axhline(limit, color=GREY, linestyle=":", linewidth=0.8)
    _finish(figure, axes, "predicted - measured S")
    return figure


def _regions(made: Made) -> "Figure":
    figure = new_figure(3.0)
    areas, rates = figure.subplots(1, 2)
    trials = sorted(
        (
            trial
            for trial in made.regions.trials
            if (trial.values, trial.rule) == ("identified", "whole object")
        ),
        key=lambda trial: trial.sigmas[0],
    )
    sigmas = [trial.sigmas[0] for trial in trials]
    areas.plot(sigmas, [one.looked.area_px for one in trials], "o-", color=BLUE, label="regions")
    areas.plot(
        sigmas,
        # Of a rate below one half a box says nothing.
        [one.constant.area_px if one.looked.hit_rate > 0.5 else np.nan for one in trials],
        "s--",
        color=ORANGE,
        label="constant box, as often a hit",
    )
    rates.plot(sigmas, [one.looked.hit_rate for one in trials], "o-", color=BLUE)
    inside = [made.regions.drawn[k] for k in sigmas]
    rates.plot(sigmas, [one for one, _ in inside], "^", color=ORANGE, label="drawn from the model")
    rates.plot(sigmas, [one for _, one in inside], ":", color=GREY, label="theory")
    for axes, label in ((areas, "mean area, px"), (rates, "whole car inside")):
        axes.set_xlabel("sigmas along and across")
        axes.set_ylabel(label)
        axes.set_ylim(bottom=0)
        plain(axes)
    legend_below(figure, areas, rates)
    return figure


def _compared(
    made: Made,
    raw: NDArray[np.float64],
    filtered: NDArray[np.float64],
    truth: NDArray[np.float64],
    label: str,
) -> "Figure":
    figure = new_figure(3.0)
    axes = figure.subplots()
    shown = slice(published.SHOWN)
    times = made.race.times_s[shown]
    axes.plot(times, truth[shown], color=TRUTH, linewidth=5, label="truth")
    axes.plot(times, raw[shown], color=ORANGE, linewidth=0.8, label="raw")
    axes.plot(times, filtered[shown], "--", color=BLUE, linewidth=1.3, label="filtered")
    _finish(figure, axes, label)
    return figure


def _finish(figure: "Figure", axes: "Axes", label: str) -> None:
    axes.set_xlabel("time, s")
    axes.set_ylabel(label)
    plain(axes)
    legend_below(figure, axes)
