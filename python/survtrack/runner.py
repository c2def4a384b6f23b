# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The loop: frames from a source through a pipeline to sinks."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from os import PathLike
from time import perf_counter
from typing import TYPE_CHECKING

from survtrack.errors import InputError, UsageError
from survtrack.sources import ArraySource, Prefetch, open_source

if TYPE_CHECKING:
    from survtrack._core import Box, Config, FrameResult, Paths, Pipeline
    from survtrack.sinks import Sink
    from survtrack.sources import Frame, Source


@dataclass
class RunSummary:
    """What a run did.

    Attributes:
        frames: results written.
        first_index, last_index: source index of the first and last result; None without any.
        size: (width, height) of the frames in pixels.
        seconds: from the first frame's request until all sinks are finished.
        pipeline_seconds: of these, inside the pipeline: without decoding, drawing and writing.
        track_ids: ids of all tracks that were reported.
        events: number of events.
        pixels_read: of all results; fewer than frames times size with regions.
        begun: there was a first result, and a place for it.
        held: results that were not written because there were too few.
        error: what ended the run early; None when it is complete.
    """

    frames: int = 0
    first_index: int | None = None
    last_index: int | None = None
    size: tuple[int, int] | None = None
    seconds: float = 0.0
    pipeline_seconds: float = 0.0
    track_ids: set[int] = field(default_factory=set)
    events: int = 0
    pixels_read: int = 0
    begun: bool = False
    held: int = 0
    error: BaseException | None = None

    @property
    def complete(self) -> bool:
        """True when every selected frame was read, processed and written."""
        return self.error is None

    def raise_error(self) -> None:
        """Raise what ended the run early, if something did."""
        if self.error is not None:
            raise self.error

    def add(self, result: "FrameResult") -> None:
        """Count one result."""
        self.frames += 1
        self.first_index = result.index if self.first_index is None else self.first_index
        self.last_index = result.index
        self.size = (result.frame.shape[1], result.frame.shape[0])
        self.track_ids.update(track.id for track in result.tracks if track.reported)
        self.events += len(result.events)
        self.pixels_read += result.pixels_read


def run(
    source: "Source",
    pipeline: "Pipeline",
    sinks: "Sequence[Sink]",
    progress: Callable[[int], None] | None = None,
    begin: Callable[[], None] | None = None,
    least: int = 1,
) -> RunSummary:
    """Process every frame of the source and write every result to every sink.

    The sinks are entered with the first result: an error that comes before it, such as a frame
    that the config does not fit, touches no outputs of an earlier run. Whatever goes wrong later,
    Ctrl-C included, ends the run but not its outputs: the frames seen before are written, the
    sinks are finished, and the summary's `error` says what it was.

    Args:
        source: see Source.
        pipeline: fresh, or reset.
        sinks: see Sink; entered and left here.
        progress: called after each result with the number of results.
        begin: called once, before the sinks are entered; makes the place of the outputs.
        least: of fewer results none is written, unless the run is interrupted.

    Raises:
        UsageError: an endless source with a pipeline that answers late.
    """
    refuse_endless_delay(source, pipeline)
    summary = RunSummary()
    began = perf_counter()
    try:
        with ExitStack() as stack:

            def enter_sinks() -> None:
                if begin is not None:
                    begin()
                summary.begun = True
                for sink in sinks:
                    stack.enter_context(sink)

            _loop(source, pipeline, enter_sinks, sinks, progress, summary, least)
    except (Exception, KeyboardInterrupt) as error:
        # A full disk also keeps other sinks from finishing: what came first is the cause.
        summary.error = summary.error or error
    summary.seconds = perf_counter() - began
    return summary


def _loop(
    source: "Source",
    pipeline: "Pipeline",
    enter_sinks: Callable[[], None],
    sinks: "Sequence[Sink]",
    progress: Callable[[int], None] | None,
    summary: RunSummary,
    least: int,
) -> None:
    """Write results until there are no more; an error on the way is put into the summary."""
    held: list[FrameResult] = []

    def write_held() -> None:
        if not summary.begun:
            enter_sinks()
        while held:
            result = held.pop(0)
            for sink in sinks:
                sink.write(result.frame, result)
            summary.add(result)
            if progress is not None:
                progress(summary.frames)

    try:
        try:
            for result in results(source, pipeline, summary):
                held.append(result)
                if summary.begun or len(held) >= least:
                    write_held()
        except (Exception, KeyboardInterrupt):
            # What kept a sink from writing would do so again.
            if 0 < len(held) < least and not summary.begun:
                write_held()
            raise
    except (Exception, KeyboardInterrupt) as error:
        summary.error = error
    summary.held = len(held)


