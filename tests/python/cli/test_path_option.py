# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack run --path`: the table, the view, and what is refused before anything is written."""

import csv
import json
from pathlib import Path

import av
import pytest

from clips import walking_square, write_video
from survtrack import Path as ImagePath
from survtrack import Paths
from survtrack.cli.main import main

FRAMES = walking_square(60, width=128, height=96, side=20, still=20)


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A square that walks to the right along y = 42, 20 px/s."""
    return write_video(tmp_path_factory.mktemp("clip") / "clip.mp4", FRAMES)


@pytest.fixture
def path_file(tmp_path: Path) -> Path:
    file = tmp_path / "lane.json"
    lane = ImagePath([(128, 50), (0, 50)], max_distance_px=40)
    file.write_text(Paths({"lane": lane}, (128, 96)).to_json())
    return file


def run(*args: object) -> int:
    return main(["run", *map(str, args)])


def error_of(capsys: pytest.CaptureFixture[str]) -> str:
    return capsys.readouterr().err.removeprefix("survtrack: error: ").rstrip("\n")


def test_the_table_agrees_with_the_tracks(clip: Path, path_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert run(clip, "--path", path_file, "--out", out) == 0
    with (out / "path.csv").open(newline="") as file:
        places = list(csv.DictReader(file))
    with (out / "tracks.csv").open(newline="") as file:
        tracks = list(csv.DictReader(file))
    assert len(places) == len(tracks) > 30
    for place, track in zip(places, tracks, strict=True):
        assert (place["frame"], place["id"], place["path"]) == (track["frame"], track["id"], "lane")
        assert float(place["s_px"]) == pytest.approx(128 - float(track["x_px"]), abs=2e-3)
        assert float(place["t_px"]) == pytest.approx(50 - float(track["y_px"]), abs=2e-3)
        speed = -float(track["velocity_x_px_per_s"])
        assert float(place["v_s_px_per_s"]) == pytest.approx(speed, abs=2e-3)
    assert float(places[-1]["v_s_px_per_s"]) == pytest.approx(-20, abs=3)
    facts = json.loads((out / "run.json").read_text())
    assert facts["path"] == str(path_file) and "path.csv" in facts["outputs"]


def test_without_a_path_there_is_no_table(clip: Path, path_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert run(clip, "--path", path_file, "--out", out) == 0
    assert run(clip, "--out", out) == 0
    assert not (out / "path.csv").exists()
    assert json.loads((out / "run.json").read_text())["path"] is None


def test_the_view_shows_the_path(clip: Path, path_file: Path, tmp_path: Path) -> None:
    args = (clip, "--path", path_file, "--video", "--limit", 5, "--out", tmp_path / "out")
    assert run(*args, "--views", "frame,path") == 0
    with av.open(str(tmp_path / "out" / "annotated.mp4")) as video:
        picture = next(video.decode(video=0)).to_ndarray(format="bgr24").astype(int)
    plain, shown = picture[:, :128], picture[:, 128:]
    yellowish = (shown[..., 0] > 150) & (shown[..., 1] > 150) & (shown[..., 2] < 120)
    assert yellowish[48:53, 30:120].any(axis=0).mean() > 0.8
    assert not ((plain[..., 0] > 150) & (plain[..., 2] < 120)).any()


def test_the_view_needs_a_path(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(clip, "--video", "--views", "path", "--out", tmp_path / "out") == 2
    assert error_of(capsys) == "--views path: shows a path; add --path FILE"
    assert not (tmp_path / "out").exists()


def test_paths_for_other_frames_are_refused_before_anything_is_written(
    clip: Path, path_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    args = (clip, "--path", path_file, "--out", tmp_path / "out")
    assert run(*args, "--resize", "64x48") == 1
    assert error_of(capsys) == f"{path_file}: is for frames of 128x96, the run's are 64x48"
    assert not (tmp_path / "out").exists()


def test_a_bad_file_is_named(
    clip: Path, path_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path_file.write_text('{"paths": [{"name": "a", "points": [[0, 0], [1, 1], [0, 0]]}]}')
    assert run(clip, "--path", path_file, "--out", tmp_path / "out") == 1
    assert f"{path_file}.paths[0].points[1]: the path turns straight back" in error_of(capsys)
    assert run(clip, "--path", tmp_path / "no.json", "--out", tmp_path / "out") == 1
    assert "no.json: no such file" in error_of(capsys)
    assert not (tmp_path / "out").exists()


FILTER = ("--set", "filter.model=kalman_path")


def test_objects_are_followed_along_the_paths(clip: Path, path_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert run(clip, "--path", path_file, *FILTER, "--out", out) == 0
    with (out / "tracks.csv").open(newline="") as file:
        tracks = list(csv.DictReader(file))
    assert len(tracks) > 30 and {track["id"] for track in tracks} == {"1"}
    assert float(tracks[-1]["velocity_x_px_per_s"]) == pytest.approx(20, abs=3)
    # The square is farther off this one: it is no object.
    far = Paths({"lane": ImagePath([(0, 90), (128, 90)], max_distance_px=10)}, (128, 96))
    path_file.write_text(far.to_json())
    assert run(clip, "--path", path_file, *FILTER, "--out", out) == 0
    assert (out / "tracks.txt").read_text() == ""


def test_following_along_paths_needs_some(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    message = (
        'filter.model "kalman_path": follows objects along paths; add --path FILE, '
        "or choose another filter"
    )
    for command in ("run", "segment"):
        assert main([command, str(clip), *FILTER, "--out", str(tmp_path / "out")]) == 2
        assert error_of(capsys) == message
    assert not (tmp_path / "out").exists()


def test_paths_of_other_frames_are_refused_by_the_filter_too(
    clip: Path, path_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    args = (clip, "--path", path_file, *FILTER, "--resize", "64x48")
    assert run(*args, "--out", tmp_path / "out") == 1
    assert "frame: is 64x48 px, and the paths are drawn on frames of 128x96" in error_of(capsys)
    assert not (tmp_path / "out").exists()
