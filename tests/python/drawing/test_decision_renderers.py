# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What decisions are made by: blobs with numbers, the matrix, the vicinity grid."""

from typing import Any

import numpy as np
import pytest

from clips import Image
from fakes import Box, Detection, Grid, Match, result_of
from survtrack.drawing import BlobRenderer, MatrixRenderer, VicinityRenderer
from survtrack.drawing.matrix import STRONG, TAKEN
from survtrack.errors import UsageError

BELIEFS = np.array([[0.0, 1.0, 0.0], [0.4, 0.0, 0.6]])


def blank(height: int = 240, width: int = 320) -> Image:
    return np.full((height, width, 3), 100, np.uint8)


def believed(beliefs: np.ndarray = BELIEFS, **more: Any) -> Any:
    rows = len(beliefs)
    return result_of(
        blank(),
        matrix_track_ids=list(range(3, 3 + rows)),
        costs=1 - beliefs[:, :-1],
        beliefs=beliefs,
        **more,
    )


def pixels(scene: Image, color: tuple[int, int, int]) -> np.ndarray:
    return (scene == color).all(axis=2)


def test_blobs_are_outlined_in_white() -> None:
    scene = blank()
    result = result_of(blank(), detections=[Detection(Box(50, 60, 40, 30))])
    assert BlobRenderer().annotate(scene, result) is scene
    assert pixels(scene, (255, 255, 255))[90, 50:91].all()


def test_an_assigned_pair_is_framed_and_a_sure_one_is_green() -> None:
    scene = MatrixRenderer().annotate(blank(), believed(matches=[Match(0, 1)]))
    assert pixels(scene, TAKEN).any()
    assert pixels(scene, STRONG).any()
    free = MatrixRenderer().annotate(blank(), believed(matches=[Match(0, 1, assigned=False)]))
    assert not pixels(free, TAKEN).any()


def test_costs_are_shown_without_beliefs_and_refused_pairs_too() -> None:
    result = result_of(blank(), matrix_track_ids=[1, 0], costs=np.array([[0.5], [np.inf]]))
    shown = MatrixRenderer().annotate(blank(), result)
    assert not pixels(shown, STRONG).any()
    other = result_of(blank(), matrix_track_ids=[1, 0], costs=np.array([[0.5], [0.7]]))
    assert (shown != MatrixRenderer().annotate(blank(), other)).any()


@pytest.mark.parametrize("shape", [(1, 1), (20, 20), (60, 80), (240, 320)])
def test_what_does_not_fit_is_left_out(shape: tuple[int, int]) -> None:
    many = believed(np.full((40, 31), 1 / 31))
    scene = MatrixRenderer().annotate(blank(*shape), many)
    assert scene.shape == (*shape, 3)


def test_a_frame_without_tracks_and_blobs_has_an_empty_table() -> None:
    scene = MatrixRenderer().annotate(blank(), result_of(blank(), costs=np.zeros((0, 0))))
    assert not pixels(scene, STRONG).any()
    assert not pixels(scene, TAKEN).any()
    assert (np.ptp(scene, axis=2) == 0).all()  # grey: no cell is coloured


def test_active_cells_are_shaded_and_the_others_are_not() -> None:
    active = np.zeros((8, 11), bool)
    active[2, 3] = True
    scene = blank()
    grid = Grid(30, np.full((8, 11), 7.0), active)
    VicinityRenderer().annotate(scene, result_of(blank(), vicinity={-1: grid}))
    assert (scene[65:75, 92:95] != 100).all(axis=2).all()
    assert (scene[1:30, 1:30] == 100).all()


def test_the_grid_of_a_class_is_asked_for_by_its_number() -> None:
    grid = Grid(30, np.full((8, 11), 7.0), np.ones((8, 11), bool))
    result = result_of(blank(), vicinity={2: grid})
    assert (VicinityRenderer(2).annotate(blank(), result) != 100).any()
    with pytest.raises(UsageError, match="nothing of class -1 was seen"):
        VicinityRenderer().annotate(blank(), result)
