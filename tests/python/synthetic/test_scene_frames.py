# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Frames of a scene: what they show, that they are the same again, and that they are a source."""

import numpy as np
import pytest
from hypothesis import given
from worlds import quick, scenes

import survtrack
from survtrack.errors import UsageError
from survtrack.evaluation import Boxes, evaluate_tracks
from survtrack.runner import results, run
from survtrack.scenes import Body, Conditions, Scene, SceneObject, make_scene, steady
from survtrack.scenes import Path as Way
from survtrack.sources import Prefetch, Selection, Source

KINDS = ("video", "grey", "mask")


def frames_of(scene: Scene, kind: str = "video") -> list[np.ndarray]:
    return [frame for _, _, frame in scene.frames(kind)]


@quick
@given(scenes(noise_sigma=3, far_scale=0.7, occluders=((40, 0, 9.5, 64),)))
def test_the_same_scene_gives_the_same_bytes(scene: Scene) -> None:
    for kind in KINDS:
        for one, other in zip(frames_of(scene, kind), frames_of(scene, kind), strict=True):
            assert one.tobytes() == other.tobytes()


def test_another_seed_gives_other_bytes() -> None:
    one, other = (frames_of(make_scene("constant", seed=seed)) for seed in (1, 2))
    assert not np.array_equal(one[0], other[0])


@pytest.mark.parametrize("kind", KINDS)
def test_a_frame_is_the_same_whichever_are_asked_for(kind: str) -> None:
    scene = make_scene("crossing", noise_sigma=5, frame_count=120)
    whole = list(scene.frames(kind))
    some = list(scene.frames(kind, selection=Selection(start=70, step=3, limit=4)))
    assert [index for index, _, _ in some] == [70, 73, 76, 79]
    for index, time_s, frame in some:
        assert time_s == whole[index][1] == index / 25
        assert np.array_equal(frame, whole[index][2])


def test_shapes_and_kinds() -> None:
    scene = make_scene("constant", size=(61, 47), frame_count=60)
    shapes = {kind: frames_of(scene, kind)[0].shape for kind in KINDS}
    assert shapes == {"video": (47, 61, 3), "grey": (47, 61), "mask": (47, 61)}
    masks = frames_of(scene, "mask")
    assert all(frame.dtype == np.uint8 for kind in KINDS for frame in frames_of(scene, kind))
    assert set(np.unique(masks)) == {0, 255}
    with pytest.raises(UsageError, match='kind: unknown "depth"; one of: video, grey, mask'):
        scene.frames("depth")
    with pytest.raises(UsageError, match="start: 60 skips all 60 frames of scene constant"):
        scene.frames(selection=Selection(start=60))


def test_grey_is_the_luminance_of_the_video() -> None:
    scene = make_scene("pillar", frame_count=60)
    color = frames_of(scene)[50] @ np.array([0.114, 0.587, 0.299])
    assert np.abs(color - frames_of(scene, "grey")[50]).max() <= 1.01


def test_the_video_shows_objects_where_the_mask_is() -> None:
    scene = make_scene("crowd", contacts=8, occluders=((100, 50, 60, 80),))
    ground = frames_of(Scene("empty", (), scene.size, 1, conditions=scene.conditions))[0]
    for frame, mask in zip(frames_of(scene), frames_of(scene, "mask"), strict=True):
        different = np.abs(frame.astype(int) - ground).max(axis=2) > 40
        wrong = different != (mask > 0)
        # Only edges differ: pixels that are covered in part.
        assert np.count_nonzero(wrong) <= 0.15 * max(np.count_nonzero(mask), 1)
        assert np.array_equal(frame[50:130, 100:160], ground[50:130, 100:160])


def drifting(speed: float, **conditions: float) -> Scene:
    """An ellipse that moves `speed` px a frame."""
    thing = SceneObject(1, Body("ellipse", 30, 24), Way((30, 32)), steady(speed * 10))
    return Scene("drifting", (thing,), (96, 64), 9, 10.0, 3, Conditions(**conditions))


