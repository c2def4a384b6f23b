# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Decoding ahead in a thread of its own."""

from collections.abc import Generator, Iterator
from queue import Empty, Full, Queue
from threading import Event, Thread
from types import TracebackType

from survtrack.errors import UsageError
from survtrack.sources.arrays import ArraySource
from survtrack.sources.base import Frame, Size, Source
from survtrack.sources.selection import Selection

Item = tuple[int, float, Frame]

# How often each side looks whether the other still wants to go on.
POLL_S = 0.1
# Longest wait for the thread to end: a live stream can be stuck in the network.
JOIN_S = 5.0


class _End:
    """Last entry of the queue: the source ended, by `error` when there is one."""

    def __init__(self, error: BaseException | None) -> None:
        self.error = error


class Prefetch:
    """A source whose frames are decoded while the consumer works on the ones before.

    Use it as a context manager, or close() it: then its thread ends, wherever the consumer
    stopped. What the wrapped source raises is raised in the consumer, after the frames before it.
    """

    def __init__(self, source: Source, *, depth: int = 4) -> None:
        """Args:
        source: any source but an ArraySource, whose arrays may be refilled by their maker.
        depth: most frames that wait; 1 or more.
        """
        if depth < 1:
            raise UsageError(f"depth: {depth} is not allowed; 1 or more")
        if isinstance(source, ArraySource):
            raise UsageError("an ArraySource cannot be read ahead: its arrays may be refilled")
        self._source = source
        self._depth = depth
        self._interrupted = Event()
        self._running: list[tuple[Thread, Event, Queue[Item | _End]]] = []

    def __enter__(self) -> "Prefetch":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def __iter__(self) -> Iterator[Item]:
        """Raises KeyboardInterrupt after interrupt()."""
        queue: Queue[Item | _End] = Queue(self._depth)
        cancelled = Event()
        thread = Thread(
            target=_fill, args=(self._source, queue, cancelled), name="decode", daemon=True
        )
        self._running.append((thread, cancelled, queue))
        thread.start()
        try:
            while not isinstance(item := self._next(queue), _End):
                yield item
            if item.error is not None:
                raise item.error
        finally:
            self.close()

    def interrupt(self) -> None:
        """Make the iteration raise KeyboardInterrupt at the next frame; safe in a signal handler.

        Unlike a bare KeyboardInterrupt it comes between two frames, never amid one.
        """
        self._interrupted.set()

    def close(self) -> None:
        """End the decoding thread and drop the frames that wait."""
        while self._running:
            thread, cancelled, queue = self._running.pop()
            cancelled.set()
            while not queue.empty():
                queue.get_nowait()
            thread.join(JOIN_S)

    def _next(self, queue: "Queue[Item | _End]") -> Item | _End:
        while True:
            if self._interrupted.is_set():
                raise KeyboardInterrupt
            try:
                return queue.get(timeout=POLL_S)
            except Empty:
                continue

    @property
    def name(self) -> str:
        """As the wrapped source."""
        return self._source.name

    @property
    def size(self) -> Size | None:
        """As the wrapped source."""
        return self._source.size

    @property
    def original_size(self) -> Size | None:
        """Of the source's."""
        return self._source.original_size

    @property
    def fps(self) -> float:
        """As the wrapped source."""
        return self._source.fps

    @property
    def fps_origin(self) -> str:
        """As the wrapped source."""
        return self._source.fps_origin

    @property
    def frame_count_declared(self) -> int | None:
        """As the wrapped source."""
        return self._source.frame_count_declared

    @property
    def endless(self) -> bool:
        """As the wrapped source."""
        return self._source.endless

    @property
    def selection(self) -> Selection:
        """As the wrapped source."""
        return self._source.selection

    def file_name(self, index: int) -> str | None:
        """As the wrapped source."""
        return self._source.file_name(index)


def _fill(source: Source, queue: "Queue[Item | _End]", cancelled: Event) -> None:
    """The thread: put frames, then how it ended, until cancelled."""
    end = _End(None)
    frames = iter(source)
    try:
        for item in frames:
            if not _put(queue, item, cancelled):
                break
    except BaseException as error:
        end = _End(error)
    finally:
        if isinstance(frames, Generator):
            frames.close()
        _put(queue, end, cancelled)


def _put(queue: "Queue[Item | _End]", item: Item | _End, cancelled: Event) -> bool:
    """Wait for room; False when cancelled meanwhile."""
    while not cancelled.is_set():
        try:
            queue.put(item, timeout=POLL_S)
        except Full:
            continue
        return True
    return False
