# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Video files: pixels, true times, and every kind of file that is none."""

import shutil
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import av
import numpy as np
import pytest

from clips import cut_short, walking_square, write_video
from survtrack.errors import InputError, UsageError
from survtrack.sources import VideoSource, open_source
from survtrack.sources.video import without_password


def read_until_error(source: VideoSource) -> tuple[int, str]:
    """Frames read, and what ended it."""
    count = 0
    with pytest.raises(InputError) as caught:
        for _ in source:
            count += 1
    return count, str(caught.value)


def test_frames_and_times_of_a_whole_video(tmp_path: Path) -> None:
    frames = walking_square(20)
    source = open_source(write_video(tmp_path / "clip.mp4", frames))
    items = list(source)
    assert [index for index, _, _ in items] == list(range(20))
    assert [time_s for _, time_s, _ in items] == pytest.approx([k / 10 for k in range(20)])
    # The encoder loses some detail, most of it in colour.
    assert all(np.abs(frame.astype(int) - frames[k]).mean() < 5 for k, _, frame in items)
    assert (source.size, source.fps, source.fps_origin) == ((96, 64), 10.0, "container")
    assert source.frame_count_declared == 20
    assert not source.endless


def test_frames_are_distinct_and_a_source_can_be_read_again(tmp_path: Path) -> None:
    source = open_source(write_video(tmp_path / "clip.mp4", walking_square(6)))
    once = [frame for _, _, frame in source]
    again = [frame for _, _, frame in source]
    assert all(np.array_equal(a, b) for a, b in zip(once, again, strict=True))
    assert not any(np.array_equal(a, b) for a, b in pairwise(once))


def test_times_are_the_containers_own(tmp_path: Path) -> None:
    times = [0, 1, 2, 5, 6, 9]
    path = write_video(tmp_path / "late.mkv", walking_square(6), times=times)
    assert [t for _, t, _ in open_source(path)] == pytest.approx([k / 10 for k in times])


