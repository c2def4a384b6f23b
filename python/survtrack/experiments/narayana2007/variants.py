# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The configurations that are run."""

from dataclasses import dataclass

import survtrack
from survtrack.experiments.trial import Variant

EUCLIDEAN, BAYESIAN = "narayana2007_euclidean", "narayana2007"
CORRESPONDENCES = {"Euclidean": EUCLIDEAN, "Bayesian": BAYESIAN}
PRESETS = {
    name: Variant(name, in_frames=name != "survtrack")
    for name in (BAYESIAN, EUCLIDEAN, "narayana2007_published", "survtrack")
}
FIXED_PX = (10, 15, 20)  # the thesis's thresholds, 5 and 7
PUBLISHED_BASE_PX = 10  # 6.4
BREAK_POINTS = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30)  # px per frame
THRESHOLDS_PX = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30)
FORMS = ("settling", "published_mean", "published_constant")
SCALED = {"vicinity_published": "published base", "vicinity_preset": "preset's base"}


@dataclass(frozen=True)
class Merging:
    """A way to merge blobs: its key in results.json, its name in tables, its assignments."""

    key: str
    label: str
    changes: tuple[str, ...]


@dataclass(frozen=True)
class Cell:
    """One of the combinations of correspondence, merging and velocity factor."""

    correspondence: str
    merging: Merging
    velocity: bool

    @property
    def variant(self) -> Variant:
        """Its configuration."""
        off = () if self.velocity else ("cost.velocity_break_point=0",)
        return Variant(CORRESPONDENCES[self.correspondence], (*self.merging.changes, *off))


def preset_base_px() -> float:
    """The base threshold of the presets' vicinity-scaled merging, px."""
    merge = survtrack.preset(EUCLIDEAN).blobs.merge
    assert isinstance(merge, survtrack.CloseMergeOptions)
    return merge.threshold_y_px


def start_factor() -> float:
    """Where the vicinity factor of each cell starts (6.1); where it goes, the tracks decide."""
    vicinity = survtrack.preset(EUCLIDEAN).vicinity
    assert isinstance(vicinity, survtrack.GridVicinityOptions)
    return (1 + vicinity.max_factor) / 2


def preset_break_point() -> float:
    """The break-point of the presets' velocity factor, px per frame."""
    cost = survtrack.preset(EUCLIDEAN).cost
    assert isinstance(cost, survtrack.MatchMatrixOptions)
    return cost.velocity_break_point


def mergings() -> list[Merging]:
    """All ways to merge, as the tables list them."""
    return [
        Merging("none", "none", ("blobs.merge.model=none",)),
        *(Merging(f"fixed_{px}", f"fixed, {px} px", fixed(px)) for px in FIXED_PX),
        Merging(
            "vicinity_published",
            f"vicinity factor, published base {PUBLISHED_BASE_PX} px",
            _thresholds(PUBLISHED_BASE_PX),
        ),
        Merging("vicinity_preset", f"vicinity factor, preset's base {preset_base_px():g} px", ()),
    ]


def merging(key: str) -> Merging:
    """One of mergings(), by its key."""
    [found] = [one for one in mergings() if one.key == key]
    return found


def scaled_bases() -> dict[str, float]:
    """The bases of the vicinity-scaled mergings, px, by their keys."""
    return {"vicinity_published": PUBLISHED_BASE_PX, "vicinity_preset": preset_base_px()}


def cells() -> list[Cell]:
    """Every combination."""
    return [
        Cell(correspondence, merging, velocity)
        for correspondence in CORRESPONDENCES
        for merging in mergings()
        for velocity in (False, True)
    ]


def fixed(threshold_px: float) -> tuple[str, ...]:
    """Merging with the same threshold everywhere."""
    return (*_thresholds(threshold_px), "blobs.merge.vicinity_scaled=false")


def scaled(threshold_px: float) -> tuple[str, ...]:
    """Merging with a vicinity-scaled threshold that is threshold_px at the factor's start."""
    return _thresholds(threshold_px / start_factor())


def _thresholds(px: float) -> tuple[str, ...]:
    value = float(px)
    return (f"blobs.merge.threshold_y_px={value!r}", f"blobs.merge.threshold_x_px={value!r}")


def with_break_point(correspondence: str, px: float) -> Variant:
    """A preset with another break-point of the velocity factor, px per frame."""
    return Variant(CORRESPONDENCES[correspondence], (f"cost.velocity_break_point={px!r}",))


def with_merging(correspondence: str, changes: tuple[str, ...]) -> Variant:
    """A preset with another merging."""
    return Variant(CORRESPONDENCES[correspondence], changes)


def with_form(form: str) -> Variant:
    """A form of the vicinity factor that no merging depends on: all learn from the same tracks."""
    fixed_px = preset_base_px() * start_factor()
    return Variant(EUCLIDEAN, (*fixed(fixed_px), f"vicinity.form={form}", "outputs.vicinity=true"))


def with_grid(correspondence: str, key: str) -> Variant:
    """A vicinity-scaled merging whose results hold the grid: each learns from its own tracks."""
    return with_merging(correspondence, (*merging(key).changes, "outputs.vicinity=true"))


def scored() -> list[Variant]:
    """All that are scored, each once."""
    every = [cell.variant for cell in cells()] + list(PRESETS.values())
    every += [with_break_point(name, px) for name in CORRESPONDENCES for px in BREAK_POINTS]
    every += [
        with_merging(name, how(px))
        for name in CORRESPONDENCES
        for how in (fixed, scaled)
        for px in THRESHOLDS_PX
    ]
    return list(dict.fromkeys(every))
