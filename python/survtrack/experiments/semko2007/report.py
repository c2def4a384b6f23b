# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""report.md: the trials, the claims, the errata, the footage."""

import math
from collections.abc import Mapping

import survtrack
from survtrack.experiments.markdown import table
from survtrack.experiments.marked_set import MarkedSet
from survtrack.experiments.marking_report import footage_report
from survtrack.experiments.semko2007.artificial import LIMIT_FRAMES, SIGMA_PX, Made
from survtrack.experiments.semko2007.claims import claims, event_after
from survtrack.experiments.semko2007.errata import Erratum
from survtrack.experiments.semko2007.plots import PLOT_TEXTS
from survtrack.experiments.semko2007.trials import FPS, FRAMES, SIZE


def report(
    made: Made, errata: list[Erratum], every: list[MarkedSet], links: Mapping[str, str]
) -> str:
    """The page; links are the plots' places beside it, by their names and those of the sets."""
    parts = [_introduction(), _claims(made, every), _trials(made), _lost(made)]
    parts += [_pictures(links), _errata(errata)]
    if every:
        parts.append(footage_report(every, links))
    return "\n".join(parts)


def _introduction() -> str:
    return f"""# The trials of Semko 2007

Made by `survtrack reproduce semko2007`, survtrack {survtrack.__version__}, with the preset
`semko2007`. The method is that of D. A. Semko, *Optical Flow Analysis and Kalman Filter Tracking in
Video Surveillance Algorithms*, MSc thesis, Naval Postgraduate School, 2007.

The artificial data are bright ellipses of 28x56 px on black, {SIZE[0]}x{SIZE[1]} px, {FRAMES}
frames at {FPS:g} frames/s, of which every position is known. The thesis took its measurements for
the truth; here it is the generator's.

- **masks**: what the flow block should find, through blobs and tracker.
- **noise**: true positions with a Gaussian noise of {SIGMA_PX:g} px a coordinate (R = I), through
  the tracker.
- **flow**: textured video of the same, through the whole preset.
"""


def _claims(made: Made, every: list[MarkedSet]) -> str:
    rows = [
        [one.claim, "**yes**" if one.holds else "no", one.numbers] for one in claims(made, every)
    ]
    return f"## Claims\n\n{table(['claim', 'holds', 'numbers'], rows, left=3)}"


def _trials(made: Made) -> str:
    rows = []
    for trial in made.trials:
        run = made.runs[trial.key]
        settled = run["masks"].settled_after
        delay, bias, rest = run["flow"].lag
        rows.append([
            trial.label,
            "never" if settled is None else str(settled),
            f"{run['masks'].largest_px:.2f}",
            f"{run['masks'].rms_px:.2f}",
            f"{run['noise'].rms_px:.2f}",
            f"{run['flow'].rms_px:.1f}",
            f"{delay:.1f}",
            f"{bias:.1f}",
            f"{rest:.1f}",
        ])  # fmt: skip
    header = [
        "trial", "masks: under 1 px after frames", "largest, px", "rms, px", "noise: rms, px",
        "flow: rms, px", "delay, frames", "bias, px", "rms without delay, px",
    ]  # fmt: skip
    return f"""## Artificial trials

Norm of truth - estimate; largest and rms from {LIMIT_FRAMES} frames after the first estimate on.

{table(header, rows)}
Noise: the measurements' own rms is {SIGMA_PX * math.sqrt(2):.2f} px. Flow: the object is seen where
it is and where it was {_frames_back()} frames ago, so that its blob is late by half of that and by
one more frame for the median of three masks. The delay is that of least squares; bias is what is
left to the right of the way.
"""


def _frames_back() -> int:
    segmenter = survtrack.preset("semko2007").segmenter
    assert isinstance(segmenter, survtrack.HornSchunckOptions)
    return segmenter.frames_back


def _lost(made: Made) -> str:
    rows = []
    for key, run in made.lost.items():
        name, way = key.split(", ")
        [label] = [trial.label for trial in made.lost_trials if trial.key == name]
        [gone] = [one for one in run.followed if one.id == 2]
        away = [
            math.dist(gone.truth[-1], (event.position[0] + 0.5, event.position[1] + 0.5))
            for event in run.ended
        ]
        rows.append([
            label,
            way,
            str(len(run.ended)),
            str(event_after(run) or ""),
            ", ".join(event.place.name for event in run.ended),
            ", ".join(f"{px:.1f}" for px in away),
        ])  # fmt: skip
    header = [
        "trial", "way", "events", "in frame without it", "place", "from the last true position, px",
    ]  # fmt: skip
    return f"""## Lost contacts

{table(header, rows, left=2)}
Through the flow the contact that is gone is seen for as long as frames with it are compared with
those without: the event is late by as many frames.
"""


def _pictures(links: Mapping[str, str]) -> str:
    return "\n".join(
        f"![{name.replace('_', ' ')}]({links[name]})\n\n*{text}*\n"
        for name, text in PLOT_TEXTS.items()
    )


def _errata(errata: list[Erratum]) -> str:
    rows = [[one.fault, one.figure, number(one.listing), number(one.ours)] for one in errata]
    return f"""## Errata

Each fault of the listing alone, in a port of our own, beside the library with the preset.

{table(["fault", "figure", "listing", "ours"], rows, left=2)}"""


def number(value: float) -> str:
    """Four places at most, large and small ones with an exponent; 0 for rounding errors."""
    if abs(value) < 1e-9:
        return "0"
    return f"{value:.2e}" if abs(value) >= 1e6 or abs(value) < 1e-3 else f"{value:.4g}"
