# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is said to be true of a scene, against the frames that it gives."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from worlds import FRAMES, SIZE, box_of, quick, scenes

from survtrack.errors import UsageError
from survtrack.scenes import Body, Conditions, Scene, SceneObject, make_scene, steady
from survtrack.scenes import Path as Way

PILLAR = (40.0, 0.0, 20.0, 64.0)


@quick
@given(scenes(most=1))
def test_the_box_of_a_lone_object_holds_exactly_its_pixels(scene: Scene) -> None:
    truth = scene.truth()
    for index, _, mask in scene.frames("mask"):
        [box] = truth.at(index).boxes
        if mask.any():
            assert tuple(box) == box_of(mask)
        else:
            assert tuple(box[2:]) == (0, 0)


@quick
@given(scenes(most=1))
def test_the_centroid_of_a_lone_object_is_within_half_a_pixel(scene: Scene) -> None:
    truth = scene.truth()
    for index, _, mask in scene.frames("mask"):
        row = truth.at(index)
        if row.outside[0] == 0:
            rows, columns = np.nonzero(mask)
            centroid = columns.mean() + 0.5, rows.mean() + 0.5
            assert np.abs(centroid - row.positions[0]).max() <= 0.5 + 1e-9


@quick
@given(scenes(occluders=(PILLAR,)))
def test_parts_add_up_and_visible_ones_are_the_mask(scene: Scene) -> None:
    truth = scene.truth()
    parts = np.stack([truth.visible, truth.occluded, truth.outside])
    assert parts.min() >= 0
    assert np.allclose(parts.sum(axis=0), 1)
    bodies = {thing.id: thing.body for thing in scene.objects}
    for index, _, mask in scene.frames("mask"):
        row = truth.at(index)
        pixels = [
            np.count_nonzero(bodies[id].silhouette(tuple(position)).values)
            for id, position in zip(row.ids, row.positions, strict=True)
        ]
        assert np.count_nonzero(mask) == pytest.approx(float(row.visible @ pixels))
        assert not mask[:, 40:60].any()


@quick
@given(scenes(far_scale=0.6))
def test_velocities_are_the_derivative_of_positions(scene: Scene) -> None:
    fine = 1000
    many = replace(scene, fps=scene.fps * fine, frame_count=(FRAMES - 1) * fine + 2)
    for motion, close in zip(scene.motions, many.motions, strict=True):
        here = np.arange(1, FRAMES) * fine
        quotient = close.view.positions[here + 1] - close.view.positions[here - 1]
        quotient *= many.fps / 2
        assert np.allclose(close.view.positions[here], motion.view.positions[1:])
        seen = motion.present[1:] & (motion.view.scales[1:] < 1.5)
        assert np.allclose(quotient[seen], motion.view.velocities_px_per_s[1:][seen], atol=0.5)


@quick
@given(scenes(far_scale=0.6, occluders=(PILLAR,)), st.floats(0, 1))
def test_boxes_are_valid_and_ids_stay(scene: Scene, min_visible: float) -> None:
    truth = scene.truth()
    order = list(zip(truth.indices.tolist(), truth.ids.tolist(), strict=True))
    assert order == sorted(set(order))
    assert set(truth.ids.tolist()) == {thing.id for thing in scene.objects}
    boxes = truth.to_boxes(min_visible)
    assert len(boxes) == np.count_nonzero(truth.outside < 1)
    assert np.array_equal(boxes.ignore, truth.visible[truth.outside < 1] < min_visible)
    edges = boxes.boxes[:, :2] + boxes.boxes[:, 2:]
    assert (boxes.boxes[:, :2] >= 0).all() and (edges <= SIZE).all()
    assert boxes.frames.tolist() == (truth.indices[truth.outside < 1] + 1).tolist()


def rolling(*, speed: float = 40.0, occluders: tuple = (), frames: int = 21) -> Scene:
    """A square of 20 px whose left edge is at -20 px in the first frame, 4 px a frame."""
    thing = SceneObject(7, Body("rectangle", 20, 20), Way((-10, 30)), steady(speed))
    return Scene("rolling", (thing,), SIZE, frames, 10.0, 0, Conditions(occluders=occluders))


def test_parts_at_the_border_and_at_a_pillar_by_hand() -> None:
    truth = rolling(occluders=((40, 0, 12, 64),)).truth()
    # Left edge 0 at frame 5; right edge 44 at frame 11; 60 at frame 15.
    assert truth.outside[:7].tolist() == [1, 0.8, 0.6, 0.4, 0.2, 0, 0]
    assert truth.occluded[9:19].tolist() == [0, 0, 0.2, 0.4, 0.6, 0.6, 0.6, 0.4, 0.2, 0]
    assert truth.boxes[2].tolist() == [0, 20, 8, 20]
    assert truth.boxes[14].tolist() == [36, 20, 20, 20]
    assert truth.velocities_px_per_s.tolist() == [[40, 0]] * 21
    assert truth.distances_px[5] == pytest.approx(20)


def test_the_later_of_two_objects_is_in_front() -> None:
    body = Body("rectangle", 10, 10)
    things = tuple(SceneObject(id, body, Way((x, 30)), steady(0)) for id, x in ((4, 20), (2, 25)))
    truth = Scene("pile", things, SIZE, 1).truth()
    assert truth.ids.tolist() == [2, 4]
    assert truth.visible.tolist() == [1, 0.5]


def test_the_nearer_of_two_objects_is_in_front() -> None:
    body = Body("rectangle", 10, 10)
    things = tuple(SceneObject(id, body, Way((48, y)), steady(0)) for id, y in ((1, 50), (2, 47)))
    near, far = Scene("pile", things, SIZE, 1, conditions=Conditions(far_scale=0.5)).truth().visible
    assert near == 1 > far


