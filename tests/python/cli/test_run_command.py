# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack run`: what it writes, prints and says, and what each end leaves behind."""

import csv
import json
import os
from pathlib import Path
from typing import Any

import av
import pytest

import survtrack
from clips import cut_short, walking_square, write_images, write_video
from survtrack.cli.main import main

FRAMES = walking_square(60, width=128, height=96, side=20, still=20)
OUTPUTS = ["config.toml", "events.jsonl", "run.json", "scene.json", "tracks.csv", "tracks.txt"]


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A video of 60 frames, 10 a second."""
    return write_video(tmp_path_factory.mktemp("clip") / "clip.mp4", FRAMES)


def facts_of(folder: Path) -> Any:
    return json.loads((folder / "run.json").read_text())


def mot_rows(folder: Path) -> list[list[str]]:
    return [line.split(",") for line in (folder / "tracks.txt").read_text().splitlines()]


def run(*args: object) -> int:
    return main(["run", *map(str, args)])


def test_leaves_all_files_and_tracks_the_square(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path / "out") == 0
    assert sorted(os.listdir(tmp_path / "out")) == OUTPUTS
    rows = mot_rows(tmp_path / "out")
    assert len({row[1] for row in rows}) == 1
    assert len(rows) > 30
    for row in rows:
        assert len(row) == 10
        assert row[6:] == ["1", "-1", "-1", "-1"]
    frame, left, top = int(rows[-1][0]), float(rows[-1][2]), float(rows[-1][3])
    assert left == pytest.approx(4 + 2 * (frame - 1 - 20), abs=4)
    assert top == pytest.approx(32, abs=4)


def test_a_run_starts_from_what_an_earlier_one_learned(clip: Path, tmp_path: Path) -> None:
    grid = ["--preset", "narayana2007", "--set", "segmenter.window=causal"]
    assert run(clip, *grid, "--out", tmp_path / "one") == 0
    scene = tmp_path / "one" / "scene.json"
    learned = json.loads(scene.read_text())["vicinity"]["grids"][0]["updates"]
    assert learned > 10
    assert run(clip, *grid, "--scene", scene, "--out", tmp_path / "two") == 0
    again = json.loads((tmp_path / "two" / "scene.json").read_text())
    assert again["vicinity"]["grids"][0]["updates"] > learned
    assert facts_of(tmp_path / "two")["scene"] == str(scene)


def test_a_scene_that_does_not_fit_is_refused(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "scene.json"
    scene.write_text('{"scale": {"samples": -1}}')
    assert run(clip, "--scene", scene, "--out", tmp_path / "out") == 1
    assert f"{scene}.scale.samples: is -1" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    assert run(clip, "--scene", tmp_path / "none.json", "--out", tmp_path / "out") == 1
    assert "none.json: No such file" in capsys.readouterr().err


def test_the_matrix_is_written_and_shown(clip: Path, tmp_path: Path) -> None:
    options = ["--preset", "narayana2007", "--set", "segmenter.window=causal"]
    views = "blobs,tracks,matrix,vicinity"
    assert run(clip, *options, "--out", tmp_path, "--matrix", "--video", "--views", views) == 0
    lines = [json.loads(line) for line in (tmp_path / "matrices.jsonl").read_text().splitlines()]
    assert len(lines) == 60
    busy = next(line for line in lines if line["track_ids"] and len(line["columns"]) > 1)
    assert busy["columns"][-1] == "lost"
    assert all(sum(row) == pytest.approx(1, abs=1e-5) for row in busy["values"])
    assert {"matrices.jsonl", "annotated.mp4"} <= set(facts_of(tmp_path)["outputs"])


def test_the_other_files_agree_with_tracks_txt(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path) == 0
    rows = mot_rows(tmp_path)
    with (tmp_path / "tracks.csv").open(newline="") as file:
        table = list(csv.DictReader(file))
    assert [(row["frame"], row["id"]) for row in table] == [(row[0], row[1]) for row in rows]
    assert all(float(row["time_s"]) == (int(row["frame"]) - 1) / 10 for row in table)
    events = [json.loads(line) for line in (tmp_path / "events.jsonl").read_text().splitlines()]
    started = [event for event in events if event["kind"] == "track_started"]
    assert [str(event["track_id"]) for event in started] == [rows[0][1]]
    assert started[0]["frame"] == int(rows[0][0])


def test_run_json_says_what_was_done(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path, "--set", "time_unit_s=0.5") == 0
    facts = facts_of(tmp_path)
    assert facts["survtrack"] == survtrack.__version__
    assert (facts["source"], facts["preset"]) == (str(clip), "survtrack")
    assert facts["set"] == ["time_unit_s=0.5"]
    assert (facts["complete"], facts["error"]) == (True, None)
    assert facts["frames"] == {"first": 1, "last": 60, "step": 1, "count": 60}
    assert (facts["fps"], facts["fps_origin"], facts["size"]) == (10, "container", [128, 96])
    assert facts["tracks"] == 1
    assert facts["frames_per_s"] == pytest.approx(60 / facts["seconds"], rel=1e-3)
    assert facts["frames_per_s_without_decoding"] >= facts["frames_per_s"]
    assert sorted([*facts["outputs"], "config.toml", "run.json"]) == OUTPUTS


def test_the_resolved_config_runs_again_to_the_same_tracks(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path / "a", "--set", "time_unit_s=0.5") == 0
    config = tmp_path / "a" / "config.toml"
    assert survtrack.Config.from_toml(config.read_text()).time_unit_s == 0.5
    assert run(clip, "--out", tmp_path / "b", "--config", config) == 0
    for name in ("tracks.txt", "events.jsonl", "tracks.csv", "config.toml"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_preset_then_config_then_set_left_to_right(clip: Path, tmp_path: Path) -> None:
    (tmp_path / "my.toml").write_text("time_unit_s = 0.25\n[outputs]\ncontours = true\n")
    args = (clip, "--out", tmp_path / "out", "--config", tmp_path / "my.toml")
    assert run(*args, "--set", "time_unit_s=3", "--set", "time_unit_s=0.5") == 0
    config = survtrack.Config.from_toml((tmp_path / "out" / "config.toml").read_text())
    assert config.time_unit_s == 0.5
    assert config.outputs.contours is True


def test_start_step_and_limit_keep_the_sources_numbers(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path, "--start", 3, "--step", 2, "--limit", 24) == 0
    assert facts_of(tmp_path)["frames"] == {"first": 4, "last": 50, "step": 2, "count": 24}
    frames = {int(row[0]) for row in mot_rows(tmp_path)}
    assert frames and all(4 <= frame <= 50 and frame % 2 == 0 for frame in frames)


def test_fps_and_resize_reach_the_pipeline(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path, "--fps", 5, "--resize", "64x48") == 0
    facts = facts_of(tmp_path)
    assert (facts["fps"], facts["fps_origin"], facts["size"]) == (5, "given", [64, 48])
    with (tmp_path / "tracks.csv").open(newline="") as file:
        last = list(csv.DictReader(file))[-1]
    assert float(last["time_s"]) == pytest.approx((int(last["frame"]) - 1) / 5)
    assert float(last["top_px"]) == pytest.approx(16, abs=3)


def test_a_folder_names_its_files_and_its_frame_rate(tmp_path: Path) -> None:
    write_images(tmp_path / "in", FRAMES, first=700)
    assert run(tmp_path / "in", "--out", tmp_path / "out") == 0
    facts = facts_of(tmp_path / "out")
    assert (facts["fps"], facts["fps_origin"]) == (25, "default")
    with (tmp_path / "out" / "tracks.csv").open(newline="") as file:
        table = list(csv.DictReader(file))
    assert table
    assert all(row["file"] == f"in{699 + int(row['frame']):06d}.png" for row in table)


def test_video_is_one_that_browsers_play(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path, "--step", 2, "--video") == 0
    with av.open(str(tmp_path / "annotated.mp4")) as container:
        stream = container.streams.video[0]
        assert (stream.codec_context.name, stream.codec_context.pix_fmt) == ("h264", "yuv420p")
        assert (stream.width, stream.height) == (128, 96)
        assert (stream.frames, float(stream.average_rate)) == (30, 5)
    assert "annotated.mp4" in facts_of(tmp_path)["outputs"]


def test_views_stand_side_by_side_and_ask_for_what_they_show(clip: Path, tmp_path: Path) -> None:
    names = "tracks,mask,background"
    assert run(clip, "--out", tmp_path, "--video", "--views", names) == 0
    with av.open(str(tmp_path / "annotated.mp4")) as container:
        stream = container.streams.video[0]
        assert (stream.width, stream.height) == (3 * 128, 96)
    config = survtrack.Config.from_toml((tmp_path / "config.toml").read_text())
    assert config.outputs.background is True


def test_views_of_flow_switch_it_on_and_begin_when_there_is_one(clip: Path, tmp_path: Path) -> None:
    flow = ["--set", "segmenter.model=horn_schunck", "--set", "segmenter.frames_back=5"]
    views = "intensity,flow,boxes,markers"
    assert run(clip, *flow, "--out", tmp_path, "--video", "--views", views) == 0
    config = survtrack.Config.from_toml((tmp_path / "config.toml").read_text())
    assert config.outputs.flow is True
    with av.open(str(tmp_path / "annotated.mp4")) as container:
        pictures = [f.to_ndarray(format="bgr24").astype(int) for f in container.decode(video=0)]
    assert len(pictures) == 60
    assert all(picture.shape == (2 * 96, 2 * 128, 3) for picture in pictures)
    # In the lower left corner of the second picture a note, then the yellow sample arrow.
    corners = [picture[84:96, 130:142] for picture in pictures]
    yellow = [(corner[..., 1] - corner[..., 0]).max() for corner in corners]
    assert [bool(most > 60) for most in yellow] == [False] * 5 + [True] * 55, yellow


def test_arrows_of_an_annotated_video_keep_to_the_segmenters_threshold(
    clip: Path, tmp_path: Path
) -> None:
    """A threshold that nothing reaches leaves the frame as it is, but for the caption and scale."""
    flow = ["--set", "segmenter.model=horn_schunck", "--views", "flow,frame", "--video"]
    differences = []
    for threshold in (0.03, 100):
        limit = ["--set", f"segmenter.magnitude_threshold={threshold}"]
        assert run(clip, *flow, *limit, "--out", tmp_path) == 0
        with av.open(str(tmp_path / "annotated.mp4")) as container:
            *_, last = container.decode(video=0)
        picture = last.to_ndarray(format="bgr24").astype(int)[20:80]
        differences.append(abs(picture[:, :128] - picture[:, 128:]).max())
    assert differences[0] > 100 > 50 > differences[1]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--views", "mask,flow"], "--views flow: shows a flow field that this config does not"),
        (["--views", "flow_color"], "--views flow_color: shows a flow field"),
        (
            ["--views", "background", "--set", "segmenter.model=horn_schunck"],
            "--views background: the segmenter horn_schunck has none",
        ),
    ],
)
def test_views_that_the_segmenter_cannot_fill_are_refused_before_the_first_frame(
    clip: Path, tmp_path: Path, options: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(clip, "--out", tmp_path / "out", "--video", *options) == 2
    assert words in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_json_is_all_there_is_on_stdout(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(clip, "--out", tmp_path, "--json") == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["frames"], printed["tracks"], printed["complete"]) == (60, 1, True)
    assert printed["out"] == str(tmp_path)
    assert printed["frames_per_s"] > 0
    assert printed["frames_per_s_without_decoding"] > 0


def test_the_summary_is_for_people_and_quiet_says_nothing(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(clip, "--out", tmp_path) == 0
    out, err = capsys.readouterr()
    assert "60 frames in" in out and "tracks: 1" in out and str(tmp_path) in out
    assert err == ""
    assert run(clip, "--out", tmp_path, "--quiet") == 0
    assert capsys.readouterr() == ("", "")


def test_a_later_run_replaces_an_earlier_one(clip: Path, tmp_path: Path) -> None:
    assert run(clip, "--out", tmp_path, "--video") == 0
    assert run(clip, "--out", tmp_path, "--limit", 3) == 0
    assert sorted(os.listdir(tmp_path)) == OUTPUTS
    assert facts_of(tmp_path)["frames"]["count"] == 3


def test_a_preset_that_answers_late_gives_every_frame(clip: Path, tmp_path: Path) -> None:
    late = [
        name
        for name in survtrack.preset_names()
        if survtrack.Pipeline(survtrack.preset(name)).delay_frames > 0
    ]
    assert late
    assert run(clip, "--out", tmp_path, "--preset", late[0], "--video") == 0
    assert facts_of(tmp_path)["frames"] == {"first": 1, "last": 60, "step": 1, "count": 60}
    with av.open(str(tmp_path / "annotated.mp4")) as container:
        assert container.streams.video[0].frames == 60


def test_a_video_cut_short_keeps_its_frames_and_names_both_counts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write_video(tmp_path / "cut.avi", FRAMES, codec="mpeg4")
    cut_short(path, 0.8)
    assert run(path, "--out", tmp_path / "out", "--video", "--json") == 1
    out, err = capsys.readouterr()
    assert sorted(os.listdir(tmp_path / "out")) == sorted([*OUTPUTS, "annotated.mp4"])
    facts = facts_of(tmp_path / "out")
    count = facts["frames"]["count"]
    assert 25 < count < 59
    assert facts["complete"] is False
    words = f"{path}: cut short: {count} frames could be read, but the file declares 60"
    assert facts["error"] == words
    assert err == f"survtrack: error: {words}\n"
    assert (json.loads(out)["complete"], json.loads(out)["frames"]) == (False, count)
    with av.open(str(tmp_path / "out" / "annotated.mp4")) as container:
        assert len(list(container.decode(video=0))) == count
    # The frames before the cut have the very tracks of the whole video.
    whole = write_video(tmp_path / "whole.avi", FRAMES, codec="mpeg4")
    assert run(whole, "--out", tmp_path / "whole", "--limit", count) == 0
    assert mot_rows(tmp_path / "whole") == mot_rows(tmp_path / "out")


def test_a_broken_image_midway_keeps_what_was_before(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_images(tmp_path / "in", FRAMES[:20])
    cut_short(tmp_path / "in" / "in000013.png", 0.5)
    assert run(tmp_path / "in", "--out", tmp_path / "out") == 1
    err = capsys.readouterr().err
    assert err.startswith("survtrack: error: ") and "in000013.png: is not an image" in err
    assert err.count("survtrack: error: ") == 1 and err.count("Traceback") == 0
    facts = facts_of(tmp_path / "out")
    assert (facts["complete"], facts["frames"]["last"]) == (False, 12)
    assert sorted(os.listdir(tmp_path / "out")) == OUTPUTS


def test_a_first_image_that_is_broken_leaves_no_folder(tmp_path: Path) -> None:
    write_images(tmp_path / "in", FRAMES[:3])
    cut_short(tmp_path / "in" / "in000001.png", 0.5)
    assert run(tmp_path / "in", "--out", tmp_path / "out") == 1
    assert not (tmp_path / "out").exists()


def full_disk_for(path: Path) -> None:
    """Let the part of `path` be a device on which every write finds no space."""
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    path.parent.mkdir(exist_ok=True)
    path.with_name(path.name + ".part").symlink_to("/dev/full")


@pytest.mark.parametrize("name", ["tracks.txt", "tracks.csv", "config.toml", "run.json"])
def test_a_full_disk_is_told_and_nothing_half_has_a_name(
    clip: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    full_disk_for(tmp_path / "out" / name)
    assert run(clip, "--out", tmp_path / "out", "--quiet") == 1
    words = f"{tmp_path / 'out' / name}: No space left on device"
    assert capsys.readouterr().err == f"survtrack: error: {words}\n"
    assert not (tmp_path / "out" / name).exists()
    if name.startswith("tracks"):
        facts = facts_of(tmp_path / "out")
        assert (facts["complete"], facts["error"]) == (False, words)
        assert name not in facts["outputs"]
    else:
        assert not (tmp_path / "out" / "run.json").exists()


def test_an_output_folder_that_cannot_be_made(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert run(clip, "--out", tmp_path / "file") == 1
    assert capsys.readouterr().err == f"survtrack: error: {tmp_path / 'file'}: File exists\n"


def test_public_footage_end_to_end(data: Path, tmp_path: Path) -> None:
    source = data / "video" / "vtest.avi"
    assert run(source, "--fps", 7, "--limit", 120, "--out", tmp_path, "--video") == 0
    assert facts_of(tmp_path)["tracks"] >= 3
    assert run(data / "cdnet/canoe/input", "--limit", 30, "--out", tmp_path / "canoe") == 0


def test_good_public_files_that_declare_nonsense_are_complete(data: Path, tmp_path: Path) -> None:
    for name, count in (
        ("caviar/OneLeaveShop1cor/OneLeaveShop1cor.mpg", 295),
        ("video/bgslib_video02.avi", 748),
    ):
        assert run(data / name, "--out", tmp_path) == 0
        facts = facts_of(tmp_path)
        assert (facts["complete"], facts["frames"]["count"]) == (True, count)
