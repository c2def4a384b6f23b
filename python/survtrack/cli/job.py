# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What `run` and `segment` have in common: from options to a finished folder."""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import survtrack
from survtrack.cli.background import load_background
from survtrack.cli.messages import one_line, print_error
from survtrack.cli.progress import show_progress
from survtrack.cli.signals import interrupted_by_signal
from survtrack.errors import InputError, UsageError
from survtrack.runner import RunSummary, least_frames, refuse_endless_delay, run, too_short
from survtrack.sinks import RunFolder, Sink
from survtrack.sinks.folder import CONFIG, MANIFEST
from survtrack.sources import Prefetch, Source, open_source
from survtrack.sources.opening import bytes_of_files

if TYPE_CHECKING:
    from survtrack._core import Config, Paths, Pipeline

INTERRUPTED = 130


@dataclass(frozen=True)
class Request:
    """Options of `run` and `segment`, as typed."""

    command: str
    source: str
    preset: str
    config: Path | None
    assignments: Sequence[str]
    fps: float | None
    start: int
    step: int
    limit: int | None
    resize: tuple[int, int] | None
    out: Path
    as_json: bool
    quiet: bool
    scene: Path | None = None
    path_file: Path | None = None
    background: Path | None = None
    zones: Sequence[str] = ()


def resolve_config(request: Request) -> "Config":
    """The preset, with the config file on top and then each --set, left to right.

    Raises:
        ConfigError: an unknown preset, option or value.
        InputError: the config file cannot be read.
    """
    config = survtrack.preset(request.preset)
    if request.config is not None:
        config.update_from_toml(read_text(request.config), str(request.config))
    for assignment in request.assignments:
        config.set(assignment)
    return config


def read_text(path: Path) -> str:
    """The text of a file; raises InputError that names it."""
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error


def execute(
    request: Request,
    config: "Config",
    make_sinks: Callable[[RunFolder, Source, "Pipeline"], list[Sink]],
    check: Callable[[Source], None] | None = None,
    paths: "Paths | None" = None,
) -> int:
    """Run it all and print the summary; returns the exit code of an interrupted run, else 0.

    check is called with the first result, before anything is written: the size of the frames is
    known by then. paths are loaded into the pipeline.

    Raises:
        SurvtrackError, OSError: what went wrong. Before the first result the folder is as it was;
            later what was seen before is in it, and run.json says that it is not complete.
    """
    pipeline = prepared_pipeline(request, config, paths)
    source = opened_source(request)
    refuse_endless_delay(source, pipeline)
    folder = RunFolder(request.out)
    sinks = make_sinks(folder, source, pipeline)

    def begin() -> None:
        if check is not None:
            check(source)
        folder.make()

    total = source.selection.expected_count(source.frame_count_declared)
    if total is not None and (short := too_short(config, source.name, total)):
        raise short
    with (
        Prefetch(source) as frames,
        interrupted_by_signal(frames.interrupt) as signals,
        show_progress(total, quiet=request.quiet) as progress,
    ):
        summary = run(frames, pipeline, sinks, progress, begin, least_frames(config))
    if not summary.begun:
        summary.error = summary.error or too_short(config, source.name, summary.held)
        return _nothing_begun(summary, signals)
    facts = run_facts(request, source, summary)
    facts["outputs"] = [name for sink in sinks for name in sink.outputs]
    _finish(folder, facts, config, summary)
    _print_summary(request, facts, summary)
    if isinstance(summary.error, KeyboardInterrupt):
        when = "" if summary.last_index is None else f" after frame {summary.last_index + 1}"
        print_error(f"interrupted{when}; what was found until then is in {request.out}")
        return _interrupted(signals)
    summary.raise_error()
    return 0


def prepared_pipeline(
    request: Request, config: "Config", paths: "Paths | None" = None
) -> "Pipeline":
    """A pipeline with all that the options load into it.

    Raises:
        UsageError, InputError: something is missing, is not taken by this config or cannot be read.
    """
    pipeline = survtrack.Pipeline(config)
    if paths is not None:
        pipeline.load_paths(paths)
    elif config.filter.model == "kalman_path":
        raise UsageError(
            'filter.model "kalman_path": follows objects along paths; add --path FILE, '
            "or choose another filter"
        )
    if request.scene is not None:
        pipeline.load_learned_scene(read_text(request.scene), str(request.scene))
    if request.zones:
        pipeline.load_zones([zone_box(zone) for zone in request.zones])
    load_background(pipeline, config, request.background)
    return pipeline


