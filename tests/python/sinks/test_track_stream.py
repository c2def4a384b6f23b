# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""tracks.svt: whole when it has its name, readable while it grows."""

import os
from pathlib import Path

import pytest

from fakes import Box, Track
from survtrack.errors import InputError
from survtrack.replay import TrackStreamDecoder, read_track_stream
from survtrack.sinks import TrackStream
from track_streams import FPS, FRAME, result_at, stream, walk


def write(path: Path, count: int = 8) -> TrackStream:
    with TrackStream(path, fps=FPS) as sink:
        for result in walk(count):
            sink.write(FRAME, result)
    return sink


def test_the_file_is_the_encoders_bytes(tmp_path: Path) -> None:
    path = tmp_path / "tracks.svt"
    assert write(path).outputs == ["tracks.svt"]
    assert path.read_bytes() == stream(walk(8))
    assert os.listdir(tmp_path) == ["tracks.svt"]
    recorded = read_track_stream(path)
    assert (recorded.problem, len(recorded.frames), recorded.header.fps) == (None, 8, FPS)
    assert [track.id for track in recorded.frames[0].tracks] == [1, 7]
    measured = recorded.frames[0].tracks[0].measured
    assert measured is not None and [*measured] == [2.5, 9.5, 8.5, 20.5]


def test_each_frame_can_be_read_as_soon_as_it_is_written(tmp_path: Path) -> None:
    part = tmp_path / "tracks.svt.part"
    decoder, at = TrackStreamDecoder(), 0
    with TrackStream(tmp_path / "tracks.svt", fps=FPS) as sink:
        for k, result in enumerate(walk(5)):
            sink.write(FRAME, result)
            data = part.read_bytes()
            assert [frame.index for frame in decoder.feed(data[at:])] == [k]
            at = len(data)
            read = read_track_stream(part)
            assert len(read.frames) == k + 1 and "is cut after frame" in (read.problem or "")
        assert sink.outputs == []
    assert not part.exists()


def test_an_interrupted_run_leaves_a_whole_stream(tmp_path: Path) -> None:
    path = tmp_path / "tracks.svt"
    with pytest.raises(KeyboardInterrupt), TrackStream(path, fps=FPS) as sink:
        sink.write(FRAME, walk(1)[0])
        raise KeyboardInterrupt
    assert read_track_stream(path).problem is None
    assert len(read_track_stream(path).frames) == 1


def test_a_frame_that_cannot_be_written_costs_only_itself(tmp_path: Path) -> None:
    path = tmp_path / "tracks.svt"
    bad = result_at(1, 0.1, Track(1, Box(0, 0, float("nan"), 1)))
    with pytest.raises(InputError, match="track 1: its"), TrackStream(path, fps=FPS) as sink:
        sink.write(FRAME, walk(1)[0])
        sink.write(FRAME, bad)
    recorded = read_track_stream(path)
    assert (len(recorded.frames), recorded.problem) == (1, None)


def test_a_run_without_frames_leaves_nothing(tmp_path: Path) -> None:
    assert write(tmp_path / "tracks.svt", 0).outputs == []
    assert os.listdir(tmp_path) == []


def test_a_full_disk_is_told_and_leaves_the_old_file(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    path = tmp_path / "tracks.svt"
    path.write_bytes(b"old")
    (tmp_path / "tracks.svt.part").symlink_to("/dev/full")
    with pytest.raises(OSError, match="No space left on device") as caught:
        write(path)
    assert caught.value.filename == str(path)
    assert path.read_bytes() == b"old"


def test_a_place_that_cannot_be_written_shows_on_entering(tmp_path: Path) -> None:
    with pytest.raises(OSError), TrackStream(tmp_path / "missing" / "x.svt", fps=FPS):
        pytest.fail("entered")
