# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The usual OpenCV recipe: background subtraction, morphology, components, trackers' SORT.

Runs in the peers' own environment, which knows nothing of survtrack. Reads one request a line
from its input, a JSON object, and answers each with one:

    {"do": "versions"}
    {"do": "time", "model", "video", "size": [w, h], "count", "fps"} -> {"seconds"}, for all frames
    {"do": "track", "model", "video", "fps"} -> {"rows"}: frame from 1, id, left, top, width, height
    {"do": "flow", "video", "size", "count", "smoothness", "sweeps"} -> {"seconds"}, of the thread,
        for the flow from the first frame to the last
"""

import json
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.metadata import version
from time import perf_counter, thread_time
from typing import Any

import cv2
import numpy as np
import pyoptflow
import supervision
import trackers
from frames import Frame, frames_of

OPEN, CLOSE = np.ones((3, 3), np.uint8), np.ones((5, 5), np.uint8)
# The best on vtest.avi of 49 settings, 50 to 500 px and SORT's own: 1 to 3 frames, IoU 0.1 to 0.3.
MIN_AREA_FRACTION = 1.13e-3  # 500 px at 768x576
SORT = {"minimum_consecutive_frames": 2, "minimum_iou_threshold": 0.1}


def make_model(name: str) -> Any:
    return {
        "mog2": cv2.createBackgroundSubtractorMOG2,
        "knn": cv2.createBackgroundSubtractorKNN,
    }[name]()


def boxes(model: Any, frame: Frame) -> np.ndarray:
    """Nx4: left, top, right, bottom of what moves; shadows do not count."""
    mask = np.where(model.apply(frame) == 255, 255, 0).astype(np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, OPEN)
    mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, CLOSE)
    _, _, stats, _ = cv2.connectedComponentsWithStats(mask)
    large = stats[1:][stats[1:, 4] >= MIN_AREA_FRACTION * mask.size]
    return np.hstack([large[:, :2], large[:, :2] + large[:, 2:4]]).astype(np.float32)


def run(name: str, frames: Iterable[Frame], fps: float) -> Iterator[supervision.Detections]:
    """The confirmed tracks of every frame."""
    model, tracker = make_model(name), trackers.SORTTracker(frame_rate=fps, **SORT)
    for frame in frames:
        found = boxes(model, frame)
        tracked = tracker.update(
            supervision.Detections(
                xyxy=found, confidence=np.ones(len(found)), class_id=np.zeros(len(found), int)
            )
        )
        yield tracked[tracked.tracker_id >= 0] if len(tracked) else tracked


@cache
def in_memory(video: str, size: tuple[int, int], count: int) -> list[Frame]:
    return list(frames_of(video, size, count))


def answer(request: dict[str, Any]) -> dict[str, Any]:
    if request["do"] == "versions":
        return {"trackers": version("trackers"), "cv2": cv2.__version__}
    if request["do"] == "time":
        frames = in_memory(request["video"], tuple(request["size"]), request["count"])
        began = perf_counter()
        for _ in run(request["model"], frames, request["fps"]):
            pass
        return {"seconds": perf_counter() - began}
    if request["do"] == "flow":
        film = in_memory(request["video"], tuple(request["size"]), request["count"])
        greys = [cv2.cvtColor(film[k], cv2.COLOR_BGR2GRAY) / 255 for k in (0, -1)]
        began = thread_time()
        pyoptflow.HornSchunck(*greys, alpha=request["smoothness"], Niter=request["sweeps"])
        return {"seconds": thread_time() - began}
    rows = []
    tracked = run(request["model"], frames_of(request["video"]), request["fps"])
    for number, found in enumerate(tracked, start=1):
        for track_id, (left, top, right, bottom) in zip(
            found.tracker_id if len(found) else [], found.xyxy.tolist(), strict=True
        ):
            rows.append([number, int(track_id), left, top, right - left, bottom - top])
    return {"rows": rows}


if __name__ == "__main__":
    cv2.setNumThreads(1)
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line))), flush=True)
