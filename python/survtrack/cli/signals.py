# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C and termination that let a run finish its files."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM)


@contextmanager
def interrupted_by_signal(interrupt: Callable[[], None]) -> Iterator[list[int]]:
    """Call `interrupt` on the first SIGINT or SIGTERM; raise KeyboardInterrupt on the next.

    Yields the list of signals that came. Python handles signals in its main thread only; in
    another one nothing is changed.
    """
    came: list[int] = []

    def handle(number: int, frame: FrameType | None) -> None:
        came.append(number)
        if len(came) > 1:
            raise KeyboardInterrupt
        interrupt()

    if threading.current_thread() is not threading.main_thread():
        yield came
        return
    earlier = {number: signal.signal(number, handle) for number in SIGNALS}
    try:
        yield came
    finally:
        for number, handler in earlier.items():
            signal.signal(number, handler)
