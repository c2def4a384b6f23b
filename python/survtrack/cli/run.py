# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack run`."""

from typing import TYPE_CHECKING, Annotated

import typer

from survtrack._core import HornSchunckOptions
from survtrack.cli import options
from survtrack.cli.background import BackgroundOption
from survtrack.cli.job import Request, execute, resolve_config
from survtrack.drawing import VIEW_NAMES, VIEW_OUTPUTS, Views
from survtrack.errors import UsageError
from survtrack.path_file import read_paths, require_frame_size
from survtrack.replay.damping import lost_damping_s
from survtrack.sinks import (
    AnnotatedVideo,
    EventLines,
    LearnedScene,
    MatrixLines,
    MotText,
    PathCsv,
    RunFolder,
    Sink,
    TracksCsv,
    TrackStream,
)
from survtrack.sources import Source

if TYPE_CHECKING:
    from survtrack._core import Config, Pipeline

VideoOption = Annotated[bool, typer.Option("--video", help="Also write annotated.mp4.")]
ViewsOption = Annotated[
    str | None,
    typer.Option(
        "--views",
        metavar="A,B",
        help=f"What annotated.mp4 shows, side by side: of {', '.join(VIEW_NAMES)}. "
        "Without it: tracks.",
    ),
]

MatrixOption = Annotated[
    bool,
    typer.Option(
        "--matrix", help="Also write matrices.jsonl: each frame's costs, or beliefs, by name."
    ),
]
StreamOption = Annotated[
    bool,
    typer.Option(
        "--stream", help="Also write tracks.svt: the tracked states alone, for `survtrack replay`."
    ),
]


def run(
    source: options.SourceArgument,
    out: options.OutOption,
    preset: options.PresetOption = "survtrack",
    config: options.ConfigOption = None,
    assignments: options.SetOption = None,
    fps: options.FpsOption = None,
    start: options.StartOption = 0,
    step: options.StepOption = 1,
    limit: options.LimitOption = None,
    resize: options.ResizeOption = None,
    video: VideoOption = False,
    views: ViewsOption = None,
    matrix: MatrixOption = False,
    stream: StreamOption = False,
    scene: options.SceneOption = None,
    path_file: options.PathOption = None,
    zones: options.ZoneOption = None,
    background: BackgroundOption = None,
    as_json: options.JsonOption = False,
    quiet: options.QuietOption = False,
) -> int:
    """Track what moves in SOURCE.

    Writes DIR/tracks.txt (MOT), events.jsonl, tracks.csv, scene.json, config.toml and run.json.
    Each is NAME.part until it is whole; Ctrl-C finishes them.
    """
    request = Request(
        "run", source, preset, config, assignments or [], fps, start, step, limit,
        options.parse_size(resize), out, as_json, quiet, scene, path_file, background,
        zones or [],
    )  # fmt: skip
    names = _view_names(video, views)
    if "path" in names and path_file is None:
        raise UsageError("--views path: shows a path; add --path FILE")
    paths = None if path_file is None else read_paths(path_file)
    resolved = resolve_config(request)
    if "vicinity" in names and resolved.vicinity.model == "none":
        raise UsageError(
            "--views vicinity: shows a grid that this config does not have; choose one of the "
            "narayana2007 presets, or add --set vicinity.model=grid"
        )
    if "regions" in names and resolved.regions.model == "none":
        raise UsageError(
            "--views regions: shows what is read, and this config reads whole frames; "
            "add --set regions.model=predicted"
        )
    flow_threshold_px = _flow_threshold_px(resolved, names)
    for output in {VIEW_OUTPUTS[name] for name in names if name in VIEW_OUTPUTS}:
        resolved.set(f"outputs.{output}=true")
    if matrix:
        resolved.set("outputs.cost_matrix=true")

    def make_sinks(folder: RunFolder, source: Source, pipeline: "Pipeline") -> list[Sink]:
        path = folder.path
        sinks: list[Sink] = [
            MotText(path / "tracks.txt"),
            EventLines(path / "events.jsonl"),
            TracksCsv(path / "tracks.csv", source.file_name),
            LearnedScene(path / "scene.json", pipeline),
        ]
        if matrix:
            sinks.append(MatrixLines(path / "matrices.jsonl"))
        rate = source.fps / source.selection.step
        if stream:
            damping_s = lost_damping_s(resolved)
            sinks.append(TrackStream(path / "tracks.svt", fps=rate, lost_damping_s=damping_s))
        if paths is not None:
            sinks.append(PathCsv(path / "path.csv", paths))
        if video:
            render = Views(names, flow_threshold_px, paths)
            sinks.append(AnnotatedVideo(path / "annotated.mp4", render, fps=rate))
        return sinks

    def check(source: Source) -> None:
        if paths is not None and path_file is not None:
            require_frame_size(paths, source.size, path_file)

    return execute(request, resolved, make_sinks, check, paths)


def _view_names(video: bool, views: str | None) -> list[str]:
    """Names of --views, checked before anything is opened."""
    if views is None:
        return ["tracks"]
    if not video:
        raise UsageError(f"--views {views}: says what annotated.mp4 shows; add --video")
    names = [name.strip() for name in views.split(",")]
    Views(names)
    return names


def _flow_threshold_px(config: "Config", names: list[str]) -> float:
    """Above which flow is foreground, px; refuses views that the segmenter has nothing for."""
    if isinstance(config.segmenter, HornSchunckOptions):
        if "background" in names:
            raise UsageError(
                "--views background: the segmenter horn_schunck has none; leave it out, or choose "
                "another with --set segmenter.model=..."
            )
        return config.segmenter.magnitude_threshold
    for name in names:
        if VIEW_OUTPUTS.get(name) == "flow":
            raise UsageError(
                f"--views {name}: shows a flow field that this config does not have; "
                "add --set segmenter.model=horn_schunck"
            )
    return 0.0
