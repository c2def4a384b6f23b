# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack scene`."""

import json
from pathlib import Path
from typing import Annotated

import typer

from survtrack.cli import options
from survtrack.cli.progress import show_progress


def scene(
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="[NAME]", help="Which scene; without it they are listed.", show_default=False
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="DIR",
            help="Folder for it; without it the scene's options are listed.",
        ),
    ] = None,
    kind: Annotated[
        str, typer.Option("--kind", metavar="KIND", help="Frames: video (colour), grey or mask.")
    ] = "video",
    size: Annotated[
        str, typer.Option("--size", metavar="WxH", help="Of the frames, in pixels.")
    ] = "320x240",
    frames: Annotated[
        int, typer.Option("--frames", metavar="N", min=1, help="How many frames.")
    ] = 200,
    fps: Annotated[float, typer.Option("--fps", metavar="F", help="Frames per second.")] = 25.0,
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", help="Of textures, noise and places.")
    ] = 0,
    assignments: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="A=B", help="One option; repeat it, left to right."),
    ] = None,
    as_json: options.JsonOption = False,
    quiet: options.QuietOption = False,
) -> None:
    """Make a synthetic scene with exact truth, for trying out and measuring.

    Writes DIR/input (frames), groundtruth (masks), temporalROI.txt, gt.txt (MOT), truth.csv and,
    when all of it is there, recipe.json. `survtrack run DIR/input` tracks it.
    """
    from survtrack import scenes

    if name is None:
        _list_scenes()
        return
    if out is None:
        _list_options(name)
        return
    made = scenes.make_scene(
        name,
        size=options.parse_size(size, "--size") or (0, 0),
        frame_count=frames,
        fps=fps,
        seed=seed,
        **dict(options.parse_assignment(each) for each in assignments or []),
    )
    with show_progress(made.frame_count, quiet=quiet) as progress:
        scenes.write_scene(made, out, kind=kind, progress=progress)
    facts = {"scene": name, "kind": kind, "frames": frames, "size": made.size, "out": str(out)}
    if as_json:
        print(json.dumps({**facts, "objects": len(made.objects)}))
    elif not quiet:
        print(f"{frames} frames of {size}, {len(made.objects)} objects, {made.duration_s:g} s")
        print(f"{out}: {', '.join(scenes.OUTPUTS)}")


def _list_scenes() -> None:
    from survtrack import scenes

    width = max(map(len, scenes.scene_names()))
    for name in scenes.scene_names():
        print(f"{name:{width}}  {scenes.scene_summary(name)}")


def _list_options(name: str) -> None:
    from survtrack import scenes

    print(scenes.scene_summary(name))
    for option, default in scenes.scene_options(name).items():
        print(f"  --set {option}={_as_toml(default)}")


def _as_toml(value: object) -> str:
    """As `--set` takes it."""
    return json.dumps(value) if isinstance(value, tuple) else str(value)
