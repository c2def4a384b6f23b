# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Regions on the command line."""

import json
from pathlib import Path

import pytest

import survtrack
from clips import walking_square, write_video
from survtrack import Path as ImagePath
from survtrack import Paths
from survtrack.cli.main import main

FRAMES = walking_square(60, width=128, height=96, side=20, still=20)
ZONES = ("--set", "regions.model=predicted", "--set", "regions.acquisition=zones")
SOON = ("--set", "segmenter.update_time_s=0.2")  # whole frames for 0.4 s only


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_video(tmp_path_factory.mktemp("clip") / "clip.mp4", FRAMES)


def run(*args: object) -> int:
    return main(list(map(str, args)))


def error_of(capsys: pytest.CaptureFixture[str]) -> str:
    return capsys.readouterr().err.removeprefix("survtrack: error: ").rstrip("\n")


def test_the_summary_says_what_was_read(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    zone = ("--zone", "0,30,40,40")
    assert (
        run("run", clip, *ZONES, *SOON, *zone, "--out", out, "--video", "--views", "regions") == 0
    )
    facts = json.loads((out / "run.json").read_text())
    assert 0.05 < facts["pixels_read_fraction"] < 0.6
    assert facts["zones"] == ["0,30,40,40"] and facts["tracks"] == 1
    part = f"{100 * facts['pixels_read_fraction']:.1f} % of the pixels read"
    assert part in capsys.readouterr().out
    assert run("segment", clip, *ZONES, *SOON, *zone, "--out", tmp_path / "masks") == 0
    capsys.readouterr()
    assert run("run", clip, "--out", tmp_path / "whole") == 0
    assert json.loads((tmp_path / "whole" / "run.json").read_text())["pixels_read_fraction"] == 1
    assert "pixels read" not in capsys.readouterr().out


def test_a_preset_that_needs_paths_and_zones_gives_masks_too(clip: Path, tmp_path: Path) -> None:
    lane = ImagePath([(0, 50), (128, 50)], max_distance_px=40)
    file = tmp_path / "lane.json"
    file.write_text(Paths({"lane": lane}, (128, 96)).to_json())
    needed = ("--preset", "omalley2000", "--path", file, "--zone", "0,20,40,60")
    assert run("segment", clip, *needed, "--out", tmp_path / "masks") == 0
    assert len(list((tmp_path / "masks").glob("bin*.png"))) == 60
    assert run("run", clip, *needed, "--out", tmp_path / "out") == 0
    found = survtrack.track(
        clip,
        "omalley2000",
        paths=Paths({"lane": lane}, (128, 96)),
        zones=[survtrack.Box(0, 20, 40, 60)],
    )
    results = [result for _, result in found]
    tracks = {track.id for result in results for track in result.tracks if track.reported}
    assert len(tracks) == json.loads((tmp_path / "out" / "run.json").read_text())["tracks"]


def test_a_background_may_be_given_to_track(clip: Path) -> None:
    config = survtrack.Config(segmenter=survtrack.StaticReferenceOptions(source="picture"))
    picture = FRAMES[0].copy()
    results = [result for _, result in survtrack.track(clip, config=config, background=picture)]
    assert len(results) == 60 and results[-1].tracks
    with pytest.raises(survtrack.InputError, match="background"):
        list(survtrack.track(clip, config=config))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ((*ZONES,), 'regions.acquisition: "zones" needs zones'),
        ((*ZONES, "--zone", "1,2,3"), "--zone 1,2,3: expected four numbers in px"),
        ((*ZONES, "--zone", "1,2,3,x"), "--zone 1,2,3,x: expected four numbers in px"),
        ((*ZONES, "--zone", "900,2,3,4"), "zones[0]: (900, 2"),
        ((*ZONES, "--zone", "1,2,0,4"), "zones[0]: (1, 2, 0"),
        (("--video", "--views", "regions"), "--views regions: shows what is read, and this config"),
        (("--zone", "1,2,3,4"), "zones: this config has no use for them"),
        (
            ("--set", "regions.model=predicted", "--set", "segmenter.model=knn"),
            'regions.model: "predicted" needs a background model that can read parts of a frame',
        ),
    ],
)
def test_what_is_refused_before_anything_is_written(
    options: tuple[str, ...],
    message: str,
    clip: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run("run", clip, *options, "--out", tmp_path / "out") != 0
    assert error_of(capsys).startswith(message)
    assert not (tmp_path / "out").exists()
