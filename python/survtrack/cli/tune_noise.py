# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack tune-noise`."""

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

import survtrack
from survtrack._core import KalmanCaOptions, KalmanCvOptions, MeasurementRecorder
from survtrack.cli import options as shared
from survtrack.cli.background import BackgroundOption
from survtrack.cli.job import (
    INTERRUPTED,
    Request,
    opened_source,
    prepared_pipeline,
    resolve_config,
)
from survtrack.cli.messages import print_error
from survtrack.cli.progress import show_progress
from survtrack.cli.signals import interrupted_by_signal
from survtrack.errors import UsageError
from survtrack.offline.noise import LEAST_STEPS, TunedNoise, tune_noise
from survtrack.runner import RunSummary, refuse_endless_delay, results
from survtrack.sinks.part_file import PartFile
from survtrack.sources import Prefetch

if TYPE_CHECKING:
    from survtrack._core import Config, FilterConsistency
    from survtrack.offline.noise import TunableOptions

OutOption = Annotated[
    Path | None,
    typer.Option(
        "--out", metavar="FILE", help="Also write what was found as TOML, for `run --config`."
    ),
]
JointOption = Annotated[
    bool,
    typer.Option(
        "--joint", help="Fit position_noise with the process noise even if objects stand still."
    ),
]
LeastOption = Annotated[
    int,
    typer.Option(
        "--min-steps",
        metavar="N",
        min=10,
        help="Refuse fewer steps from one measurement to the next.",
    ),
]


def tune_noise_command(
    source: shared.SourceArgument,
    preset: shared.PresetOption = "survtrack",
    config: shared.ConfigOption = None,
    assignments: shared.SetOption = None,
    fps: shared.FpsOption = None,
    start: shared.StartOption = 0,
    step: shared.StepOption = 1,
    limit: shared.LimitOption = None,
    resize: shared.ResizeOption = None,
    joint: JointOption = False,
    least_steps: LeastOption = LEAST_STEPS,
    scene: shared.SceneOption = None,
    zones: shared.ZoneOption = None,
    background: BackgroundOption = None,
    out: OutOption = None,
    as_json: shared.JsonOption = False,
    quiet: shared.QuietOption = False,
) -> int:
    """Find the noises of the Kalman filter that fit SOURCE best.

    Tracks what moves, and takes the measurements of the confirmed tracks: R from those that stand
    still, if there are enough, and Q by maximum likelihood. Prints both as options.
    """
    request = Request(
        "tune-noise", source, preset, config, assignments or [], fps, start, step, limit,
        shared.parse_size(resize), Path(), as_json, quiet, scene, None, background,
        zones or [],
    )  # fmt: skip
    resolved = resolve_config(request)
    options = _tunable(resolved)
    recorder = MeasurementRecorder(resolved)
    file = None if out is None else PartFile(out)
    # Where nothing can be written is told before the run, not after it.
    if file is not None:
        file.open()
    try:
        frames = _measure(request, resolved, recorder)
        if frames is None:
            return INTERRUPTED
        tuned = tune_noise(recorder.tracks(), options, joint=joint, least_steps=least_steps)
        text = config_text(resolved, tuned.options, request.source)
        if file is not None:
            file.write(text)
            file.finish()
    finally:
        if file is not None:
            file.discard()
    if as_json:
        print(json.dumps(_facts(tuned, options, recorder, frames, out), allow_nan=False))
    elif not quiet:
        _print(tuned, options, recorder)
        print(f"\n{text}" if out is None else f"{out}: for `survtrack run --config`")
    return 0


def _tunable(config: "Config") -> "TunableOptions":
    """The filter's options; raises UsageError for one whose noises are not identified."""
    options = config.filter
    if isinstance(options, (KalmanCvOptions, KalmanCaOptions)):
        return options
    raise UsageError(
        f'filter.model: the noises of "{options.model}" are not identified; choose kalman_cv or '
        "kalman_ca, such as by --set filter.model=kalman_cv"
    )


