# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Reading ahead: the same frames, errors in their place, and a thread that always ends."""

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from clips import walking_square, write_images
from survtrack.errors import InputError, UsageError
from survtrack.sources import ArraySource, Frame, Prefetch, Selection, open_source


class Scripted:
    """A source that counts how far it was read, may fail, and may never end."""

    name, size, fps, fps_origin = "scripted", (8, 8), 25.0, "given"
    frame_count_declared, selection = None, Selection()

    def __init__(self, count: int | None, error: BaseException | None = None) -> None:
        self.count, self.error, self.read, self.closed = count, error, 0, False
        self.endless = count is None

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
        try:
            while self.count is None or self.read < self.count:
                self.read += 1
                yield self.read - 1, self.read / 25, np.zeros((8, 8), np.uint8)
            if self.error is not None:
                raise self.error
        finally:
            self.closed = True

    def file_name(self, index: int) -> str | None:
        return f"file{index}"


def decoding_threads() -> list[threading.Thread]:
    return [thread for thread in threading.enumerate() if thread.name == "decode"]


def test_gives_what_the_source_gives(tmp_path: Path) -> None:
    source = open_source(write_images(tmp_path, walking_square(30)), step=2)
    plain = list(source)
    with Prefetch(source, depth=3) as ahead:
        read = list(ahead)
        assert (ahead.name, ahead.size, ahead.fps) == (source.name, source.size, source.fps)
        assert ahead.fps_origin == source.fps_origin
        assert ahead.frame_count_declared == 30
        assert (ahead.selection, ahead.endless) == (source.selection, False)
        assert ahead.file_name(4) == "in000005.png"
    assert [item[:2] for item in read] == [item[:2] for item in plain]
    assert all(np.array_equal(a[2], b[2]) for a, b in zip(read, plain, strict=True))
    assert not decoding_threads()


def test_reads_ahead_but_no_further_than_its_depth() -> None:
    source = Scripted(None)
    with Prefetch(source, depth=4) as ahead:
        frames = iter(ahead)
        next(frames)
        deadline = time.monotonic() + 5
        while source.read < 6 and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.05)
        # One taken, four waiting, one in hand.
        assert source.read == 6
    assert not decoding_threads()


def test_an_error_comes_after_the_frames_before_it() -> None:
    seen = []
    with pytest.raises(InputError, match="frame 6 is broken"):
        for index, _, _ in Prefetch(Scripted(5, InputError("frame 6 is broken"))):
            seen.append(index)
    assert seen == [0, 1, 2, 3, 4]
    assert not decoding_threads()


def test_the_thread_ends_when_the_consumer_stops() -> None:
    source = Scripted(None)
    with Prefetch(source, depth=2) as ahead:
        for index, _, _ in ahead:
            if index == 3:
                break
    assert source.closed
    assert not decoding_threads()


def test_the_thread_ends_when_the_consumer_fails() -> None:
    source = Scripted(None)
    with pytest.raises(ZeroDivisionError), Prefetch(source) as ahead:
        for _ in ahead:
            raise ZeroDivisionError
    assert source.closed
    assert not decoding_threads()


def test_interrupt_comes_between_two_frames() -> None:
    seen = []
    with pytest.raises(KeyboardInterrupt), Prefetch(Scripted(None)) as ahead:
        for index, _, _ in ahead:
            seen.append(index)
            if index == 2:
                ahead.interrupt()
    assert seen == [0, 1, 2]
    assert not decoding_threads()


def test_interrupt_does_not_wait_for_a_source_that_is_stuck() -> None:
    released = threading.Event()

    class Stuck(Scripted):
        def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
            released.wait(30)
            yield from super().__iter__()

    ahead = Prefetch(Stuck(1))
    threading.Timer(0.2, ahead.interrupt).start()
    threading.Timer(0.4, released.set).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        list(ahead)
    assert time.monotonic() - began < 10
    assert not decoding_threads()


def test_refuses_arrays_and_no_depth() -> None:
    with pytest.raises(UsageError, match="cannot be read ahead"):
        Prefetch(ArraySource([]))
    with pytest.raises(UsageError, match="depth: 0 is not allowed"):
        Prefetch(Scripted(1), depth=0)
