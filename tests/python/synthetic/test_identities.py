# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Who merges and parts, or leaves and comes back, keeps its identity: on video with exact truth."""

from collections import defaultdict

import numpy as np
import pytest

import survtrack
from survtrack.runner import results
from survtrack.scenes import make_scene
from survtrack.scenes.scene import Scene


def config_of(preset: str, *settings: str) -> survtrack.Config:
    config = survtrack.preset(preset)
    for setting in settings:
        config.set(setting)
    return config


def owners(scene: Scene, config: survtrack.Config) -> tuple[dict[int, set[int]], list[str]]:
    """Which objects each track followed while those were far from each other, and the events."""
    truth = scene.truth()
    followed: dict[int, set[int]] = defaultdict(set)
    told = []
    for result in results(scene.frames("video"), survtrack.Pipeline(config)):
        told += [event.kind.name for event in result.events]
        now = truth.at(result.index)
        seen = np.array(now.positions)[np.array(now.boxes)[:, 2] > 0]
        ids = np.array(now.ids)[np.array(now.boxes)[:, 2] > 0]
        if len(ids) == 2 and np.hypot(*(seen[0] - seen[1])) < 70:
            continue
        for track in result.tracks:
            if len(ids) and track.lost_frames == 0 and track.group == 0:
                nearest = np.hypot(*(seen - track.position).T).argmin()
                followed[track.id].add(int(ids[nearest]))
    return dict(followed), told


@pytest.mark.parametrize("angle_deg", [60.0, 90.0, 120.0])
def test_two_who_cross_keep_their_identities_as_a_group(angle_deg: float) -> None:
    scene = make_scene("crossing", seed=1, angle_deg=angle_deg)
    alone = ("time_unit_s=0.04", "segmenter.window=causal")
    grouped = config_of("narayana2007_euclidean", *alone, "groups.model=shared_blob")
    followed, told = owners(scene, grouped)
    assert sorted(map(sorted, followed.values())) == [[1], [2]]
    assert told.count("merged") == 1 and told.count("split") == 1
    followed, told = owners(scene, config_of("narayana2007_euclidean", *alone))
    assert len(followed) == 3
    assert not {"merged", "split"} & set(told)


def test_one_who_comes_back_is_known_again() -> None:
    scene = make_scene("reentry", seed=1)
    followed, told = owners(scene, config_of("survtrack", "reentry.model=remember"))
    assert followed == {1: {1}}
    assert told.count("track_started") == 1 and told.count("track_reentered") == 1
    followed, told = owners(scene, config_of("survtrack"))
    assert followed == {1: {1}, 2: {1}}
    assert "track_reentered" not in told
