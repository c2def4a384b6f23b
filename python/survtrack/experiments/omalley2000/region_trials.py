# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""All ways of choosing regions over the same drive, and the constant box of the same hit rate."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from survtrack.experiments.omalley2000 import regions
from survtrack.experiments.omalley2000.regions import Looked

WANTED_RATE = 0.99
WANTED_SAVING = 0.33


@dataclass(frozen=True, eq=False)
class RegionTrial:
    """One way beside the smallest constant box that holds the car as often.

    Attributes:
        values: whose Q and R.
        rule: "published" or "whole object".
        sigmas: along and across.
        looked: the regions.
        constant: the box.
    """

    values: str
    rule: str
    sigmas: tuple[float, float]
    looked: Looked
    constant: Looked

    @property
    def saving(self) -> float:
        """Part of the constant box's area that is not read."""
        return 1 - self.looked.area_px / self.constant.area_px

    def facts(self) -> dict[str, Any]:
        """As results.json holds them."""
        return {
            "values": self.values,
            "rule": self.rule,
            "sigmas": list(self.sigmas),
            "area_px": self.looked.area_px,
            "area_deviation_px": float(self.looked.areas_px.std()),
            "hit_rate": self.looked.hit_rate,
            "losses": self.looked.losses,
            "constant_area_px": self.constant.area_px,
            "constant_hit_rate": self.constant.hit_rate,
            "saving": self.saving,
        }


@dataclass(frozen=True, eq=False)
class Regions:
    """What the report says of regions on the closed track.

    Attributes:
        trials: by whose values, rule and sigmas.
        drawn: by sigmas, the share inside on data drawn from the model, and what theory says.
    """

    trials: list[RegionTrial]
    drawn: dict[float, tuple[float, float]]

    def one(self, values: str, rule: str, along: float) -> RegionTrial:
        """The trial of these."""
        return next(
            trial
            for trial in self.trials
            if (trial.values, trial.rule, trial.sigmas[0]) == (values, rule, along)
        )


def frames() -> int:
    """Of all drives, for the progress."""
    return regions.LAPS * (2 * 3 + len(regions.SIGMAS) - 1)


def measure(tick: Callable[[int], None]) -> Regions:
    """Drive with each set of values by both rules, and with the identified ones by all sigmas."""
    one = regions.drive()
    cars = regions.car_corners_px(one)
    trials = []
    for name, noises in regions.values().items():
        rules = [("published", regions.PUBLISHED), ("whole object", regions.WHOLE)]
        if name == "identified":
            more = [k for k in regions.SIGMAS if k != regions.WHOLE.sigmas_along]
            rules += [
                ("whole object", regions.WHOLE.replace(sigmas_along=k, sigmas_across=k))
                for k in more
            ]
        for rule, options in rules:
            looked = regions.follow(one, cars, noises, options)
            # Below one half a box of the same rate says nothing.
            rate = max(looked.hit_rate, 0.5)
            trials.append(
                RegionTrial(
                    name,
                    rule,
                    (options.sigmas_along, options.sigmas_across),
                    looked,
                    regions.constant(one, cars, rate),
                )
            )
            tick(regions.LAPS)
    drawn = {k: (regions.drawn(k), regions.theory(k)) for k in regions.SIGMAS}
    return Regions(trials, drawn)
