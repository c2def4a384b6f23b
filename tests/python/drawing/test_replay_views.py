# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Replays show where things were: over the camera's picture, and from above at scale."""

from typing import Any

import numpy as np
import pytest

from clips import Image
from survtrack import Box, RegionKind, TrackStatus
from survtrack.drawing import color_of_id
from survtrack.drawing.paper import lines_between, nice_step, plain_ground
from survtrack.drawing.plan import Extent, PlanView
from survtrack.drawing.regions import COLORS
from survtrack.drawing.replay import FILTERED, MEASURED, OverView
from survtrack.errors import InputError
from survtrack.replay import GroundMap, StreamFrame, StreamTrack, predicted
from survtrack.replay.filling import Shown
from track_streams import region

SIZE = (320, 240)


def track(x: float, y: float, track_id: int = 1, **more: Any) -> StreamTrack:
    """20 x 40 px about (x, y), known to two px."""
    values: dict[str, Any] = {
        "id": track_id,
        "status": TrackStatus.confirmed,
        "box": Box(x - 10, y - 20, 20, 40),
        "position": (x, y),
        "velocity_px_per_s": (50.0, 0.0),
        "covariance_px2": (4.0, 0.0, 4.0),
        "rate_covariance": (100.0, 0.0, 100.0),
    }
    return StreamTrack(**{**values, **more})


def shown(*tracks: StreamTrack, then: tuple[StreamTrack, ...] = (), k: int = 0) -> Shown:
    return Shown(StreamFrame(k, k / 10, tracks), StreamFrame(k + 1, (k + 1) / 10, then))


def pixels(scene: Image, color: tuple[int, int, int]) -> np.ndarray:
    """(x, y) of all pixels of a colour that are not in the captions' rows."""
    found = np.argwhere((scene == color).all(axis=2))[:, ::-1]
    return found[(found[:, 1] > 20) & (found[:, 1] < scene.shape[0] - 20)]


def test_a_box_is_blue_where_it_was_and_red_where_it_is_measured_next() -> None:
    next_one = track(170, 120, measured=Box(165, 95, 21, 41))
    scene = OverView(SIZE)(shown(track(160, 120), then=(next_one,)))
    assert scene.shape == (240, 320, 3)
    blue, red = pixels(scene, FILTERED), pixels(scene, MEASURED)
    assert (blue.min(axis=0).tolist(), blue.max(axis=0).tolist()) == ([150, 100], [170, 140])
    assert (red.min(axis=0).tolist(), red.max(axis=0).tolist()) == ([165, 95], [186, 136])


def test_without_a_next_measurement_nothing_is_red() -> None:
    others = track(170, 120, 2, measured=Box(165, 95, 21, 41))
    for following in ((), (track(170, 120),), (others,)):
        scene = OverView(SIZE)(shown(track(160, 120), then=following))
        assert len(pixels(scene, FILTERED)) and not len(pixels(scene, MEASURED))
    assert not len(pixels(OverView(SIZE)(Shown(StreamFrame(0, 0.0), None)), FILTERED))


def test_regions_of_the_next_frame_are_magenta_and_those_of_newcomers_orange() -> None:
    read = (
        region(RegionKind.acquisition, 0, 30, 320, 20),
        region(RegionKind.predicted, 140, 90, 60, 70, 1),
        region(RegionKind.refresh, 0, 200, 320, 15),
    )
    frame = StreamFrame(0, 0.0, (track(160, 120),))
    scene = OverView(SIZE)(Shown(frame, StreamFrame(1, 0.1, regions=read)))
    magenta, orange = (pixels(scene, COLORS[kind]) for kind in ("predicted", "acquisition"))
    magenta = magenta[magenta[:, 1] < 200]  # above the caption
    assert (magenta.min(axis=0).tolist(), magenta.max(axis=0).tolist()) == ([140, 90], [199, 159])
    assert 230 < len(magenta) <= 2 * 60 + 2 * 68  # one px wide; the id's label is over it
    assert (orange.min(axis=0).tolist(), orange.max(axis=0).tolist()) == ([0, 30], [319, 49])
    assert (scene[200] == COLORS["refresh"]).all(axis=1).sum() < 20, "the strip is left out"
    looked_at = Shown(StreamFrame(0, 0.0, (track(160, 120),), regions=read), StreamFrame(1, 0.1))
    assert not len(pixels(OverView(SIZE)(looked_at), COLORS["predicted"])), "of the next frame only"


