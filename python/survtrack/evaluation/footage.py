# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Which frames of the footage are scored."""

import json
from pathlib import Path
from typing import Any

from survtrack.errors import InputError, UsageError
from survtrack.evaluation.boxes import MAX_INTEGER
from survtrack.evaluation.files import read_bytes

RUN_FILE = "run.json"


def given_range(frames: tuple[int, int], lowest: int) -> range:
    """The frames a to b, both counted, or a UsageError when they are no such thing."""
    first, last = frames
    if not lowest <= first <= last <= MAX_INTEGER:
        raise UsageError(
            f"frames {first}-{last}: the first must be at least {lowest} and not above the last"
        )
    return range(first, last + 1)


def processed_frames(run_file: Path) -> range:
    """The frames that a run says it has processed, counted from 1 as in its tracks.

    Reads `"frames": {"first": F, "last": L, "step": S, "count": N}` of its `run.json`.

    Raises:
        InputError: the file is not a run's, contradicts itself, or lists no frame.
    """
    advice = "name the frames to score (--frames A-B)"
    try:
        entry: Any = json.loads(read_bytes(run_file))["frames"]
        values = [entry[key] for key in ("first", "last", "step", "count")]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(
            f'{run_file}: no "frames" with first, last, step and count; {advice}'
        ) from error
    if values[3] == 0:
        raise InputError(f"{run_file}: the run has processed no frame; {advice}")
    whole = all(type(value) is int and 1 <= value <= MAX_INTEGER for value in values)
    if whole:
        first, last, step, count = values
        if first + (count - 1) * step == last:
            return range(first, last + 1, step)
    raise InputError(
        f"{run_file}: frames {json.dumps(entry)} contradict themselves (whole numbers from 1 with "
        f"last = first + (count - 1) * step expected); {advice}"
    )
