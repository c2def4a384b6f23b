# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Several configurations on one set, compared with its truth: numbers, tables, the plot."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from survtrack.evaluation import Boxes
from survtrack.experiments.datasets import Dataset
from survtrack.experiments.following_plots import markers_over_time
from survtrack.experiments.footage import Footage
from survtrack.experiments.markdown import table
from survtrack.experiments.marking import Marked, mark
from survtrack.experiments.plotting import png
from survtrack.experiments.trial import Variant
from survtrack.runner import too_short
from survtrack.sources.base import Size

SCORES = ("HOTA", "MOTA", "IDF1")
PLACES = ("border", "behind_object", "open")


@dataclass(frozen=True, eq=False)
class MarkedSet:
    """What the tables and the plot of one set are made from; marked by the variants' names."""

    dataset: Dataset
    fps: float
    frames: int
    size: Size
    truth: Boxes
    variants: Mapping[str, Variant]
    marked: Mapping[str, Marked]

    @property
    def name(self) -> str:
        """Of the set."""
        return self.dataset.name

    def plot(self) -> bytes:
        """PNG: where the markers were."""
        markers = {name: one.markers for name, one in self.marked.items()}
        return png(markers_over_time(self.truth, markers, self.size))

    def facts(self) -> dict[str, Any]:
        """As results.json holds them."""
        return {
            "name": self.name,
            "source": self.dataset.source,
            "truth": str(self.dataset.truth),
            "offset": self.dataset.offset,
            "fps": self.fps,
            "frames": self.frames,
            "size": list(self.size),
            "runs": [self._run(name) for name in self.marked],
        }

    def _run(self, name: str) -> dict[str, Any]:
        one, variant = self.marked[name], self.variants[name]
        scores = one.trial.scores.to_dict()
        return {
            "name": name,
            "preset": variant.preset,
            "set": variant.assignments(1 / self.fps),
            **{key: scores[key] for key in SCORES},
            "switches": scores["switches"],
            "objects": one.objects,
            "found": one.found,
            "boxes_with_marker": _known(one.on_contact),
            "markers_in_truth": _known(one.on_truth),
            "mask_coverage": _known(one.coverage),
            "mask_in_truth": _known(one.mask_in_truth),
            "ends": {
                key: _known(value) if isinstance(value, float) else value
                for key, value in vars(one.ends).items()
            },
            "frames_per_s": round(one.trial.frames_per_s, 1),
        }


def mark_set(
    footage: Footage, variants: Mapping[str, Variant], tick: Callable[[], None]
) -> MarkedSet:
    """Run each variant on a set; `tick` is called after each.

    Raises:
        InputError: fewer frames than a variant's flow looks back.
    """
    for variant in variants.values():
        config = variant.config(footage.frame_period_s)
        if short := too_short(config, footage.dataset.source, len(footage.frames)):
            raise short
    marked = {}
    for name, variant in variants.items():
        marked[name] = mark(footage, variant)
        tick()
    return MarkedSet(
        footage.dataset,
        footage.fps,
        len(footage.frames),
        footage.size,
        footage.truth,
        variants,
        marked,
    )


def score_table(every: list[MarkedSet]) -> str:
    """Scores and markers."""
    header = [
        "set", "run", *SCORES, "switches", "contacts found", "boxes with a marker",
        "markers in a box", "frames/s", "times real time",
    ]  # fmt: skip
    rows = []
    for one in every:
        for name, marked in one.marked.items():
            scores = marked.trial.scores
            rows.append([
                one.name,
                name,
                *(f"{value:.1f}" for value in (scores.hota, scores.mota, scores.idf1)),
                str(scores.id_switches),
                f"{marked.found} of {marked.objects}",
                _percent(marked.on_contact),
                _percent(marked.on_truth),
                f"{marked.trial.frames_per_s:.0f}",
                f"{marked.trial.frames_per_s / one.fps:.0f}",
            ])  # fmt: skip
    return table(header, rows, left=2)


def mask_table(every: list[MarkedSet]) -> str:
    """Masks against true boxes."""
    rows = [
        [one.name, name, _percent(marked.coverage), _percent(marked.mask_in_truth)]
        for one in every
        for name, marked in one.marked.items()
    ]
    return table(["set", "run", "of the boxes in the mask", "of the mask in a box"], rows, left=2)


def ends_table(every: list[MarkedSet]) -> str:
    """Lost contacts."""
    header = [
        "set", "run", "true ends", "events", "of these right", "distance, px",
        "last measurement to event, frames", "border, behind, open",
    ]  # fmt: skip
    rows = [
        [
            one.name,
            name,
            str(marked.ends.true_ends),
            str(marked.ends.told),
            str(marked.ends.matched),
            _number(marked.ends.distance_px),
            _number(marked.ends.latency_frames),
            ", ".join(str(marked.ends.places[place]) for place in PLACES),
        ]
        for one in every
        for name, marked in one.marked.items()
    ]  # fmt: skip
    return table(header, rows, left=2)


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value


def _percent(part: float) -> str:
    return "" if math.isnan(part) else f"{100 * part:.0f} %"


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.0f}"
