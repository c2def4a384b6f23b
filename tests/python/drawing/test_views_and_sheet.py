# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Views alone and side by side, and several pictures in one."""

import numpy as np
import pytest

from clips import walking_square
from fakes import Box, Detection, Event, Grid, Kind, Match, Place, Track, result_of
from survtrack.drawing import (
    VIEW_NAMES,
    BoxRenderer,
    FlowColorRenderer,
    FlowRenderer,
    IntensityRenderer,
    LostContactRenderer,
    MarkerRenderer,
    Views,
    as_scene,
    contact_sheet,
)
from survtrack.drawing.scene import draw_label
from survtrack.errors import UsageError

FRAME = walking_square(3, width=160, height=120, side=30)[2]
RESULT = result_of(
    FRAME,
    2,
    Track(1, Box(8, 40, 30, 30)),
    background=np.full_like(FRAME, 77),
    detections=[Detection(Box(8, 40, 30, 30))],
    matches=[Match(0, 0)],
    costs=np.array([[0.25]]),
    matrix_track_ids=[1],
    vicinity={-1: Grid(30, np.full((4, 6), 3.0), np.arange(24).reshape(4, 6) % 2 == 0)},
    flow=np.full((120, 160, 2), 0.5, np.float32),
)
# Below the captions, above the bottom edge.
INSIDE = slice(30, 118)


def test_a_single_view_has_the_size_of_the_frame() -> None:
    for name in VIEW_NAMES:
        assert Views([name])(FRAME, RESULT).shape == FRAME.shape


def test_each_view_shows_what_it_says() -> None:
    assert np.array_equal(Views(["frame"])(FRAME, RESULT)[INSIDE], FRAME[INSIDE])
    assert (Views(["background"])(FRAME, RESULT)[INSIDE] == 77).all()
    mask = Views(["mask"])(FRAME, RESULT)[INSIDE]
    assert np.array_equal(mask[..., 0], RESULT.mask[INSIDE])
    assert set(np.unique(mask)) == {0, 255}
    tracks = Views(["tracks"])(FRAME, RESULT)
    changed = (tracks != FRAME).any(axis=2)[INSIDE]
    assert 20 < changed.sum() < 0.3 * changed.size


def test_the_views_of_a_flow_tracker_are_those_of_their_renderers() -> None:
    ended = Event(Kind.track_ended, 2, 0.2, 4, position=(80.0, 60.0), place=Place.open)
    result = result_of(FRAME, 2, Track(1, Box(8, 40, 30, 30)), events=[ended], flow=RESULT.flow)
    for name, renderer in (
        ("intensity", IntensityRenderer()),
        ("flow", FlowRenderer()),
        ("flow_color", FlowColorRenderer()),
        ("boxes", BoxRenderer()),
        ("markers", MarkerRenderer()),
        ("covariance", MarkerRenderer(0.95)),
        ("lost_contacts", LostContactRenderer()),
    ):
        alone = renderer.annotate(as_scene(FRAME), result)
        assert (alone != FRAME).any()
        assert np.array_equal(Views([name])(FRAME, result)[INSIDE], alone[INSIDE])


def test_four_views_are_two_by_two_with_their_names() -> None:
    names = ["intensity", "flow", "boxes", "markers"]
    picture = Views(names)(FRAME, RESULT)
    assert picture.shape == (240, 320, 3)
    for k, name in enumerate(names):
        top, left = k // 2 * 120, k % 2 * 160
        expected = np.zeros((120, 160, 3), np.uint8)
        text = f"{name}: frame 3, 0.20 s" if k == 0 else name
        draw_label(expected, text, (0, 0), (0, 0, 0))
        corner = picture[top : top + 12, left : left + 10]
        assert np.array_equal(corner, expected[:12, :10])
    flow_next = Views(["flow_color", *names[:3]])(FRAME, RESULT)
    assert np.array_equal(flow_next[20:120, 160:], picture[20:120, :160])


def test_arrows_keep_to_the_threshold_that_they_are_given() -> None:
    shown, hidden = (Views(["flow"], limit)(FRAME, RESULT)[30:100] for limit in (0.6, 0.8))
    assert (shown != FRAME[30:100]).any()  # 0.71 px everywhere
    assert (hidden == FRAME[30:100]).all()
    with pytest.raises(UsageError, match="threshold_px: -1 is not allowed"):
        Views(["flow"], -1)


