# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One run: frames of one format, times and indices that increase; an error changes nothing."""

import math
from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import PRESETS, answer, run, scene
from survtrack import Detector, InputError, Pipeline, Segmenter

FRAMES = scene()
FRAME = FRAMES[0]

BAD_CALLS: dict[str, tuple[tuple[Any, ...], str]] = {
    "smaller": ((FRAME[:-1], 9.0), "frame: is 63x96x3 uint8, the frames before were 64x96x3"),
    "turned": ((FRAME.transpose(1, 0, 2), 9.0), "frame: is 96x64x3 .* were 64x96x3"),
    "grey": ((FRAME[..., 0], 9.0), "frame: is 64x96 uint8, the frames before were 64x96x3"),
    "BGRA": ((np.zeros((64, 96, 4), np.uint8), 9.0), r"frame: is \(64, 96, 4\) uint8"),
    "16 bit": ((FRAME.astype(np.uint16), 9.0), r"frame: is \(64, 96, 3\) uint16"),
    "no frame": ((None, 9.0), "frame: is NoneType"),
    "same time": ((FRAME, 1.5), "time_s: 1.5 does not come after 1.5"),
    "earlier": ((FRAME, -3.0), "time_s: -3 does not come after 1.5"),
    "NaN": ((FRAME, math.nan), "time_s: is nan; expected a finite number of seconds"),
    "infinite": ((FRAME, math.inf), "time_s: is inf; expected a finite number"),
    "minus infinite": ((FRAME, -math.inf), "time_s: is -inf; expected a finite number"),
    "far future": ((FRAME, 2e12), r"time_s: .*within \+-1e12"),
}
BAD_INDICES: dict[str, tuple[tuple[Any, ...], str]] = {
    "same index": ((FRAME, 9.0, 15), "index: 15 does not come after 15"),
    "lower index": ((FRAME, 9.0, 3), "index: 3 does not come after 15"),
    "negative index": ((FRAME, 9.0, -1), "index: -1 "),
    "overflow": ((FRAME, 9.0, 2**63 - 1), f"index: {2**63 - 1} is not allowed"),
}
ALL_BAD = BAD_CALLS | BAD_INDICES


@pytest.mark.parametrize(("arguments", "message"), ALL_BAD.values(), ids=ALL_BAD)
@pytest.mark.parametrize("preset", PRESETS)
def test_an_error_keeps_the_state(arguments: tuple[Any, ...], message: str, preset: str) -> None:
    pipeline = Pipeline.from_preset(preset)
    results = []
    for index, frame in enumerate(FRAMES):
        results.append(pipeline.process(frame, index / 10))
        if index == 15:
            with pytest.raises(InputError, match=f"^{message}"):
                pipeline.process(*arguments)
    results = [result for result in results if result is not None] + pipeline.finish()
    assert answer(results) == answer(run(Pipeline.from_preset(preset), FRAMES))


@pytest.mark.parametrize(("arguments", "message"), ALL_BAD.values(), ids=ALL_BAD)
def test_a_detector_has_the_same_rules(arguments: tuple[Any, ...], message: str) -> None:
    detector, undisturbed = Detector(), Detector()
    for index, frame in enumerate(FRAMES):
        detections = detector.process(frame, index / 10)
        assert detections.array.tolist() == undisturbed.process(frame, index / 10).array.tolist()
        if index == 15:
            with pytest.raises(InputError, match=f"^{message}"):
                detector.process(*arguments)


@pytest.mark.parametrize(("arguments", "message"), BAD_CALLS.values(), ids=BAD_CALLS)
def test_a_segmenter_has_the_same_rules(arguments: tuple[Any, ...], message: str) -> None:
    segmenter, undisturbed = Segmenter(), Segmenter()
    for index, frame in enumerate(FRAMES):
        mask = segmenter.segment(frame, index / 10)
        assert np.array_equal(mask, undisturbed.segment(frame, index / 10))
        if index == 15:
            with pytest.raises(InputError, match=f"^{message}"):
                segmenter.segment(*arguments)