def opened_source(request: Request) -> Source:
    """The frames that the options choose; raises what `open_source` does."""
    return open_source(
        request.source,
        fps=request.fps,
        start=request.start,
        step=request.step,
        limit=request.limit,
        resize=request.resize,
    )


def _nothing_begun(summary: RunSummary, signals: list[int]) -> int:
    """The end of a run without a result; nothing was written, and an earlier run is kept."""
    if isinstance(summary.error, KeyboardInterrupt):
        print_error("interrupted before the first frame was done; nothing was written")
        return _interrupted(signals)
    summary.raise_error()
    raise InputError("the source gave no frames; nothing was written")


def _interrupted(signals: list[int]) -> int:
    return 128 + signals[0] if signals else INTERRUPTED


def run_facts(request: Request, source: Source, summary: RunSummary) -> dict[str, Any]:
    """What run.json says of a run; frames count from 1, as in tracks.txt."""
    first, last = summary.first_index, summary.last_index
    return {
        "survtrack": survtrack.__version__,
        "command": request.command,
        "source": source.name,
        "preset": request.preset,
        "config": None if request.config is None else str(request.config),
        "set": list(request.assignments),
        "scene": None if request.scene is None else str(request.scene),
        "path": None if request.path_file is None else str(request.path_file),
        "zones": list(request.zones),
        "background": None if request.background is None else str(request.background),
        "complete": summary.complete,
        "error": None if summary.error is None else one_line(summary.error),
        "frames": {
            "first": None if first is None else first + 1,
            "last": None if last is None else last + 1,
            "step": source.selection.step,
            "count": summary.frames,
        },
        "fps": source.fps,
        "fps_origin": source.fps_origin,
        "size": summary.size,
        "original_size": source.original_size,
        "source_bytes": bytes_of_files(source),
        "tracks": len(summary.track_ids),
        "events": summary.events,
        "pixels_read_fraction": _part_read(summary),
        "seconds": round(summary.seconds, 6),
        "frames_per_s": _rate(summary.frames, summary.seconds),
        "pipeline_seconds": round(summary.pipeline_seconds, 6),
        "frames_per_s_without_decoding": _rate(summary.frames, summary.pipeline_seconds),
    }


def zone_box(text: str) -> "survtrack.Box":
    """The box of LEFT,TOP,WIDTH,HEIGHT; raises UsageError."""
    try:
        left, top, width, height = (float(number) for number in text.split(","))
    except ValueError as error:
        raise UsageError(
            f"--zone {text}: expected four numbers in px, LEFT,TOP,WIDTH,HEIGHT"
        ) from error
    return survtrack.Box(left, top, width, height)


def _part_read(summary: RunSummary) -> float | None:
    """What part of all pixels was looked at."""
    if summary.size is None:
        return None
    return round(summary.pixels_read / (summary.frames * summary.size[0] * summary.size[1]), 6)


def _rate(frames: int, seconds: float) -> float | None:
    return round(frames / seconds, 3) if frames and seconds > 0 else None


def _finish(
    folder: RunFolder, facts: dict[str, Any], config: "Config", summary: RunSummary
) -> None:
    """Write run.json; when that fails too, what ended the run is the error to tell."""
    try:
        folder.finish(facts, config.to_toml())
    except OSError:
        summary.raise_error()
        raise


def _print_summary(request: Request, facts: dict[str, Any], summary: RunSummary) -> None:
    if request.as_json:
        printed = {**facts, "frames": summary.frames, "out": str(request.out)}
        print(json.dumps(printed, allow_nan=False))
    elif not request.quiet and summary.frames:
        print(
            f"{summary.frames} frames in {summary.seconds:.2f} s: {facts['frames_per_s']:.1f} "
            f"frames/s, pipeline alone {facts['frames_per_s_without_decoding']:.1f} frames/s"
        )
        read = facts["pixels_read_fraction"]
        looked = "" if read == 1 else f"; {100 * read:.1f} % of the pixels read"
        print(f"tracks: {facts['tracks']}, events: {facts['events']}{looked}")
        print(f"{request.out}: {', '.join([*facts['outputs'], CONFIG, MANIFEST])}")
