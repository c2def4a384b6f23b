# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Threads: pipelines do not meet, one pipeline takes calls in turn, others run meanwhile."""

import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import survtrack
from scenes import answer, run, scene
from survtrack import InputError, Pipeline


@pytest.mark.parametrize(
    "model", [survtrack.SelectiveOptions, survtrack.Mog2Options, survtrack.KnnOptions]
)
def test_pipelines_in_threads_answer_as_alone(model: type) -> None:
    config = survtrack.Config(segmenter=model())
    footage = [scene(50), [frame[:, ::-1] for frame in scene(50)], scene(50)[::-1]]
    alone = [answer(run(Pipeline(config), frames)) for frames in footage]
    start = threading.Barrier(len(footage))

    def work(frames: list[np.ndarray]) -> list[tuple[object, ...]]:
        pipeline = Pipeline(config)
        start.wait()
        return answer(run(pipeline, frames))

    with ThreadPoolExecutor(len(footage)) as pool:
        assert list(pool.map(work, footage)) == alone


def test_calls_of_many_threads_take_turns() -> None:
    pipeline, frames = Pipeline(), scene(50)
    clock, done, refused = iter(range(10**6)), [], []

    def work(seed: int) -> None:
        for k in range(60):
            try:
                done.append(pipeline.process(frames[(seed + k) % 50], next(clock) / 10).index)
            except InputError as error:  # another thread's later frame came first
                refused.append(str(error))
            if seed == 0 and k == 30:
                pipeline.reset()

    with ThreadPoolExecutor(6) as pool:
        list(pool.map(work, range(6)))
    assert len(done) + len(refused) == 360
    assert all("does not come after" in text for text in refused)
    pipeline.reset()
    assert answer(run(pipeline, frames)) == answer(run(Pipeline(), frames))


def test_other_threads_run_while_a_frame_is_processed() -> None:
    frame = np.random.default_rng(0).integers(0, 256, (1080, 1920, 3), dtype=np.uint8)
    pipeline, entered, left = Pipeline(), [], []

    def work() -> None:
        for k in range(20):
            entered.append(k)
            pipeline.process(frame, k)
            left.append(k)

    seen_inside = 0
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)  # a thread runs on until it gives the GIL up
    try:
        other = threading.Thread(target=work)
        other.start()
        while other.is_alive():
            seen_inside += len(entered) > len(left)
            time.sleep(1e-4)
    finally:
        sys.setswitchinterval(interval)
    assert len(left) == 20
    assert seen_inside > 0
