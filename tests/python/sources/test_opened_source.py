# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A source that is open already goes wherever one can be opened, and takes no options."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import survtrack
from clips import Image, walking_square, write_images, write_video
from survtrack.errors import InputError, UsageError
from survtrack.sources import ArraySource, Prefetch, Selection, Source, open_source

FRAMES = walking_square(30, still=10)


class Tape:
    """A source of its own class, with times that no frame rate gives."""

    name = "tape 7"
    size = original_size = (96, 64)
    fps = 10.0
    fps_origin = "given"
    frame_count_declared = len(FRAMES)
    endless = False
    selection = Selection()

    def __iter__(self) -> Iterator[tuple[int, float, Image]]:
        for index, frame in enumerate(FRAMES):
            yield index, 100 + index / 10 + 0.01 * (index % 2), frame

    def file_name(self, index: int) -> str | None:
        return None


def boxes_of(source: Any, **options: Any) -> list[Any]:
    return [
        (result.index, track.id, track.box.x, track.box.width)
        for _, result in survtrack.track(source, **options)
        for track in result.tracks
    ]


def test_a_source_is_returned_as_it_is(tmp_path: Path) -> None:
    opened = open_source(write_images(tmp_path, FRAMES), limit=3)
    assert isinstance(opened, Source)
    assert open_source(opened) is opened
    assert isinstance(Tape(), Source)
    for other in (FRAMES, iter(FRAMES), FRAMES[0], "in", tmp_path):
        assert not isinstance(other, Source)


def test_track_takes_every_kind_of_source(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "in", FRAMES)
    expected = boxes_of(FRAMES, start=4, step=2)
    assert expected
    selection = Selection(4, 2)
    assert boxes_of(ArraySource(FRAMES, selection=selection)) == expected
    assert boxes_of(open_source(folder, start=4, step=2)) == expected
    with Prefetch(open_source(folder, start=4, step=2)) as ahead:
        assert boxes_of(ahead) == expected
    clip = write_video(tmp_path / "clip.mp4", FRAMES)
    assert boxes_of(open_source(clip, limit=25)) == boxes_of(clip, limit=25)


def test_a_source_keeps_its_own_times() -> None:
    pairs = list(survtrack.track(Tape()))
    assert [result.index for _, result in pairs] == list(range(30))
    assert [result.time_s for _, result in pairs] == [time_s for _, time_s, _ in Tape()]
    assert all(frame is result.frame for frame, result in pairs)


def test_an_array_that_is_refilled_is_not_read_ahead() -> None:
    def refilled() -> Iterator[Image]:
        frame = FRAMES[0].copy()
        for one in FRAMES:
            frame[:] = one
            yield frame

    assert boxes_of(ArraySource(refilled())) == boxes_of(FRAMES)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"fps": 10.0}, r"fps: 10\.0"),
        ({"start": 1}, "start: 1"),
        ({"step": 2}, "step: 2"),
        ({"limit": 3}, "limit: 3"),
        ({"resize": (48, 32)}, r"resize: \(48, 32\)"),
    ],
)
def test_options_belong_to_opening(options: dict[str, Any], told: str) -> None:
    message = f"{told} is not allowed with tape 7, which is a source already"
    for take in (open_source, survtrack.track):
        with pytest.raises(UsageError, match=message):
            take(Tape(), **options)


def test_what_is_half_a_source_is_refused_by_its_frames() -> None:
    pairs = [(index, time_s, frame) for index, time_s, frame in Tape()]
    with pytest.raises(InputError, match="frame 0: is a tuple, not a numpy array"):
        list(survtrack.track(pairs))  # type: ignore[arg-type]


def test_an_endless_source_is_refused_where_results_come_late() -> None:
    live = Tape()
    live.endless = True
    with pytest.raises(UsageError, match=r"tape 7: is a live stream, .* 75 frames late"):
        survtrack.track(live, "narayana2007")
