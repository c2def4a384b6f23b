# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Streams from a network and cameras have no end that anyone knows."""

import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import av
import pytest

from clips import walking_square, write_video
from fakes import Pipeline
from survtrack.errors import InputError, UsageError
from survtrack.runner import refuse_endless_delay
from survtrack.sources import VideoSource, open_source


@pytest.fixture
def stream(tmp_path: Path) -> Iterator[str]:
    """URL of a sender that gives a transport stream of 30 frames to whoever connects first."""
    data = write_video(tmp_path / "live.ts", walking_square(30)).read_bytes()
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(20)

        def send() -> None:
            with server.accept()[0] as connection:
                connection.sendall(data)

        sender = threading.Thread(target=send)
        sender.start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}"
        sender.join()


def test_a_stream_is_endless_and_gives_its_frames_once(stream: str) -> None:
    source = open_source(stream)
    assert isinstance(source, VideoSource)
    assert source.endless
    assert source.frame_count_declared is None
    with pytest.raises(UsageError, match=r"is a live stream, but .* 75 frames late"):
        refuse_endless_delay(source, Pipeline(75))  # type: ignore[arg-type]
    times = [time_s for _, time_s, _ in source]
    assert times == pytest.approx([k / 10 for k in range(30)])


def test_a_stream_that_is_not_there_is_named_without_its_password() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    with pytest.raises(InputError) as caught:
        open_source(f"tcp://guard:secret@127.0.0.1:{port}")
    assert str(caught.value).startswith(f"tcp://127.0.0.1:{port}: is not a video")
    assert "secret" not in str(caught.value)


def test_a_camera_is_opened_as_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    clip = write_video(tmp_path / "clip.mp4", walking_square(3))
    formats = []

    def open_instead(location: str, *, format: str, timeout: None) -> object:
        formats.append((location, format))
        return real_open(str(clip))

    real_open = av.open
    monkeypatch.setattr(av, "open", open_instead)
    monkeypatch.setattr(Path, "exists", lambda path: True)
    source = open_source("/dev/video0")
    assert source.endless
    assert formats == [("/dev/video0", "v4l2")]


def test_a_camera_that_is_not_there_is_named() -> None:
    with pytest.raises(InputError, match="/dev/video999: no such file or folder"):
        open_source("/dev/video999")
