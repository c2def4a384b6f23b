# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The ready-made scenes: each shows what it is for."""

from typing import Any

import numpy as np
import pytest

from documents import ROOT
from survtrack.errors import UsageError
from survtrack.scenes import Scene, make_scene, scene_names, scene_options, scene_summary
from survtrack.scenes.stage import lane


def speeds(scene: Scene, id: int = 1) -> np.ndarray:
    return np.hypot(*scene.truth().of(id).velocities_px_per_s.T)


def headings(scene: Scene, id: int = 1) -> np.ndarray:
    velocities = scene.truth().of(id).velocities_px_per_s
    return np.degrees(np.arctan2(velocities[:, 1], velocities[:, 0]))


@pytest.mark.parametrize("name", scene_names())
def test_every_scene_is_made_with_its_defaults(name: str) -> None:
    scene = make_scene(name)
    truth = scene.truth()
    assert (scene.name, scene.size, scene.frame_count) == (name, (320, 240), 200)
    assert set(truth.ids.tolist()) == {thing.id for thing in scene.objects}
    assert all(truth.of(thing.id).visible.max() == 1 for thing in scene.objects)
    assert len(scene_summary(name)) > 20
    assert make_scene(name, **scene_options(name)) == scene


@pytest.mark.parametrize("name", sorted(set(scene_names()) - {"crowd"}))
def test_a_background_can_be_learned_before_anybody_comes(name: str) -> None:
    truth = make_scene(name, far_scale=1.0).truth()
    assert truth.visible[truth.times_s < 0.9].sum() == 0


@pytest.mark.parametrize("contacts", [1, 3])
def test_the_three_motions_of_semko(contacts: int) -> None:
    """Semko 2007, V.B: one contact, and three at once."""
    same = make_scene("constant", contacts=contacts)
    bends = make_scene("varying_direction", contacts=contacts)
    surges = make_scene("varying_speed", contacts=contacts)
    for id in range(1, contacts + 1):
        assert np.allclose(speeds(same, id), 60) and np.ptp(np.abs(headings(same, id))) < 1e-9
        assert np.allclose(speeds(bends, id), 60) and np.ptp(np.cos(headings(bends, id))) > 0.1
        assert np.ptp(speeds(surges, id)) > 60 and np.ptp(np.abs(headings(surges, id))) < 1e-9
        for scene in (same, bends, surges):
            assert scene.truth().of(id).occluded.max() == 0


def test_two_meet_in_the_middle_and_one_is_in_front() -> None:
    truth = make_scene("crossing").truth()
    apart = np.hypot(*(truth.of(1).positions - truth.of(2).positions).T)
    meet = int(apart.argmin())
    assert apart[meet] < 2 and apart[0] > 100 < apart[-1]
    assert np.allclose(truth.at(meet).positions, (160, 120), atol=2)
    assert truth.at(meet).visible.tolist() == pytest.approx([0, 1], abs=0.1)


def test_the_pillar_hides_each_who_passes() -> None:
    truth = make_scene("pillar").truth()
    for id in (1, 2):
        behind = truth.of(id).occluded
        assert behind.max() == 1 and behind[0] == behind[-1] == 0
    assert make_scene("pillar", pillar_width_px=12).truth().occluded.max() < 0.7


def test_one_comes_back_after_the_time_away() -> None:
    truth = make_scene("reentry", away_s=2.0, frame_count=230).truth()
    inside = truth.times_s[truth.outside < 1]
    gaps = np.diff(inside)
    assert np.count_nonzero(gaps > 0.05) == 1
    assert gaps.max() == pytest.approx(2.0, abs=0.1)


def test_one_stops_in_the_open_and_stays() -> None:
    scene = make_scene("stopping")
    truth = scene.truth()
    stands = speeds(scene) == 0
    assert stands[-50:].all() and not stands[:90].any()
    assert np.allclose(truth.positions[stands], (160, 120))
    assert truth.visible[stands].min() == 1


def test_one_is_removed_between_two_frames() -> None:
    truth = make_scene("removal", removed_s=5.0).truth()
    assert truth.indices[-1] == 124
    assert truth.visible[-1] == 1


