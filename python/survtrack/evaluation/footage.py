# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Which frames of the footage are scored, and at which size they were processed."""

import json
import math
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


def given_scale(scale: tuple[float, float]) -> tuple[float, float]:
    """The two scales, or a UsageError when they are not both finite and above 0."""
    if not all(math.isfinite(part) and part > 0 for part in scale):
        raise UsageError(f"scale {scale[0]:g}x{scale[1]:g}: both must be finite and above 0")
    return scale


def frame_scale(run_file: Path) -> tuple[float, float]:
    """How much a run has scaled its frames (--resize), across and down; (1, 1) when it is not told.

    Raises:
        InputError: the sizes that the file names are none.
    """
    try:
        facts: Any = json.loads(read_bytes(run_file))
        size, original = facts["size"], facts["original_size"]
    except (ValueError, KeyError, TypeError, RecursionError):
        return 1.0, 1.0
    if size is None or original is None:
        return 1.0, 1.0
    try:
        scale = float(size[0]) / float(original[0]), float(size[1]) / float(original[1])
        return given_scale(scale)
    except (ValueError, KeyError, TypeError, IndexError, ZeroDivisionError, UsageError) as error:
        raise InputError(
            f'{run_file}: "size" and "original_size" are no two sizes in pixels; give --scale'
        ) from error
