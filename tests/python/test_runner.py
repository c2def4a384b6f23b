# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The loop: every frame to every sink, late results, and an end that loses nothing."""

from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
import pytest

from clips import Image, cut_short, walking_square, write_images
from fakes import Pipeline, Result
from survtrack.errors import InputError, UsageError
from survtrack.runner import results, run
from survtrack.sources import ArraySource, Selection, open_source


class Recorder:
    """A sink that remembers; fails at one frame or at the end when asked to."""

    def __init__(self, fails_at: int | None = None, fails_at_end: bool = False) -> None:
        self.indices: list[int] = []
        self.frames: list[Image] = []
        self.outputs: list[str] = []
        self.entered = self.finished = False
        self._fails_at, self._fails_at_end = fails_at, fails_at_end

    def __enter__(self) -> Self:
        self.entered = True
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.finished = True
        if self._fails_at_end:
            raise OSError(28, "No space left on device", "recorder")

    def write(self, frame: Image, result: Result) -> None:
        if result.index == self._fails_at:
            raise OSError(28, "No space left on device", "recorder")
        self.indices.append(result.index)
        self.frames.append(frame)


def run_fake(source: Any, pipeline: Pipeline, *sinks: Recorder) -> Any:
    return run(source, pipeline, sinks)  # type: ignore[arg-type]


FRAMES = walking_square(10)


def test_every_frame_reaches_every_sink() -> None:
    one, two, counts = Recorder(), Recorder(), []
    summary = run(ArraySource(FRAMES), Pipeline(), [one, two], counts.append)  # type: ignore[arg-type,list-item]
    assert one.indices == two.indices == list(range(10))
    assert all(a is b for a, b in zip(one.frames, FRAMES, strict=True))
    assert counts == list(range(1, 11))
    assert one.finished and two.finished and summary.complete
    assert (summary.frames, summary.first_index, summary.last_index) == (10, 0, 9)
    assert (summary.size, summary.track_ids, summary.events) == ((96, 64), {1}, 0)
    assert 0 < summary.pipeline_seconds <= summary.seconds
    summary.raise_error()


@pytest.mark.parametrize("delay", [1, 3, 9, 75])
def test_late_results_come_with_their_own_frames(delay: int) -> None:
    sink = Recorder()
    summary = run_fake(ArraySource(FRAMES), Pipeline(delay), sink)
    assert sink.indices == list(range(10))
    assert all(a is b for a, b in zip(sink.frames, FRAMES, strict=True))
    assert summary.complete


def test_start_and_step_keep_the_sources_indices() -> None:
    sink = Recorder()
    summary = run_fake(ArraySource(FRAMES, selection=Selection(2, 3)), Pipeline(1), sink)
    assert sink.indices == [2, 5, 8]
    assert (summary.first_index, summary.last_index, summary.frames) == (2, 8, 3)


@pytest.mark.parametrize("delay", [0, 4])
def test_a_source_that_breaks_keeps_what_was_before(tmp_path: Path, delay: int) -> None:
    write_images(tmp_path, FRAMES)
    cut_short(tmp_path / "in000007.png", 0.5)
    sink = Recorder()
    summary = run_fake(open_source(tmp_path), Pipeline(delay), sink)
    assert sink.indices == list(range(6))
    assert sink.finished
    assert not summary.complete
    assert isinstance(summary.error, InputError)
    with pytest.raises(InputError, match=r"in000007\.png"):
        summary.raise_error()


def test_a_pipeline_that_fails_keeps_what_was_before() -> None:
    sink = Recorder()
    summary = run_fake(ArraySource(FRAMES), Pipeline(2, fails_at=5), sink)
    assert sink.indices == [0, 1, 2, 3, 4]
    assert sink.finished
    assert str(summary.error) == "index 5 is refused"


@pytest.mark.parametrize("delay", [0, 2])
@pytest.mark.parametrize("breaks", ["source", "pipeline", "nothing"])
def test_without_a_first_result_no_sink_is_entered(breaks: str, delay: int) -> None:
    first = {"source": FRAMES[0][:, :0], "pipeline": FRAMES[0]}
    frames = [first[breaks], *FRAMES] if breaks in first else FRAMES
    pipeline = Pipeline(delay, fails_at=0 if breaks == "pipeline" else None)
    sink, begun = Recorder(), []
    summary = run(ArraySource(frames), pipeline, [sink], begin=lambda: begun.append(sink.entered))  # type: ignore[arg-type,list-item]
    if breaks == "nothing":
        assert begun == [False]  # once, and before the sinks
        assert summary.complete and summary.begun and sink.finished
        return
    assert begun == []
    assert not (summary.begun or sink.entered or sink.finished)
    assert isinstance(summary.error, InputError if breaks == "source" else ValueError)


