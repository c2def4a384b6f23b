# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""report.md: the claims, the filter, figures 5 to 9, the errata."""

import math
from collections.abc import Mapping

import survtrack
from survtrack.experiments.markdown import table
from survtrack.experiments.omalley2000 import film, filmed, identified, published, race, regions
from survtrack.experiments.omalley2000.claims import claims
from survtrack.experiments.omalley2000.followed import LEAST_RATE, Filmed
from survtrack.experiments.omalley2000.footage_runs import Read
from survtrack.experiments.omalley2000.measured import Made
from survtrack.experiments.omalley2000.plots import PLOT_TEXTS
from survtrack.experiments.semko2007.report import number


def report(made: Made, read: list[Read], links: Mapping[str, str]) -> str:
    """The page; links are the plots' places beside it, by their names."""
    return "\n".join(
        [
            _introduction(made),
            _claims(made, read),
            _filter(made),
            _pictures(links),
            _regions(made),
            _filmed(made),
            *(_footage(one) for one in read),
            _errata(made),
        ]
    )


def _introduction(made: Made) -> str:
    return f"""# The filter of O'Malley 2000

Made by `survtrack reproduce omalley2000`, survtrack {survtrack.__version__}. The method is that of
P. D. O'Malley, *Use of a Kalman Filter to Improve Realtime Video Stream Image Processing: An
Example*, honours report, University of Florida, 2000: cars on a slot track, followed by S along it
and T across it. Its recordings are not published.

A car is simulated on a closed `survtrack.Path` of {published.LENGTH} units in a picture of
{race.SIZE[0]}x{race.SIZE[1]} px, {made.race.unit_px:.2f} px a unit: {len(made.race.times_s)}
frames at 15 frames/s. It stays in its slot, goes {published.START[2]:g} units/s and is faster and
slower by {100 * race.SWING:g} % twice a lap. Places are measured in the picture with a noise of
{race.SIGMA_PX:g} px a coordinate and put back on the path.
"""


def _claims(made: Made, read: list[Read]) -> str:
    every = claims(made, read)
    rows = [[one.claim, "**yes**" if one.holds else "no", one.numbers] for one in every]
    return f"## Claims\n\n{table(['claim', 'holds', 'numbers'], rows, left=3)}"


def _filter(made: Made) -> str:
    rows = [
        [
            name,
            f"{one.worst_s:.2f}",
            f"{one.three_sigma_s:.2f}",
            f"{100 * one.within:.0f} %",
            f"{one.t:.3f}",
            f"{one.v_s:.2f}",
            f"{one.v_t:.3f}",
            f"{one.nis:.1f}",
        ]
        for name, one in made.errors.items()
    ]
    raw = (f"{made.raw[0]:.3f}", f"{made.raw[1]:.2f}", f"{made.raw[2]:.3f}")
    rows.append(["measured", "", "", "", *raw, ""])
    header = [
        "values", "worst predicted S", "3 sigma_S", "true S within it", "T, rms", "vS, rms",
        "vT, rms", "mean NIS",
    ]  # fmt: skip
    return f"""## The filter

Lengths in the track's unit, times in s. A model that fits has a mean NIS of 2.

{table(header, rows)}
By the printed values S repeats its measurement, and the velocity hardly follows the car. The
identified ones are white accelerations, {made.densities[0]:g} along and {made.densities[1]:g}
units^2/s^3 across, the likeliest of {len(identified.DENSITIES)} each on another race, and
the image's noise.
"""


def _pictures(links: Mapping[str, str]) -> str:
    return "\n".join(
        f"![{name.replace('_', ' ')}]({links[name]})\n\n*{text}*\n"
        for name, text in PLOT_TEXTS.items()
    )


def _regions(made: Made) -> str:
    rows = [
        [
            trial.values,
            trial.rule,
            f"{trial.sigmas[0]:g}, {trial.sigmas[1]:g}",
            f"{trial.looked.area_px:.0f}",
            f"{trial.looked.areas_px.std():.0f}",
            f"{100 * trial.looked.hit_rate:.2f} %",
            f"{trial.looked.losses}",
            f"{trial.constant.area_px:.0f}" if trial.looked.hit_rate > 0.5 else "",
            f"{100 * trial.saving:.0f} %" if trial.looked.hit_rate > 0.5 else "",
        ]
        for trial in made.regions.trials
    ]
    header = [
        "values", "rule", "sigmas along, across", "mean area, px", "deviation", "whole car inside",
        "times lost", "constant box, px", "less",
    ]  # fmt: skip
    length, width = regions.CAR_PX
    printed_new, printed_old = published.AREAS
    return f"""## Regions

{regions.LAPS} frames of the same drive, a car of {length:g} x {width:g} px. What is not wholly in
its region is not measured; after {regions.LOST_AFTER} such frames in a row the car is lost and
starts anew. *published* is the report's rule: from the last position to the prediction and its
sigmas, each side the car's longest axis at least. *whole object* adds the car's box all round. The
constant box stands a fixed step ahead of the measured place and is the smallest that holds the car
as often. The report prints {printed_new} against {printed_old}, of recordings of another length.

{table(header, rows, left=2)}
The printed Q is far too small for the reported errors, so that the longest axis does nearly all
of the published rule's work, and that is not enough: the car is loose after a bend.
"""


