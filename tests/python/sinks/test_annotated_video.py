# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The video is one that browsers play, and a half one never gets its name."""

import os
import resource
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import av
import numpy as np
import pytest

from clips import Image, walking_square
from fakes import Result, result_of
from survtrack.sinks import AnnotatedVideo


def as_it_is(frame: Image, result: Result) -> Image:
    return frame


def write(path: Path, frames: list[Image], fps: float = 10) -> AnnotatedVideo:
    with AnnotatedVideo(path, as_it_is, fps=fps) as sink:
        for k, frame in enumerate(frames):
            sink.write(frame, result_of(frame, k))
    return sink


def atoms(path: Path) -> list[str]:
    """Names of an MP4's outermost boxes, in order."""
    data, names, at = path.read_bytes(), [], 0
    while at < len(data):
        names.append(data[at + 4 : at + 8].decode("ascii"))
        at += int.from_bytes(data[at : at + 4], "big")
    return names


def test_h264_yuv420p_with_its_index_in_front(tmp_path: Path) -> None:
    path = tmp_path / "annotated.mp4"
    frames = walking_square(25)
    assert write(path, frames, fps=12.5).outputs == ["annotated.mp4"]
    assert os.listdir(tmp_path) == ["annotated.mp4"]
    names = atoms(path)
    assert names.index("moov") < names.index("mdat")
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        assert (stream.codec_context.name, stream.codec_context.pix_fmt) == ("h264", "yuv420p")
        assert (stream.frames, float(stream.average_rate)) == (25, 12.5)
        for picture, frame in zip(container.decode(stream), frames, strict=True):
            shown = picture.to_ndarray(format="bgr24")
            assert np.abs(shown.astype(int) - frame).mean() < 8


@pytest.mark.parametrize(("width", "height"), [(75, 51), (74, 51), (1, 1)])
def test_odd_sides_are_padded_with_their_edge(tmp_path: Path, width: int, height: int) -> None:
    frame = np.full((height, width, 3), 200, np.uint8)
    write(tmp_path / "odd.mp4", [frame] * 3)
    with av.open(str(tmp_path / "odd.mp4")) as container:
        for picture in container.decode(video=0):
            shown = picture.to_ndarray(format="bgr24")
            assert shown.shape == (height + height % 2, width + width % 2, 3)
            assert np.abs(shown.astype(int) - 200).max() < 8


def test_a_run_without_frames_leaves_nothing(tmp_path: Path) -> None:
    assert write(tmp_path / "none.mp4", []).outputs == []
    assert os.listdir(tmp_path) == []


def test_what_was_written_is_finished_on_an_exception(tmp_path: Path) -> None:
    frame = walking_square(1)[0]
    path = tmp_path / "annotated.mp4"
    with pytest.raises(KeyboardInterrupt), AnnotatedVideo(path, as_it_is, fps=10) as sink:
        for k in range(7):
            sink.write(frame, result_of(frame, k))
        raise KeyboardInterrupt
    with av.open(str(path)) as container:
        assert len(list(container.decode(video=0))) == 7


@contextmanager
def file_size_limit(size: int) -> Iterator[None]:
    """Files cannot grow beyond size bytes: as on a full disk, but for anyone."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("count", [3, 200])
def test_a_full_disk_is_told_with_the_name_and_leaves_the_old_file(
    tmp_path: Path, count: int
) -> None:
    path = tmp_path / "annotated.mp4"
    path.write_text("old")
    random = np.random.default_rng(0)
    frames = [random.integers(0, 256, (64, 96, 3), dtype=np.uint8) for _ in range(count)]
    with file_size_limit(4000), pytest.raises(OSError, match="File too large") as caught:
        write(path, frames)
    assert caught.value.filename == str(path)
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["annotated.mp4"]


def test_a_place_that_cannot_be_written_shows_on_entering(tmp_path: Path) -> None:
    with pytest.raises(OSError) as caught:
        write(tmp_path / "missing" / "annotated.mp4", [])
    assert caught.value.filename == str(tmp_path / "missing" / "annotated.mp4")
