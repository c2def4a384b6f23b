# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack find`."""

import json
from pathlib import Path
from typing import Annotated

import typer

from survtrack.cli import options as shared
from survtrack.offline.patterns import read_patterns
from survtrack.offline.search import FoundTrack, find_tracks

RunsArgument = Annotated[
    list[Path],
    typer.Argument(
        metavar="RUN_DIR...",
        help="Folders that `survtrack run` or `survtrack link` left, of one camera.",
        show_default=False,
    ),
]
KnownOption = Annotated[
    Path,
    typer.Option(
        "--known",
        metavar="FILE",
        help="The patterns.json of `survtrack patterns` that tracks are judged by.",
        show_default=False,
    ),
]
PatternOption = Annotated[
    list[int] | None,
    typer.Option("--pattern", metavar="N", help="Only tracks that follow pattern N; repeat it."),
]
KindOption = Annotated[
    list[str] | None,
    typer.Option(
        "--kind",
        metavar="KIND",
        help="Only tracks that do this: usual, standing, other_way, too_fast, too_slow; repeat it.",
    ),
]


def find(
    run_dirs: RunsArgument,
    known: KnownOption,
    pattern: PatternOption = None,
    kind: KindOption = None,
    as_json: shared.JsonOption = False,
) -> None:
    """Find the tracks of many runs that go a known way, without viewing them.

    Prints a line a track; nothing is written.
    """
    found = find_tracks(run_dirs, read_patterns(known), ids=pattern or [], kinds=kind or [])
    if as_json:
        print(json.dumps([one.to_dict() for one in found], allow_nan=False))
        return
    for one in found:
        print(_line(one))
    print(f"tracks found: {len(found)} in {len(run_dirs)} runs")


def _line(one: FoundTrack) -> str:
    way = "no pattern" if one.pattern is None else f"pattern {one.pattern}"
    return (
        f"{one.run}: track {one.id}, frames {one.first_frame} to {one.last_frame} "
        f"({one.first_s:.2f} to {one.last_s:.2f} s): {one.kind}, {way}, "
        f"{one.speed_px_per_s:.0f} px/s"
    )
