# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The part of a report about real footage: markers, masks and lost contacts against the truth."""

from collections.abc import Mapping

from survtrack.experiments.ends import WITHIN_S
from survtrack.experiments.marked_set import MarkedSet, ends_table, mask_table, score_table
from survtrack.experiments.marking import FOUND_PART


def footage_report(every: list[MarkedSet], links: Mapping[str, str]) -> str:
    """The sections about real footage."""
    pictures = "\n".join(
        f"![{one.name}: markers]({links[one.name]})\n\n*{one.name}: x and y of every marker by "
        "frame; true boxes are grey, those that do not count pale.*\n"
        for one in every
    )
    return f"""## Footage

The published claims are visual; these are numbers. A contact is found when {100 * FOUND_PART:.0f} %
of its true boxes hold a marker, the estimate of a reported track. HOTA, MOTA and IDF1 are of boxes:
those of flow blobs hold the way of the last frames too, and few reach an overlap of 0.5. Frames/s
are by processor time of one core, without decoding.

{score_table(every)}
### Segmentation

{mask_table(every)}
Boxes hold more than a person, so that the first is below 100 % even for perfect masks.

### Lost contacts on footage

An event is right when its last measurement lies within {WITHIN_S:g} s of the end of a true track,
no further from the centre of its last box than that is high.

{ends_table(every)}
{pictures}"""
