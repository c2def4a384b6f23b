# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The segmenter by optical flow: what it hands out, and when."""

from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import scene
from survtrack import ConfigError, InputError

FRAMES = scene(40)
OPTIONS = survtrack.HornSchunckOptions(frames_back=3, smoothness=0.1, sweeps=25)


def config(**outputs: bool) -> survtrack.Config:
    return survtrack.Config(segmenter=OPTIONS, outputs=survtrack.OutputOptions(**outputs))


def test_its_mask_is_the_flow_since_the_nth_frame_before() -> None:
    segmenter = survtrack.Segmenter(OPTIONS.replace(magnitude_threshold=0.5))
    for k, frame in enumerate(FRAMES):
        mask = segmenter.segment(frame, k / 10)
        if k < 3:
            assert segmenter.flow() is None and not mask.any()
            continue
        u, v = survtrack.horn_schunck(FRAMES[k - 3], frame, smoothness=0.1, sweeps=25)
        field = segmenter.flow()
        assert field is not None and field.dtype == np.float32
        assert np.array_equal(field, np.dstack([u, v]))
        assert np.array_equal(mask > 0, u * u + v * v > np.float32(0.25))
    assert mask.any()
    segmenter.reset()
    assert segmenter.flow() is None


def test_it_has_no_background_and_the_others_no_flow() -> None:
    by_flow, other = survtrack.Segmenter(OPTIONS), survtrack.Segmenter()
    for k, frame in enumerate(FRAMES[:5]):
        by_flow.segment(frame, k / 10)
        other.segment(frame, k / 10)
    with pytest.raises(InputError, match=r"^background: this model has none"):
        by_flow.background()
    assert other.flow() is None


@pytest.mark.parametrize("make", [survtrack.Detector, survtrack.Pipeline])
def test_results_have_the_flow_that_was_asked_for(make: Any) -> None:
    asked, plain = make(config(flow=True)), make(config())
    fields = []
    for k, frame in enumerate(FRAMES):
        result = asked.process(frame, k / 10)
        assert plain.process(frame, k / 10).flow is None
        assert (result.flow is None) == (k < 3)
        if result.flow is not None:
            assert result.flow.shape == (64, 96, 2) and result.flow.dtype == np.float32
            fields.append((result.flow, result.flow.copy()))
        if isinstance(result, survtrack.FrameResult):
            assert (result.detections.flow is None) == (k < 3)
    assert all(np.array_equal(*pair) for pair in fields), "a later frame changed an earlier result"
    assert any(field.any() for field, _ in fields)


def test_a_run_no_longer_than_it_looks_back_has_neither_flow_nor_foreground() -> None:
    pipeline = survtrack.Pipeline(
        survtrack.Config(
            segmenter=OPTIONS.replace(frames_back=40), outputs=survtrack.OutputOptions(flow=True)
        )
    )
    for k, frame in enumerate(FRAMES):
        result = pipeline.process(frame, k / 10)
        assert result.flow is None and not result.mask.any() and not result.tracks


def test_only_a_model_with_flow_can_be_asked_for_it() -> None:
    asked = survtrack.Config(outputs=survtrack.OutputOptions(flow=True))
    expected = r"^outputs\.flow: true needs a flow field, .* expected segmenter\.model horn_schunck"
    with pytest.raises(ConfigError, match=expected):
        survtrack.Detector(asked)


@pytest.mark.parametrize(
    ("option", "value", "allowed"),
    [
        ("frames_back", 0, "between 1 and 1000"),
        ("smoothness", 0, "between 0.0001 and 1000"),
        ("smoothness", float("nan"), "between 0.0001 and 1000|a finite number"),
        ("sweeps", 0, "between 1 and 100000"),
        ("tolerance", -0.1, "between 0 and 1000000"),
        ("derivatives", "roberts", '"hs1981", "sobel"|hs1981, sobel'),
        ("magnitude_threshold", -1, "between 0 and 1000000"),
    ],
)
def test_options_out_of_range(option: str, value: Any, allowed: str) -> None:
    with pytest.raises(ConfigError, match=rf"{option}: .* is not allowed; expected .*({allowed})"):
        survtrack.HornSchunckOptions(**{option: value})