def test_what_is_lost_or_predicted_is_dashed() -> None:
    seen = shown(track(160, 120))
    lost = shown(track(160, 120, status=TrackStatus.lost))
    later = Shown(predicted(seen.frame, 0.2), None)
    counts = [len(pixels(OverView(SIZE)(each), FILTERED)) for each in (seen, lost, later)]
    assert counts[1] < 0.8 * counts[0] and counts[2] < 0.8 * counts[0]
    moved = pixels(OverView(SIZE)(later), FILTERED)
    assert (moved[:, 0].min(), moved[:, 0].max()) == (160, 180)


def test_a_prediction_is_less_certain_and_says_so() -> None:
    frame = StreamFrame(0, 0.0, (track(160, 120, velocity_px_per_s=(0.0, 0.0)),))
    ends = []
    for time_s in (0.0, 0.6, 1.2):
        at = predicted(frame, time_s)
        picture = OverView(SIZE)(Shown(at, None))
        blank = OverView(SIZE)(Shown(StreamFrame(0, time_s, (), at.predicted_s), None))
        row = (picture[120] != blank[120]).any(axis=1)
        row[[149, 150, 151, 169, 170, 171]] = False  # the box
        ends.append(int(np.flatnonzero(row).max()))
    # 2.448 standard deviations: variances of 4 px^2 and of 100 px^2/s^2 times t^2.
    wanted = [160 + 2.448 * (4 + 100 * time_s**2) ** 0.5 for time_s in (0.0, 0.6, 1.2)]
    assert ends == pytest.approx(wanted, abs=1.6)


def test_trails_go_through_recorded_places_only() -> None:
    view = OverView(SIZE)
    frames = [StreamFrame(k, k / 10, (track(40 + 20 * k, 120),)) for k in range(8)]
    for frame in frames:
        scene = view(Shown(frame, None))
    color = np.array(color_of_id(1))
    near = (np.abs(scene[120, 42:168].astype(int) - color) < 60).all(axis=1)
    assert near.mean() > 0.9
    astray = predicted(frames[-1], 1.0)
    view(Shown(astray, None))
    back = view(Shown(StreamFrame(9, 1.1, (track(180, 80),)), None))
    assert not (back[115:, 200:310] == color_of_id(1)).all(axis=2).any()


def test_a_background_is_under_it_at_the_frames_size() -> None:
    background = np.full((480, 640, 3), (0, 200, 0), np.uint8)
    scene = OverView(SIZE, background)(shown(track(160, 120)))
    assert (scene[200, 20] == (0, 120, 0)).all() and scene.shape == (240, 320, 3)
    grey = OverView(SIZE, np.full((240, 320), 100, np.uint8))(shown())
    assert (grey[200, 20] == 60).all()


def test_a_background_of_another_form_is_refused() -> None:
    with pytest.raises(InputError, match="the background is 640x360 px, the stream's frames are"):
        OverView(SIZE, np.zeros((360, 640, 3), np.uint8))


@pytest.mark.parametrize("size", [(1, 1), (2, 900), (64, 48), (5000, 20)])
@pytest.mark.parametrize("value", [0.0, 1e-300, 7e10, -7e10])
def test_any_state_can_be_drawn(size: tuple[int, int], value: float) -> None:
    there = track(value, -value, covariance_px2=(value * value, 0.0, 2.0**80))
    box = Box(value, value, abs(value), abs(value))
    each = shown(there, track(1, 1, 2, box=box), then=(track(3, 3, 2, measured=box),))
    read = (region(RegionKind.predicted, value, 0, max(abs(value), 1e-300), 1e10),)
    each = Shown(each.frame, StreamFrame(1, 0.1, regions=read))
    for view in (OverView(size), plan_of(size, each.frame)):
        assert (view(each) == view(each)).all()


