# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""report.md: the marker that waits, the centroid beside the estimate, the footage."""

import math
from collections.abc import Mapping

import survtrack
from survtrack.experiments.markdown import table
from survtrack.experiments.marked_set import MarkedSet
from survtrack.experiments.marking_report import footage_report
from survtrack.experiments.suliman2010.errata import Eq6
from survtrack.experiments.suliman2010.footage import OnFootage
from survtrack.experiments.suliman2010.plots import PLOT_TEXTS
from survtrack.experiments.suliman2010.scenes import PRESET, Made, Reentry


def report(
    made: Made,
    eq6: Eq6,
    every: list[MarkedSet],
    compared: Mapping[str, OnFootage],
    links: Mapping[str, str],
) -> str:
    """The page; links are the plots' places beside it, by their names and those of the sets."""
    parts = [
        _introduction(),
        _reentries(made),
        _picture(links, "reentry"),
        _centroids(made, compared),
        _picture(links, "centroid_and_estimate"),
        _errata(eq6),
    ]
    if every:
        parts.append(footage_report(every, links))
    return "\n".join(parts)


def _introduction() -> str:
    return f"""# What Suliman et al. 2010 show

Made by `survtrack reproduce suliman2010`, survtrack {survtrack.__version__}, with the preset
`{PRESET}`. The method is that of C. Suliman, C. Cruceru, F. Moldoveanu, *Kalman Filter Based
Tracking in an Video Surveillance System*, DAS 2010: optical flow from frame to frame, one blob, one
filter. Their footage, one person before a fixed camera, is not published.
"""


def claim(one: Reentry) -> bool:
    """Figure 7: the marker follows, and is given to the contact again; it is the same one."""
    return len(one.track_ids) == 1 and one.given_again_after is not None


def _reentries(made: Made) -> str:
    rows = []
    for way, one in made.reentries.items():
        again = one.given_again_after
        rows.append([
            way,
            "**yes**" if claim(one) else "no",
            str(len(one.track_ids)),
            f"{100 * one.share(after=False):.0f} %",
            str(one.back - one.left),
            "never" if again is None else str(again),
            f"{100 * one.share(after=True):.0f} %",
        ])  # fmt: skip
    header = [
        "way", "the marker is given again (figure 7)", "ids", "frames on the contact, before",
        "frames away", "frames from the return to the marker", "frames on the contact, after",
    ]  # fmt: skip
    return f"""## The contact leaves and comes back

The synthetic scene `reentry`: masks through blobs and tracker, and video through the whole preset.

{table(header, rows, left=2)}
While nothing is seen the marker is predicted at constant acceleration. The centroid of what is
still seen at the border slows down, so that it may turn round; it does not stay where the contact
left.
"""


def _centroids(made: Made, compared: Mapping[str, OnFootage]) -> str:
    rows = [
        [
            trial.label,
            str(one.frames),
            *(f"{value:.2f}" for value in (one.centroid_px, one.estimate_px)),
            *(f"{value:.2f}" for value in (one.centroid_lag, one.estimate_lag)),
            *(f"{value:.2f}" for value in (one.centroid_rest_px, one.estimate_rest_px)),
        ]
        for trial in made.trials
        for one in (made.compared[trial.key],)
    ]
    header = [
        "scene", "frames", "centroid: rms, px", "estimate: rms, px", "centroid: delay, frames",
        "estimate: delay", "centroid: rms without delay, px", "estimate: the same",
    ]  # fmt: skip
    text = f"""## The flow's centroid and the filter's estimate

Against the truth, in the same frames.

{table(header, rows)}"""
    if not compared:
        return text
    lines = [
        [
            name,
            str(one.frames),
            str(one.detected),
            str(one.compared),
            *("" if math.isnan(px) else f"{px:.1f}" for px in (one.centroid_px, one.estimate_px)),
        ]
        for name, one in compared.items()
    ]
    columns = [
        "set", "frames", "with a blob", "with its centroid in a true box", "centroid: rms, px",
        "estimate: rms, px",
    ]  # fmt: skip
    return f"""{text}
On footage, to the centre of the true box that holds the centroid. With several contacts the largest
blob is now one, now the other, and the only filter goes from one to the other with it.

{table(columns, lines)}"""


def _errata(eq6: Eq6) -> str:
    rows, columns = eq6.printed_shape
    return f"""## Errata

Eq. 6 prints a matrix of {rows} rows and {columns} columns, and a right-hand side of
{eq6.printed_states} states: v_x is missing. Their product does not exist; numpy refuses it. The
library's filter has {eq6.states} states and a {eq6.covariance_shape[0]}x{eq6.covariance_shape[1]}
covariance. Eq. 9 is that of Semko 2007: `survtrack reproduce semko2007` shows that fault.
"""


def _picture(links: Mapping[str, str], name: str) -> str:
    return f"![{name.replace('_', ' ')}]({links[name]})\n\n*{PLOT_TEXTS[name]}*\n"
