# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack link`."""

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from survtrack._core import LinkOptions
from survtrack.cli import options as shared
from survtrack.errors import ConfigError, InputError
from survtrack.evaluation.files import read_bytes
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
ConfigOption = Annotated[
    Path | None, typer.Option("--config", metavar="FILE", help="TOML of options.")
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
    config: ConfigOption = None,
    assignments: SetOption = None,
    as_json: shared.JsonOption = False,
    quiet: shared.QuietOption = False,
) -> None:
    """Join the broken tracks of a run and drop those too short to be real.

    Writes DIR/tracks.txt (MOT), tracks.csv, link.jsonl (why tracks were joined or dropped),
    config.toml and run.json; RUN_DIR stays as it is.
    """
    options = resolve_options(config, assignments or [])
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


def resolve_options(config: Path | None, assignments: list[str]) -> LinkOptions:
    """The defaults, with the config file on top and then each --set, left to right.

    Raises:
        ConfigError: an unknown option or value, or a file that is no TOML.
        InputError: the config file cannot be read.
    """
    options = LinkOptions()
    if config is not None:
        options = _replaced(options, _read_toml(config), f"{config}: ")
    for assignment in assignments:
        name, equals, text = (part.strip() for part in assignment.partition("="))
        if not equals or not name:
            raise ConfigError(
                f'"{assignment}" is not allowed; expected option=value, such as max_gap_s=2'
            )
        options = _replaced(options, {name: _value(text)})
    return options


def _replaced(options: LinkOptions, values: Mapping[str, Any], where: str = "") -> LinkOptions:
    try:
        return options.replace(**values)
    except ConfigError as error:
        raise ConfigError(where + str(error).removeprefix("LinkOptions.")) from error


def _read_toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(read_bytes(path).decode("utf-8"))
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(f"{path}: {error}") from error


def _value(text: str) -> Any:
    """As TOML reads it; what is no value of TOML is text, which no option takes."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text
