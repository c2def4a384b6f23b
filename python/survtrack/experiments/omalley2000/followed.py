# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What presets read of filmed drives, beside constant boxes that hold the car as often."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.omalley2000 import race, regions

Floats = NDArray[np.float64]

LEAST_RATE = 0.5  # below it a box of the same rate says nothing


@dataclass(frozen=True, eq=False)
class Followed:
    """One drive.

    Attributes:
        areas_px: (N,) of the regions in each frame; without one what is read is the zone.
        with_region: frames with a region.
        held: frames in which the whole car lay in one.
        read_px: pixels that were read in all frames.
        needed_px: (N, 2) sides that a box needs to hold the car, the printed way of a frame ahead.
        fitted_px: (N, 2) the same, this drive's own mean way ahead.
        off: (K, 2) of each measured S and T from the truth, in the track's units.
    """

    areas_px: Floats
    with_region: int
    held: int
    read_px: int
    needed_px: Floats
    fitted_px: Floats
    off: Floats

    @property
    def hit_rate(self) -> float:
        """0 to 1; a frame without a region is a miss."""
        return self.held / len(self.areas_px)


@dataclass(frozen=True, eq=False)
class Filmed:
    """All drives of a preset; means are those of all frames."""

    preset: str
    drives: tuple[Followed, ...]

    @property
    def frames(self) -> int:
        """In which the car could have been followed."""
        return sum(len(one.areas_px) for one in self.drives)

    @property
    def with_region(self) -> float:
        """Part of them with a region."""
        return sum(one.with_region for one in self.drives) / self.frames

    @property
    def hit_rate(self) -> float:
        """0 to 1."""
        return sum(one.held for one in self.drives) / self.frames

    @property
    def worst_hit_rate(self) -> float:
        """Of the drives."""
        return min(one.hit_rate for one in self.drives)

    @property
    def area_px(self) -> float:
        """Mean of the regions; NaN if there never was one."""
        if not self.with_region:
            return float("nan")
        return float(np.concatenate([one.areas_px for one in self.drives]).mean())

    @property
    def constant_px(self) -> float:
        """Area of the smallest box for all drives that holds the car as often."""
        needed = np.concatenate([one.needed_px for one in self.drives])
        return _area_px(needed, self.hit_rate)

    @property
    def fitted_px(self) -> float:
        """Mean area when each drive has such a box of its own, fitted to it afterwards."""
        areas = [_area_px(one.fitted_px, one.hit_rate) for one in self.drives]
        return float(np.average(areas, weights=[len(one.areas_px) for one in self.drives]))

    @property
    def saving(self) -> float:
        """Part of the constant box's area that is not read; NaN without a region."""
        return 1 - self.area_px / self.constant_px

    @property
    def saving_of_fitted(self) -> float:
        """The same of the boxes that are fitted to each drive."""
        return 1 - self.area_px / self.fitted_px

    @property
    def pixels(self) -> float:
        """Part of all pixels that was read."""
        width, height = race.SIZE
        return sum(one.read_px for one in self.drives) / (self.frames * width * height)

    @property
    def variances(self) -> Floats:
        """(2,) of the measured S and T about the truth, in the track's units; NaN without any."""
        off = np.concatenate([one.off for one in self.drives])
        return np.asarray(off.var(axis=0)) if len(off) else np.full(2, np.nan)

    def facts(self) -> dict[str, Any]:
        """As results.json holds them; None is what there was nothing for."""
        return {
            "preset": self.preset,
            "frames": self.frames,
            "with_region": self.with_region,
            "area_px": _known(self.area_px),
            "hit_rate": self.hit_rate,
            "hit_rates": [one.hit_rate for one in self.drives],
            "constant_area_px": self.constant_px,
            "fitted_area_px": self.fitted_px,
            "saving": _known(self.saving),
            "saving_of_fitted": _known(self.saving_of_fitted),
            "pixels": self.pixels,
            "measurement_variances": [_known(float(value)) for value in self.variances],
        }


def _area_px(needed: Floats, hit_rate: float) -> float:
    width, height = regions.smallest_sides(needed, max(hit_rate, LEAST_RATE))
    return width * height


def _known(value: float) -> float | None:
    return value if np.isfinite(value) else None
