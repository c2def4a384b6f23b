# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The experiments there are, by name."""

from collections.abc import Callable

from survtrack.errors import UsageError
from survtrack.experiments.experiment import Experiment
from survtrack.experiments.narayana2007 import Narayana2007
from survtrack.experiments.nashenda2011 import Nashenda2011
from survtrack.experiments.omalley2000 import OMalley2000
from survtrack.experiments.semko2007 import Semko2007
from survtrack.experiments.suliman2010 import Suliman2010

EXPERIMENTS: dict[str, Callable[[], Experiment]] = {
    "narayana2007": Narayana2007,
    "nashenda2011": Nashenda2011,
    "omalley2000": OMalley2000,
    "semko2007": Semko2007,
    "suliman2010": Suliman2010,
}


def make_experiment(name: str) -> Experiment:
    """A fresh experiment; raises UsageError that names those there are for any other name."""
    if name not in EXPERIMENTS:
        raise UsageError(f"unknown experiment {name!r}; one of: {', '.join(sorted(EXPERIMENTS))}")
    return EXPERIMENTS[name]()
