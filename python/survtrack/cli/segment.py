# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack segment`."""

from typing import TYPE_CHECKING

from survtrack.cli import options
from survtrack.cli.background import BackgroundOption
from survtrack.cli.job import Request, execute, resolve_config
from survtrack.path_file import read_paths, require_frame_size
from survtrack.sinks import MaskFolder, RunFolder, Sink
from survtrack.sources import ImageSource, Source

if TYPE_CHECKING:
    from survtrack._core import Pipeline


def segment(
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
    path_file: options.PathOption = None,
    zones: options.ZoneOption = None,
    background: BackgroundOption = None,
    as_json: options.JsonOption = False,
    quiet: options.QuietOption = False,
) -> int:
    """Write the foreground mask of every frame of SOURCE: DIR/binNNNNNN.png, 0 or 255.

    Folder of images: NNNNNN are the last six digits of the image's name; video: the frame counted
    from 1. The masks are those of `survtrack run`, which expects objects where its tracks are.
    They are in DIR/masks.part until the end, where they replace those of an earlier run.
    """
    request = Request(
        "segment", source, preset, config, assignments or [], fps, start, step, limit,
        options.parse_size(resize), out, as_json, quiet,
        path_file=path_file, background=background, zones=zones or [],
    )  # fmt: skip

    def make_sinks(folder: RunFolder, source: Source, pipeline: "Pipeline") -> list[Sink]:
        folder.refuse_foreign_masks()
        masks = MaskFolder(folder.path, source.file_name)
        if isinstance(source, ImageSource):
            masks.check_names(source.selection.indices(source.frame_count_declared))
        return [masks]

    paths = None if path_file is None else read_paths(path_file)

    def check(source: Source) -> None:
        if paths is not None and path_file is not None:
            require_frame_size(paths, source.size, path_file)

    return execute(request, resolve_config(request), make_sinks, check, paths)
