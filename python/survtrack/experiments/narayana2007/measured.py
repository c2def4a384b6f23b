# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""All numbers of one set of footage."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from survtrack.experiments.datasets import Dataset
from survtrack.experiments.footage import Footage
from survtrack.experiments.narayana2007 import variants
from survtrack.experiments.narayana2007.vicinity import Learning, learn
from survtrack.experiments.scene import Scene, describe
from survtrack.experiments.trial import Trial, Variant, run_trial
from survtrack.sources.base import Size


@dataclass(frozen=True, eq=False)
class Measured:
    """What the tables, plots and statements of one set are made from.

    Attributes:
        dataset, fps, frames, source_size: as in Footage; frames is their number.
        scene: what the truth says of the scene.
        trials: of each configuration in variants.scored().
        learning: of each form in variants.FORMS.
    """

    dataset: Dataset
    fps: float
    frames: int
    source_size: Size
    scene: Scene
    trials: Mapping[Variant, Trial]
    learning: Mapping[str, Learning]

    @property
    def name(self) -> str:
        """Of the set."""
        return self.dataset.name

    @property
    def instances(self) -> int:
        """True boxes that count: what errors are divided by."""
        return next(iter(self.trials.values())).scores.truth_boxes

    @property
    def objects(self) -> int:
        """Identities among them."""
        return next(iter(self.trials.values())).scores.truth_ids

    def cell(self, correspondence: str, merging: str, velocity: bool) -> Trial:
        """The trial of a combination; merging by its key."""
        [way] = [one for one in variants.mergings() if one.key == merging]
        return self.trials[variants.Cell(correspondence, way, velocity).variant]


def measure(footage: Footage, tick: Callable[[], None]) -> Measured:
    """Run everything on a set; `tick` is called after each of runs() runs."""
    trials: dict[Variant, Trial] = {}
    for variant in variants.scored():
        trials[variant] = run_trial(footage, variant.config(footage.frame_period_s))
        tick()
    learning: dict[str, Learning] = {}
    for form in variants.FORMS:
        learning[form] = learn(footage, form)
        tick()
    return Measured(
        footage.dataset,
        footage.fps,
        len(footage.frames),
        footage.source_size,
        describe(footage.truth),
        trials,
        learning,
    )


def runs() -> int:
    """How many times a set goes through a pipeline."""
    return len(variants.scored()) + len(variants.FORMS)