def plan_of(size: tuple[int, int], *frames: StreamFrame) -> PlanView:
    ground = GroundMap.of_pixels(*size)
    extent = Extent(ground)
    for frame in frames:
        extent.add(frame)
    return PlanView(ground, extent)


IMAGE = [[60, 220], [260, 220], [200, 120], [120, 120]]
GROUND = [[0, 0], [10, 0], [10, 20], [0, 20]]


def street_view() -> PlanView:
    ground = GroundMap.of_points(IMAGE, GROUND)
    return PlanView(ground, Extent(ground))


def standing(x: float, y: float, track_id: int = 1, **more: Any) -> StreamTrack:
    """A track whose foot is at (x, y)."""
    return track(x, y - 20, track_id, **more)


def center(scene: Image, color: tuple[int, int, int]) -> np.ndarray:
    found: np.ndarray = pixels(scene, color).mean(axis=0)
    return found


def test_feet_are_at_scale_on_the_plan_and_far_is_up() -> None:
    view = street_view()
    corners = [center(view(shown(standing(*corner))), FILTERED) for corner in IMAGE]
    near, right, far, left = corners
    assert far[1] < near[1] and right[0] > near[0]
    px_a_metre = (right[0] - near[0]) / 10
    assert (near[1] - left[1]) / 20 == pytest.approx(px_a_metre, rel=0.01)
    assert abs(left[0] - near[0]) < 1 and abs(right[1] - near[1]) < 1


def test_the_next_measured_foot_is_red() -> None:
    next_one = standing(180, 200, measured=Box(200, 150, 20, 30))
    view = street_view()
    red = center(view(shown(standing(100, 200), then=(next_one,))), MEASURED)
    alone = center(view(shown(standing(210, 180))), FILTERED)
    assert np.abs(red - alone).max() < 1


def test_beyond_the_horizon_and_the_plan_nothing_is_drawn() -> None:
    view = street_view()
    blank = view(shown())
    for foot in ((160, 20), (160, 5000), (-9000, 220)):
        assert (view(shown(standing(*foot))) == blank).all()


def test_what_is_lost_is_a_ring() -> None:
    dot = street_view()(shown(standing(160, 180)))
    ring = street_view()(shown(standing(160, 180, status=TrackStatus.lost)))
    x, y = center(dot, FILTERED).round().astype(int)
    assert (dot[y, x] == FILTERED).all() and not (ring[y, x] == FILTERED).all()


def test_pixels_have_a_plan_too_and_down_is_down() -> None:
    high, low = standing(60, 60), standing(60, 220)
    view = plan_of(SIZE, StreamFrame(0, 0.0, (high, low)))
    assert center(view(shown(high)), FILTERED)[1] < center(view(shown(low)), FILTERED)[1]


def test_tracks_widen_a_plan_by_its_own_size_at_most() -> None:
    ground = GroundMap.of_points(IMAGE, GROUND)
    extent = Extent(ground)
    extent.add(StreamFrame(0, 0.0, (standing(160, 240), standing(160, 89), standing(160, 3))))
    (left, low), (right, high) = extent.box()
    assert left < 0 and right > 10 and right - left < 15
    assert low < -1 and high == pytest.approx(40 + 0.05 * (high - low) / 1.1, abs=0.2)


@pytest.mark.parametrize(
    ("extent", "step"), [(8, 1), (7.9, 0.5), (768, 50), (320, 20), (0.9, 0.1), (1e6, 1e5), (41, 5)]
)
def test_steps_are_round_numbers(extent: float, step: float) -> None:
    assert nice_step(extent) == pytest.approx(step)


def test_lines_are_the_multiples_within() -> None:
    assert lines_between(-1.5, 3, 1) == [-1, 0, 1, 2, 3]
    assert lines_between(0.1, 0.9, 1) == []


def test_the_plain_ground_has_a_grid_of_its_pixels() -> None:
    scene = plain_ground((320, 240))
    assert (scene[10, 20] == scene[110, 200]).all()
    assert not (scene[10, 20] == scene[10, 21]).all()
