# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Background models alone: their contract, and OpenCV's models against OpenCV itself."""

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest

import survtrack
from clips import Image
from scenes import scene
from survtrack import ConfigError, InputError, Segmenter

CAUSAL = survtrack.MovingAverageOptions(window="causal", window_frames=20)
MODELS = [
    survtrack.SelectiveOptions(),
    survtrack.Mog2Options(),
    survtrack.KnnOptions(),
    CAUSAL,
    survtrack.StaticReferenceOptions(),
]
FRAMES = scene(60)


def masks(options: Any, frames: list[Image] = FRAMES) -> list[Image]:
    segmenter = Segmenter(options)
    return [segmenter.segment(frame, k / 10) for k, frame in enumerate(frames)]


each_model = pytest.mark.parametrize("options", MODELS, ids=lambda options: options.model)


@each_model
def test_a_still_scene_stays_empty(options: Any) -> None:
    for mask in masks(options, scene(10) * 4):
        assert mask.shape == (64, 96) and mask.dtype == np.uint8
        assert np.count_nonzero(mask) < 0.01 * mask.size
    assert not masks(options)[0].any(), "a first frame is no foreground"


@each_model
def test_the_square_is_found(options: Any) -> None:
    for k, mask in enumerate(masks(options)[:50]):
        assert set(np.unique(mask)) <= {0, 255}
        if k < 20:
            continue
        left = 4 + 2 * (k - 10)
        assert np.count_nonzero(mask[21:35, left + 11 : left + 14]) > 0.9 * 14 * 3, "its front"
        mask[21:35, : left + 14] = 0
        assert np.count_nonzero(mask) < 0.02 * mask.size


@each_model
def test_same_frames_same_masks_and_frames_stay_as_they_are(options: Any) -> None:
    before = [frame.copy() for frame in FRAMES]
    first, second = masks(options), masks(options)
    assert all(np.array_equal(a, b) for a, b in zip(first, second, strict=True))
    assert all(np.array_equal(a, b) for a, b in zip(FRAMES, before, strict=True))
    segmenter = Segmenter(options)
    for k, frame in enumerate(FRAMES):
        segmenter.segment(frame, k / 10)
    segmenter.reset()
    for k, frame in enumerate(FRAMES):
        assert np.array_equal(segmenter.segment(frame, k / 10), first[k])


@each_model
@pytest.mark.parametrize("grey", [False, True], ids=["colour", "grey"])
def test_the_background_is_the_empty_scene(options: Any, grey: bool) -> None:
    segmenter = Segmenter(options)
    with pytest.raises(InputError, match=r"^background: no frame was segmented yet"):
        segmenter.background()
    frames = [frame[..., 1] if grey else frame for frame in FRAMES]
    for k, frame in enumerate(frames):
        segmenter.segment(frame, k / 10)
    scene_now, background = frames[0], segmenter.background()
    if options is CAUSAL and not grey:
        scene_now = cv2.cvtColor(scene_now, cv2.COLOR_BGR2GRAY)
    assert background.dtype == np.uint8 and background.shape == scene_now.shape
    away = background[40:].astype(int) - scene_now[40:]
    assert np.abs(away).max() < 8
    segmenter.reset()
    with pytest.raises(InputError, match=r"^background: "):
        segmenter.background()


def opencv_masks(model: Any, frames: list[Image]) -> list[Image]:
    """OpenCV's own masks, shadows taken out; its first frame, all foreground, left out."""
    return [np.where(model.apply(frame) == 255, 255, 0) for frame in frames][1:]


@pytest.mark.parametrize(
    ("options", "make"),
    [
        (survtrack.Mog2Options(), lambda: cv2.createBackgroundSubtractorMOG2()),
        (
            survtrack.Mog2Options(history_frames=30, variance_threshold=40, detect_shadows=False),
            lambda: cv2.createBackgroundSubtractorMOG2(30, 40, False),
        ),
    ],
)
def test_mog2_is_opencvs(options: Any, make: Callable[[], Any]) -> None:
    ours, theirs = masks(options)[1:], opencv_masks(make(), FRAMES)
    different = [np.count_nonzero(a != b) for a, b in zip(ours, theirs, strict=True)]
    # Python's cv2 is another release than the library's, compiled with other instructions.
    assert sum(different) <= 1e-4 * FRAMES[0][..., 0].size * len(FRAMES)


def test_the_causal_average_is_its_formula() -> None:
    options = CAUSAL.replace(window_frames=8, threshold=12.5, secondary_background=False)
    grey = [frame[..., 0] for frame in FRAMES]
    for k, mask in enumerate(masks(options, grey)):
        window = np.array(grey[max(0, k - 7) : k + 1], np.float64)
        expected = np.abs(window.mean(axis=0) - grey[k]) > 12.5
        assert np.array_equal(mask > 0, expected), k


def test_the_secondary_background_is_its_formula() -> None:
    """Narayana 2007, eq. 3.2 to 3.5: foreground differs from the mean and from the second too."""
    options = CAUSAL.replace(window_frames=8, threshold=10.0, secondary_threshold=15.0)
    grey = [frame[..., 0].astype(float) for frame in FRAMES]
    second = grey[0].copy()
    for k, mask in enumerate(masks(options, [frame[..., 0] for frame in FRAMES])):
        mean = np.mean(grey[max(0, k - 7) : k + 1], axis=0)
        first = np.abs(mean - grey[k]) > 10
        expected = first & (np.abs(second - grey[k]) > 15)
        assert np.array_equal(mask > 0, expected), k
        second[~expected] = grey[k][~expected]


def test_a_centred_window_goes_through_a_detector() -> None:
    with pytest.raises(ConfigError, match=r"^segmenter\.window: .* delay of 75 frames; Segmenter"):
        Segmenter(survtrack.MovingAverageOptions())
    assert Segmenter(survtrack.MovingAverageOptions(window_frames=1)) is not None


def test_places_to_keep_are_not_learned() -> None:
    config = survtrack.Config(segmenter=survtrack.SelectiveOptions(absorb_time_s=1))
    still = scene(11)[10]
    ground = scene(10)
    kept = [survtrack.Box(0, 15, 25, 25)]
    found = []
    for keep in ([], kept):
        detector = survtrack.Detector(config)
        for k, frame in enumerate(ground + 60 * [still]):
            detections = detector.process(frame, k / 10, keep=keep)
        found.append(len(detections))
    assert found == [0, 1], "the square that stands still is absorbed, but not where it is kept"


def test_only_segmenter_options_make_a_segmenter() -> None:
    for options in (survtrack.Config(), survtrack.CleanupOptions(), "mog2"):
        with pytest.raises(TypeError, match="SelectiveOptions"):
            Segmenter(options)  # type: ignore[arg-type]
