# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""How right the answers are, on public footage with ground truth; the judge is survtrack's own."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from frames import Frame, frames_of
from peers import Peers

import survtrack
from survtrack.evaluation import Boxes, evaluate_masks, evaluate_tracks

RATES = [7, 10]  # frames/s of the scene, and of the file's header
SEQUENCES = ["cdnet/highway", "cdnet/pedestrians", "cdnet/canoe", "sbi/IBMtest2", "sbi/CAVIAR2"]
Row = dict[str, Any]
MaskModel = Callable[[Frame, int], Frame]


def our_tracks(video: str, fps: float) -> list[list[float]]:
    pipeline, rows = survtrack.Pipeline(), []
    for index, frame in enumerate(frames_of(video)):
        for track in pipeline.process(frame, index / fps).tracks:
            if track.reported:
                rows.append([index + 1, track.id, *track.box])
    return rows


def judge_tracks(peers: Peers, video: str, truth: Path) -> list[Row]:
    """HOTA, MOTA, IDF1 of our default preset and of the OpenCV recipes with SORT."""
    rows = []
    for fps in RATES:
        answers = {"survtrack": our_tracks(video, fps)}
        for model in ("mog2", "knn"):
            asked = peers.ask(do="track", model=model, video=video, fps=fps)
            answers[f"{model.upper()} + components + SORT"] = asked["rows"]
        for name, found in answers.items():
            table = np.array(found, dtype=float).reshape(-1, 6)
            scores = evaluate_tracks(truth, Boxes(table[:, 0], table[:, 1], table[:, 2:]))
            keys = ("HOTA", "DetA", "AssA", "MOTA", "IDF1", "switches")
            rows.append({"fps": fps, "what": name} | {key: scores.to_dict()[key] for key in keys})
    return rows


def our_masks() -> MaskModel:
    detector = survtrack.Detector()
    return lambda frame, index: detector.process(frame, index / 25).mask


def opencv_masks(model: Any) -> MaskModel:
    def apply(frame: Frame, _: int) -> Frame:
        return cv2.medianBlur(np.where(model.apply(frame) == 255, 255, 0).astype(np.uint8), 5)

    return apply


def judge_masks(sequence: Path) -> Row:
    """F of the default preset's masks and of OpenCV's models after a 5x5 median."""
    row: Row = {}
    models = {
        "survtrack": our_masks(),
        "MOG2": opencv_masks(cv2.createBackgroundSubtractorMOG2()),
        "KNN": opencv_masks(cv2.createBackgroundSubtractorKNN()),
    }
    for name, model in models.items():
        with tempfile.TemporaryDirectory() as folder:
            for index, path in enumerate(sorted((sequence / "input").iterdir())):
                mask = model(cv2.imread(str(path)), index)
                cv2.imwrite(f"{folder}/bin{path.stem[-6:]}.png", mask)
            row[name] = evaluate_masks(sequence, folder).f_measure
    return row


def measure_tracks(peers: Peers, data: Path) -> tuple[list[Row], list[str]]:
    """The rows, and what is missing."""
    video = data / "video" / "vtest.avi"
    truth = data / "mot" / "PETS09-S2L1" / "gt" / "gt.txt"
    missing = [str(path) for path in (video, truth) if not path.is_file()]
    return ([] if missing else judge_tracks(peers, str(video), truth)), missing


def measure_masks(data: Path) -> tuple[list[Row], list[str]]:
    """The rows, and what is missing."""
    rows, missing = [], []
    for name in SEQUENCES:
        if (data / name / "input").is_dir() and (data / name / "groundtruth").is_dir():
            rows.append({"sequence": name} | judge_masks(data / name))
        else:
            missing.append(str(data / name))
    return rows, missing
