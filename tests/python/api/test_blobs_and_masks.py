# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Blobs and mask cleanup against OpenCV's components, median and morphology."""

from typing import Any

import cv2
import numpy as np
import pytest

import survtrack
from clips import Image
from survtrack import (
    BlobOptions,
    CleanupOptions,
    InputError,
    NoMergeOptions,
    clean_mask,
    find_blobs,
)

ALL_BLOBS = BlobOptions(min_area_fraction=0, merge=NoMergeOptions(), max_blobs=100000)
SIZES = [(1, 1), (1, 70), (70, 1), (2, 2), (7, 64), (33, 65), (64, 128), (97, 131)]
SHARES = [0.02, 0.3, 0.6, 0.97]


def random_mask(size: tuple[int, int], share: float, seed: int = 0) -> Image:
    random = np.random.default_rng(seed)
    return np.where(random.random(size) < share, 255, 0).astype(np.uint8)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("share", SHARES)
def test_blobs_are_opencvs_components(size: tuple[int, int], share: float) -> None:
    mask = random_mask(size, share)
    image = np.random.default_rng(1).integers(0, 256, (*size, 3), dtype=np.uint8)
    count, labels, stats, centroids = cv2.connectedComponentsWithStats(mask, connectivity=8)
    expected = []
    for label in range(1, count):
        at = np.argwhere(labels == label)[:, ::-1]
        away = at - centroids[label]
        moments = away.T @ away / len(at)
        color = image[labels == label].mean(axis=0)
        values = (*stats[label][:4], *centroids[label], stats[label][4], *color)
        expected.append((*values, moments[0, 0], moments[0, 1], moments[1, 1], 1.0, -1.0))
    found = [tuple(row) for row in find_blobs(mask, image, ALL_BLOBS).array]
    assert in_order(found) == pytest.approx(in_order(expected), abs=1e-9)


def in_order(blobs: list[tuple[float, ...]]) -> np.ndarray:
    """A row a blob, in an order that rounding does not change."""
    ordered = sorted(blobs, key=lambda blob: [round(value, 6) for value in blob])
    return np.array(ordered, np.float64).reshape(-1, 15)


def test_contours_are_opencvs() -> None:
    mask = random_mask((60, 80), 0.4)
    expected, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    outer = {tuple(map(tuple, contour[:, 0].tolist())) for contour in expected}
    blobs = find_blobs(mask, options=ALL_BLOBS, contours=True)
    ours = {tuple(map(tuple, contour.tolist())) for contour in blobs.contours}
    assert len(blobs.contours) == len(blobs)
    assert outer <= ours, "OpenCV's leaves out blobs in the holes of others"


def test_small_blobs_are_dropped() -> None:
    mask = np.zeros((100, 100), np.uint8)
    for k in range(6):
        mask[10 : 10 + k + 1, 15 * k : 15 * k + 2] = 255  # 2, 4, ... 12 px
    area = {"merge": NoMergeOptions()}
    by_px = find_blobs(mask, options=BlobOptions(min_area_px=6, min_area_fraction=0, **area))
    by_part = find_blobs(mask, options=BlobOptions(min_area_fraction=8e-4, **area))
    both = find_blobs(mask, options=BlobOptions(min_area_px=6, min_area_fraction=8e-4, **area))
    assert sorted(one.area_px for one in by_px) == [6, 8, 10, 12]
    assert sorted(one.area_px for one in by_part) == [8, 10, 12]
    assert by_part.array.tolist() == both.array.tolist()


def test_of_too_many_blobs_the_largest_are_kept() -> None:
    mask = np.zeros((8, 400), np.uint8)
    for k in range(80):
        mask[: 1 + k % 8, 5 * k : 5 * k + 3] = 255
    blobs = find_blobs(mask, options=ALL_BLOBS.replace(max_blobs=20))
    assert sorted(one.area_px for one in blobs) == 10 * [21] + 10 * [24]


def test_what_is_not_zero_is_foreground() -> None:
    mask = random_mask((40, 50), 0.3)
    for value in (1, 127, 254):
        other = np.minimum(mask, value).astype(np.uint8)
        blobs = find_blobs(other, mask, ALL_BLOBS)
        assert blobs.array.tolist() == find_blobs(mask, mask, ALL_BLOBS).array.tolist()


def test_colours_are_the_frames_or_the_masks_own() -> None:
    mask = np.zeros((20, 30), np.uint8)
    mask[3:9, 4:12] = 255
    grey = np.full((20, 30), 9, np.uint8)
    assert find_blobs(mask)[0].mean_color == (255, 255, 255)
    assert find_blobs(mask, grey)[0].mean_color == (9, 9, 9)
    assert find_blobs(mask, np.dstack([grey, grey + 1, grey + 2]))[0].mean_color == (9, 10, 11)


