# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Options that several commands share."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Protocol, Self, TypeVar

import typer

from survtrack.errors import ConfigError, InputError, UsageError
from survtrack.evaluation.files import read_bytes

SourceArgument = Annotated[
    str,
    typer.Argument(
        metavar="SOURCE",
        help="A video file, a stream's URL, a folder of images, or a quoted glob of images.",
        show_default=False,
    ),
]
OutOption = Annotated[
    Path,
    typer.Option("--out", metavar="DIR", help="Folder for the results.", show_default=False),
]
PresetOption = Annotated[
    str, typer.Option("--preset", metavar="NAME", help="Where options start from.")
]
ConfigOption = Annotated[
    Path | None,
    typer.Option("--config", metavar="FILE", help="TOML of options, on top of the preset."),
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set", metavar="A.B=C", help="One option, on top of FILE; repeat it, left to right."
    ),
]
PathOption = Annotated[
    Path | None,
    typer.Option(
        "--path",
        metavar="FILE",
        help="Also write path.csv: where tracks are along and across the paths of FILE (JSON). "
        "filter.model kalman_path follows objects along them.",
    ),
]
SceneOption = Annotated[
    Path | None,
    typer.Option(
        "--scene",
        metavar="FILE",
        help="Start from what an earlier run learned of this scene: its scene.json.",
    ),
]
ZoneOption = Annotated[
    list[str] | None,
    typer.Option(
        "--zone",
        metavar="L,T,W,H",
        help="Where newcomers are looked for (left, top, width, height in px, after --resize), "
        "with --set regions.model=predicted --set regions.acquisition=zones; repeat it.",
    ),
]
FpsOption = Annotated[
    float | None,
    typer.Option(
        "--fps",
        metavar="F",
        help="Frames per second, instead of the video's own times. Images: 25 unless given.",
    ),
]
StartOption = Annotated[
    int, typer.Option("--start", metavar="N", min=0, help="Skip the first N frames.")
]
StepOption = Annotated[
    int, typer.Option("--step", metavar="N", min=1, help="Take every N-th frame.")
]
LimitOption = Annotated[
    int | None, typer.Option("--limit", metavar="N", min=1, help="Process at most N frames.")
]
ResizeOption = Annotated[
    str | None,
    typer.Option(
        "--resize",
        metavar="WxH",
        help="Scale frames to W x H pixels; results are in pixels of the scaled frames.",
    ),
]
OptionsFileOption = Annotated[
    Path | None, typer.Option("--config", metavar="FILE", help="TOML of options.")
]
JsonOption = Annotated[
    bool, typer.Option("--json", help="Print the summary as JSON, for programs.")
]
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="No progress, no summary.")]


def parse_size(text: str | None, option: str = "--resize") -> tuple[int, int] | None:
    """(width, height) of "640x480"; raises UsageError that names the option for anything else."""
    if text is None:
        return None
    match = re.fullmatch(r"([1-9][0-9]{0,4})x([1-9][0-9]{0,4})", text)
    if match is None:
        raise UsageError(f"{option} {text}: width x height in pixels expected, such as 640x480")
    return int(match[1]), int(match[2])


class Options(Protocol):
    """An option class of the core, such as LinkOptions."""

    def replace(self, **options: object) -> Self:
        """A copy with some options changed."""


OptionsT = TypeVar("OptionsT", bound=Options)


def resolve_options(options: OptionsT, config: Path | None, assignments: list[str]) -> OptionsT:
    """The options, with the config file on top and then each --set, left to right.

    Raises:
        ConfigError: an unknown option or value, or a file that is no TOML.
        InputError: the config file cannot be read.
    """
    if config is not None:
        options = _replaced(options, _read_toml(config), f"{config}: ")
    for assignment in assignments:
        options = _replaced(options, dict([parse_assignment(assignment)]))
    return options


def parse_assignment(assignment: str) -> tuple[str, Any]:
    """Name and value of "name=value"; the value as TOML reads it, else its text.

    Raises:
        ConfigError: it has another form.
    """
    name, equals, text = (part.strip() for part in assignment.partition("="))
    if not equals or not name:
        raise ConfigError(f'--set "{assignment}" is not allowed; expected option=value')
    try:
        return name, tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return name, text


def _replaced(options: OptionsT, values: Mapping[str, Any], where: str = "") -> OptionsT:
    try:
        return options.replace(**values)
    except ConfigError as error:
        raise ConfigError(where + str(error).removeprefix(f"{type(options).__name__}.")) from error


def _read_toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(read_bytes(path).decode("utf-8"))
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(f"{path}: {error}") from error
