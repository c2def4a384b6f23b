# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack link`."""

import json
from pathlib import Path
from typing import Annotated

import typer

from survtrack._core import LinkOptions
from survtrack.cli import options as shared
from survtrack.offline import link_run
from survtrack.sinks.folder import CONFIG, MANIFEST

RunArgument = Annotated[
    Path,
    typer.Argument(
        metavar="RUN_DIR", help="A folder that `survtrack run` left.", show_default=False
    ),
]
OutOption = Annotated[
    Path | None,
    typer.Option("--out", metavar="DIR", help="Folder for the results, instead of RUN_DIR/linked."),
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="A=B",
        help="One option, on top of FILE; repeat it, left to right. Options: "
        f"{', '.join(LinkOptions().to_dict())}.",
    ),
]


def link(
    run_dir: RunArgument,
    out: OutOption = None,
    config: shared.OptionsFileOption = None,
    assignments: SetOption = None,
    as_json: shared.JsonOption = False,
    quiet: shared.QuietOption = False,
) -> None:
    """Join the broken tracks of a run and drop those too short to be real.

    Writes DIR/tracks.txt (MOT), tracks.csv, link.jsonl (why tracks were joined or dropped),
    config.toml and run.json; RUN_DIR stays as it is.
    """
    options = shared.resolve_options(LinkOptions(), config, assignments or [])
    facts = link_run(run_dir, out, options)
    place = run_dir / "linked" if out is None else out
    if as_json:
        print(json.dumps({**facts, "out": str(place)}, allow_nan=False))
    elif not quiet:
        if not facts["complete"]:
            print(f"the run is not complete ({facts['error']}); linked as far as it goes")
        print(
            f"tracks: {facts['tracks_before']}; joins: {facts['joined']}, dropped: "
            f"{facts['dropped']}; left: {facts['tracks']}"
        )
        print(f"{place}: {', '.join([*facts['outputs'], CONFIG, MANIFEST])}")
