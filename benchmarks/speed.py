# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How long a frame takes: one thread, decoded frames in memory, contenders in turn."""

from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import Any

import cv2
from frames import Frame, Size, frames_of
from peers import Peers

import survtrack

SIZES: list[Size] = [(320, 240), (768, 576)]
FPS = 7
UNIT = "MOG2 (cv2)"  # what the others are compared to

Contender = Callable[[list[Frame]], float]


def pipeline(frames: list[Frame]) -> float:
    ours = survtrack.Pipeline()
    began = perf_counter()
    for index, frame in enumerate(frames):
        _ = ours.process(frame, index / FPS).track_array
    return perf_counter() - began


def segmentation(frames: list[Frame]) -> float:
    ours = survtrack.Segmenter()
    began = perf_counter()
    for index, frame in enumerate(frames):
        ours.segment(frame, index / FPS)
    return perf_counter() - began


def mog2(frames: list[Frame]) -> float:
    model = cv2.createBackgroundSubtractorMOG2()
    began = perf_counter()
    for frame in frames:
        model.apply(frame)
    return perf_counter() - began


def measure(peers: Peers, video: str, count: int, rounds: int) -> list[dict[str, Any]]:
    """A row a size and contender: median milliseconds a frame, and their ratio to MOG2's."""
    cv2.setNumThreads(1)
    rows = []
    for size in SIZES:
        frames = list(frames_of(video, size, count))
        request = {"do": "time", "model": "mog2", "video": video, "size": size, "count": count}
        contenders: dict[str, Contender] = {
            "survtrack, whole pipeline": pipeline,
            "survtrack, segmentation": segmentation,
            UNIT: mog2,
            "MOG2 + components + SORT": lambda _, ask=request: float(
                peers.ask(**ask, fps=FPS)["seconds"]
            ),
        }
        seconds: dict[str, list[float]] = {name: [] for name in contenders}
        for done in range(rounds + 1):
            for name, contender in contenders.items():
                took = contender(frames)
                if done > 0:  # the first round warms up
                    seconds[name].append(took)
        unit = median(seconds[UNIT])
        for name, taken in seconds.items():
            rows.append(
                {
                    "size": f"{size[0]}x{size[1]}",
                    "what": name,
                    "ms_per_frame": 1000 * median(taken) / count,
                    "ms_fastest_round": 1000 * min(taken) / count,
                    "ratio_to_mog2": median(taken) / unit,
                }
            )
    return rows
