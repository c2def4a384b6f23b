# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How long optical flow takes: one thread, two grey frames in memory, contenders in turn.

Processor time, not the clock's: a busy machine lengthens long calls more often than short ones.
"""

import os
from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import thread_time
from typing import Any

import cv2
import numpy as np
from frames import Frame, Size, frames_of
from peers import Peers

import survtrack
from survtrack.evaluation import flow_error, read_flo

SMALL: Size = (320, 240)
LARGE: Size = (1920, 1080)
SMOOTHNESS = 0.5
FRAMES_BACK = 10
OURS = "survtrack"
NUMPY = "numpy + cv2.filter2D"
PYOPTFLOW = "pyoptflow"
# A call of each takes about as long as those of the others: pixels x sweeps.
WORK = {OURS: 1e8, NUMPY: 1e7, PYOPTFLOW: 0}

MEAN = np.array([[1, 2, 1], [2, 0, 2], [1, 2, 1]], np.float32) / 12
ACROSS = np.array([[-1, 1], [-1, 1]], np.float32) / 4
CUBE = np.full((2, 2), 0.25, np.float32)

Contender = Callable[[Frame, Frame, int], object]


def numpy_flow(previous: Frame, current: Frame, sweeps: int) -> tuple[np.ndarray, np.ndarray]:
    """The same equations, float32, as one writes them with numpy."""

    def filtered(values: np.ndarray, kernel: np.ndarray, anchor: tuple[int, int]) -> np.ndarray:
        return cv2.filter2D(values, -1, kernel, anchor=anchor, borderType=cv2.BORDER_REPLICATE)

    before, now = (frame.astype(np.float32) / np.float32(255) for frame in (previous, current))
    ix = filtered(before + now, ACROSS, (0, 0))
    iy = filtered(before + now, np.ascontiguousarray(ACROSS.T), (0, 0))
    it = filtered(now - before, CUBE, (0, 0))
    scale = 1 / (np.float32(SMOOTHNESS**2) + ix * ix + iy * iy)
    u, v = np.zeros_like(ix), np.zeros_like(ix)
    for _ in range(sweeps):
        mean_u, mean_v = filtered(u, MEAN, (1, 1)), filtered(v, MEAN, (1, 1))
        error = (ix * mean_u + iy * mean_v + it) * scale
        u, v = mean_u - ix * error, mean_v - iy * error
    return u, v


def our_flow(previous: Frame, current: Frame, sweeps: int) -> tuple[np.ndarray, np.ndarray]:
    return survtrack.horn_schunck(previous, current, smoothness=SMOOTHNESS, sweeps=sweeps)


def seconds_of(
    contender: Contender, previous: Frame, current: Frame, sweeps: int, work: float
) -> float:
    """The mean time of as many calls as make up so much work, at least one."""
    calls = max(1, int(work / (previous.size * sweeps)))
    began = thread_time()
    for _ in range(calls):
        contender(previous, current, sweeps)
    return (thread_time() - began) / calls


def measure_speed(peers: Peers, video: str, rounds: int) -> list[dict[str, Any]]:
    """A row a size, number of sweeps and contender: median times, and their ratios to ours."""
    cv2.setNumThreads(1)
    cases = [(size, sweeps) for sweeps in (10, 100) for size in (SMALL, LARGE)]
    frames = {}
    for size in (SMALL, LARGE):
        film = list(frames_of(video, size, FRAMES_BACK + 1))
        frames[size] = [cv2.cvtColor(film[k], cv2.COLOR_BGR2GRAY) for k in (0, FRAMES_BACK)]
    for size, sweeps in cases:
        away = np.subtract(our_flow(*frames[size], sweeps), numpy_flow(*frames[size], sweeps))
        assert np.abs(away).max() < 1e-3, "the contenders do not compute the same"

    def theirs(size: Size, sweeps: int) -> float:
        request = {"do": "flow", "video": video, "size": size, "count": FRAMES_BACK + 1}
        return float(peers.ask(**request, smoothness=SMOOTHNESS, sweeps=sweeps)["seconds"])

    taken: dict[tuple[Size, int, str], list[float]] = {}
    for done in range(rounds + 1):
        for size, sweeps in cases:
            took = {
                OURS: seconds_of(our_flow, *frames[size], sweeps, WORK[OURS]),
                NUMPY: seconds_of(numpy_flow, *frames[size], sweeps, WORK[NUMPY]),
            }
            if size == SMALL:
                took[PYOPTFLOW] = theirs(size, sweeps)
            for name, seconds in took.items():
                if done > 0:  # the first round warms up
                    taken.setdefault((size, sweeps, name), []).append(seconds)
    rows = []
    for (size, sweeps, name), seconds in taken.items():
        work = size[0] * size[1] * sweeps
        small = median(taken[SMALL, sweeps, name]) / (SMALL[0] * SMALL[1] * sweeps)
        rows.append(
            {
                "size": f"{size[0]}x{size[1]}",
                "sweeps": sweeps,
                "what": name,
                "ms": 1000 * median(seconds),
                "ns_per_pixel_and_sweep": 1e9 * median(seconds) / work,
                "ns_fastest_round": 1e9 * min(seconds) / work,
                "ratio_to_320x240": median(seconds) / work / small,
                "ratio_to_ours": median(seconds) / median(taken[size, sweeps, OURS]),
            }
        )
    return rows


def measure_accuracy() -> tuple[list[dict[str, Any]], list[str]]:
    """A row a Middlebury pair: mean endpoint error in px; and the pairs that are missing."""
    data = Path(os.environ.get("SURVTRACK_DATA", "SURVTRACK_DATA-is-not-set"))
    rows, missing = [], []
    for name in ("Dimetrodon", "Grove2", "RubberWhale", "Venus"):
        folder = data / "flow" / name
        if not (folder / "flow10.flo").exists():
            missing.append(f"flow/{name}")
            continue
        frames = [cv2.imread(str(folder / f"frame{k}.png")) for k in (10, 11)]
        truth = read_flo(folder / "flow10.flo")
        nothing = np.zeros_like(truth[0])
        began = thread_time()
        pyramid = survtrack.horn_schunck(*frames, levels=5)
        took = thread_time() - began
        rows.append(
            {
                "pair": name,
                "zero_flow_px": flow_error((nothing, nothing), truth).endpoint_px,
                "one_level_px": flow_error(survtrack.horn_schunck(*frames), truth).endpoint_px,
                "five_levels_px": flow_error(pyramid, truth).endpoint_px,
                "five_levels_deg": flow_error(pyramid, truth).angular_deg,
                "five_levels_ms": 1000 * took,
            }
        )
    return rows, missing