def test_inputs_are_left_alone_and_any_layout_works() -> None:
    mask = random_mask((41, 67), 0.5)
    wide = np.zeros((82, 201), np.uint8)[::2, ::3]
    wide[...] = mask
    backwards = mask[::-1, ::-1].copy()[::-1, ::-1]
    options = CleanupOptions(median_px=5, open_px=3, close_px=3)
    expected = clean_mask(mask, options)
    for laid in (wide, backwards, np.asfortranarray(mask)):
        assert np.array_equal(clean_mask(laid, options), expected)
        assert find_blobs(laid).array.tolist() == find_blobs(mask).array.tolist()
        assert np.array_equal(laid, mask)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize("side", [1, 3, 5, 7, 15, 31])
def test_the_median_is_opencvs(size: tuple[int, int], share: float, side: int) -> None:
    mask = random_mask(size, share)
    cleaned = clean_mask(mask, CleanupOptions(median_px=side))
    assert np.array_equal(cleaned, cv2.medianBlur(mask, side) if side > 1 else mask)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize("side", [1, 3, 5, 11, 31, 99])
def test_morphology_is_opencvs(size: tuple[int, int], share: float, side: int) -> None:
    mask = random_mask(size, share)
    opened = clean_mask(mask, CleanupOptions(median_px=0, open_px=side))
    square = np.ones((side, side), np.uint8)
    assert np.array_equal(opened, cv2.morphologyEx(mask, cv2.MORPH_OPEN, square))
    closed = clean_mask(mask, CleanupOptions(median_px=0, close_px=side))
    assert np.array_equal(closed, closed_by_opencv(mask, side))


def closed_by_opencv(mask: Image, side: int) -> Image:
    """With a margin of background: without one OpenCV's fills gaps towards the border."""
    wide = cv2.copyMakeBorder(mask, *4 * [side], cv2.BORDER_CONSTANT, value=0)
    wide = cv2.morphologyEx(wide, cv2.MORPH_CLOSE, np.ones((side, side), np.uint8))
    return wide[side:-side, side:-side]


def test_the_steps_come_in_their_order() -> None:
    mask = random_mask((64, 80), 0.5)
    opened = cv2.morphologyEx(cv2.medianBlur(mask, 5), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    expected = closed_by_opencv(opened, 5)
    options = CleanupOptions(median_px=5, open_px=3, close_px=5)
    assert np.array_equal(clean_mask(mask, options), expected)
    assert np.array_equal(clean_mask(mask), cv2.medianBlur(mask, 5)), "the default's median"


@pytest.mark.parametrize("function", [clean_mask, find_blobs])
@pytest.mark.parametrize(
    ("mask", "message"),
    [
        (np.zeros((4, 5, 3), np.uint8), "mask: has 3 channels; expected HxW uint8"),
        (np.zeros((4, 5), bool), r"mask: is \(4, 5\) bool; expected"),
        (np.zeros((4, 5)), r"mask: is \(4, 5\) float64; expected"),
        (np.zeros((0, 5), np.uint8), r"mask: is \(0, 5\) uint8; expected"),
        ([[0, 255]], "mask: is list; expected"),
        (None, "mask: is NoneType; expected"),
    ],
)
def test_what_is_no_mask_is_refused(function: Any, mask: Any, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        function(mask)


def test_a_frame_of_another_size_is_refused() -> None:
    mask = np.zeros((20, 30), np.uint8)
    with pytest.raises(InputError, match=r"^frame: is 30x20; expected the mask's size, 20x30"):
        find_blobs(mask, np.zeros((30, 20), np.uint8))
    with pytest.raises(InputError, match=r"^frame: is \(20, 30\) float64"):
        find_blobs(mask, np.zeros((20, 30)))
    with pytest.raises(TypeError):
        find_blobs(mask, None, survtrack.CleanupOptions())  # type: ignore[arg-type]


def test_blobs_of_masks_go_through_a_tracker() -> None:
    """One's own masks, followed: the frame's time and index travel with the detections."""
    tracker = survtrack.Tracker(survtrack.preset("semko2007"))
    for k in range(20):
        mask = np.zeros((120, 160), np.uint8)
        mask[40:80, 20 + 3 * k : 50 + 3 * k] = 255
        found = find_blobs(mask, options=ALL_BLOBS, time_s=0.04 * k, index=10 + k)
        assert (found.time_s, found.index) == (0.04 * k, 10 + k)
        result = tracker.process(found)
        assert (result.index, result.time_s) == (10 + k, 0.04 * k)
    [track] = result.tracks
    assert track.position == pytest.approx((91.5, 59.5), abs=0.1)
    assert track.velocity_px_per_s == pytest.approx((75.0, 0.0), abs=0.5)
    with pytest.raises(survtrack.InputError, match="time"):
        tracker.process(find_blobs(mask, time_s=0.04))
    with pytest.raises(survtrack.InputError, match="time"):
        tracker.process(find_blobs(mask, time_s=float("nan")))
