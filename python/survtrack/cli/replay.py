# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack replay`."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from survtrack.cli import options
from survtrack.cli.progress import show_progress
from survtrack.errors import InputError, UsageError
from survtrack.path_file import read_paths, require_frame_size
from survtrack.replay.filling import MAX_GAP_S
from survtrack.replay.film import VIEWS, replay_stream
from survtrack.replay.ground import read_ground
from survtrack.replay.reader import TrackStreamReader

if TYPE_CHECKING:
    from survtrack._core import Paths
    from survtrack.sources.base import Frame

FileArgument = Annotated[
    Path,
    typer.Argument(
        metavar="FILE",
        help="The tracks.svt that `survtrack run --stream` left.",
        show_default=False,
    ),
]
OutOption = Annotated[
    Path | None,
    typer.Option("--out", metavar="MP4", help="The video to write; without it only figures."),
]
BackgroundOption = Annotated[
    str | None,
    typer.Option(
        "--background",
        metavar="PICTURE",
        help="An image, or a video whose first frame is taken, to draw over. Without it: a grid.",
    ),
]
ViewOption = Annotated[
    str,
    typer.Option(
        "--view",
        metavar="V",
        help=f"One of {', '.join(VIEWS)}: as the camera saw it, or from above on a plan.",
    ),
]
GroundOption = Annotated[
    Path | None,
    typer.Option(
        "--ground",
        metavar="FILE",
        help='For the view above: JSON of four "image_points" and their four "ground_points".',
    ),
]
FpsOption = Annotated[
    float | None,
    typer.Option(
        "--fps",
        metavar="F",
        help="Pictures per second, instead of the stream's own. Missing ones are predicted.",
    ),
]
GapOption = Annotated[
    float,
    typer.Option(
        "--max-gap", metavar="S", help="Predict so many seconds; then pass over the rest of a gap."
    ),
]

PathOption = Annotated[
    Path | None,
    typer.Option(
        "--path",
        metavar="FILE",
        help="Predict tracks near the paths of FILE (JSON) along them, and draw these: the file of "
        "`survtrack run --path`.",
    ),
]


def replay(
    file: FileArgument,
    out: OutOption = None,
    background: BackgroundOption = None,
    view: ViewOption = "over",
    ground: GroundOption = None,
    fps: FpsOption = None,
    max_gap_s: GapOption = MAX_GAP_S,
    path_file: PathOption = None,
    as_json: options.JsonOption = False,
    quiet: options.QuietOption = False,
) -> None:
    """Make a scene again from its tracked states, without its video.

    A stream that is cut or damaged is replayed as far as it is whole; the exit code is then 1.
    """
    if out is not None and out.resolve() == file.resolve():
        raise UsageError(f"--out {out}: is the stream itself")
    picture = None if background is None else _first_frame(background)
    plan = None if ground is None else read_ground(ground)
    paths = None if path_file is None else _read_paths(path_file, file)
    with show_progress(None, quiet=quiet or out is None) as progress:
        facts = replay_stream(
            file, out,
            background=picture, view=view, ground=plan,
            fps=fps, max_gap_s=max_gap_s, paths=paths, progress=progress,
        )  # fmt: skip
    if as_json:
        print(json.dumps(facts, allow_nan=False))
    elif not quiet:
        _print_facts(facts)
    if facts["error"] is not None:
        raise InputError(facts["error"])


def _first_frame(source: str) -> "Frame":
    from survtrack.sources import open_source

    for _, _, frame in open_source(source, limit=1):
        return frame
    raise InputError(f"{source}: holds no frames")


def _read_paths(path_file: Path, stream: Path) -> "Paths":
    """The paths; raises InputError, which names their file, for those of other frames."""
    paths, header = read_paths(path_file), TrackStreamReader(stream).header
    require_frame_size(paths, (header.width_px, header.height_px), path_file)
    return paths


def _print_facts(facts: dict[str, Any]) -> None:
    width, height = facts["size"]
    print(
        f"{facts['frames']['count']} frames of {width}x{height} px in {facts['seconds']:.2f} s, "
        f"tracks: {facts['tracks']}"
    )
    if facts["frames"]["count"]:
        print(f"stream: {facts['stream_bytes_per_s']:,.0f} bytes/s")
        for name, words in (("raw", "raw video"), ("source", "source file")):
            if facts[f"{name}_ratio"] is not None:
                print(
                    f"{words}: {facts[f'{name}_bytes_per_s']:,.0f} bytes/s, "
                    f"{facts[f'{name}_ratio']:,.0f} times as many"
                )
    if facts["out"] is not None:
        print(
            f"{facts['out']}: {facts['pictures']} pictures, {facts['predicted_pictures']} predicted"
        )
