# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Boxes, lost markers and trails are where the tracks are."""

import numpy as np
import pytest

from clips import Image
from fakes import Box, Status, Track, result_of
from survtrack.drawing import BoxRenderer, TrailRenderer, color_of_id
from survtrack.errors import UsageError


def blank(height: int = 120, width: int = 160) -> Image:
    return np.zeros((height, width, 3), np.uint8)


def drawn_in(scene: Image, track_id: int) -> np.ndarray:
    return (scene == color_of_id(track_id)).all(axis=2)


def test_a_box_outlines_its_track_in_its_colour() -> None:
    scene = blank()
    result = result_of(blank(), 0, Track(3, Box(40.2, 50.4, 30, 40)))
    assert BoxRenderer().annotate(scene, result) is scene
    outline = drawn_in(scene, 3)
    assert outline[50, 40:71].all()
    assert outline[90, 40:71].all()
    assert outline[50:91, 40].all()
    assert outline[50:91, 70].all()
    assert not outline[52:89, 42:69].any()


def test_a_lost_track_is_dashed_and_marked() -> None:
    kept, lost = blank(), blank()
    box = Box(40, 50, 60, 60)
    BoxRenderer().annotate(kept, result_of(blank(), 0, Track(3, box)))
    BoxRenderer().annotate(lost, result_of(blank(), 0, Track(3, box, Status.lost)))
    sides = drawn_in(lost, 3)[110, 40:101], drawn_in(lost, 3)[50:111, 100]
    assert drawn_in(kept, 3)[110, 40:101].all()
    assert all(0.3 < side.mean() < 0.8 for side in sides)
    # Its label has one character more.
    widths = [np.flatnonzero(scene[45].any(axis=1)).size for scene in (kept, lost)]
    assert widths[1] > widths[0] > 0


def test_tracks_that_are_not_reported_are_not_drawn() -> None:
    track = Track(1, Box(40, 50, 30, 40), Status.tentative, reported=False)
    for renderer in (BoxRenderer(), TrailRenderer()):
        assert not renderer.annotate(blank(), result_of(blank(), 0, track)).any()


@pytest.mark.parametrize(
    "box",
    [
        Box(-30, -30, 50, 50),
        Box(150, 110, 500, 500),
        Box(-1e12, 3, 2e12, 4),
        Box(float("nan"), 3, 2, 4),
        Box(5, 5, 0, 0),
    ],
)
def test_boxes_beyond_the_picture_do_no_harm(box: Box) -> None:
    for status in (Status.confirmed, Status.lost):
        scene = BoxRenderer().annotate(blank(), result_of(blank(), 0, Track(1, box, status)))
        assert scene.any()


def test_a_trail_goes_through_the_last_positions() -> None:
    renderer = TrailRenderer(length=10)
    for k in range(30):
        scene = renderer.annotate(blank(), result_of(blank(), k, Track(5, Box(4 * k, 50, 10, 20))))
    # Centres are at x = 4 k + 5, y = 60.
    columns = np.flatnonzero(scene[60].any(axis=1))
    assert columns.min() == pytest.approx(4 * 20 + 5, abs=2)
    assert columns.max() == pytest.approx(4 * 29 + 5, abs=2)
    assert np.abs(np.subtract(scene[60, 110], color_of_id(5), dtype=int)).max() < 30
    assert not scene[70:].any()


def test_a_trail_may_lead_anywhere() -> None:
    """A kept contact is predicted for ever, and accelerates."""
    renderer = TrailRenderer()
    for x in (0, 2**40, -(2**60)):
        scene = renderer.annotate(blank(), result_of(blank(), 0, Track(5, Box(x, 50, 10, 20))))
    assert scene[60].any()


def test_a_track_that_went_away_leaves_no_trail_to_one_that_comes_back() -> None:
    renderer = TrailRenderer()
    renderer.annotate(blank(), result_of(blank(), 0, Track(5, Box(0, 50, 10, 20))))
    renderer.annotate(blank(), result_of(blank(), 1))
    scene = renderer.annotate(blank(), result_of(blank(), 2, Track(5, Box(100, 50, 10, 20))))
    assert not scene[:, :95].any()


def test_a_trail_needs_two_positions() -> None:
    with pytest.raises(UsageError, match="length: 1 positions is not allowed"):
        TrailRenderer(1)
