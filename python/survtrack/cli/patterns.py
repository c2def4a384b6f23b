# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack patterns`."""

import json
from pathlib import Path
from typing import Annotated

import typer

from survtrack._core import PatternOptions
from survtrack.cli import options as shared
from survtrack.offline.patterns import PATTERNS, patterns_of_run, read_patterns
from survtrack.sinks.folder import CONFIG, MANIFEST

RunArgument = Annotated[
    Path,
    typer.Argument(
        metavar="RUN_DIR",
        help="A folder that `survtrack run` or `survtrack link` left.",
        show_default=False,
    ),
]
OutOption = Annotated[
    Path | None,
    typer.Option(
        "--out", metavar="DIR", help="Folder for the results, instead of RUN_DIR/patterns."
    ),
]
KnownOption = Annotated[
    Path | None,
    typer.Option(
        "--known",
        metavar="FILE",
        help="Judge by the patterns.json of an earlier run, with its options, and learn nothing.",
    ),
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="A=B",
        help="One option, on top of FILE; repeat it, left to right. Options: "
        f"{', '.join(PatternOptions().to_dict())}.",
    ),
]


def patterns(
    run_dir: RunArgument,
    known: KnownOption = None,
    out: OutOption = None,
    config: shared.OptionsFileOption = None,
    assignments: SetOption = None,
    as_json: shared.JsonOption = False,
    quiet: shared.QuietOption = False,
) -> None:
    """Learn the ways that tracks of a run go, and find the unusual ones.

    Writes DIR/patterns.json, activities.csv (what each track does), paths.json (the ways, for
    `survtrack run --path`), patterns.png (the ways as arrows), config.toml and run.json; RUN_DIR
    stays as it is.
    """
    start = PatternOptions() if known is None else read_patterns(known).options
    options = shared.resolve_options(start, config, assignments or [])
    facts = patterns_of_run(run_dir, out, options, known)
    place = run_dir / "patterns" if out is None else out
    if as_json:
        print(json.dumps({**facts, "out": str(place)}, allow_nan=False))
    elif not quiet:
        if not facts["complete"]:
            print(f"the run is not complete ({facts['error']}); taken as far as it goes")
        _print_patterns(place / PATTERNS)
        for identity, reason in facts["no_path"].items():
            print(f"pattern {identity} is no path: {reason}")
        kinds = ", ".join(f"{kind}: {count}" for kind, count in facts["kinds"].items())
        print(f"tracks: {facts['tracks']}; {kinds}")
        print(f"{place}: {', '.join([*facts['outputs'], CONFIG, MANIFEST])}")


def _print_patterns(path: Path) -> None:
    for pattern in read_patterns(path).patterns:
        enters, leaves = (f"({x:.0f}, {y:.0f})" for x, y in (pattern.enters, pattern.leaves))
        print(
            f"pattern {pattern.id}: {pattern.count} tracks from {enters} to {leaves}, "
            f"{pattern.speed_px_per_s:.0f} px/s, {pattern.duration_s:.1f} s"
        )
