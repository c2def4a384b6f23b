# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The locally normalised difference against another implementation, in numpy alone."""

import numpy as np
import pytest

from clips import Image
from scenes import scene
from survtrack import ConfigError, NormalizedDifferenceOptions, Segmenter

KERNEL = np.array([1, 4, 6, 4, 1])


def halved(picture: np.ndarray) -> np.ndarray:
    """The next level of Burt and Adelson's pyramid, rounded; pixels are mirrored at the border."""
    padded = np.pad(picture.astype(int), 2, mode="reflect")
    rows, columns = picture.shape
    smooth = sum(w * padded[:, k : k + columns] for k, w in enumerate(KERNEL))
    smooth = sum(w * smooth[k : k + rows] for k, w in enumerate(KERNEL))
    return (smooth[::2, ::2] + 128) >> 8


def sums(values: np.ndarray, side: int) -> np.ndarray:
    """Of each pixel the sum over the square about it, nothing beyond the border."""
    padded = np.pad(values, side // 2)
    windows = np.lib.stride_tricks.sliding_window_view(padded, (side, side))
    return np.asarray(windows.sum(axis=(2, 3)))


def normalized(frame: np.ndarray, reference: np.ndarray, side: int, constant: float) -> np.ndarray:
    """Nashenda 2011, eq. 3."""
    wide = np.pad(reference, 1, mode="edge").astype(float)
    across = (wide[1:-1, 2:] - wide[1:-1, :-2]) / 2
    down = (wide[2:, 1:-1] - wide[:-2, 1:-1]) / 2
    gradient = np.hypot(across, down)
    difference = np.abs(frame.astype(float) - reference)
    return sums(difference * gradient, side) / (sums(gradient**2, side) + constant)


def values_of(
    frame: np.ndarray, reference: np.ndarray, o: NormalizedDifferenceOptions
) -> np.ndarray:
    """Steps i to iii: from the coarsest level down, a high value replaces."""
    frames, references = [frame], [reference]
    while len(frames) < o.levels and (min(frames[-1].shape) + 1) // 2 >= 8:
        frames.append(halved(frames[-1]))
        references.append(halved(references[-1]))
    carried: np.ndarray | None = None
    for now, before in zip(frames[::-1], references[::-1], strict=True):
        own = normalized(now, before, o.neighbourhood_px, o.constant)
        if carried is not None:
            wide = carried.repeat(2, axis=0).repeat(2, axis=1)[: own.shape[0], : own.shape[1]]
            own = np.where(own > o.high, own, wide)
        carried = own
    assert carried is not None
    return carried


def textured(count: int) -> list[Image]:
    """The walking square on a ground with structure."""
    rows, columns = np.mgrid[:64, :96]
    ground = (30 * np.sin(columns / 3) + 30 * np.cos(rows / 4)).astype(int)
    return [
        np.clip(frame[..., 2].astype(int) + ground + 40, 0, 255).astype(np.uint8)
        for frame in scene(count)
    ]


@pytest.mark.parametrize(
    "options",
    [
        NormalizedDifferenceOptions(reference="previous"),
        NormalizedDifferenceOptions(reference="previous", levels=3, high=1, threshold=1),
        NormalizedDifferenceOptions(reference="previous", frames_back=4, levels=1),
        NormalizedDifferenceOptions(reference="previous", levels=5, neighbourhood_px=3, high=0.4),
        NormalizedDifferenceOptions(reference="previous", high=3, threshold=0.5, constant=900),
    ],
    ids=repr,
)
def test_the_mask_is_numpys(options: NormalizedDifferenceOptions) -> None:
    frames = textured(30)
    segmenter, moving, unsure = Segmenter(options), 0, 0
    for k, frame in enumerate(frames):
        mask = segmenter.segment(frame, k / 10)
        if k < options.frames_back:
            assert not mask.any()
            continue
        values = values_of(frame, frames[k - options.frames_back], options)
        # The core's gradients are rounded to 1/16: values near a threshold may fall either side.
        clear = np.abs(values - options.threshold) > 0.01 + 0.01 * options.threshold
        agrees = (mask > 0) == (values > options.threshold)
        unsure += np.count_nonzero(~agrees)
        if options.high == options.threshold:
            assert agrees[clear].all(), k
        moving += np.count_nonzero(mask)
    assert unsure <= 1e-3 * len(frames) * frames[0].size
    assert 0.003 < moving / (len(frames) * frames[0].size) < 0.5


def test_the_running_reference_is_a_mean_that_fades() -> None:
    options = NormalizedDifferenceOptions(update_time_s=1, levels=1, high=1, threshold=1)
    segmenter, mean = Segmenter(options), np.zeros(0)
    for k, frame in enumerate(textured(40)):
        mask = segmenter.segment(frame, k / 10)
        if k == 0:
            assert not mask.any()
            mean = frame.astype(np.float32)
            continue
        shown = segmenter.background()
        assert np.abs(shown - mean).max() <= 0.51, k
        values = values_of(frame, shown, options)
        clear = np.abs(values - 1) > 0.02
        assert ((mask > 0) == (values > 1))[clear].all(), k
        rate = 0.1 / min(1, k / 10)
        mean += np.float32(rate) * (frame - mean)


def test_options_are_checked() -> None:
    for wrong in ({"constant": 0}, {"levels": 0}, {"neighbourhood_px": 4}, {"high": -1}):
        with pytest.raises(ConfigError, match="is not allowed"):
            NormalizedDifferenceOptions(**wrong)