def test_a_place_that_cannot_be_made_ends_the_run_before_its_sinks() -> None:
    def begin() -> None:
        raise OSError(28, "No space left on device", "place")

    sink = Recorder()
    summary = run(ArraySource(FRAMES), Pipeline(), [sink], begin=begin)  # type: ignore[arg-type,list-item]
    assert isinstance(summary.error, OSError)
    assert not (summary.begun or sink.entered)


def test_a_source_that_breaks_while_results_are_late_keeps_what_was_before() -> None:
    sink = Recorder()
    frames = [*FRAMES[:2], FRAMES[2][:9]]
    summary = run_fake(ArraySource(frames), Pipeline(75), sink)
    assert sink.indices == [0, 1]
    assert summary.begun and sink.finished and not summary.complete


def test_ctrl_c_keeps_what_was_before() -> None:
    def frames() -> Any:
        yield from FRAMES[:4]
        raise KeyboardInterrupt

    sink = Recorder()
    summary = run_fake(ArraySource(frames()), Pipeline(3), sink)
    assert sink.indices == [0, 1, 2, 3]
    assert sink.finished
    assert isinstance(summary.error, KeyboardInterrupt)


@pytest.mark.parametrize("delay", [0, 3])
def test_of_too_few_results_none_is_written(delay: int) -> None:
    for least, written in ((10, 10), (11, 0)):
        sink = Recorder()
        summary = run(  # type: ignore[call-overload,arg-type]
            ArraySource(FRAMES),
            Pipeline(delay),  # type: ignore[arg-type]
            [sink],  # type: ignore[list-item]
            least=least,
        )
        assert (len(sink.indices), summary.frames, summary.held) == (written, written, 10 - written)
        assert summary.begun == sink.entered == (written > 0)


def test_of_too_few_results_those_before_an_interruption_are_written() -> None:
    def frames() -> Any:
        yield from FRAMES[:4]
        raise KeyboardInterrupt

    sink = Recorder()
    summary = run(ArraySource(frames()), Pipeline(), [sink], least=9)  # type: ignore[arg-type,list-item]
    assert sink.indices == [0, 1, 2, 3] and summary.held == 0 and sink.finished


def test_a_sink_that_fails_ends_the_run_and_all_others_are_finished() -> None:
    before, failing, after = Recorder(), Recorder(fails_at=4), Recorder()
    summary = run_fake(ArraySource(FRAMES), Pipeline(), before, failing, after)
    assert (before.indices, after.indices) == ([0, 1, 2, 3, 4], [0, 1, 2, 3])
    assert before.finished and failing.finished and after.finished
    assert (summary.frames, summary.last_index) == (4, 3)
    assert isinstance(summary.error, OSError)


def test_a_sink_that_fails_at_its_end_is_told_and_all_others_are_finished() -> None:
    before, failing, after = Recorder(), Recorder(fails_at_end=True), Recorder()
    summary = run_fake(ArraySource(FRAMES), Pipeline(), before, failing, after)
    assert before.finished and after.finished
    assert summary.frames == 10
    assert not summary.complete


def test_a_pipeline_that_cannot_finish_does_not_hide_why() -> None:
    class Broken(Pipeline):
        def finish(self) -> list[Result]:
            raise ValueError("a consequence")

    sink = Recorder()
    summary = run_fake(ArraySource(FRAMES), Broken(fails_at=4), sink)
    assert sink.indices == [0, 1, 2, 3] and sink.finished
    assert summary.error is not None and "consequence" not in str(summary.error)


def test_the_first_of_several_errors_is_the_one_told() -> None:
    sinks = Recorder(fails_at_end=True), Recorder(fails_at_end=True)
    summary = run_fake(ArraySource([*FRAMES[:2], FRAMES[2][:9]]), Pipeline(), *sinks)
    assert all(sink.finished for sink in sinks)
    assert isinstance(summary.error, InputError)


def test_an_endless_source_cannot_wait_for_later_frames() -> None:
    source = ArraySource(FRAMES, name="rtsp://camera")
    source.endless = True
    with pytest.raises(UsageError, match=r"rtsp://camera: is a live stream.*3 frames late"):
        run_fake(source, Pipeline(3))
    assert run_fake(source, Pipeline()).complete


def test_results_come_before_what_the_source_raises() -> None:
    frames = [*FRAMES[:3], np.zeros((2, 2), np.uint8)]
    seen = []
    with pytest.raises(InputError, match="frame 3"):
        for result in results(ArraySource(frames), Pipeline(2)):  # type: ignore[arg-type]
            seen.append(result.index)
    assert seen == [0, 1, 2]