def results(
    source: "Source", pipeline: "Pipeline", summary: RunSummary | None = None
) -> "Iterator[FrameResult]":
    """Yield the result of each frame, late ones included, also before what the source raises.

    Args:
        source: see Source.
        pipeline: fresh, or reset.
        summary: its pipeline_seconds grow by the time spent in the pipeline.
    """
    watch = summary or RunSummary()
    try:
        for index, time_s, frame in source:
            began = perf_counter()
            result = pipeline.process(frame, time_s, index)
            watch.pipeline_seconds += perf_counter() - began
            if result is not None:
                yield result
    except (Exception, KeyboardInterrupt) as error:
        try:
            rest = _finish(pipeline, watch)
        except Exception:
            # What failed may also keep the pipeline from its end: the first error is the cause.
            raise error from None
        yield from rest
        raise
    yield from _finish(pipeline, watch)


def _finish(pipeline: "Pipeline", watch: RunSummary) -> "list[FrameResult]":
    began = perf_counter()
    rest = pipeline.finish()
    watch.pipeline_seconds += perf_counter() - began
    return rest


def refuse_endless_delay(source: "Source", pipeline: "Pipeline") -> None:
    """Raise UsageError for an endless source with a pipeline that needs frames yet to come."""
    if source.endless and pipeline.delay_frames > 0:
        raise UsageError(
            f"{source.name}: is a live stream, but this config answers "
            f"{pipeline.delay_frames} frames late; choose one without delay, such as the default"
        )


def _empty_masks(config: "Config") -> tuple[str, int]:
    """How many masks of a run's beginning are empty by the segmenter's options, and by which."""
    from survtrack import HornSchunckOptions, NormalizedDifferenceOptions, StaticReferenceOptions

    segmenter = config.segmenter
    if isinstance(segmenter, StaticReferenceOptions) and segmenter.source != "picture":
        return "frames", segmenter.frames
    if isinstance(segmenter, HornSchunckOptions):
        return "frames_back", segmenter.frames_back
    if isinstance(segmenter, NormalizedDifferenceOptions) and segmenter.reference == "previous":
        return "frames_back", segmenter.frames_back
    return "", 0


def least_frames(config: "Config") -> int:
    """How many frames a source must have: more than those whose masks are empty."""
    return _empty_masks(config)[1] + 1


def too_short(config: "Config", name: str, count: int) -> InputError | None:
    """What is wrong when `count` frames are too few for a model whose first masks are empty."""
    option, frames = _empty_masks(config)
    if not option or count == 0 or count > frames:
        return None
    return InputError(
        f"segmenter.{option}: {frames} is not allowed with the {count} "
        f"frame(s) of {name}; expected fewer than there are"
    )


def track(
    source: "str | PathLike[str] | Iterable[Frame] | Source",
    preset: str = "survtrack",
    *,
    config: "Config | None" = None,
    fps: float | None = None,
    start: int = 0,
    step: int = 1,
    limit: int | None = None,
    resize: tuple[int, int] | None = None,
    paths: "Paths | None" = None,
    zones: "Sequence[Box]" = (),
    background: "Frame | None" = None,
) -> "Iterator[tuple[Frame, FrameResult]]":
    """Track what moves in a video, a folder or glob of images, an iterable of arrays or a Source.

        for frame, result in survtrack.track("street.mp4"):
            print(result.index, [track.id for track in result.tracks if track.reported])

    Args:
        source, fps, start, step, limit, resize: as for survtrack.sources.open_source; a source
            that is open already, such as one of your own class, takes none of the options.
        preset: name of a preset; not looked at when `config` is given.
        config: what to run instead of a preset.
        paths: those of the scene, which filter.model kalman_path needs; others leave them aside.
        zones: where newcomers are looked for, px, with regions.acquisition zones.
        background: the picture to start from, with segmenter.source picture.

    Returns:
        An iterator of (frame, result); frame is the one that the result belongs to. What the
        source raises comes after the results of the frames before it.

    Raises:
        InputError: the source cannot be read; the paths, zones or background cannot be used.
        UsageError: a bad option, or any of source's options with one that is open already.
    """
    import survtrack

    pipeline = survtrack.Pipeline(config or survtrack.preset(preset))
    if paths is not None:
        pipeline.load_paths(paths)
    if zones:
        pipeline.load_zones(list(zones))
    if background is not None:
        pipeline.load_background(background)
    frames = open_source(source, fps=fps, start=start, step=step, limit=limit, resize=resize)
    refuse_endless_delay(frames, pipeline)
    return _pairs(frames, pipeline)


def _pairs(source: "Source", pipeline: "Pipeline") -> "Iterator[tuple[Frame, FrameResult]]":
    if isinstance(source, (ArraySource, Prefetch)):
        yield from ((result.frame, result) for result in results(source, pipeline))
        return
    with Prefetch(source) as ahead:
        for result in results(ahead, pipeline):
            yield result.frame, result
