# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack reproduce`."""

import os
import platform
import sys
from pathlib import Path
from typing import Annotated

import typer

import survtrack
from survtrack.cli import options
from survtrack.cli.progress import show_progress
from survtrack.errors import UsageError
from survtrack.experiments import (
    EXPERIMENTS,
    Dataset,
    Experiment,
    ReportFolder,
    find_datasets,
    load,
    make_experiment,
    own_dataset,
)
from survtrack.experiments.folder import REPORT, RESULTS
from survtrack.experiments.footage import Footage
from survtrack.experiments.plotting import require_matplotlib

DATA = "SURVTRACK_DATA"


def reproduce(
    name: Annotated[
        str,
        typer.Argument(
            metavar="EXPERIMENT", help=f"One of: {', '.join(EXPERIMENTS)}.", show_default=False
        ),
    ],
    out: options.OutOption,
    source: Annotated[
        str | None,
        typer.Option(metavar="SOURCE", help="Footage of your own, as for run; needs --truth."),
    ] = None,
    truth: Annotated[
        Path | None, typer.Option(metavar="TRUTH", help="Its true boxes: MOT text, or CVML.")
    ] = None,
    offset: Annotated[
        int | None,
        typer.Option(
            help="Frame f of SOURCE, from 1, is frame f + OFFSET of TRUTH; 0 unless given."
        ),
    ] = None,
    fps: options.FpsOption = None,
    data: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help=f"Folder of the public sets, instead of the one that {DATA} names; all that are "
            "there are run.",
        ),
    ] = None,
    resize: Annotated[
        str | None,
        typer.Option(
            metavar="WxH",
            help="Scale frames and true boxes to W x H pixels. Without it: the published size.",
        ),
    ] = None,
    quiet: options.QuietOption = False,
) -> None:
    """Run a published experiment again, on your footage, on public sets or on synthetic scenes.

    Writes DIR/report.md, DIR/plots and, when they are whole, DIR/results.json.
    """
    experiment = make_experiment(name)
    size = options.parse_size(resize) or experiment.size
    datasets = _datasets(experiment, source, truth, offset, fps, data)
    require_matplotlib()
    folder = ReportFolder(out)
    # What is wrong with the first set shows before the long work begins.
    first = load(datasets[0], size) if datasets else None
    _measure_made(experiment, quiet)
    for number, dataset in enumerate(datasets, start=1):
        if not quiet:
            print(
                f"survtrack: {dataset.name}, set {number} of {len(datasets)}",
                file=sys.stderr,
                flush=True,
            )
        _measure(experiment, first or load(dataset, size), quiet)
        first = None
    facts = experiment.write(folder)
    folder.finish({"experiment": name, "versions": _versions(), **facts})
    if not quiet:
        if datasets:
            runs = "1 run" if experiment.runs == 1 else f"{experiment.runs} runs"
            print(f"{runs} on each of {', '.join(each.name for each in datasets)}")
        print(f"{out}: {REPORT}, {RESULTS}, {len(folder.plots)} plots")


def _datasets(
    experiment: Experiment,
    source: str | None,
    truth: Path | None,
    offset: int | None,
    fps: float | None,
    data: Path | None,
) -> list[Dataset]:
    """The set that is given, or the public ones that are there; none for an experiment that can do
    without; UsageError for anything else."""
    if source is not None and truth is not None:
        if data is not None:
            raise UsageError("--data: --source names the footage already; give one of the two")
        return [own_dataset(source, truth, fps, offset or 0)]
    if source is not None:
        raise UsageError(f"--source {source}: needs --truth, the true boxes in it")
    for option, value in (("--truth", truth), ("--offset", offset), ("--fps", fps)):
        if value is not None:
            raise UsageError(f"{option} {value}: belongs to --source, which is missing")
    named = data or (Path(os.environ[DATA]) if os.environ.get(DATA) else None)
    if named is None and experiment.made_frames:
        return []
    if named is None:
        raise UsageError(
            f"no footage: give --source and --truth, or --data (or {DATA}) for the public sets"
        )
    return find_datasets(named, experiment.sets)


def _measure_made(experiment: Experiment, quiet: bool) -> None:
    """Run what needs no footage."""
    total, done = experiment.made_frames, 0
    with show_progress(total, quiet=quiet or total == 0) as progress:

        def tick(frames: int) -> None:
            nonlocal done
            done += frames
            if progress is not None:
                progress(done)

        experiment.measure_made(tick)


def _measure(experiment: Experiment, footage: Footage, quiet: bool) -> None:
    """Run everything on a set; the progress counts the frames of all runs."""
    frames, done = len(footage.frames), 0
    with show_progress(frames * experiment.runs, quiet=quiet) as progress:

        def tick() -> None:
            nonlocal done
            done += frames
            if progress is not None:
                progress(done)

        experiment.measure(footage, tick)


def _versions() -> dict[str, str]:
    """What the numbers were made with."""
    import cv2
    import matplotlib
    import numpy as np

    return {
        "survtrack": survtrack.__version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "opencv": cv2.__version__,
        "matplotlib": matplotlib.__version__,
    }
