# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots of one set."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from survtrack.experiments.markdown import percent
from survtrack.experiments.narayana2007 import published
from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.variants import (
    BREAK_POINTS,
    CORRESPONDENCES,
    FORMS,
    THRESHOLDS_PX,
    fixed,
    mergings,
    scaled,
    start_factor,
    with_break_point,
    with_merging,
)
from survtrack.experiments.plotting import BLUE, GREEN, GREY, ORANGE, new_figure, plain, png
from survtrack.experiments.trial import Trial

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STYLES = {"Euclidean": (BLUE, "o"), "Bayesian": (ORANGE, "s")}
BUSIEST = ((BLUE, "-"), (ORANGE, "--"), (GREEN, ":"))  # colours and dashes of as many cells
BLOBS_LABEL = "number-of-blobs errors,\n% of instances"


def plots(measured: Measured) -> dict[str, bytes]:
    """PNG files by name."""
    makers: dict[str, Callable[[Measured], Figure]] = {
        "merging": _merging,
        "threshold": _threshold,
        "break_point": _break_point,
        "vicinity": _vicinity,
    }
    return {name: png(make(measured)) for name, make in makers.items()}


def _merging(measured: Measured) -> "Figure":
    """Number-of-blobs errors of every merging, ours as bars and the thesis's as diamonds."""
    figure = new_figure(3.4)
    axes = figure.subplots()
    ways = mergings()
    for index, name in enumerate(CORRESPONDENCES):
        heights = [_blobs(measured, measured.cell(name, way.key, True)) for way in ways]
        places = [at + (index - 0.5) * 0.36 for at in range(len(ways))]
        axes.bar(places, heights, 0.34, color=STYLES[name][0], label=f"{measured.name}, {name}")
    there = [
        (at, published.NUMBER_OF_BLOBS[way.key].percent)
        for at, way in enumerate(ways)
        if way.key in published.NUMBER_OF_BLOBS
    ]
    axes.scatter(*zip(*there, strict=True), marker="D", color="black", label="thesis (cars)")
    axes.set_xticks(range(len(ways)), [_short(way.label) for way in ways])
    axes.set_ylabel(BLOBS_LABEL)
    _finish(figure, axes)
    return figure


def _threshold(measured: Measured) -> "Figure":
    """Number-of-blobs errors over the merging threshold, fixed and scaled, a panel for each
    correspondence."""
    figure = new_figure(3.4)
    panels = figure.subplots(1, len(CORRESPONDENCES), sharey=True)
    start = f"{start_factor():g}"
    for axes, name in zip(panels, CORRESPONDENCES, strict=True):
        for how, color, marker, label in (
            (fixed, BLUE, "o", "fixed"),
            (scaled, ORANGE, "s", f"scaled: base x vicinity factor, base = threshold / {start}"),
        ):
            trials = [measured.trials[with_merging(name, how(px))] for px in THRESHOLDS_PX]
            values = [_blobs(measured, trial) for trial in trials]
            axes.plot(THRESHOLDS_PX, values, color=color, marker=marker, label=label)
        none = _blobs(measured, measured.cell(name, "none", True))
        axes.axhline(none, color=GREY, linestyle="--", label="no merging")
        axes.set_xticks(range(0, max(THRESHOLDS_PX) + 1, 5))
        axes.set_title(f"{name} correspondence", fontsize="medium")
        axes.set_xlabel(f"threshold of merging, px\n(scaled: at the factor's start, {start})")
        plain(axes)
    panels[0].set_ylabel(BLOBS_LABEL)
    _finish(figure, panels[0])
    return figure


def _break_point(measured: Measured) -> "Figure":
    """Index and swap errors over the velocity factor's break-point; dashed without the factor."""
    figure = new_figure(3.4)
    kinds: dict[str, Callable[[Trial], int]] = {
        "index errors": lambda trial: trial.scores.index_errors,
        "swap errors": lambda trial: trial.scores.swap_errors,
    }
    for axes, (kind, errors) in zip(figure.subplots(1, 2), kinds.items(), strict=True):
        for name, (color, marker) in STYLES.items():
            swept = [measured.trials[with_break_point(name, px)] for px in BREAK_POINTS]
            axes.plot(
                BREAK_POINTS, list(map(errors, swept)), color=color, marker=marker, label=name
            )
            off = errors(measured.cell(name, "vicinity_preset", False))
            axes.axhline(off, color=color, linestyle="--", label=f"{name}, without factor")
        axes.set_xlabel("break-point of the velocity factor, px per frame")
        axes.set_ylabel(kind)
        plain(axes)
    _legend_below(figure, axes)
    return figure


def _vicinity(measured: Measured) -> "Figure":
    """The factor of the busiest cells after each frame, a panel for each form."""
    figure = new_figure(3.4)
    cells = measured.learning[FORMS[0]].busiest(len(BUSIEST))
    panels = figure.subplots(1, len(FORMS), sharey=True)
    for axes, form in zip(panels, FORMS, strict=True):
        learning = measured.learning[form]
        frames = range(1, measured.frames + 1)
        for (color, style), (row, column) in zip(BUSIEST, cells, strict=False):
            label = f"cell in row {row + 1}, column {column + 1}"
            axes.plot(frames, learning.factor_x[:, row, column], style, color=color, label=label)
        axes.set_title(form.replace("_", " "), fontsize="medium")
        axes.set_xlabel("frame")
        axes.set_ylim(0.8, learning.max_factor + 0.2)
        plain(axes)
    panels[0].set_ylabel("vicinity factor in X")
    _legend_below(figure, panels[0])
    return figure


def _blobs(measured: Measured, trial: Trial) -> float:
    return percent(trial.scores.number_of_blobs_errors, measured.instances)


def _short(label: str) -> str:
    """A merging's name on three short lines at most."""
    return label.replace(", ", "\n").replace(" base ", " base\n")


def _finish(figure: "Figure", axes: "Axes") -> None:
    axes.set_ylim(0, 1.05 * max(axes.get_ylim()[1], 1))
    plain(axes)
    _legend_below(figure, axes)


def _legend_below(figure: "Figure", axes: "Axes") -> None:
    """One legend for all panels, where it covers nothing."""
    handles, labels = axes.get_legend_handles_labels()
    if handles:  # a vicinity factor without any updated cell has no line
        figure.legend(
            handles, labels, loc="outside lower center", ncols=4, columnspacing=1.2, frameon=False
        )
