# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack run --stream` and `survtrack replay`: what they write, count and say."""

import csv
import json
import os
from pathlib import Path
from typing import Any

import av
import cv2
import numpy as np
import pytest

import survtrack
from clips import walking_square, write_images, write_video
from fakes import Box, Track
from survtrack import Path as ImagePath
from survtrack import Paths, RegionKind
from survtrack.cli.main import main
from survtrack.errors import InputError
from survtrack.path_file import read_paths
from survtrack.replay import read_track_stream, replay_stream
from track_streams import pieces, result_at

FRAMES = walking_square(60, width=128, height=96, side=20, still=20)
GROUND = {
    "image_points": [[10, 90], [118, 90], [90, 40], [38, 40]],
    "ground_points": [[0, 0], [6, 0], [6, 12], [0, 12]],
}


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A video of 60 frames, 10 a second."""
    return write_video(tmp_path_factory.mktemp("clip") / "clip.mp4", FRAMES)


@pytest.fixture(scope="module")
def run_dir(clip: Path) -> Path:
    folder = clip.parent / "out"
    assert main(["run", str(clip), "--out", str(folder), "--stream", "-q"]) == 0
    return folder


@pytest.fixture
def stream(run_dir: Path, tmp_path: Path) -> Path:
    """A copy of the stream without its run.json."""
    path = tmp_path / "tracks.svt"
    path.write_bytes((run_dir / "tracks.svt").read_bytes())
    return path


def replay(*args: object) -> int:
    return main(["replay", *map(str, args)])


def facts_of(capsys: pytest.CaptureFixture[str], *args: object, code: int = 0) -> Any:
    assert replay(*args, "--json") == code
    return json.loads(capsys.readouterr().out)


def pictures_of(path: Path) -> list[np.ndarray]:
    with av.open(str(path)) as container:
        return [picture.to_ndarray(format="bgr24") for picture in container.decode(video=0)]


def test_the_stream_agrees_with_tracks_csv(run_dir: Path) -> None:
    recorded = read_track_stream(run_dir / "tracks.svt")
    assert recorded.problem is None and [frame.index for frame in recorded.frames] == [*range(60)]
    assert (recorded.header.width_px, recorded.header.height_px) == (128, 96)
    with (run_dir / "tracks.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    tracks = [(frame, track) for frame in recorded.frames for track in frame.tracks]
    assert len(rows) == len(tracks) > 30
    for row, (frame, track) in zip(rows, tracks, strict=True):
        assert (int(row["frame"]), int(row["id"])) == (frame.index + 1, track.id)
        assert (float(row["time_s"]), row["status"]) == (frame.time_s, track.status.name)
        box = [float(row[name]) for name in ("left_px", "top_px", "width_px", "height_px")]
        assert [*track.box] == pytest.approx(box, abs=1 / 32 + 1e-3)
        place = float(row["x_px"]), float(row["y_px"])
        assert track.position == pytest.approx(place, abs=1 / 32 + 1e-3)
    assert any(track.measured is not None for _, track in tracks)


def test_the_run_says_what_it_wrote(run_dir: Path, clip: Path) -> None:
    facts = json.loads((run_dir / "run.json").read_text())
    assert "tracks.svt" in facts["outputs"]
    assert facts["source_bytes"] == clip.stat().st_size


def test_the_same_run_gives_the_same_bytes(clip: Path, run_dir: Path, tmp_path: Path) -> None:
    assert main(["run", str(clip), "--out", str(tmp_path), "--stream", "-q"]) == 0
    assert (tmp_path / "tracks.svt").read_bytes() == (run_dir / "tracks.svt").read_bytes()


def test_a_later_run_without_it_removes_it(clip: Path, tmp_path: Path) -> None:
    assert main(["run", str(clip), "--out", str(tmp_path), "--stream", "-q"]) == 0
    assert main(["run", str(clip), "--out", str(tmp_path), "-q"]) == 0
    assert "tracks.svt" not in os.listdir(tmp_path)


def test_source_bytes_of_images_and_of_parts(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "in", FRAMES[:6])
    size = sum(path.stat().st_size for path in folder.iterdir())
    for args, wanted in (([], size), (["--step", "2"], size), (["--limit", "3"], None)):
        assert main(["run", str(folder), "--out", str(tmp_path / "out"), "-q", *args]) == 0
        facts = json.loads((tmp_path / "out" / "run.json").read_text())
        assert facts["source_bytes"] == wanted


def test_the_figures(
    run_dir: Path, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    facts = facts_of(capsys, run_dir / "tracks.svt")
    size = (run_dir / "tracks.svt").stat().st_size
    raw = 128 * 96 * 3 * 60
    assert (facts["complete"], facts["error"], facts["out"]) == (True, None, None)
    assert facts["frames"] == {"first": 1, "last": 60, "count": 60}
    assert (facts["size"], facts["seconds"], facts["tracks"]) == ([128, 96], 6.0, 1)
    assert facts["stream_bytes"] == size
    assert facts["stream_bytes_per_s"] == pytest.approx(size / 6, abs=1e-3)
    assert (facts["raw_bytes"], facts["raw_bytes_per_s"]) == (raw, 128 * 96 * 3 * 10)
    assert facts["raw_ratio"] == pytest.approx(raw / size, abs=1e-3)
    assert facts["source_bytes"] == clip.stat().st_size
    assert facts["source_ratio"] == pytest.approx(clip.stat().st_size / size, abs=1e-3)
    assert facts["raw_ratio"] > 1000


def test_without_run_json_the_source_is_not_known(
    stream: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    facts = facts_of(capsys, stream)
    assert facts["source_bytes"] is facts["source_ratio"] is facts["source_bytes_per_s"] is None
    (stream.parent / "run.json").write_text('{"outputs": ["tracks.csv"], "source_bytes": 5}')
    assert facts_of(capsys, stream)["source_bytes"] is None
    for text in ("[]", "{", '{"outputs": ["tracks.svt"], "source_bytes": -1}'):
        (stream.parent / "run.json").write_text(text)
        assert replay(stream) == 1
        assert f"{stream.parent / 'run.json'}: " in capsys.readouterr().err


def test_the_summary_is_for_people_and_quiet_says_nothing(
    run_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "replay.mp4"
    assert replay(run_dir / "tracks.svt", "--out", out) == 0
    text, err = capsys.readouterr()
    assert "60 frames of 128x96 px in 6.00 s, tracks: 1\nstream: " in text
    assert "\nraw video: 368,640 bytes/s, " in text and "\nsource file: " in text
    assert text.endswith(f"{out}: 60 pictures, 0 predicted\n") and err == ""
    assert replay(run_dir / "tracks.svt", "--quiet") == 0
    assert capsys.readouterr() == ("", "")


def test_the_scene_is_drawn_again_where_it_was(
    stream: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "replay.mp4"
    facts = facts_of(capsys, stream, "--out", out)
    assert (facts["out"], facts["pictures"], facts["fps"]) == (str(out), 60, 10.0)
    pictures = pictures_of(out)
    assert len(pictures) == 60 and pictures[0].shape == (96, 128, 3)
    # The square's left side, at x = 4 + 2 (50 - 20) = 64 in frame 50, is blue.
    column = pictures[50][40:48, 62:67].astype(int)
    assert (column[..., 0] - column[..., 2]).max() > 80
    assert abs(pictures[0].astype(int) - pictures[50]).max() > 80


def test_over_a_picture_or_a_videos_first_frame(stream: Path, clip: Path, tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "green.png"), np.full((192, 256, 3), (0, 250, 0), np.uint8))
    out = tmp_path / "replay.mp4"
    assert replay(stream, "--out", out, "--background", tmp_path / "green.png", "-q") == 0
    assert pictures_of(out)[0][50, 10].tolist() == pytest.approx([0, 150, 0], abs=12)
    assert replay(stream, "--out", out, "--background", clip, "-q") == 0
    assert len(pictures_of(out)) == 60


def test_from_above(stream: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ground = tmp_path / "ground.json"
    ground.write_text(json.dumps(GROUND))
    for args in ([], ["--ground", ground]):
        out = tmp_path / f"{len(args)}.mp4"
        facts = facts_of(capsys, stream, "--out", out, "--view", "above", *args)
        assert (facts["view"], facts["pictures"]) == ("above", 60)
    plain, mapped = (pictures_of(tmp_path / name)[50] for name in ("0.mp4", "2.mp4"))
    assert plain.shape[1] > plain.shape[0] and mapped.shape[0] > mapped.shape[1]


def test_missing_frames_are_predicted_at_the_rate_that_is_asked_for(
    clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    args = ["--out", str(tmp_path), "--stream", "--step", "2", "-q"]
    assert main(["run", str(clip), *args]) == 0
    out = tmp_path / "replay.mp4"
    facts = facts_of(capsys, tmp_path / "tracks.svt", "--out", out, "--fps", 10)
    assert facts["frames"] == {"first": 1, "last": 59, "count": 30}
    assert (facts["pictures"], facts["predicted_pictures"]) == (59, 29)
    assert len(pictures_of(out)) == 59
    assert facts_of(capsys, tmp_path / "tracks.svt", "--out", out)["pictures"] == 30
    short = facts_of(capsys, tmp_path / "tracks.svt", "--out", out, "--fps", 20, "--max-gap", 0.06)
    assert (short["pictures"], short["predicted_pictures"]) == (59, 29)


@pytest.mark.parametrize("damage", ["cut", "flipped"])
def test_what_was_before_the_damage_is_replayed_and_it_ends_with_1(
    stream: Path, tmp_path: Path, damage: str, capsys: pytest.CaptureFixture[str]
) -> None:
    data = bytearray(stream.read_bytes())
    if damage == "cut":
        del data[len(data) // 2 :]
    else:
        data[len(data) // 2] ^= 1
    stream.write_bytes(data)
    out = tmp_path / "replay.mp4"
    assert replay(stream, "--out", out, "--json") == 1
    text, err = capsys.readouterr()
    facts = json.loads(text)
    count = facts["frames"]["count"]
    assert 20 < count < 60 and facts["complete"] is False
    word = "is cut" if damage == "cut" else "is damaged"
    assert facts["error"].startswith(f"{stream}: {word} after frame {count} of it")
    assert err == f"survtrack: error: {facts['error']}\n"
    assert len(pictures_of(out)) == count == facts["pictures"]


def test_a_stream_that_is_cut_before_its_first_frame_leaves_no_video(
    stream: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stream.write_bytes(stream.read_bytes()[:32])
    out = tmp_path / "replay.mp4"
    assert replay(stream, "--out", out) == 1
    text, err = capsys.readouterr()
    assert (
        text == "0 frames of 128x96 px in 0.00 s, tracks: 0\n"
        and "is cut in its first frame; it holds no whole" in err
    )
    assert not out.exists()


def path_file(folder: Path, size: tuple[int, int] = (128, 96)) -> Path:
    """Right along the way of the square, and from x = 90 on down."""
    file = folder / "lane.json"
    lane = ImagePath([(0, 42), (90, 42), (90, 96)], max_distance_px=20)
    file.write_text(Paths({"lane": lane}, size).to_json())
    return file


def corner_of_blue(picture: np.ndarray) -> tuple[float, float]:
    """(x, y) of the lower right corner of what is drawn in blue, above the caption."""
    blue, green, red = (picture[:78, :, channel].astype(int) for channel in range(3))
    y, x = np.nonzero((blue > 150) & (blue > green + 60) & (blue > red + 90))
    assert len(x) > 20, len(x)
    return float(x.max()), float(y.max())


def test_along_a_path_what_is_missing_goes_round_the_bend(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    car = Track(1, Box(70, 32, 20, 20), velocity_px_per_s=(20.0, 0.0))
    results = [result_at(0, 0.0, car), result_at(20, 2.0, car)]
    stream, out = tmp_path / "tracks.svt", tmp_path / "replay.mp4"
    stream.write_bytes(b"".join(pieces(results, size=(128, 96))))
    lane = path_file(tmp_path)
    # 1.5 s after the first, 30 px further: 10 px to the bend and 20 px down, or straight on.
    for args, wanted in ((["--path", lane], (100, 72)), ([], (120, 52))):
        facts = facts_of(capsys, stream, *args, "--out", out)
        assert (facts["pictures"], facts["predicted_pictures"]) == (21, 19)
        shown = pictures_of(out)[15].astype(int)
        assert corner_of_blue(shown) == pytest.approx(wanted, abs=2)
        # The path is drawn, in cyan.
        beside = shown[36:49, 20:60]
        line = (beside[..., 0] > 150) & (beside[..., 1] > 150) & (beside[..., 2] < 120)
        assert bool(line.any(axis=0).mean() > 0.9) is bool(args)
    assert facts_of(capsys, stream, "--path", lane, "--view", "above", "--out", out)["pictures"]


def test_paths_of_other_frames_or_none_are_refused(
    stream: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lane, out = path_file(tmp_path, (64, 48)), tmp_path / "replay.mp4"
    assert replay(stream, "--path", lane, "--out", out) == 1
    message = f"{lane}: is for frames of 64x48, the run's are 128x96"
    assert capsys.readouterr().err == f"survtrack: error: {message}\n"
    with pytest.raises(InputError, match=r"^paths: is for frames of 64x48, the run's are 128x96$"):
        replay_stream(stream, out, paths=read_paths(lane))
    assert replay(stream, "--path", tmp_path / "none.json", "--out", out) == 1
    assert "none.json: no such file" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.parametrize(
    ("args", "code", "words"),
    [
        (["--view", "below"], 2, 'view: unknown "below"; one of: over, above'),
        (["--fps", "0"], 2, "fps: 0.0 pictures/s is not allowed"),
        (["--max-gap", "-1"], 2, "max_gap: -1.0 s is not allowed"),
        (["--ground", "GROUND"], 2, "ground: is for the view above"),
        (["--view", "above", "--background", "CLIP"], 2, "background: the view above has none"),
        (["--background", "none.png"], 1, "none.png"),
        (["--view", "above", "--ground", "none.json"], 1, "none.json: no such file"),
        (["--out", "STREAM"], 2, "is the stream itself"),
        (["--out", "missing/replay.mp4"], 1, "missing/replay.mp4: No such file"),
    ],
)
def test_misuse_and_what_is_missing_are_named(
    stream: Path,
    clip: Path,
    tmp_path: Path,
    args: list[str],
    code: int,
    words: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "ground.json").write_text(json.dumps(GROUND))
    places = {"GROUND": tmp_path / "ground.json", "CLIP": clip, "STREAM": stream}
    before = stream.read_bytes()
    given = [str(places.get(arg, arg)) for arg in args]
    given += [] if "--out" in args else ["--out", str(tmp_path / "replay.mp4")]
    assert replay(stream, *given) == code
    assert words in capsys.readouterr().err
    assert not (tmp_path / "replay.mp4").exists() and stream.read_bytes() == before


def test_what_is_no_stream(clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert replay(clip) == 1
    assert f"{clip}: is no track stream: it begins with" in capsys.readouterr().err
    assert replay(tmp_path / "none.svt") == 1
    assert "none.svt: no such file" in capsys.readouterr().err


@pytest.mark.parametrize("source", ["video/vtest.avi", "caviar/Walk1/input"])
@pytest.mark.parametrize("regions", ["none", "predicted"])
def test_public_footage_takes_a_thousandth_of_its_raw_bytes(
    data: Path, tmp_path: Path, source: str, regions: str, capsys: pytest.CaptureFixture[str]
) -> None:
    args = [str(data / source), "--limit", "150", "--out", str(tmp_path), "--stream", "-q"]
    assert main(["run", *args, "--set", f"regions.model={regions}"]) == 0
    facts = facts_of(capsys, tmp_path / "tracks.svt")
    assert facts["tracks"] >= 1 and facts["raw_ratio"] > 1000
    frames = read_track_stream(tmp_path / "tracks.svt").frames
    assert any(frame.regions for frame in frames) == (regions == "predicted")


def test_the_stream_has_what_the_detector_read_and_the_replay_draws_it(
    clip: Path, tmp_path: Path
) -> None:
    args = ["--out", str(tmp_path), "--stream", "-q", "--set", "regions.model=predicted"]
    assert main(["run", str(clip), *args, "--set", "regions.whole_above=1"]) == 0
    frames = read_track_stream(tmp_path / "tracks.svt").frames
    config = survtrack.Config.from_toml((tmp_path / "config.toml").read_text())
    boxes = []
    for (_, result), frame in zip(survtrack.track(clip, config=config), frames, strict=True):
        parts = [each for each in result.regions if each.kind is not RegionKind.whole_frame]
        assert len(frame.regions) == (len(result.regions) if parts else 0)
        for got, read in zip(frame.regions, result.regions, strict=False):
            assert (got.kind, got.track_id) == (read.kind, read.track_id)
            ends = (got.box.x, got.box.x + got.box.width)
            assert ends == (np.floor(read.box.x), np.ceil(read.box.x + read.box.width))
        boxes.append([each.box for each in parts if each.track_id == 1])
    assert sum(map(bool, boxes)) > 20
    out = tmp_path / "replay.mp4"
    assert replay(tmp_path / "tracks.svt", "--out", out, "-q") == 0
    [box] = boxes[51]  # what is looked at next of frame 50, magenta
    column = pictures_of(out)[50][30:70, max(0, int(box.x) - 1) : int(box.x) + 2].astype(int)
    assert (column[..., [0, 2]].min(axis=2) - column[..., 1]).max() > 60


@pytest.mark.parametrize(
    ("settings", "damping_s"), [([], 2.0), (["--set", "filter.lost_damping_time=0"], None)]
)
def test_the_stream_says_how_lost_tracks_are_damped(
    clip: Path, tmp_path: Path, settings: list[str], damping_s: float | None
) -> None:
    assert main(["run", str(clip), "--out", str(tmp_path), "--stream", "-q", *settings]) == 0
    assert read_track_stream(tmp_path / "tracks.svt").header.lost_damping_s == damping_s
