# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The commands `survtrack evaluate` and `survtrack evaluate-masks`."""

import json
import math
import re
from dataclasses import fields
from pathlib import Path
from typing import Annotated

import typer

from survtrack.errors import UsageError
from survtrack.evaluation import MaskScores, TrackScores, evaluate_tracks
from survtrack.evaluation import evaluate_masks as score_masks
from survtrack.evaluation.scores import score_key

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON at full precision, for programs.")]


def evaluate(
    truth: Annotated[
        Path, typer.Argument(metavar="TRUTH", help="True boxes: MOT text, or CVML (CAVIAR's XML).")
    ],
    tracks: Annotated[Path, typer.Argument(metavar="TRACKS", help="Tracks to score: MOT text.")],
    frames: Annotated[
        str | None,
        typer.Option(
            metavar="A-B",
            help="Score only these frames, in the tracks' numbering from 1. Without it: those "
            "that a run.json beside TRACKS lists as processed, or else all.",
        ),
    ] = None,
    offset: Annotated[
        int, typer.Option(help="Frame f of the tracks is frame f + OFFSET of the truth.")
    ] = 0,
    iou: Annotated[
        float, typer.Option(help="Overlap from which a box matches (MOTA, IDF1), above 0 to 1.")
    ] = 0.5,
    scale: Annotated[
        str | None,
        typer.Option(
            metavar="X[,Y]",
            help="Scale the truth's boxes by X across and Y down (the same without Y). Without it: "
            "as a run.json beside TRACKS says that --resize scaled the frames.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Score tracks against true boxes: HOTA, MOTA, IDF1 and their parts, in percent (0 to 100).

    Truth rows of confidence 0 are left out. Boxes that CVML calls inactive are don't-care.
    """
    chosen = _parse_frames(frames)
    by = _parse_scale(scale)
    scores = evaluate_tracks(truth, tracks, frames=chosen, offset=offset, iou=iou, scale=by)
    _print(scores, as_json)


def evaluate_masks(
    sequence_dir: Annotated[
        Path,
        typer.Argument(
            metavar="SEQUENCE_DIR", help="A CDnet or SBI sequence: groundtruth/, temporalROI.txt."
        ),
    ],
    mask_dir: Annotated[
        Path, typer.Argument(metavar="MASK_DIR", help="Masks to score: binNNNNNN.png.")
    ],
    frames: Annotated[
        str | None,
        typer.Option(
            metavar="A-B",
            help="Score only these of the frames in temporalROI.txt, numbered as the files are.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Score foreground masks by CDnet's rule: Re, Sp, FPR, FNR, Pr, F from 0 to 1, PWC in percent.

    A score that is not defined, such as the precision of empty masks, is null in JSON.
    """
    _print(score_masks(sequence_dir, mask_dir, frames=_parse_frames(frames)), as_json)


def _parse_frames(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    match = re.fullmatch(r"\s*([0-9]{1,15})\s*-\s*([0-9]{1,15})\s*", text)
    if match is None:
        raise UsageError(f"--frames {text}: two frame numbers expected, such as 1-100")
    return int(match[1]), int(match[2])


def _parse_scale(text: str | None) -> tuple[float, float] | None:
    if text is None:
        return None
    try:
        across, *down = (float(part) for part in text.split(","))
    except ValueError:
        across, down = math.nan, []
    if math.isnan(across) or len(down) > 1:
        raise UsageError(f"--scale {text}: one or two numbers expected, such as 0.5 or 0.5,0.4")
    return across, down[0] if down else across


def _print(scores: TrackScores | MaskScores, as_json: bool) -> None:
    if as_json:
        typer.echo(json.dumps(scores.to_dict(), indent=2, allow_nan=False))
        return
    from rich.console import Console
    from rich.table import Table

    table = Table("score", "value", "meaning")
    table.columns[1].justify = "right"
    for entry in fields(scores):
        value = getattr(scores, entry.name)
        name = score_key(entry).replace("_", " ")
        table.add_row(name, _format(value, entry.metadata["percent"]), entry.metadata["meaning"])
    Console().print(table)


def _format(value: float | int, percent: bool) -> str:
    if isinstance(value, int):
        return str(value)
    if math.isnan(value):
        return "-"
    return f"{value:.1f} %" if percent else f"{value:.4f}"
