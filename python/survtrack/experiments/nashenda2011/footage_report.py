# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The part of report.md about footage."""

import math
from collections.abc import Mapping

from survtrack.experiments.markdown import table
from survtrack.experiments.nashenda2011.footage import OnFootage
from survtrack.experiments.nashenda2011.footage_runs import GAP, SETTLED


def footage_part(every: list[OnFootage], links: Mapping[str, str]) -> str:
    """The section; links are the plots' places by the sets' names."""
    pictures = "\n".join(
        f"![{one.name}: the sweep]({links[one.name]})\n\n*{one.name}: one of the {one.stride} "
        "runs, and the error by q of all.*\n"
        for one in every
    )
    return f"""## Footage

The largest blob of each frame, from the first that lies in a true box on. To come near the printed
frame rate every frame out of a few is a run, and so is every one of the frames beside it. Rms
distances to the centre of the true box, in frames whose blob lies in it, from the
{SETTLED + GAP + 1}th of a run on.

{_sets(every)}
{_errors(every)}
The centre of a box is not the centroid of a blob: what the measurement itself is off bounds what
any filter can show here.

{pictures}"""


def _sets(every: list[OnFootage]) -> str:
    rows = [
        [
            one.name,
            str(one.frames),
            str(one.blobs),
            str(one.on_object),
            str(one.stride),
            f"{one.period_s:.3f}",
            str(one.object_id),
            str(one.compared),
            f"{one.blob_px:.2f}",
            f"{one.best_q:.2g}",
            f"{one.best[one.best_q]:.2f}",
        ]
        for one in every
    ]
    header = [
        "set", "frames", "with a blob", "of the object", "runs", "s between frames", "object's id",
        "frames compared",
        "measurement, px", "best q", "its estimate, px",
    ]  # fmt: skip
    return table(header, rows)


def _errors(every: list[OnFootage]) -> str:
    rows = [
        [
            one.name,
            way,
            f"{q:g}",
            *(_px(px) for px in (errors.truth_px, errors.measured_px, errors.hidden_px)),
        ]
        for one in every
        for way, of in one.errors.items()
        for q, errors in of.items()
    ]
    header = [
        "set", "filter", "q", "to the truth, px", "to the measurement, px",
        f"to the truth after {GAP} hidden frames, px",
    ]  # fmt: skip
    return table(header, rows, left=2)


def _px(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.2f}"
