# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The option --background of `run` and `segment`: a picture of the empty scene."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from survtrack.errors import InputError, UsageError
from survtrack.sources.images import read_image

if TYPE_CHECKING:
    from survtrack._core import Config, Pipeline

BackgroundOption = Annotated[
    Path | None,
    typer.Option(
        "--background",
        metavar="FILE",
        help="Picture of the empty scene: segmenter.model=static_reference, source=picture.",
    ),
]


def load_background(pipeline: "Pipeline", config: "Config", path: Path | None) -> None:
    """Give the pipeline the picture of --background.

    Raises:
        UsageError: the config takes a picture and none is given, or the other way round.
        InputError: the file is no 8-bit picture; the message names it.
    """
    segmenter = config.segmenter.to_dict()
    takes = segmenter["model"] == "static_reference" and segmenter["source"] == "picture"
    if path is None:
        if takes:
            raise UsageError("segmenter.source: picture needs one; add --background FILE")
        return
    if not takes:
        raise UsageError(
            f"--background {path}: this config takes no picture; add --set "
            "segmenter.model=static_reference --set segmenter.source=picture"
        )
    picture = read_image(path)
    try:
        pipeline.load_background(picture)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
