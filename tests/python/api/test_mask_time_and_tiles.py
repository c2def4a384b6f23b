# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The temporal median by counting; tiled morphology against OpenCV's erode and dilate."""

from typing import Any

import cv2
import numpy as np
import pytest

import survtrack
from clips import Image
from survtrack import (
    Cleanup,
    CleanupOptions,
    Config,
    ConfigError,
    InputError,
    QuadrantsOptions,
    WholeFrameOptions,
    clean_mask,
    tiled_morphology,
)

SHAPES = ["square", "cross", "ellipse"]
PUBLISHED: dict[str, Any] = {
    "rows": 2,
    "columns": 2,
    "overlap_px": 10,
    "erode_px": np.array([[4, 4], [4, 4]]),
    "dilate_px": np.array([[11, 14], [14, 15]]),
}


def random_mask(size: tuple[int, int], seed: int, share: float = 0.7, block: int = 5) -> Image:
    coarse = np.random.default_rng(seed).random((size[0] // block + 1, size[1] // block + 1))
    fine = np.kron(coarse < share, np.ones((block, block), bool))
    return np.where(fine[: size[0], : size[1]], 255, 0).astype(np.uint8)


def element(shape: str, edge: int) -> Image:
    """Of odd and even edges around edge // 2, from the definition."""
    origin = edge // 2
    y, x = np.mgrid[:edge, :edge] - origin
    if shape == "square":
        return np.ones((edge, edge), np.uint8)
    if shape == "cross":
        return ((x == 0) | (y == 0)).astype(np.uint8)
    half_chord = np.rint(np.sqrt(origin**2 - y**2))
    return (np.abs(x) <= half_chord).astype(np.uint8)


def opened_by_opencv(mask: Image, erode_px: int, dilate_px: int, shape: str) -> Image:
    """Erosion, then dilation by the reflected element, of the whole mask."""
    if erode_px > 1:
        mask = cv2.erode(mask, element(shape, erode_px))
    if dilate_px > 1:
        anchor = dilate_px - 1 - dilate_px // 2
        reflected = cv2.flip(element(shape, dilate_px), -1)
        mask = cv2.dilate(mask, reflected, anchor=(anchor, anchor))
    return mask


def tiles_by_opencv(mask: Image, grid: dict[str, Any], shape: str) -> Image:
    """Tile by tile: cut out with the overlap, worked on alone, cut to its own part."""
    rows, columns, overlap = grid["rows"], grid["columns"], grid["overlap_px"]
    height, width = mask.shape
    result = np.zeros_like(mask)
    for r in range(rows):
        for c in range(columns):
            top, bottom = r * height // rows, (r + 1) * height // rows
            left, right = c * width // columns, (c + 1) * width // columns
            y, x = max(top - overlap, 0), max(left - overlap, 0)
            part = mask[y : bottom + overlap, x : right + overlap].copy()
            done = opened_by_opencv(
                part, int(grid["erode_px"][r][c]), int(grid["dilate_px"][r][c]), shape
            )
            result[top:bottom, left:right] = done[top - y : bottom - y, left - x : right - x]
    return result


@pytest.mark.parametrize("frames", [3, 5, 25])
def test_the_temporal_median_is_what_most_of_the_last_masks_are(frames: int) -> None:
    cleanup = Cleanup(CleanupOptions(median_px=0, temporal_median_frames=frames))
    masks = [random_mask((50, 67), seed, share=0.5) for seed in range(2 * frames + 2)]
    for _ in range(2):
        for k, mask in enumerate(masks):
            last = np.stack(masks[max(k + 1 - frames, 0) : k + 1]) > 0
            expected = np.where(2 * last.sum(axis=0) > len(last), 255, 0)
            assert np.array_equal(cleanup.apply(mask), expected)
        cleanup.reset()


def test_one_mask_alone_has_no_past() -> None:
    mask = random_mask((40, 50), 1)
    options = CleanupOptions(temporal_median_frames=3)
    assert np.array_equal(clean_mask(mask, options), clean_mask(mask, CleanupOptions()))


def test_masks_of_different_sizes_are_refused() -> None:
    cleanup = Cleanup(CleanupOptions(temporal_median_frames=3))
    cleanup.apply(np.zeros((20, 30), np.uint8))
    with pytest.raises(InputError, match=r"^mask: is 21x30, the masks before were 20x30"):
        cleanup.apply(np.zeros((21, 30), np.uint8))
    cleanup.reset()
    cleanup.apply(np.zeros((21, 30), np.uint8))


def test_even_lengths_are_refused() -> None:
    message = r"temporal_median_frames: 4 is not allowed; expected between 0 and 999, 0 or odd"
    with pytest.raises(ConfigError, match=message):
        CleanupOptions(temporal_median_frames=4)


def test_the_pipeline_has_the_temporal_median_and_forgets_it_on_reset() -> None:
    config = Config(segmenter=survtrack.KnnOptions())
    config.set("cleanup.temporal_median_frames=3")
    raw = Config(segmenter=survtrack.KnnOptions(), cleanup=CleanupOptions(median_px=0))
    random = np.random.default_rng(3)
    frames = [random.integers(0, 256, (48, 64), dtype=np.uint8) for _ in range(6)]
    detector, without = survtrack.Detector(config), survtrack.Detector(raw)
    for _ in range(2):
        cleanup = Cleanup(config.cleanup)
        for k, frame in enumerate(frames):
            found, plain = detector.process(frame, k / 10), without.process(frame, k / 10)
            assert found is not None and plain is not None
            assert np.array_equal(found.mask, cleanup.apply(plain.mask))
        detector.reset()
        without.reset()


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("edges", [(3, 3), (4, 4), (4, 14), (5, 10), (2, 1), (0, 7)])
def test_equal_edges_are_the_whole_mask_s(shape: str, edges: tuple[int, int]) -> None:
    for rows, columns in [(1, 1), (2, 2), (3, 5), (7, 4)]:
        mask = random_mask((131, 193), rows)
        tiled = tiled_morphology(
            mask,
            rows=rows,
            columns=columns,
            overlap_px=edges[0] // 2 + edges[1] // 2,
            erode_px=edges[0],
            dilate_px=edges[1],
            shape=shape,
        )
        assert np.array_equal(tiled, opened_by_opencv(mask, *edges, shape))


@pytest.mark.parametrize("shape", SHAPES)
def test_unequal_edges_are_those_of_tiles_cut_out_and_rejoined(shape: str) -> None:
    random = np.random.default_rng(7)
    for seed in range(20):
        rows, columns = random.integers(1, 5, 2)
        grid = {
            "rows": int(rows),
            "columns": int(columns),
            "overlap_px": 12,
            "erode_px": random.integers(0, 10, (rows, columns)),
            "dilate_px": random.integers(0, 17, (rows, columns)),
        }
        mask = random_mask((101 + seed, 150 - seed), seed)
        tiled = tiled_morphology(mask, shape=shape, **grid)
        assert np.array_equal(tiled, tiles_by_opencv(mask, grid, shape))


def test_the_quadrants_of_the_config_are_the_published_grid() -> None:
    mask = random_mask((288, 384), 1)
    options = CleanupOptions(median_px=0, tiling=QuadrantsOptions())
    expected = tiles_by_opencv(mask, PUBLISHED, "square")
    assert np.array_equal(clean_mask(mask, options), expected)
    assert np.array_equal(tiled_morphology(mask, **PUBLISHED), expected)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_whole_frame_in_the_config(shape: str) -> None:
    mask = random_mask((60, 80), 2)
    options = CleanupOptions(median_px=0, tiling=WholeFrameOptions(shape=shape))
    assert np.array_equal(clean_mask(mask, options), opened_by_opencv(mask, 4, 14, shape))


@pytest.mark.parametrize("edge", range(2, 24))
def test_squares_and_crosses_are_opencvs(edge: int) -> None:
    for shape, kind in (("square", cv2.MORPH_RECT), ("cross", cv2.MORPH_CROSS)):
        assert np.array_equal(element(shape, edge), cv2.getStructuringElement(kind, (edge, edge)))


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"overlap_px": 8}, ConfigError, r"overlap_px: 8 is not allowed; expected at least 9, the"),
        ({"rows": 0, "erode_px": 3, "dilate_px": 3}, ConfigError, "rows: 0 is not allowed"),
        ({"columns": 10**6, "erode_px": 3, "dilate_px": 3}, ConfigError, "columns: 1000000 is not"),
        (
            {"erode_px": [[4, 4], [4, 300]]},
            ConfigError,
            r"erode_px of tile \(row 2, column 2\): 300",
        ),
        (
            {"erode_px": [[4, 4], [4, 10**12]]},
            ConfigError,
            "erode_px: 1000000000000 is not allowed",
        ),
        ({"erode_px": -7}, ConfigError, r"erode_px of tile \(row 1, column 1\): -7 is not"),
        ({"erode_px": [4, 4, 4, 4]}, InputError, r"erode_px: is \[4, 4, 4, 4\]; expected an int"),
        ({"dilate_px": 4.5}, InputError, "dilate_px: is 4.5; expected an integer or 2x2 integers"),
        ({"dilate_px": None}, InputError, "dilate_px: is None; expected an integer or 2x2"),
        ({"shape": "disc"}, ConfigError, 'shape: "disc" is not allowed; expected one of: square'),
    ],
)
def test_grids_that_cannot_be_are_refused(
    changes: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=f"^{message}"):
        tiled_morphology(np.zeros((60, 60), np.uint8), **{**PUBLISHED, **changes})


def test_masks_too_small_for_the_grid_are_refused() -> None:
    with pytest.raises(InputError, match=r"^mask: is 29x60, which makes tile \(row 1, column 1\)"):
        tiled_morphology(np.zeros((29, 60), np.uint8), **{**PUBLISHED, "dilate_px": 15})
    with pytest.raises(InputError, match=r"^mask: is 1x60, smaller than the grid of 2x2 tiles"):
        tiled_morphology(np.zeros((1, 60), np.uint8), **PUBLISHED)


def test_an_overlap_below_the_reach_is_refused_with_its_path() -> None:
    config = Config()
    config.set("cleanup.tiling.model=quadrants")
    config.set("cleanup.tiling.overlap_px=8")
    message = "^cleanup.tiling.overlap_px: 8 is not allowed; expected at least 9"
    with pytest.raises(ConfigError, match=message):
        survtrack.Pipeline(config)
