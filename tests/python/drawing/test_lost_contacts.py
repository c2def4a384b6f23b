# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Crosses where tracks were lost, for a time."""

import numpy as np
import pytest

from clips import Image
from fakes import Event, Kind, Place, result_of
from survtrack.drawing import LostContactRenderer, color_of_id
from survtrack.errors import UsageError


def blank() -> Image:
    return np.zeros((120, 160, 3), np.uint8)


def end(place: Place = Place.open, position: tuple[float, float] = (80.0, 60.0)) -> Event:
    return Event(Kind.track_ended, 10, 1.0, 4, position=position, place=place)


def drawn(scene: Image) -> bool:
    return bool((scene == color_of_id(4)).all(axis=2).any())


def test_an_end_is_shown_for_its_time() -> None:
    renderer = LostContactRenderer(show_s=0.5)
    shown = []
    for index in range(8, 20):
        events = [end()] if index == 10 else []
        scene = blank()
        assert renderer.annotate(scene, result_of(blank(), index, events=events)) is scene
        shown.append(drawn(scene))
    assert shown == [False] * 2 + [True] * 5 + [False] * 5


def test_the_cross_is_where_the_track_was_seen_last() -> None:
    scene = LostContactRenderer().annotate(blank(), result_of(blank(), 10, events=[end()]))
    assert tuple(scene[60, 80]) == color_of_id(4)


def test_events_without_a_place_are_not_drawn() -> None:
    event = end(Place.none)
    scene = LostContactRenderer().annotate(blank(), result_of(blank(), 10, events=[event]))
    assert not scene.any()


def test_an_end_outside_the_picture_is_shown_at_its_edge() -> None:
    event = end(Place.border, (1e6, -50.0))
    assert drawn(LostContactRenderer().annotate(blank(), result_of(blank(), 10, events=[event])))


def test_a_time_must_be_above_0() -> None:
    with pytest.raises(UsageError, match="show_s: 0 is not allowed"):
        LostContactRenderer(0)
