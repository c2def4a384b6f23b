# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Published experiments, run again on public footage with ground truth.

An experiment is a class that fits experiment.Experiment, in a package of its own, listed in
registry.EXPERIMENTS. `survtrack reproduce NAME` runs it. Importing this package loads no
matplotlib; writing a report does.
"""

from survtrack.experiments.datasets import Dataset, find_datasets, own_dataset
from survtrack.experiments.experiment import Experiment
from survtrack.experiments.folder import ReportFolder
from survtrack.experiments.footage import Footage, load
from survtrack.experiments.registry import EXPERIMENTS, make_experiment
from survtrack.experiments.trial import Trial, Variant, run_trial

__all__ = [
    "EXPERIMENTS",
    "Dataset",
    "Experiment",
    "Footage",
    "ReportFolder",
    "Trial",
    "Variant",
    "find_datasets",
    "load",
    "make_experiment",
    "own_dataset",
    "run_trial",
]
