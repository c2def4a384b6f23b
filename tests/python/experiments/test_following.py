# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Estimates beside the truth: norms, delays, whose track is whose, lost contacts, markers."""

from pathlib import Path

import numpy as np
import pytest

import survtrack
from clips import walking_square
from survtrack.evaluation import Boxes
from survtrack.experiments import Dataset, Footage, Variant
from survtrack.experiments.ends import End, compare_ends
from survtrack.experiments.following import (
    Followed,
    Seen,
    follow,
    of_masks,
    of_measurements,
    of_video,
)
from survtrack.experiments.marking import mark
from survtrack.scenes import Body, Scene, SceneObject, steady
from survtrack.scenes import Path as Way

FPS = 25.0
STILL = 30  # frames before the square of the clip comes


def followed(estimate: list[tuple[float, float]]) -> Followed:
    """An object that goes 2 px to the right in each of as many frames."""
    count = len(estimate)
    truth = np.stack([2.0 * np.arange(count), np.zeros(count)], axis=1)
    velocity = np.tile([2.0, 0.0], (count, 1))
    return Followed(1, 1, np.arange(count), truth, velocity, np.array(estimate, np.float64))


def test_norms_and_when_they_stay_under_a_limit() -> None:
    nowhere = (float("nan"), float("nan"))
    one = followed([nowhere, (2, 3), (4, 4), (6, 0.5), (8, 0)])
    assert one.start == 1
    assert one.norms[1:].tolist() == [3, 4, 0.5, 0]
    assert one.settled_after(1.0) == 2
    assert one.settled_after(10.0) == 0
    assert followed([(0, 0), (2, 3)]).settled_after(1.0) is None
    assert followed([nowhere, nowhere]).settled_after(1.0) is None
    assert followed([(0, 0), nowhere, (4, 0)]).settled_after(1.0) == 2
    assert one.rms_px(2) == pytest.approx(np.sqrt(0.25 / 2))


def test_a_constant_delay_and_bias_are_told_apart() -> None:
    delay, bias, rest = followed([(2.0 * (k - 3), 1.5) for k in range(8)]).lag()
    # y points down: what lies lower is to the right of the way.
    assert (delay, bias, rest) == pytest.approx((3.0, 1.5, 1.5))


def two(**first: float) -> Scene:
    body = Body("ellipse", 28.0, 56.0)
    contacts = (
        SceneObject(1, body, Way((40.0, 60.0)), steady(50.0), **first),
        SceneObject(2, body, Way((200.0, 160.0), 180.0), steady(50.0)),
    )
    return Scene("two", contacts, (240, 220), 30, FPS)


@pytest.mark.parametrize("run", [of_masks, lambda scene, config: of_measurements(scene, config, 0)])
def test_masks_and_measurements_give_the_true_positions(run) -> None:  # type: ignore[no-untyped-def]
    scene = two()
    both = follow(scene, run(scene, survtrack.preset("semko2007")))
    assert [one.id for one in both] == [1, 2]
    assert len({one.track_id for one in both}) == 2
    for one in both:
        assert one.start == 0
        assert one.rms_px() < 0.1


def test_a_track_belongs_to_one_object_only() -> None:
    """The contact comes back under another number: nobody follows the second."""
    body = Body("ellipse", 28.0, 56.0)
    way = Way((40.0, 60.0))
    contacts = (
        SceneObject(1, body, way, steady(50.0), until_s=9.5 / FPS),
        SceneObject(2, body, way, steady(50.0), from_s=14.5 / FPS),
    )
    scene = Scene("twice", contacts, (240, 120), 30, FPS)
    first, second = follow(scene, of_masks(scene, survtrack.preset("semko2007")))
    assert (first.track_id, second.track_id) == (1, None)
    assert second.start is None


def test_video_is_seen_late() -> None:
    scene = two()
    seen = of_video(scene, survtrack.preset("semko2007"))
    assert not any(one.detected for one in seen[:11])
    assert [one.index for one in seen] == list(range(30))
    for one in follow(scene, seen):
        assert one.start is not None and one.start >= 11
        assert one.lag()[0] > 3


def footage(truth: Boxes, frames: int = 60) -> Footage:
    images = walking_square(frames, width=96, height=64, still=STILL)
    return Footage(Dataset("made", "made", Path("gt.txt")), images, FPS, (96, 64), (96, 64), truth)


def test_ends_match_in_time_and_place_one_to_one() -> None:
    rows = [(k, 1, [10, 20, 8, 16]) for k in (1, 20)] + [(k, 2, [60, 20, 8, 16]) for k in (1, 60)]
    truth = Boxes([row[0] for row in rows], [row[1] for row in rows], [row[2] for row in rows])
    at = (13.5, 27.5)  # the centre (14, 28), counted by pixels
    told = [
        End(22, 40, (at[0] + 3, at[1]), "open"),
        End(24, 42, at, "open"),  # closer, so this is the one
        End(60, 60, (63.5, 27.5), "border"),  # the second is there until the footage ends
        End(50, 63, at, "open"),  # too late
        End(20, 33, (at[0] + 17, at[1]), "behind_object"),  # further than 16 px
    ]
    ends = compare_ends(footage(truth), told)
    assert (ends.true_ends, ends.told, ends.matched, ends.distance_px) == (1, 5, 1, 0)
    assert ends.latency_frames == 13
    assert ends.places == {"border": 1, "behind_object": 1, "open": 3}
    assert np.isnan(compare_ends(footage(truth), []).distance_px)


def test_markers_and_masks_against_true_boxes() -> None:
    """The square walks 2 px a frame; its last boxes do not count."""
    frames = range(STILL, 60)
    boxes = [[4 + 2 * (k - STILL), 21, 14, 14] for k in frames]
    truth = Boxes([k + 1 for k in frames], [1] * 30, boxes, [k >= 55 for k in frames])
    marked = mark(footage(truth), Variant("survtrack", in_frames=False))
    assert (marked.objects, marked.found, marked.trial.scores.truth_boxes) == (1, 1, 25)
    assert marked.on_truth == 1
    assert marked.mask_in_truth > 0.95
    assert 0.9 < marked.coverage < 1
    with_marker = {frame for frame in marked.markers[:, 0].astype(int).tolist() if frame <= 55}
    assert marked.on_contact == len(with_marker) / 25 > 0.5
    elsewhere = footage(Boxes([40], [1], [[80, 2, 5, 5]]))
    missed = mark(elsewhere, Variant("survtrack", in_frames=False))
    assert (missed.found, missed.on_contact, missed.coverage, missed.mask_in_truth) == (0, 0, 0, 0)
    assert missed.on_truth == 0


def test_unknown_tracks_are_nowhere() -> None:
    scene = two()
    far = [Seen(k, {7: (230.0, 10.0)}, {7: 1.0}, [], []) for k in range(30)]
    assert [one.track_id for one in follow(scene, far)] == [None, None]