def test_times_count_from_the_first_frame(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.ts", walking_square(4), times=[50, 51, 52, 53])
    assert [t for _, t, _ in open_source(path)] == pytest.approx([0, 0.1, 0.2, 0.3])


def test_fps_overrides_the_container(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.mp4", walking_square(4))
    source = open_source(path, fps=4)
    assert [t for _, t, _ in source] == [0, 0.25, 0.5, 0.75]
    assert (source.fps, source.fps_origin) == (4, "given")


def test_selection_keeps_position_and_time(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.mp4", walking_square(12))
    items = [(k, round(t, 6)) for k, t, _ in open_source(path, start=3, step=4, limit=2)]
    assert items == [(3, 0.3), (7, 0.7)]


def test_start_after_the_end_is_misuse(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.mp4", walking_square(5))
    with pytest.raises(UsageError, match=r"start: 5 skips all 5 frames of .*clip\.mp4"):
        list(open_source(path, start=5))


def test_odd_sizes_and_resize(tmp_path: Path) -> None:
    frames = walking_square(2, width=75, height=51)
    path = write_video(tmp_path / "clip.avi", frames, codec="mpeg4")
    assert [frame.shape for _, _, frame in open_source(path)] == [(51, 75, 3)] * 2
    source = open_source(path, resize=(40, 30))
    assert [frame.shape for _, _, frame in source] == [(30, 40, 3)] * 2


def test_a_turned_phone_gives_upright_frames(tmp_path: Path) -> None:
    frames = walking_square(3)
    path = tmp_path / "turned.mp4"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=10)
        stream.height, stream.width, stream.pix_fmt = 64, 96, "yuv420p"
        stream.set_display_rotation(90)
        for frame in frames:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(frame, format="bgr24")))
        container.mux(stream.encode(None))
    with av.open(str(path)) as container:
        turned = next(container.decode(video=0)).rotation
    upright = next(iter(open_source(path)))[2]
    assert upright.shape == (96, 64, 3)
    expected = np.rot90(frames[0], turned // 90)
    assert np.abs(upright.astype(int) - expected).mean() < 5


@pytest.mark.parametrize("codec", ["mpeg4", "libx264"])
def test_reordered_pictures_in_avi_have_rising_times(tmp_path: Path, codec: str) -> None:
    path = write_video(tmp_path / "clip.avi", walking_square(20), codec=codec, b_frames=2)
    times = [t for _, t, _ in open_source(path)]
    assert times == pytest.approx([k / 10 for k in range(20)])


def test_a_file_without_times_asks_for_fps(tmp_path: Path) -> None:
    path = write_video(tmp_path / "bare.h264", walking_square(5), format_name="h264")
    count, message = read_until_error(VideoSource(str(path)))
    assert count == 0
    assert message == f"{path}: frame 1 has no time in this file; give the frame rate with --fps"
    assert [t for _, t, _ in open_source(path, fps=10)] == [0, 0.1, 0.2, 0.3, 0.4]


def test_times_that_do_not_rise_ask_for_fps(tmp_path: Path) -> None:
    path = tmp_path / "jumps.ts"
    one = write_video(tmp_path / "one.ts", walking_square(6)).read_bytes()
    path.write_bytes(one + one)
    count, message = read_until_error(VideoSource(str(path)))
    assert 0 < count < 12
    assert "which is not after" in message
    assert message.endswith("give the frame rate with --fps")
    assert len(list(open_source(path, fps=10))) == 12


@pytest.mark.parametrize(
    ("name", "share"), [("clip.avi", 0.5), ("clip.mp4", 0.7), ("clip.mkv", 0.7)]
)
def test_a_file_cut_short_gives_its_frames_then_both_counts(
    tmp_path: Path, name: str, share: float
) -> None:
    whole = write_video(tmp_path / f"whole_{name}", walking_square(40))
    cut = tmp_path / name
    shutil.copy(whole, cut)
    if name.endswith(".mp4"):  # its index stands at the end: put it in front before the cut
        with (
            av.open(str(whole)) as source,
            av.open(str(cut), "w", options={"movflags": "faststart"}) as target,
        ):
            stream = target.add_stream_from_template(source.streams.video[0])
            for packet in source.demux(video=0):
                if packet.dts is not None:
                    packet.stream = stream
                    target.mux(packet)
    count, message = read_until_error(VideoSource(str(cut_short(cut, share))))
    assert 5 < count < 39
    assert message.startswith(f"{cut}: cut short: {count} frames could be read")
    assert message.endswith(" 40") or message.endswith("about 40 frames")


def test_a_few_missing_frames_are_forgiven(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.avi", walking_square(100), codec="mpeg4")
    data = bytearray(path.read_bytes())
    declared = data.index(b"avih") + 8 + 16
    assert int.from_bytes(data[declared : declared + 4], "little") == 100
    length = data.index(b"strh") + 8 + 32
    assert int.from_bytes(data[length : length + 4], "little") == 100
    for count, fine in ((102, True), (104, False)):
        data[length : length + 4] = count.to_bytes(4, "little")
        path.write_bytes(data)
        if fine:
            assert len(list(open_source(path))) == 100
        else:
            read, message = read_until_error(VideoSource(str(path)))
            assert read == 100
            assert message.endswith(f"but the file declares {count}")


def test_a_change_of_size_midway_is_named(tmp_path: Path) -> None:
    path = tmp_path / "grows.ts"
    small = write_video(tmp_path / "small.ts", walking_square(6)).read_bytes()
    large = write_video(tmp_path / "large.ts", walking_square(6, width=128)).read_bytes()
    path.write_bytes(small + large)
    source = VideoSource(str(path), fps=10)
    count, message = read_until_error(source)
    assert count == 6
    assert message == f"{path}: frame 7 is 128x64, but the frames before are 96x64"


def test_a_damaged_picture_is_named(tmp_path: Path) -> None:
    path = write_video(tmp_path / "clip.avi", walking_square(8), codec="ffv1")
    with av.open(str(path)) as container:
        third = [packet.pos for packet in container.demux(video=0)][2]
    data = bytearray(path.read_bytes())
    data[third : third + 600] = b"\xff" * 600
    path.write_bytes(data)
    with av.open(str(path)) as container, pytest.raises(av.FFmpegError):
        list(container.decode(video=0))
    count, message = read_until_error(VideoSource(str(path)))
    assert count == 2
    assert message.startswith(f"{path}: cannot be decoded after frame 2: ")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is an empty file"),
        (b"hello" * 100, "(is not a video that can be read|has no video in it)"),
    ],
)
@pytest.mark.parametrize("suffix", [".avi", ".mp4", ".txt", ""])
def test_a_file_that_is_no_video(tmp_path: Path, content: bytes, words: str, suffix: str) -> None:
    path = tmp_path / f"file{suffix}"
    path.write_bytes(content)
    with pytest.raises(InputError, match=f"{path}: {words}"):
        open_source(path)


def test_a_file_with_sound_only(tmp_path: Path) -> None:
    path = tmp_path / "sound.wav"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("pcm_s16le", rate=8000)
        sound = av.AudioFrame.from_ndarray(np.zeros((1, 800), np.int16), "s16", "mono")
        sound.sample_rate, sound.pts, sound.time_base = 8000, 0, Fraction(1, 8000)
        container.mux(stream.encode(sound))
        container.mux(stream.encode(None))
    with pytest.raises(InputError, match=r"sound\.wav: has no video in it"):
        open_source(path)


def test_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"missing\.avi: no such file or folder"):
        open_source(tmp_path / "missing.avi")


def test_passwords_of_streams_are_not_told() -> None:
    url = "rtsp://guard:secret@camera.local/live"
    assert without_password(url) == "rtsp://camera.local/live"
    assert without_password("videos/a@b.mp4") == "videos/a@b.mp4"


@pytest.mark.parametrize(
    ("name", "count", "fps", "last_s"),
    [
        ("video/vtest.avi", 795, 10, 79.4),
        ("video/bgslib_video02.avi", 748, 25, 29.88),
        ("caviar/OneLeaveShop1cor/OneLeaveShop1cor.mpg", 295, 25, 11.76),
        ("video/atrium.mp4", 431, 30, 430 / 30),
    ],
)
def test_good_public_files_are_whole_whatever_they_declare(
    data: Path, name: str, count: int, fps: float, last_s: float
) -> None:
    times = [time_s for _, time_s, _ in open_source(data / name)]
    assert len(times) == count
    assert times[-1] == pytest.approx(last_s)
    assert np.diff(times) == pytest.approx(1 / fps)
