# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Options that several commands share."""

import re
from pathlib import Path
from typing import Annotated

import typer

from survtrack.errors import UsageError

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