def _filmed(made: Made) -> str:
    rows = [
        [
            one.preset,
            f"{100 * one.with_region:.1f} %",
            _known(one.area_px, "{:.0f}"),
            f"{100 * one.hit_rate:.2f} %",
            f"{100 * one.worst_hit_rate:.2f} %",
            *_boxes(one),
            f"{100 * one.pixels:.1f} %",
            ", ".join(_known(value, "{:.4f}") for value in one.variances.tolist()),
        ]
        for one in made.filmed
    ]
    header = [
        "preset", "with a region", "mean area, px", "whole car inside", "in the worst drive",
        "constant box, px", "less", "box of each drive, px", "less", "pixels read",
        "variances of S and T",
    ]  # fmt: skip
    return f"""## Filmed, through the whole pipeline

{len(filmed.SEEDS)} drives as pictures of {race.SIZE[0]}x{race.SIZE[1]} px with a noise of
{film.NOISE_SIGMA:g} grey levels: each starts anywhere, goes the printed speed give or take a fifth
and is faster and slower by {50 * race.SWING:g} to {100 * race.SWING:g} % twice a lap, its fastest
place anywhere. The fourth lap counts, {made.filmed[0].frames} frames in all: in the first the car
comes to the zone where it is acquired, and by the fourth all that a preset may learn of the scene
is learned. Background, blobs, filter and regions are the preset's. A frame without a region is a
miss, and its area is that of the zone. The constant box is one for all drives, the printed way of a
frame ahead of the car's true place in the frame before, and the smallest that holds it as often;
the box of each drive knows that drive beforehand, its mean way and its worst frames. Pixels read
are all, with the zone. The variances are those of the measured places about the truth, in the
track's units: in clean pictures centroids are better than the half pixel (0.01) that
omalley2000_identified expects, and the true car does not accelerate at random.

{table(header, rows)}
omalley2000 has the printed values, by which the velocity hardly follows the car: its regions begin
where the car was, so that they are long, and still lose the front of a car that is faster than
they expect. omalley2000_identified is the one to use.
"""


def _boxes(one: Filmed) -> list[str]:
    if one.hit_rate <= LEAST_RATE:
        return [""] * 4
    return [
        f"{one.constant_px:.0f}",
        f"{100 * one.saving:.0f} %",
        f"{one.fitted_px:.0f}",
        f"{100 * one.saving_of_fitted:.0f} %",
    ]


def _known(value: float, form: str) -> str:
    return "" if math.isnan(value) else form.format(value)


def _footage(one: Read) -> str:
    rows = [
        [
            name,
            f"{100 * run.pixels:.0f} %",
            f"{run.areas_px.mean():.0f}" if run.areas_px.size else "",
            f"{run.areas_px.std():.0f}" if run.areas_px.size else "",
            f"{100 * run.hit_rate:.1f} %" if run.followed else "",
            f"{100 * run.found:.0f} %",
            f"{run.tracks}",
            "" if run.scores is None else f"{run.scores.hota:.1f}",
            "" if run.scores is None else f"{run.scores.mota:.1f}",
            f"{run.frame_ms / one.runs['whole frame'].frame_ms:.2f}",
        ]
        for name, run in one.runs.items()
    ]
    header = [
        "read", "pixels", "mean region, px", "deviation", "whole object inside", "boxes found",
        "tracks", "HOTA", "MOTA", "time",
    ]  # fmt: skip
    return f"""## {one.name}, {one.objects}

{one.frames} frames, the default preset. An object is inside when its box in the run on whole frames
lies in the region of the track that followed it in the frame before; found are that run's boxes
with an IoU above 0.5. The fixed box is a square about the prediction, two and a half times the
object's longer side. Time is processor time, by the whole frame's.

{table(header, rows)}"""


def _errata(made: Made) -> str:
    rows = [[one.fault, one.figure, number(one.listing), number(one.ours)] for one in made.errata]
    return f"""## Errata

Each fault of report or listings alone, in a port of our own, beside the library.

{table(["fault", "figure", "print", "ours"], rows, left=2)}"""
