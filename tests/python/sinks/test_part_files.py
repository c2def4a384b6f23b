# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A file has its name only when it is whole: on errors, on full disks, in place of old ones."""

import errno
import os
from pathlib import Path

import pytest

from clips import walking_square
from fakes import Box, Track, result_of
from survtrack.sinks import MotText
from survtrack.sinks.part_file import PartFile, write_whole

FRAME = walking_square(1)[0]


def write_rows(sink: MotText, count: int) -> None:
    for index in range(count):
        sink.write(FRAME, result_of(FRAME, index, Track(1, Box(0, 0, 4, 5))))


def test_until_the_end_there_is_only_the_part(tmp_path: Path) -> None:
    path = tmp_path / "tracks.txt"
    path.write_text("old\n")
    with MotText(path) as sink:
        write_rows(sink, 3)
        assert path.read_text() == "old\n"
        assert sorted(os.listdir(tmp_path)) == ["tracks.txt", "tracks.txt.part"]
        assert sink.outputs == []
    assert os.listdir(tmp_path) == ["tracks.txt"]
    assert len(path.read_text().splitlines()) == 3


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_what_was_written_is_finished_on_an_exception(
    tmp_path: Path, error: type[BaseException]
) -> None:
    with pytest.raises(error), MotText(tmp_path / "tracks.txt") as sink:
        write_rows(sink, 2)
        raise error
    assert len((tmp_path / "tracks.txt").read_text().splitlines()) == 2
    assert not (tmp_path / "tracks.txt.part").exists()


def full_disk(path: Path) -> None:
    """Let the part of `path` be a device on which every write finds no space."""
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    path.with_name(path.name + ".part").symlink_to("/dev/full")


def test_a_full_disk_is_told_with_the_name_and_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "tracks.txt"
    path.write_text("old\n")
    full_disk(path)
    with pytest.raises(OSError, match="No space left on device") as caught, MotText(path) as sink:
        write_rows(sink, 10_000)
    assert caught.value.errno == errno.ENOSPC
    assert caught.value.filename == str(path)
    assert path.read_text() == "old\n"
    assert sink.outputs == []


def test_a_disk_that_is_full_at_the_very_end(tmp_path: Path) -> None:
    path = tmp_path / "tracks.txt"
    full_disk(path)
    with pytest.raises(OSError, match="No space left on device") as caught, MotText(path) as sink:
        write_rows(sink, 1)
    assert caught.value.filename == str(path)
    assert not path.exists()
    assert sink.outputs == []


def test_a_place_that_cannot_be_written_shows_on_entering(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError) as caught, MotText(tmp_path / "file" / "tracks.txt"):
        pytest.fail("entered")
    assert caught.value.filename == str(tmp_path / "file" / "tracks.txt")


def test_writing_outside_of_the_with_block_is_a_mistake(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="written to while it is not open"):
        PartFile(tmp_path / "x").write("text")


def test_write_whole_replaces(tmp_path: Path) -> None:
    write_whole(tmp_path / "run.json", "one")
    write_whole(tmp_path / "run.json", "two")
    assert (tmp_path / "run.json").read_text() == "two"
    assert os.listdir(tmp_path) == ["run.json"]