def _measure(request: Request, config: "Config", recorder: MeasurementRecorder) -> int | None:
    """Run the pipeline; returns the number of frames, None when it was interrupted."""
    pipeline = prepared_pipeline(request, config)
    source = opened_source(request)
    refuse_endless_delay(source, pipeline)
    total = source.selection.expected_count(source.frame_count_declared)
    summary = RunSummary()
    try:
        with (
            Prefetch(source) as frames,
            interrupted_by_signal(frames.interrupt),
            show_progress(total, quiet=request.quiet) as progress,
        ):
            for result in results(frames, pipeline):
                recorder.add(result)
                summary.frames += 1
                if progress is not None:
                    progress(summary.frames)
    except KeyboardInterrupt:
        print_error(f"interrupted after {summary.frames} frames; nothing was identified")
        return None
    return summary.frames


def config_text(config: "Config", options: "TunableOptions", source: str) -> str:
    """TOML of the filter, with the time unit that its numbers are in."""
    lines = [
        f"# Noises identified by survtrack {survtrack.__version__} from {json.dumps(source)}.",
        f"time_unit_s = {json.dumps(config.time_unit_s)}",
        "",
        "[filter]",
        f'model = "{options.model}"',
    ]
    for name, value in options.to_dict().items():
        if name != "model":
            lines.append(f"{name} = {json.dumps(value)}")
    return "\n".join(lines) + "\n"


def _print(tuned: TunedNoise, options: "TunableOptions", recorder: MeasurementRecorder) -> None:
    print(
        f"measurements: {recorder.used} used; left out: {recorder.shared} of blobs that several "
        f"tracks share, {recorder.at_border} cut by the frame's border"
    )
    print(f"tracks: {tuned.tracks}, steps: {tuned.after.steps}; {_origin(tuned)}")
    _print_row("", "now", "identified", "standard error")
    for name, noise in tuned.noises.items():
        error = f"{noise.standard_error:.2g}" if math.isfinite(noise.standard_error) else "open"
        _print_row(f"filter.{name}", f"{getattr(options, name):.4g}", f"{noise.value:.4g}", error)
    before, after = tuned.before, tuned.after
    _print_row("log-likelihood", f"{before.log_likelihood:.1f}", f"{after.log_likelihood:.1f}")
    low, high = after.nis_band
    band = f"{low:.3f} to {high:.3f} if it fits"
    _print_row("mean NIS", f"{before.nis_mean:.3f}", f"{after.nis_mean:.3f}", band)
    limit = f"within {after.correlation_limit:.3f} if it fits"
    _print_row("correlation", f"{before.correlation:.3f}", f"{after.correlation:.3f}", limit)


def _print_row(name: str, now: str, identified: str, more: str = "") -> None:
    print(f"{name:24}{now:>12}{identified:>14}  {more}".rstrip())


def _origin(tuned: TunedNoise) -> str:
    if tuned.measurement is None:
        return f"{tuned.still_tracks} of them stand still, R is fitted with Q"
    return (
        f"R is from {tuned.still_tracks} that stand still, {tuned.measurement.samples} measurements"
    )


def _facts(
    tuned: TunedNoise,
    options: "TunableOptions",
    recorder: MeasurementRecorder,
    frames: int,
    out: Path | None,
) -> dict[str, Any]:
    """The summary for programs; what the data do not determine has no error."""
    return {
        "frames": frames,
        "model": options.model,
        "noise_unit": options.noise_unit,
        "measurements": recorder.used,
        "left_out": {"shared": recorder.shared, "at_border": recorder.at_border},
        "tracks": tuned.tracks,
        "still_tracks": tuned.still_tracks,
        "steps": tuned.after.steps,
        "position_noise_from_still": tuned.measurement is not None,
        "noises": {
            name: {
                "now": getattr(options, name),
                "identified": noise.value,
                "standard_error": noise.standard_error
                if math.isfinite(noise.standard_error)
                else None,
            }
            for name, noise in tuned.noises.items()
        },
        "before": _consistency(tuned.before),
        "after": _consistency(tuned.after),
        "out": None if out is None else str(out),
    }


def _consistency(found: "FilterConsistency") -> dict[str, Any]:
    return {
        "log_likelihood": found.log_likelihood,
        "nis_mean": found.nis_mean,
        "nis_band": list(found.nis_band),
        "correlation": found.correlation,
        "correlation_limit": found.correlation_limit,
    }
