# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Colour histograms of tracks."""

import cv2
import numpy as np
import pytest

import survtrack
from scenes import config_of, run, scene


def test_a_histogram_is_that_of_opencv() -> None:
    rng = np.random.default_rng(1)
    image = rng.integers(0, 256, (40, 30, 3), np.uint8)
    mask = (rng.random((40, 30)) < 0.4).astype(np.uint8) * 255
    for inside in (None, mask):
        expected = cv2.calcHist([image], [0, 1, 2], inside, [8, 8, 8], [0, 256] * 3)
        found = survtrack.color_histogram(image, inside)
        assert found.shape == (8, 8, 8) and found.dtype == np.float32
        np.testing.assert_allclose(found, expected / expected.sum(), rtol=1e-6)


def test_intersection_is_that_of_opencv() -> None:
    rng = np.random.default_rng(2)
    a, b = (
        survtrack.color_histogram(rng.integers(0, high, (40, 30, 3), np.uint8))
        for high in (120, 256)
    )
    expected = cv2.compareHist(a.ravel(), b.ravel(), cv2.HISTCMP_INTERSECT)
    assert survtrack.histogram_intersection(a, b) == pytest.approx(expected, rel=1e-6)
    assert survtrack.histogram_intersection(a, a) == pytest.approx(1.0, abs=1e-6)


def test_a_tracker_on_boxes_takes_histograms() -> None:
    config = config_of(
        appearance=survtrack.ColorHistogramOptions(min_intersection=0.5),
        lifecycle=survtrack.LostCountOptions(),
    )
    red, blue = (
        survtrack.color_histogram(np.full((4, 4, 3), color, np.uint8))
        for color in ((0, 0, 200), (200, 0, 0))
    )
    tracker = survtrack.Tracker(config)

    def ids(time_s: float, histogram: np.ndarray) -> list[int]:
        seen = survtrack.Detections([[10, 10, 20, 20]], time_s, histograms=[histogram])
        np.testing.assert_array_equal(seen.histograms[0], histogram)
        return [t.id for t in tracker.process(seen).tracks if t.detection >= 0]

    assert ids(0.0, red) == [1] and ids(0.1, red) == [1] and ids(0.2, blue) == [2]
    with pytest.raises(survtrack.InputError, match="expected one each"):
        tracker.process([[10, 10, 20, 20]], 0.3)


@pytest.mark.parametrize(
    ("histograms", "message"),
    [
        (np.zeros((2, 8, 8, 8)), "expected 1x8x8x8"),
        ("red", "expected 1x8x8x8"),
        (np.full((1, 8, 8, 8), 1.0), r"histograms\[0\]: its parts sum to 512"),
        (np.full((1, 8, 8, 8), np.nan), r"histograms\[0\]: has a part that is negative"),
    ],
)
def test_what_is_no_histogram(histograms: object, message: str) -> None:
    with pytest.raises(survtrack.InputError, match=message):
        survtrack.Detections([[0, 0, 9, 9]], 0.0, histograms=histograms)


def test_functions_refuse_what_they_cannot_read() -> None:
    with pytest.raises(survtrack.InputError, match="expected 8x8x8"):
        survtrack.histogram_intersection(np.zeros(9), np.zeros(512))
    with pytest.raises(survtrack.InputError, match="sum to"):
        survtrack.histogram_intersection(np.ones(512), np.zeros(512))
    image = np.zeros((4, 4, 3), np.uint8)
    with pytest.raises(survtrack.InputError, match="mask"):
        survtrack.color_histogram(image, np.zeros((4, 5), np.uint8))
    with pytest.raises(survtrack.InputError, match="image"):
        survtrack.color_histogram(np.zeros((4, 4), np.float32))


def test_blobs_have_them_when_asked_for() -> None:
    config = config_of(appearance=survtrack.ColorHistogramOptions())
    results = run(survtrack.Pipeline(config), scene())
    last = results[-1].detections
    assert last.histograms.shape == (len(last), 8, 8, 8) and len(last)
    np.testing.assert_allclose(last.histograms.sum(axis=(1, 2, 3)), 1, atol=1e-5)
    assert run(survtrack.Pipeline(), scene())[-1].detections.histograms.shape == (0, 8, 8, 8)
    assert [t.id for t in results[-1].tracks] == [1]