@pytest.mark.parametrize("arguments", [(FRAME, None), (FRAME, "0"), (FRAME, 0.0, 1.5), (FRAME,)])
def test_what_is_no_number_is_a_type_error(arguments: Any) -> None:
    with pytest.raises(TypeError, match="time_s"):
        Pipeline().process(*arguments)


@pytest.mark.parametrize("index", [-1, -(2**63), 2**63 - 1])
def test_an_index_is_refused_on_the_first_frame_too(index: int) -> None:
    with pytest.raises(InputError, match=f"^index: {index} is not allowed; expected"):
        Pipeline().process(FRAME, 0.0, index)


def test_numpy_numbers_are_times_and_indices() -> None:
    result = Pipeline().process(FRAME, np.float32(0.5), np.int64(7))
    assert (result.time_s, result.index) == (0.5, 7)


def test_indices_count_on_from_the_last() -> None:
    pipeline = Pipeline()
    given = [None, None, 7, None, 1000, None]
    indices = [pipeline.process(FRAME, k, index).index for k, index in enumerate(given)]
    assert indices == [0, 1, 7, 8, 1000, 1001]


def test_times_may_be_negative_and_far_apart() -> None:
    pipeline = Pipeline()
    for time_s in (-1e12, -3.0, 0.0, 1e-9, 1e12):
        result = pipeline.process(FRAME, time_s)
        assert result.time_s == time_s
        assert np.isfinite(result.track_array["position_x"]).all()


@pytest.mark.parametrize("preset", PRESETS)
def test_reset_starts_anew(preset: str) -> None:
    pipeline = Pipeline.from_preset(preset)
    first = answer(run(pipeline, FRAMES))
    pipeline.reset()
    assert answer(run(pipeline, FRAMES)) == first
    pipeline.reset()
    grey = [frame[:50, :, 0] for frame in FRAMES]
    assert answer(run(pipeline, grey)) == answer(run(Pipeline.from_preset(preset), grey))


def test_reset_before_the_end_drops_what_waits() -> None:
    pipeline = Pipeline.from_preset("narayana2007")
    for index, frame in enumerate(FRAMES):
        assert pipeline.process(frame, index / 10) is None
    pipeline.reset()
    assert pipeline.finish() == []


def test_after_finish_only_reset_is_allowed() -> None:
    for stage in (Pipeline(), Detector()):
        stage.process(FRAME, 0.0)
        assert stage.finish() == []
        with pytest.raises(InputError, match=r"came after finish\(\); reset\(\) starts another"):
            stage.process(FRAME, 1.0)
        assert stage.finish() == []
        stage.reset()
        assert stage.process(FRAME, 0.0).index == 0


def test_nothing_comes_of_nothing() -> None:
    for preset in PRESETS:
        assert Pipeline.from_preset(preset).finish() == []


def test_a_delayed_pipeline_answers_75_frames_late() -> None:
    pipeline = Pipeline.from_preset("narayana2007")
    assert (pipeline.delay_frames, Pipeline().delay_frames) == (75, 0)
    frames = [FRAMES[k % len(FRAMES)].copy() for k in range(100)]
    given = [pipeline.process(frame, k * 0.04, 2 * k) for k, frame in enumerate(frames)]
    assert [result is None for result in given] == 75 * [True] + 25 * [False]
    originals = [frame.copy() for frame in frames]
    for frame in frames:
        frame[:] = 0  # a delayed pipeline has copies of its own
    results = given[75:] + pipeline.finish()
    assert [result.index for result in results] == list(range(0, 200, 2))
    assert [result.time_s for result in results] == [k * 0.04 for k in range(100)]
    for result, original in zip(results, originals, strict=True):
        assert np.array_equal(result.frame, original)


@pytest.mark.parametrize("window_frames", [1, 2, 5, 10])
def test_the_delay_is_half_the_window(window_frames: int) -> None:
    config = survtrack.preset("narayana2007")
    config.set(f"segmenter.window_frames={window_frames}")
    assert Pipeline(config).delay_frames == Detector(config).delay_frames == window_frames // 2
    config.set("segmenter.window=causal")
    assert Pipeline(config).delay_frames == 0
