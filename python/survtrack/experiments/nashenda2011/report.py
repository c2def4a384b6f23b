# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""report.md: the matrices, the sweep, the walk, the gaps, the errata, the footage."""

from collections.abc import Mapping

import survtrack
from survtrack.experiments.markdown import table
from survtrack.experiments.nashenda2011 import gaps, published, sweep, targets
from survtrack.experiments.nashenda2011.claims import claims
from survtrack.experiments.nashenda2011.errata_filter import refusal_of_eq_22, refusal_of_r
from survtrack.experiments.nashenda2011.footage import OnFootage
from survtrack.experiments.nashenda2011.footage_report import footage_part
from survtrack.experiments.nashenda2011.plots import SWEEP_TEXTS
from survtrack.experiments.nashenda2011.simulated import Made
from survtrack.experiments.nashenda2011.walk_plots import WALK_TEXTS
from survtrack.experiments.semko2007.report import number

GAP_LENGTHS = (1, 2, 5, 10)


def report(made: Made, every: list[OnFootage], links: Mapping[str, str]) -> str:
    """The page; links are the plots' places beside it, by their names and those of the sets."""
    parts = [_introduction(), _claims(made, every), _matrices(made), _sweep(made)]
    parts += [_best(made), _picture("best_q", SWEEP_TEXTS, links), _walk(links)]
    parts += [_gaps(made), _picture("gaps", SWEEP_TEXTS, links), _errata(made)]
    if every:
        parts.append(footage_part(every, links))
    return "\n".join(parts)


def _introduction() -> str:
    return f"""# The sweep of Q of Nashenda 2011

Made by `survtrack reproduce nashenda2011`, survtrack {survtrack.__version__}. The method is that of
H. T. Nashenda, *Uncertain Input Estimation with Application to Kalman Tracking*, MSc dissertation,
University of Cape Town, 2011: the largest blob that differs from a still background, and a Kalman
filter of constant velocity, {1 / published.PERIOD_S:.3f} frames/s, Q = q I with q = 0, 1, 10, 50
and 100. Its footage is not published.

- **published**: the printed R, which is no covariance, and the printed B u; unvalidated.
- **corrected**: R = diag(0.2877, 1.1465), no control input.

The dissertation took the measurements for the truth. Here the truth is the simulation's, or that of
annotated footage.
"""


def _claims(made: Made, every: list[OnFootage]) -> str:
    rows = [
        [one.claim, "**yes**" if one.holds else "no", one.numbers] for one in claims(made, every)
    ]
    return f"## Claims\n\n{table(['claim', 'holds', 'numbers'], rows, left=3)}"


def _matrices(made: Made) -> str:
    rows = [
        [
            f"q = {one.printed.q:g}: {one.printed.name}",
            str(one.printed.updates),
            f"{one.largest:.6f}",
            "**yes**" if one.same else "no",
        ]
        for one in made.matrices
    ]
    header = ["printed", "updates", "largest difference", "the same to 4 decimals"]
    return f"""## The printed matrices

Of the library's filter with `validate=False`, after so many updates; the misprint (errata) is left
out. They do not depend on what is measured.

{table(header, rows)}"""


def _sweep(made: Made) -> str:
    rows = []
    for name, by_way in made.sweep.items():
        for way, of in by_way.items():
            best = min(of, key=lambda q: of[q].truth_px)
            for q, errors in of.items():
                px = f"{errors.truth_px:.2f}"
                rows.append([
                    name,
                    way,
                    f"{q:g}",
                    f"**{px}**" if q == best else px,
                    f"{errors.late_px:.2f}",
                    f"{errors.measured_px:.2f}",
                ])  # fmt: skip
    header = [
        "target", "filter", "q", f"to the truth, frames {sweep.SETTLED + 1} to {published.FRAMES}",
        f"frames {sweep.LATE + 1} to {sweep.LONG_FRAMES}", "to the measurement",
    ]  # fmt: skip
    return f"""## The sweep

{sweep.RUNS} runs each, measured with a Gaussian noise of {targets.SIGMA_PX:g} px a coordinate. The
steady target goes at {targets.VELOCITY[0]:g} and {targets.VELOCITY[1]:g} px/s; the manoeuvring one
is pushed to and fro besides, by {sweep.ACCELERATION:g} px/s^2 for {targets.HOLD_FRAMES} frames at a
time, in directions that are drawn. Rms of a coordinate, px.

{table(header, rows, left=2)}
To the measurement the error falls with q, whatever the target does, since the filter comes to
repeat what it is given: its error to the truth becomes that of the measurement.
"""