def test_cars_go_round_and_round() -> None:
    scene = make_scene("race", contacts=2, frame_count=500, size=(400, 300))
    for id in (1, 2):
        track = scene.objects[id - 1].path
        car = scene.truth().of(id)
        lap = track.length_px / 120 * 25
        assert car.visible.min() == 1
        assert np.hypot(*(car.positions[round(lap)] - car.positions[0])) < 3
        points, _ = track.locate(np.mod(car.distances_px, track.length_px))
        assert np.allclose(points, car.positions)


def test_ways_keep_their_places_however_many_there_are() -> None:
    assert [lane(k) for k in range(1, 8)] == [1 / 2, 1 / 4, 3 / 4, 1 / 8, 5 / 8, 3 / 8, 7 / 8]
    assert (
        make_scene("constant", contacts=5).objects[:3] == make_scene("constant", contacts=3).objects
    )


def test_conditions_go_with_every_motion() -> None:
    box = (10.0, 20.0, 30.0, 40.0)
    for name in scene_names():
        scene = make_scene(name, noise_sigma=3, far_scale=0.9, light_gain=0.5, occluders=[box])
        conditions = scene.conditions
        assert (conditions.noise_sigma, conditions.far_scale) == (3, 0.9)
        assert (conditions.light_gain, conditions.occluders) == (0.5, (box,))
    scene = make_scene("light_switch").under(noise_sigma=2.0)
    assert (scene.conditions.light_gain, scene.conditions.noise_sigma) == (0.6, 2.0)


@pytest.mark.parametrize(
    ("name", "options", "words"),
    [
        ("constnat", {}, 'unknown scene "constnat"; one of: constant, varying_speed'),
        ("constant", {"sped": 3}, 'constant: unknown option "sped"; one of: contacts, speed'),
        ("constant", {"speed_px_per_s": "fast"}, "speed_px_per_s: 'fast' is not allowed; a number"),
        ("constant", {"speed_px_per_s": 0}, "speed_px_per_s: 0 is not allowed; above 0"),
        ("constant", {"contacts": 1.5}, "contacts: 1.5 is not allowed; a whole number"),
        ("constant", {"contacts": -1}, "contacts: -1"),
        ("constant", {"noise_sigma": True}, "noise_sigma: True is not allowed; a number"),
        ("constant", {"shape": 3}, "shape: 3 is not allowed; a word"),
        ("constant", {"shape": "star"}, 'shape: unknown "star"'),
        ("constant", {"occluders": 3}, "occluders: 3 is not allowed; a list of boxes"),
        ("constant", {"frame_count": 0}, "frame_count: 0"),
        ("constant", {"size": (0, 240)}, "size: width: 0"),
        ("constant", {"size": (320,)}, r"size: \(320,\) is not allowed; \(width, height\)"),
        ("constant", {"fps": -1.0}, "fps: -1"),
        ("crowd", {"seed": -1}, "seed: -1 is not allowed"),
        ("constant", {"frame_count": 20}, "object 1 is never in the frame"),
        ("constant", {"enter_s": 100.0}, "object 1 is never in the frame"),
        ("varying_direction", {"enter_s": 100.0}, "object 1 is never in the frame"),
        ("varying_speed", {"enter_s": 100.0}, "object 1 is never in the frame"),
        ("crossing", {"speed_px_per_s": 10.0}, "crossing: the contacts meet at 19.30 s, but"),
        ("reentry", {"speed_px_per_s": 50.0}, "reentry: the contact comes back at"),
        ("stopping", {"speed_px_per_s": 10.0}, "stopping: the contact stands at"),
        ("stopping", {"brake_s": 100.0}, "brake_s: 100 is not allowed"),
        ("removal", {"removed_s": 9.0}, "removal: the contact is removed at 9.00 s"),
        ("removal", {"removed_s": 0.5}, "object 1 is never in the frame"),
        ("race", {"contacts": 9}, "race: no room for the lane of contact 4"),
    ],
)
def test_what_is_not_allowed_is_named(name: str, options: dict[str, Any], words: str) -> None:
    with pytest.raises(UsageError, match=words):
        make_scene(name, **options)


def test_the_document_names_every_scene_and_option() -> None:
    text = (ROOT / "docs" / "scenes.md").read_text()
    for name in scene_names():
        for word in (name, *scene_options(name)):
            assert f"`{word}`" in text, f"{name}: {word}"