def test_textures_move_with_their_objects_by_parts_of_a_pixel() -> None:
    inner = np.s_[24:40, 22:38]
    quarter, whole = frames_of(drifting(0.25)), frames_of(drifting(1.0))
    assert np.array_equal(quarter[4], whole[1])
    assert np.array_equal(whole[3][24:40, 25:41], whole[0][inner])
    between = quarter[2][inner].astype(float)
    mean = (quarter[0][inner].astype(float) + quarter[4][inner]) / 2
    assert np.abs(between - mean).max() < 6
    assert whole[0][inner].std(axis=(0, 1)).min() > 1


def test_objects_differ_from_the_ground_everywhere() -> None:
    for seed in range(20):
        scene = make_scene("constant", seed=seed, enter_s=-2.0, frame_count=1)
        ground = frames_of(Scene("empty", (), scene.size, 1, seed=seed))[0].astype(int)
        frame, mask = frames_of(scene)[0], frames_of(scene, "mask")[0]
        edge = np.pad(mask == 0, 1, constant_values=True)
        inner = (mask > 0) & ~(edge[:-2, 1:-1] | edge[2:, 1:-1] | edge[1:-1, :-2] | edge[1:-1, 2:])
        assert np.abs(frame - ground)[inner].min(initial=255) >= 10


def test_noise_has_its_sigma_and_is_new_in_every_frame() -> None:
    clean, noisy = frames_of(drifting(0)), frames_of(drifting(0, noise_sigma=6))
    noise = [a.astype(float) - b for a, b in zip(noisy, clean, strict=True)]
    assert np.std(noise) == pytest.approx(6, rel=0.05)
    assert abs(np.mean(noise)) < 0.1
    assert abs(np.corrcoef(noise[0].ravel(), noise[1].ravel())[0, 1]) < 0.05
    assert abs(np.corrcoef(noise[0][..., 0].ravel(), noise[0][..., 1].ravel())[0, 1]) < 0.05


def test_light_fades_or_is_switched() -> None:
    def levels(**light: float) -> list[float]:
        bright = frames_of(drifting(0))[0].mean()
        return [frame.mean() / bright for frame in frames_of(drifting(0, **light))]

    assert levels(light_gain=0.5, light_at_s=0.4) == pytest.approx([1] * 4 + [0.5] * 5, abs=0.01)
    fading = [1, 1, 1, 0.875, 0.75, 0.625, 0.5, 0.5, 0.5]
    faded = levels(light_gain=0.5, light_at_s=0.2, light_over_s=0.4)
    assert faded == pytest.approx(fading, abs=0.01)
    assert max(frames_of(drifting(0, light_gain=9, light_at_s=0))[0].ravel()) == 255


def test_objects_grow_towards_the_camera() -> None:
    scene = make_scene("perspective", contacts=1)
    near = scene.truth()
    whole = near.outside == 0
    heights = near.boxes[whole, 3]
    assert (np.diff(heights) >= -1).all() and heights[-1] > 2 * heights[0]
    assert (np.diff(near.velocities_px_per_s[:, 1]) > 0).all()


def test_it_is_a_source_for_the_runner() -> None:
    scene = make_scene("constant", noise_sigma=2)
    source: Source = scene.frames()
    assert (source.name, source.size, source.fps) == ("scene constant", (320, 240), 25.0)
    assert (source.frame_count_declared, source.endless, source.file_name(3)) == (200, False, None)
    summary = run(source, survtrack.Pipeline(survtrack.preset("survtrack")), [])
    summary.raise_error()
    assert (summary.frames, summary.last_index, len(summary.track_ids)) == (200, 199, 1)
    with Prefetch(source) as ahead:
        assert sum(1 for _ in ahead) == 200


def test_a_tracker_is_scored_against_the_truth() -> None:
    scene = make_scene("constant", contacts=3, noise_sigma=2)
    rows = [
        (result.index + 1, track.id, track.box.x, track.box.y, track.box.width, track.box.height)
        for result in results(scene.frames(), survtrack.Pipeline(survtrack.preset("survtrack")))
        for track in result.tracks
        if track.reported
    ]
    table = np.array(rows)
    found = Boxes(table[:, 0], table[:, 1], table[:, 2:])
    scores = evaluate_tracks(scene.truth().to_boxes(), found)
    assert scores.idf1 > 80
