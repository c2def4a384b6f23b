# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Figures on public footage, judged against its ground truth. The README prints them."""

from collections.abc import Iterator
from pathlib import Path

import cv2
import pytest

import survtrack
from clips import Image
from survtrack.evaluation import Boxes, MaskScores, TrackScores, evaluate_masks, evaluate_tracks


def frames_of(video: Path) -> Iterator[Image]:
    capture = cv2.VideoCapture(str(video))
    while (read := capture.read())[0]:
        yield read[1]


def scores_of_default_preset(data: Path, fps: float) -> TrackScores:
    return scores_of(data, fps, survtrack.Config())[0]


def scores_of(data: Path, fps: float, config: survtrack.Config) -> tuple[TrackScores, float]:
    """Of vtest.avi, and the part of its pixels that was read.

    It is MOT15's PETS09-S2L1: frame k from 0 is frame k + 1 there.
    """
    pipeline, reported, read = survtrack.Pipeline(config), [], 0
    for index, frame in enumerate(frames_of(data / "video" / "vtest.avi")):
        result = pipeline.process(frame, index / fps)
        read += result.pixels_read
        reported += [(index + 1, track) for track in result.tracks if track.reported]
    assert index == 794
    tracks = Boxes(
        [frame for frame, _ in reported],
        [track.id for _, track in reported],
        [list(track.box) for _, track in reported],
    )
    truth = data / "mot" / "PETS09-S2L1" / "gt" / "gt.txt"
    scores = evaluate_tracks(truth, tracks, frames=(1, 795))
    names = ("HOTA", "DetA", "AssA", "MOTA", "IDF1", "switches")
    print(f"vtest.avi at {fps:g} fps:", {name: scores.to_dict()[name] for name in names})
    return scores, read / (795 * 768 * 576)


def test_people_crossing_a_campus(data: Path) -> None:
    """The footage was taken at 7 frames a second; the file's header says 10."""
    true_rate = scores_of_default_preset(data, 7)
    assert true_rate.hota >= 42
    assert true_rate.mota >= 52
    assert true_rate.idf1 >= 46
    header_rate = scores_of_default_preset(data, 10)
    assert header_rate.hota >= true_rate.hota - 3
    assert header_rate.mota >= true_rate.mota - 3
    assert header_rate.idf1 >= true_rate.idf1 - 3


@pytest.mark.parametrize("fps", [7, 10])  # that of the truth, and that of the file
def test_regions_find_as_much_in_half_of_the_pixels(fps: int, data: Path) -> None:
    whole, everything = scores_of(data, fps, survtrack.Config())
    assert everything == 1
    regions = survtrack.PredictedRegionsOptions()
    parts, read = scores_of(data, fps, survtrack.Config(regions=regions))
    print(f"{100 * read:.1f} % of the pixels, MOTA {parts.mota:.1f} against {whole.mota:.1f}")
    assert read <= 0.5
    assert parts.mota >= whole.mota - 1


def scores_of_average(data: Path, masks: Path, secondary_background: bool) -> MaskScores:
    sequence = data / "cdnet" / "highway"
    config = survtrack.preset("narayana2007")
    config.cleanup = survtrack.CleanupOptions(median_px=5)
    config.segmenter = survtrack.MovingAverageOptions(
        threshold=15, secondary_threshold=15, secondary_background=secondary_background
    )
    detector = survtrack.Detector(config)
    masks.mkdir()
    found = []
    for path in sorted((sequence / "input").iterdir()):
        number = int(path.stem[-6:])
        found.append(detector.process(cv2.imread(str(path)), number / 25, number))
    for detections in [one for one in found if one is not None] + detector.finish():
        assert cv2.imwrite(str(masks / f"bin{detections.index:06d}.png"), detections.mask)
    return evaluate_masks(sequence, masks)


def test_the_secondary_background_takes_tails_away(data: Path, tmp_path: Path) -> None:
    """Narayana 2007, 3.1.2 and fig. 3.5: what a moving object drags along in the average."""
    alone = scores_of_average(data, tmp_path / "alone", False)
    both = scores_of_average(data, tmp_path / "both", True)
    print(f"highway, average: F {alone.f_measure:.3f}; with secondary: F {both.f_measure:.3f}")
    assert (alone.frames, both.frames) == (531, 531)
    assert both.f_measure >= alone.f_measure + 0.05
    assert both.precision > alone.precision
