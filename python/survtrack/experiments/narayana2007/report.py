# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""report.md: what was run, ours beside the thesis's numbers, and what became of its claims."""

from collections.abc import Mapping

import survtrack
from survtrack.experiments.markdown import table
from survtrack.experiments.narayana2007 import tables
from survtrack.experiments.narayana2007.differences import statements
from survtrack.experiments.narayana2007.measured import Measured
from survtrack.experiments.narayana2007.published import FRAMES_PER_S
from survtrack.experiments.narayana2007.reasons import reasons
from survtrack.experiments.narayana2007.variants import (
    CORRESPONDENCES,
    FIXED_PX,
    PUBLISHED_BASE_PX,
    preset_base_px,
    preset_break_point,
    start_factor,
)
from survtrack.sources.base import Size

Links = Mapping[str, Mapping[str, str]]

PLOT_TEXTS = {
    "merging": "Number-of-blobs errors of every merging, velocity factor on; diamonds: the "
    "thesis's cars. Above 100 % there are more errors than true boxes.",
    "threshold": "Number-of-blobs errors over the threshold of merging, velocity factor on. "
    "Scaled thresholds are those at the factor's start; later it is what the cells learned.",
    "break_point": "Index and swap errors over the break-point of the velocity factor, with the "
    "presets' merging. The axes do not start at 0.",
    "vicinity": "The vicinity factor in X of the busiest cells, by its form. The tracks are the "
    "same for all forms: nothing else uses the factor here.",
}


def report(every: list[Measured], size: Size, links: Links) -> str:
    """The page.

    Args:
        every: the sets that were run.
        size: (width, height) of the frames as they were run, px.
        links: of each set, the plots' names and where they lie beside the page.
    """
    parts = [
        _introduction(size),
        _what_was_run(every),
        _published_beside_ours(every),
        _differences(every),
        *(_details(one, links[one.name]) for one in every),
    ]
    return "\n".join(parts)


def _introduction(size: Size) -> str:
    return f"""# The experiments of Narayana 2007

Made by `survtrack reproduce narayana2007`, survtrack {survtrack.__version__}. The method is that of
M. Narayana, *Automatic Tracking of Moving Objects in Video for Surveillance Applications*, MSc
thesis, University of Kansas, 2007. Its footage, cars on roads, is not published: this is the same
method on other footage, so it is the differences between variants that can agree, not the counts.

Frames and true boxes are scaled to {size[0]}x{size[1]} px; the thesis's thresholds are px of
320x240 frames. Percentages are of instances, object times frame. Frames/s are those of the
pipeline on this machine, without decoding and scoring.
"""


def _what_was_run(every: list[Measured]) -> str:
    names = " and ".join(f"{name} (preset `{preset}`)" for name, preset in CORRESPONDENCES.items())
    fixed = ", ".join(map(str, FIXED_PX))
    return f"""## What was run

{tables.sets(every)}
Object: median width x height of the true boxes as they were run. Overlapping: true boxes that
overlap another one. Tracks per box: reported tracks per true box without merging, Euclidean
correspondence.

- **Correspondence:** {names}.
- **Velocity factor:** off, or with the presets' break-point, {preset_break_point():g} px per frame.
- **Merging:** none; fixed thresholds of {fixed} px; thresholds of a base times the vicinity
  factor, which starts at {start_factor():g}: the published base of {PUBLISHED_BASE_PX} px, or the
  presets' {preset_base_px():g} px.

Everything else is as in the presets, with `time_unit_s` set to the frame period. `results.json`
lists of every run what differs from its preset.

Errors are counted as in 5.2. Number-of-blobs: k tracks on an object count k - 1, none counts 1.
Index: the object is found, but not by its best number. Swap: changes of the object's number. Both
are counted where an object is found: who finds less makes fewer of them.
"""


def _published_beside_ours(every: list[Measured]) -> str:
    return f"""## Ours beside the thesis

The thesis's numbers are those of its tables 5.1 to 5.6, 7.1 and 7.2, as errors in subsequences
1 / 2 / 3 and in total; percentages of the totals are corrected (the thesis prints means of the
three percentages, here in square brackets).

### Number-of-blobs errors

Velocity factor on. The thesis has Euclidean correspondence.

{tables.blobs(every)}
### Index and swap errors

With the presets' merging: vicinity factor, base {preset_base_px():g} px. Each pair is without and
with the velocity factor.

{tables.identities(every)}
### Presets as they are

The default preset, `survtrack`, for comparison.

{tables.presets(every)}
The thesis's program ran at {FRAMES_PER_S} frames/s, with JPEG in and out, on a 3 GHz Pentium.
"""


def _differences(every: list[Measured]) -> str:
    columns = [statements(one) for one in every]
    rows = [
        [f"{number}. {row[0].claim}", *(_verdict(one.holds, one.short) for one in row)]
        for number, row in enumerate(zip(*columns, strict=True), start=1)
    ]
    parts = [
        "## Differences",
        "",
        "What the thesis claims, with its own counts, and whether the numbers of this run say the "
        "same, with the change in ours.",
        "",
        table(["claim", *(one.name for one in every)], rows),
    ]
    for one, found in zip(every, columns, strict=True):
        parts += [f"### Differences: {one.name}", "", "The counts behind the table:", ""]
        parts += [f"{number}. {_sentence(each.numbers)}" for number, each in enumerate(found, 1)]
        parts += ["", "Reasons that its own numbers support:", ""]
        parts += [f"- {reason}" for reason in reasons(one)] or ["- None."]
        parts.append("")
    return "\n".join(parts)


def _verdict(holds: bool, short: str) -> str:
    return f"{'**yes**' if holds else 'no'}, {short}"


def _sentence(text: str) -> str:
    return f"{text[0].upper()}{text[1:]}."


def _details(measured: Measured, links: Mapping[str, str]) -> str:
    pictures = "\n".join(
        f"![{measured.name}: {name.replace('_', ' ')}]({link})\n\n*{PLOT_TEXTS[name]}*\n"
        for name, link in links.items()
    )
    return f"""## {measured.name}

{pictures}
### All combinations

{tables.combinations(measured)}
### Vicinity factor

Factors and steps, px per frame, are means over the cells, weighted by their updates. The first
{len(measured.learning)} rows learned from the same tracks, the others from those of their own run.

{tables.vicinity(measured)}"""