@pytest.mark.parametrize("shape", [(16, 16, 3), (16, 16), (17, 90, 3)])
def test_all_views_of_a_small_frame_without_flow(shape: tuple[int, ...]) -> None:
    frame = np.full(shape, 90, np.uint8)
    names = ["intensity", "flow", "flow_color", "boxes", "markers", "covariance", "lost_contacts"]
    result = result_of(frame, 0, Track(1, Box(2, 2, 8, 8)))
    one, other = Views(names)(frame, result), Views(names)(frame, result)
    assert one.shape == (4 * shape[0], 2 * shape[1], 3)
    assert np.array_equal(one, other)
    assert (frame == 90).all()


def test_drawing_leaves_the_frame_and_the_result_alone() -> None:
    frame, mask = FRAME.copy(), RESULT.mask.copy()
    Views(VIEW_NAMES)(FRAME, RESULT)
    assert np.array_equal(frame, FRAME)
    assert np.array_equal(mask, RESULT.mask)
    assert (RESULT.background == 77).all()


@pytest.mark.parametrize(
    ("count", "columns", "rows"), [(1, 1, 1), (2, 2, 1), (3, 3, 1), (4, 2, 2), (7, 2, 4)]
)
def test_views_stand_side_by_side(count: int, columns: int, rows: int) -> None:
    names = VIEW_NAMES[:count]
    picture = Views(names)(FRAME, RESULT)
    assert picture.shape == (120 * rows, 160 * columns, 3)
    for k, name in enumerate(names):
        top, left = k // columns * 120, k % columns * 160
        alone = Views([name])(FRAME, RESULT)
        shown = picture[top : top + 120, left : left + 160]
        assert np.array_equal(shown[INSIDE], alone[INSIDE])


def test_grey_frames_are_drawn_on_in_colour() -> None:
    grey = np.ascontiguousarray(FRAME[..., 1])
    picture = Views()(grey, result_of(grey, 0, Track(1, Box(8, 40, 30, 30))))
    assert picture.shape == (120, 160, 3)
    assert (picture[..., 0] != picture[..., 2]).any()


def test_tiny_frames_can_be_drawn_on() -> None:
    dot = np.zeros((1, 1, 3), np.uint8)
    assert Views(["tracks", "mask"])(dot, result_of(dot, 0, Track(1, Box(0, 0, 1, 1)))).shape == (
        (1, 2, 3)
    )


def test_what_cannot_be_shown_is_named() -> None:
    with pytest.raises(UsageError, match='views: unknown "trakcs"; one of: frame, mask'):
        Views(["trakcs"])
    with pytest.raises(UsageError, match=r"views: \['mask', 'mask'\] is not allowed"):
        Views(["mask", "mask"])
    with pytest.raises(UsageError, match=r"views: \[\] is not allowed"):
        Views([])
    with pytest.raises(UsageError, match="background cannot be shown"):
        Views(["background"])(FRAME, result_of(FRAME))
    with pytest.raises(UsageError, match="vicinity: cannot be shown"):
        Views(["vicinity"])(FRAME, result_of(FRAME))
    with pytest.raises(UsageError, match=r"matrix: .* outputs.cost_matrix is false"):
        Views(["matrix"])(FRAME, result_of(FRAME, matrix_track_ids=[1]))


def test_a_contact_sheet_has_rows_of_pictures() -> None:
    pictures = [np.full((20, 30, 3), 10 * k, np.uint8) for k in range(1, 6)]
    sheet = contact_sheet(pictures)
    assert sheet.shape == (44, 98, 3)
    for k, picture in enumerate(pictures):
        top, left = k // 3 * 24, k % 3 * 34
        assert np.array_equal(sheet[top : top + 20, left : left + 30], picture)
    assert len(np.unique(sheet[24:, 68:])) == 1
    assert contact_sheet(pictures[:2], columns=3).shape == (20, 64, 3)
    assert contact_sheet([picture[..., 0] for picture in pictures], columns=1).shape == (
        (116, 30, 3)
    )


def test_a_contact_sheet_of_what_does_not_fit() -> None:
    with pytest.raises(UsageError, match="at least one is needed"):
        contact_sheet([])
    with pytest.raises(UsageError, match="sizes differ"):
        contact_sheet([FRAME, FRAME[:50]])
    with pytest.raises(UsageError, match="columns: 0 is not allowed"):
        contact_sheet([FRAME], columns=0)
