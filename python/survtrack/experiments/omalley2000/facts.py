# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers as results.json holds them."""

from typing import Any

from survtrack.experiments.omalley2000 import published, race, regions
from survtrack.experiments.omalley2000.claims import claims
from survtrack.experiments.omalley2000.footage_runs import Read
from survtrack.experiments.omalley2000.measured import Made


def facts(made: Made, read: list[Read]) -> dict[str, Any]:
    """Of the whole experiment."""
    return {
        "length": published.LENGTH,
        "unit_px": made.race.unit_px,
        "noise_px": race.SIGMA_PX,
        "frames": len(made.race.times_s),
        "densities": list(made.densities),
        "raw": dict(zip(("t", "v_s", "v_t"), made.raw, strict=True)),
        "filtered": {name: vars(errors) for name, errors in made.errors.items()},
        "regions": {
            "car_px": list(regions.CAR_PX),
            "frames": regions.LAPS,
            "trials": [trial.facts() for trial in made.regions.trials],
            "drawn": [
                {"sigmas": sigmas, "inside": inside, "theory": theory}
                for sigmas, (inside, theory) in made.regions.drawn.items()
            ],
        },
        "filmed": [one.facts() for one in made.filmed],
        "footage": [
            {
                "name": one.name,
                "frames": one.frames,
                "runs": [{"name": name, **run.facts()} for name, run in one.runs.items()],
            }
            for one in read
        ],
        "claims": [vars(claim) for claim in claims(made, read)],
        "errata": [vars(erratum) for erratum in made.errata],
    }
