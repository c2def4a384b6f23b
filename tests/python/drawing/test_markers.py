# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Circles at the filters' estimates, and ellipses of their covariances."""

import numpy as np
import pytest

from clips import Image
from fakes import Box, Status, Track, result_of
from survtrack.drawing import IntensityRenderer, MarkerRenderer, color_of_id
from survtrack.errors import UsageError

RED = (0, 0, 255)


def blank(height: int = 240, width: int = 320) -> Image:
    return np.zeros((height, width, 3), np.uint8)


def at(x: float, y: float, track_id: int = 1, **more: object) -> Track:
    return Track(track_id, Box(x - 10, y - 20, 20, 40), **more)  # type: ignore[arg-type]


def drawn(renderer: MarkerRenderer, *tracks: Track, scene: Image | None = None) -> Image:
    scene = blank() if scene is None else scene
    assert renderer.annotate(scene, result_of(blank(), 0, *tracks)) is scene
    return scene


def pixels(scene: Image, color: tuple[int, int, int]) -> np.ndarray:
    """(x, y) of all pixels of a colour."""
    return np.argwhere((scene == color).all(axis=2))[:, ::-1]


def ellipse(coverage: float, track: Track) -> np.ndarray:
    """(x, y) of what an ellipse adds to the picture."""
    added = (drawn(MarkerRenderer(coverage), track) != drawn(MarkerRenderer(), track)).any(axis=2)
    return np.argwhere(added)[:, ::-1]


def test_a_red_circle_is_at_the_estimate() -> None:
    circle = pixels(drawn(MarkerRenderer(), at(100, 120)), RED)
    assert np.abs(circle.mean(axis=0) - (100, 120)).max() < 0.5
    distances = np.hypot(*(circle - (100, 120)).T)
    assert (np.abs(distances - 6) <= 2).all()  # of 240 // 40 px
    assert len({round(angle) for angle in np.arctan2(*(circle - (100, 120)).T)}) == 7


def test_the_id_stands_beside_it_and_a_missing_one_is_asked_for() -> None:
    seen, lost = at(100, 120, 3), at(100, 120, 3, status=Status.lost)
    one, other = drawn(MarkerRenderer(), seen), drawn(MarkerRenderer(), lost)
    label = pixels(one, color_of_id(3))
    assert label[:, 0].min() > 104 and label[:, 1].max() < 118
    assert len(pixels(other, color_of_id(3))) > len(label)


def test_an_estimate_outside_of_the_picture_leaves_no_id_in_it() -> None:
    assert not drawn(MarkerRenderer(), at(100, 300), at(-50, 20)).any()
    part = drawn(MarkerRenderer(), at(100, -3))
    assert len(pixels(part, RED)) and not len(pixels(part, color_of_id(1)))


def test_only_reported_tracks_have_a_circle() -> None:
    assert not drawn(MarkerRenderer(), at(100, 120, reported=False)).any()
    assert not drawn(MarkerRenderer(0.95)).any()


def test_the_ellipse_has_the_axes_of_the_covariance() -> None:
    track = at(160, 120, 2, position_covariance_px2=np.diag([900.0, 400.0]))
    x, y = ellipse(0.95, track).T
    # 95 % of a normal distribution in the plane lie within 2.448 standard deviations.
    assert x.min() == pytest.approx(160 - 2.448 * 30, abs=1.5)
    assert x.max() == pytest.approx(160 + 2.448 * 30, abs=1.5)
    assert y.min() == pytest.approx(120 - 2.448 * 20, abs=1.5)
    assert y.max() == pytest.approx(120 + 2.448 * 20, abs=1.5)


def test_the_ellipse_leans_as_the_errors_go_together() -> None:
    covariance = np.array([[500.0, 450.0], [450.0, 500.0]])
    track = at(160, 120, 2, position_covariance_px2=covariance)
    x, y = ellipse(0.5, track).T
    far = x > 175
    assert far.any() and (y[far] > 120).all()
    assert (y[x < 145] < 120).all()


@pytest.mark.parametrize("shape", [(1, 1), (16, 16), (240, 320)])
@pytest.mark.parametrize("value", [0.0, -5.0, 1e-320, 1e300, np.inf, np.nan])
def test_any_estimate_can_be_drawn(shape: tuple[int, int], value: float) -> None:
    track = at(value, -value, position_covariance_px2=np.full((2, 2), value))
    scene = drawn(MarkerRenderer(0.95), track, scene=blank(*shape))
    again = drawn(MarkerRenderer(0.95), track, scene=blank(*shape))
    assert (scene == again).all()


def test_a_coverage_is_a_probability_below_1() -> None:
    for bad in (-0.1, 1.0, float("nan")):
        with pytest.raises(UsageError, match=f"coverage: {bad} is not allowed"):
            MarkerRenderer(bad)


def test_intensity_is_the_grey_of_the_flow_frames() -> None:
    scene = np.zeros((2, 2, 3), np.uint8)
    scene[0, 0], scene[0, 1], scene[1, 0] = (255, 0, 0), (0, 255, 0), (0, 0, 255)
    scene[1, 1] = 77
    grey = IntensityRenderer().annotate(scene, result_of(blank()))
    assert grey is scene
    assert (grey == np.array([[29, 150], [76, 77]])[..., np.newaxis]).all()