def _best(made: Made) -> str:
    rows = []
    for acceleration in sweep.GRID_ACCELERATIONS:
        cells = [f"{acceleration:g}"]
        for sigma_px in sweep.GRID_SIGMAS_PX:
            by_q = made.best[sigma_px][acceleration]
            q = sweep.best_q(by_q)
            cells.append(f"{q:.2g} ({by_q[q]:.2f} px)")
        rows.append(cells)
    header = [
        "acceleration, px/s^2", *(f"noise of {each:g} px" for each in sweep.GRID_SIGMAS_PX)
    ]  # fmt: skip
    return f"""## The best q

Of a grid of {len(sweep.GRID_Q)} from 0 to 10000, {sweep.GRID_RUNS} runs each, corrected
filter; with the rms error of a coordinate, frames {sweep.SETTLED + 1} to {published.FRAMES}.

{table(header, rows)}
R stays that of the preset, so that a noise of 2 px is larger than it says: what counts is q against
R, and the more noise, the smaller the q that fits.
"""


def _walk(links: Mapping[str, str]) -> str:
    pictures = "\n".join(_picture(name, WALK_TEXTS, links) for name in WALK_TEXTS)
    first, last = targets.WALK_HIDDEN
    return f"""## A walk, in kind figures 14 to 22

A person comes in at frame {targets.WALK_FROM}, turns round at frame {targets.WALK_TURN}, goes on by
{published.STEP_PX:.4f} px a frame as printed, and is hidden in frames {first} and {last}, for
{len(targets.WALK_HIDDEN) * published.PERIOD_S:.3f} s; noise of {targets.SIGMA_PX:g} px.

{pictures}"""


def _picture(name: str, texts: Mapping[str, str], links: Mapping[str, str]) -> str:
    return f"![{name.replace('_', ' ')}]({links[name]})\n\n*{texts[name]}*\n"


def _gaps(made: Made) -> str:
    rows = []
    for name, by_way in made.gaps.items():
        for q in published.SWEEP:
            for length in GAP_LENGTHS:
                ours, listing = (by_way[way][q][length] for way in ("ours", "listing"))
                rows.append([
                    name,
                    f"{q:g}",
                    str(length),
                    f"{ours.before:.1f}",
                    f"{ours.during:.1f}",
                    f"{listing.during:.1f}",
                    f"{ours.after:.1f}",
                    f"{listing.after:.1f}",
                    f"{ours.settled:.1f}",
                    f"{listing.settled:.1f}",
                ])  # fmt: skip
    header = [
        "target", "q", "frames hidden", "before", "in the last of them: ours", "listing",
        "in the first after: ours", "listing", f"{gaps.SHOWN_AFTER} frames later: ours", "listing",
    ]  # fmt: skip
    return f"""## Occlusions

Hidden from frame {gaps.HIDDEN_FROM} on, {gaps.RUNS} runs, corrected filter, rms distance to the
truth, px. Ours predicts; the listing's `continue` leaves the state of that frame at zero, so that
the filter starts again from (0, 0). All lengths from 1 to 10 are in the plot and in `results.json`.

{table(header, rows)}"""


def _errata(made: Made) -> str:
    rows = [[one.fault, one.figure, number(one.listing), number(one.ours)] for one in made.errata]
    return f"""## Errata

Each fault of print or listing alone, in a port of our own, beside the library.

{table(["fault", "figure", "print", "ours"], rows, left=2)}
The library refuses the printed R: `{refusal_of_r()}`. Eq. 22 to the letter has no value:
`{refusal_of_eq_22()}`.
"""