def test_a_hidden_object_keeps_its_box_and_is_not_scored() -> None:
    scene = make_scene("pillar", contacts=1)
    truth = scene.truth()
    hidden = truth.visible == 0
    behind = hidden & (truth.outside == 0)
    assert behind.any()
    assert (truth.boxes[behind, 2:] == (24, 40)).all(axis=1).any()
    boxes = truth.to_boxes()
    assert boxes.ignore[np.isin(boxes.frames - 1, truth.indices[behind])].all()
    with pytest.raises(UsageError, match="min_visible: 2"):
        truth.to_boxes(2)


def test_the_truth_is_read_only() -> None:
    truth = rolling().truth()
    with pytest.raises(ValueError, match="read-only"):
        truth.positions[0] = 0


def test_a_scene_without_objects_is_empty() -> None:
    scene = Scene("empty", (), SIZE, 3)
    assert len(scene.truth()) == len(scene.truth().to_boxes()) == 0
    assert not any(mask.any() for _, _, mask in scene.frames("mask"))
    assert [positions for _, _, positions in scene.measurements()] == [{}, {}, {}]


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"size": (0, 10)}, "size: width: 0 is not allowed; a whole number from 1"),
        ({"size": (10, 9.5)}, "size: height: 9.5"),
        ({"frame_count": 0}, "frame_count: 0"),
        ({"fps": 0.0}, "fps: 0 is not allowed; above 0"),
        ({"seed": -1}, "seed: -1"),
        ({"seed": 2**32}, "seed: 4294967296"),
        ({"conditions": Conditions(far_scale=0.05)}, "far_scale: 0.05 makes object 7 1 px small"),
        ({"conditions": Conditions(occluders=((200, 0, 9, 9),))}, "covers no pixel of the frame"),
        ({"frame_count": 1}, "object 7 is never in the frame"),
    ],
)
def test_scenes_that_are_none(values: dict, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        replace(rolling(), **values)


def test_an_id_belongs_to_one_object() -> None:
    scene = rolling()
    with pytest.raises(UsageError, match="id 7 is that of several"):
        replace(scene, objects=scene.objects * 2)
    with pytest.raises(UsageError, match="id: 0"):
        replace(scene.objects[0], id=0)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"noise_sigma": -1}, "noise_sigma: -1 is not allowed; at least 0 and at most 255"),
        ({"far_scale": 0}, "far_scale: 0 is not allowed; above 0 and at most 1"),
        ({"light_gain": float("inf")}, "light_gain: inf"),
        ({"light_over_s": -1}, "light_over_s: -1"),
        ({"occluders": ((1, 2, 3),)}, r"occluders: \(1, 2, 3\) is not allowed; left, top"),
        ({"occluders": ((1, 2, 0, 3),)}, "occluders: width: 0"),
        ({"occluders": ((1, "2", 1, 3),)}, "occluders: top: '2' is not a number"),
    ],
)
def test_conditions_that_are_none(values: dict, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        Conditions(**values)


def test_measurements_are_the_truth_and_noise_and_miss_what_is_not_seen() -> None:
    scene = make_scene("pillar", contacts=2)
    truth = scene.truth()
    seen = truth.visible >= 0.25
    expected = {
        (index, id): tuple(position)
        for index, id, position in zip(
            truth.indices[seen].tolist(),
            truth.ids[seen].tolist(),
            truth.positions[seen],
            strict=True,
        )
    }
    exact = list(scene.measurements())
    assert [index for index, _, _ in exact] == list(range(scene.frame_count))
    assert [time_s for _, time_s, _ in exact] == scene.times_s.tolist()
    flat = {(k, id): place for k, _, places in exact for id, place in places.items()}
    assert flat == expected
    noisy = {(k, i): p for k, _, places in scene.measurements(2.0) for i, p in places.items()}
    assert list(noisy) == list(flat)
    errors = np.array([np.subtract(noisy[key], flat[key]) for key in flat])
    assert errors.std() == pytest.approx(2, rel=0.15)
    assert abs(errors.mean()) < 0.3
    assert list(scene.measurements(2.0)) == list(scene.measurements(2.0))
    for bad in ({"sigma_px": -1}, {"min_visible": 0}):
        with pytest.raises(UsageError, match=next(iter(bad))):
            scene.measurements(**bad)


def test_one_more_object_changes_nothing_of_the_others() -> None:
    few, more = (make_scene("crowd", contacts=n, frame_count=80) for n in (3, 4))
    assert more.objects[:3] == few.objects
    for id in (1, 2, 3):
        assert np.array_equal(few.truth().of(id).positions, more.truth().of(id).positions)
    strict = list(few.measurements(1.0, min_visible=1.0))
    for (_, _, alone), (_, _, all_of_them) in zip(strict, more.measurements(1.0), strict=True):
        common = alone.keys() & all_of_them.keys()
        assert {id: alone[id] for id in common} == {id: all_of_them[id] for id in common}
    places, body = more.truth().of(4).positions, more.objects[3].body
    reach = (body.width_px / 2 + 1, body.height_px / 2 + 1)
    pixels = np.indices((240, 320))[::-1] + 0.5
    for (index, _, one), (_, _, other) in zip(few.frames(), more.frames(), strict=True):
        off = np.abs(pixels - places[index][:, None, None])
        apart = (off[0] > reach[0]) | (off[1] > reach[1])
        assert np.array_equal(one[apart], other[apart])
