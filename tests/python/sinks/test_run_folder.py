# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A folder belongs to the last run that ended in it."""

import json
import os
from pathlib import Path

import pytest

from survtrack.errors import UsageError
from survtrack.sinks import RunFolder


def leave(folder: Path, *names: str) -> None:
    """What a run that ended in `folder` leaves."""
    run = RunFolder(folder)
    run.make()
    for name in names:
        (folder / name.replace("*", "000001")).write_text("content")
    run.finish({"complete": True, "outputs": names}, "config")


def test_makes_the_folder_and_says_what_is_in_it(tmp_path: Path) -> None:
    leave(tmp_path / "a" / "b", "tracks.txt")
    assert sorted(os.listdir(tmp_path / "a" / "b")) == ["config.toml", "run.json", "tracks.txt"]
    facts = json.loads((tmp_path / "a" / "b" / "run.json").read_text())
    assert facts == {"complete": True, "outputs": ["tracks.txt"]}
    assert (tmp_path / "a" / "b" / "config.toml").read_text() == "config"


def test_nothing_is_there_before_it_is_made(tmp_path: Path) -> None:
    folder = RunFolder(tmp_path / "a" / "b")
    folder.refuse_foreign_masks()
    assert os.listdir(tmp_path) == []
    folder.make()
    assert (tmp_path / "a" / "b").is_dir()


def test_outputs_of_the_run_before_do_not_pose_as_this_ones(tmp_path: Path) -> None:
    leave(tmp_path, "tracks.txt", "annotated.mp4", "bin*.png")
    (tmp_path / "notes.txt").write_text("the user's own")
    leave(tmp_path, "tracks.txt")
    assert sorted(os.listdir(tmp_path)) == ["config.toml", "notes.txt", "run.json", "tracks.txt"]


def test_an_earlier_run_json_cannot_name_foreign_files_to_be_removed(tmp_path: Path) -> None:
    (tmp_path / "precious").write_text("")
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "run.json").write_text('{"outputs": ["../precious", "run.json", 5]}')
    leave(folder)
    assert (tmp_path / "precious").exists()


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"outputs": 5}', "null", "\xff"])
def test_an_earlier_run_json_that_is_none_is_replaced(tmp_path: Path, text: str) -> None:
    (tmp_path / "run.json").write_text(text, encoding="latin-1")
    leave(tmp_path)
    assert json.loads((tmp_path / "run.json").read_text())["complete"] is True


def test_masks_of_an_earlier_run_may_be_replaced_but_no_others(tmp_path: Path) -> None:
    leave(tmp_path, "bin*.png")
    RunFolder(tmp_path).refuse_foreign_masks()
    (tmp_path / "run.json").unlink()
    with pytest.raises(UsageError, match=r"holds 1 masks \(bin000001\.png, \.\.\.\)"):
        RunFolder(tmp_path).refuse_foreign_masks()


def test_a_folder_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for place in (tmp_path / "file", tmp_path / "file" / "out"):
        with pytest.raises(OSError) as caught:
            RunFolder(place).make()
        assert caught.value.filename == str(place)


def test_when_run_json_cannot_be_written_the_old_one_does_not_pose(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    leave(tmp_path, "tracks.txt")
    (tmp_path / "run.json.part").symlink_to("/dev/full")
    with pytest.raises(OSError, match="No space left on device"):
        leave(tmp_path, "tracks.txt")
    assert not (tmp_path / "run.json").exists()
