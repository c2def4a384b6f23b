# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How far a run is: a bar on a terminal, a line now and then elsewhere."""

import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from time import monotonic

LINE_EVERY_S = 10.0


def show_progress(
    total: int | None, *, quiet: bool
) -> AbstractContextManager[Callable[[int], None] | None]:
    """Context manager that gives what a run calls with its number of frames so far.

    All goes to stderr. On a terminal it is a bar that goes away at the end.

    Args:
        total: frames to come; None when nobody knows.
        quiet: show nothing.
    """
    if quiet:
        return nullcontext()
    return _bar(total) if sys.stderr.isatty() else _lines(total)


@contextmanager
def _bar(total: int | None) -> Iterator[Callable[[int], None]]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
    from rich.progress import TimeRemainingColumn as TimeLeft

    began = monotonic()
    columns = (
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("frames  {task.fields[rate]:.1f} frames/s "),
        TimeLeft(),
        TextColumn("left"),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=total, rate=0.0)

        def update(frames: int) -> None:
            rate = frames / max(monotonic() - began, 1e-9)
            progress.update(task, completed=frames, rate=rate)

        yield update


@contextmanager
def _lines(total: int | None) -> Iterator[Callable[[int], None]]:
    began = shown = monotonic()

    def update(frames: int) -> None:
        nonlocal shown
        now = monotonic()
        if now - shown >= LINE_EVERY_S:
            shown = now
            print(progress_line(frames, total, now - began), file=sys.stderr, flush=True)

    yield update


def progress_line(frames: int, total: int | None, seconds: float) -> str:
    """Words for so many frames in so many seconds: "survtrack: 120 of 795 frames, ..."."""
    rate = frames / seconds
    text = f"survtrack: {frames}{f' of {total}' if total else ''} frames, {rate:.1f} frames/s"
    if total and total > frames:
        text += f", {(total - frames) / rate:.0f} s left"
    return text
