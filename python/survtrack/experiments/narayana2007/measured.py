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
        learning: of each form in variants.FORMS, all from the same tracks.
        grids: by correspondence and the key of a vicinity-scaled merging, each from its own tracks.
    """

    dataset: Dataset
    fps: float
    frames: int
    source_size: Size
    scene: Scene
    trials: Mapping[Variant, Trial]
    learning: Mapping[str, Learning]
    grids: Mapping[tuple[str, str], Learning]

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
        return self.trials[
            variants.Cell(correspondence, variants.merging(merging), velocity).variant
        ]

    def blobs(self, correspondence: str, merging: str) -> int:
        """Number-of-blobs errors of a merging, by its key, with the velocity factor on."""
        return self.cell(correspondence, merging, True).scores.number_of_blobs_errors

    def best_fixed(self, correspondence: str) -> str:
        """The key of the fixed threshold of the thesis with the fewest number-of-blobs errors."""
        keys = (f"fixed_{px}" for px in variants.FIXED_PX)
        return min(keys, key=lambda key: self.blobs(correspondence, key))

    def best_threshold(
        self, correspondence: str, how: Callable[[float], tuple[str, ...]]
    ) -> tuple[int, int]:
        """Of the sweep: the threshold with the fewest number-of-blobs errors, px, and their count.

        `how` is variants.fixed, or variants.scaled for thresholds at the factor's start.
        """
        errors = {
            px: self.trials[
                variants.with_merging(correspondence, how(px))
            ].scores.number_of_blobs_errors
            for px in variants.THRESHOLDS_PX
        }
        best = min(errors, key=errors.__getitem__)
        return best, errors[best]


def measure(footage: Footage, tick: Callable[[], None]) -> Measured:
    """Run everything on a set; `tick` is called after each of runs() runs."""
    trials: dict[Variant, Trial] = {}
    for variant in variants.scored():
        trials[variant] = run_trial(footage, variant.config(footage.frame_period_s))
        tick()
    learning: dict[str, Learning] = {}
    for form in variants.FORMS:
        learning[form] = learn(footage, variants.with_form(form))
        tick()
    grids: dict[tuple[str, str], Learning] = {}
    for correspondence, merging in _with_own_grid():
        grids[correspondence, merging] = learn(footage, variants.with_grid(correspondence, merging))
        tick()
    return Measured(
        footage.dataset,
        footage.fps,
        len(footage.frames),
        footage.source_size,
        describe(footage.truth),
        trials,
        learning,
        grids,
    )


def runs() -> int:
    """How many times a set goes through a pipeline."""
    return len(variants.scored()) + len(variants.FORMS) + len(_with_own_grid())


def _with_own_grid() -> list[tuple[str, str]]:
    return [(name, key) for name in variants.CORRESPONDENCES for key in variants.SCALED]
