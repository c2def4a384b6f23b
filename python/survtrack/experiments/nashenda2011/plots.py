# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The plots of the sweep, the gaps and the footage."""

from typing import TYPE_CHECKING

from survtrack.experiments.following_plots import legend_below
from survtrack.experiments.nashenda2011 import gaps, published, sweep, targets
from survtrack.experiments.nashenda2011.footage import OnFootage
from survtrack.experiments.nashenda2011.simulated import Made
from survtrack.experiments.nashenda2011.walk_plots import Q_STYLES, SKY, TRUTH, walk_plots
from survtrack.experiments.plotting import BLUE, GREEN, GREY, ORANGE, new_figure, plain, png

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN_ACCELERATIONS = (0.0, 5.0, 20.0, 100.0)
SHOWN_ON_FOOTAGE = (0.0, 10.0, 100.0)
SMALLEST_Q = 3e-5  # where q = 0 stands on a logarithmic axis
STYLES = ((BLUE, "o"), (ORANGE, "s"), (GREEN, "^"), (GREY, "D"))

SWEEP_TEXTS = {
    "best_q": "Left: rms error of a coordinate by q for four manoeuvres, noise of 2 px, the best "
    "of each marked. Right: the best q by manoeuvre for four noises. q = 0 is at the end of the "
    "axis.",
    "gaps": "Rms distance in the last frame of a gap (above) and in the first after it (below), by "
    "its length: predicted, and skipped as in the listing.",
}


def plots(made: Made) -> dict[str, bytes]:
    """PNG files by name."""
    return {
        **walk_plots(made.walk),
        "best_q": png(_best(made.best)),
        "gaps": png(_gaps(made.gaps)),
    }


def _best(best: sweep.Best) -> "Figure":
    figure = new_figure(3.6)
    left, right = figure.subplots(1, 2)
    for acceleration, (color, marker) in zip(SHOWN_ACCELERATIONS, STYLES, strict=True):
        by_q = best[targets.SIGMA_PX][acceleration]
        q = sweep.best_q(by_q)
        name = f"{acceleration:g} px/s²"
        left.plot([_shown(q) for q in by_q], list(by_q.values()), color=color, label=name)
        left.plot([_shown(q)], [by_q[q]], marker, color=color)
    left.set_yscale("log")
    left.set_ylim(0.2, 50)
    left.set_xlabel("q")
    left.set_ylabel("rms error, px")
    left.legend(fontsize="x-small", frameon=False, loc="upper right")
    for (sigma_px, by), (color, marker) in zip(best.items(), STYLES, strict=True):
        each = [_shown(sweep.best_q(by_q)) for by_q in by.values()]
        right.plot(
            range(len(by)), each, color=color, marker=marker, markersize=4, label=f"{sigma_px:g} px"
        )
    right.set_xticks(range(len(sweep.GRID_ACCELERATIONS)))
    right.set_xticklabels([f"{each:g}" for each in sweep.GRID_ACCELERATIONS])
    right.set_yscale("log")
    right.set_xlabel("acceleration, px/s²")
    right.set_ylabel("best q")
    right.legend(fontsize="x-small", frameon=False, loc="lower right", title="noise")
    left.set_xscale("log")
    for axes in (left, right):
        plain(axes)
    return figure


def _shown(q: float) -> float:
    return max(q, SMALLEST_Q)


def _gaps(every: gaps.Gaps) -> "Figure":
    figure = new_figure(5.2)
    columns = [(name, way) for name in sweep.TARGETS for way in ("ours", "listing")]
    grid = figure.subplots(2, len(columns), sharex=True, sharey="row")
    for column, (name, way) in enumerate(columns):
        for line, when in enumerate(("during", "after")):
            axes = grid[line, column]
            for q, (color, dash) in Q_STYLES.items():
                of = every[name][way][q]
                px = [getattr(of[length], when) for length in gaps.LENGTHS]
                axes.plot(gaps.LENGTHS, px, dash, color=color, linewidth=1.2, label=f"q = {q:g}")
            axes.set_yscale("log")
            plain(axes)
        words = "predicted" if way == "ours" else "skipped"
        grid[0, column].set_title(f"{name},\n{words}", fontsize="small")
        grid[1, column].set_xlabel("frames hidden")
    grid[0, 0].set_ylabel("last frame of the gap, px")
    grid[1, 0].set_ylabel("first frame after it, px")
    legend_below(figure, grid[0, 0])
    return figure


def footage_plot(one: OnFootage) -> bytes:
    """PNG: x and y of one run, and the error by q."""
    figure = new_figure(3.6)
    panels = figure.subplots(1, 3, width_ratios=(2, 2, 1.6))
    for axis, axes in enumerate(panels[:2]):
        _run(axes, one, axis)
        axes.set_title(f"{one.name}: {'xy'[axis]}, px", fontsize="small")
        axes.set_xlabel("frame")
        plain(axes)
    axes = panels[2]
    axes.plot([_shown(q) for q in one.best], list(one.best.values()), color=BLUE)
    axes.plot([_shown(one.best_q)], [one.best[one.best_q]], "o", color=BLUE)
    axes.axhline(one.blob_px, color=GREY, linestyle=":", label="the measurement")
    axes.set_xscale("log")
    axes.set_ylim(0, max(4 * one.blob_px, 1.0))
    axes.set_title("rms distance to the truth, px", fontsize="small")
    axes.set_xlabel("q")
    axes.legend(fontsize="x-small", frameon=False)
    plain(axes)
    legend_below(figure, panels[0])
    return png(figure)


def _run(axes: "Axes", one: OnFootage, axis: int) -> None:
    axes.plot(one.frames_of_run, one.truth[:, axis], color=TRUTH, linewidth=5, label="truth")
    axes.plot(one.frames_of_run, one.measured[:, axis], ".", color=GREY, label="measured")
    for q in SHOWN_ON_FOOTAGE:
        color, dash = Q_STYLES[q]
        line = one.estimates["corrected"][q][:, axis]
        axes.plot(one.frames_of_run, line, dash, color=color, linewidth=1.2, label=f"q = {q:g}")
    line = one.estimates["published"][SHOWN_ON_FOOTAGE[0]][:, axis]
    axes.plot(
        one.frames_of_run, line, "--", color=SKY, linewidth=1.2,
        label=f"q = {published.SWEEP[0]:g}, published",
    )  # fmt: skip
    truth = one.truth[:, axis]
    known = truth[truth == truth]
    if known.size:
        axes.set_ylim(known.min() - 60, known.max() + 60)
