# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Video files and live streams, decoded by FFmpeg through PyAV."""

import re
from collections.abc import Iterator
from pathlib import Path

import av
import numpy as np
from av.container import InputContainer
from av.video.frame import VideoFrame
from av.video.reformatter import VideoReformatter

from survtrack.errors import InputError
from survtrack.sources.base import (
    DEFAULT_FPS,
    Frame,
    Size,
    check_fps,
    check_resize,
    resized,
)
from survtrack.sources.decoding import Decoder
from survtrack.sources.selection import Selection
from survtrack.sources.timing import (
    ContainerClock,
    SteadyClock,
    container_fps,
    declared_duration_s,
)

# A file that ends before this share of what its header promises was cut short. Some good files
# promise a few frames too many; counts up to 10 are not believed at all.
WHOLE_SHARE = 0.98
BELIEVED_ABOVE = 10
NETWORK_TIMEOUT_S = 10.0
CAMERA_FORMAT = "v4l2"
# FFmpeg plays any .txt as the output of a terminal; here it is a file that is no video.
TEXT_ART_CODECS = frozenset({"ansi", "bintext", "idf", "xbin"})


class VideoSource:
    """Frames of a video as HxWx3 BGR, turned upright, with the container's own times.

    Times count from the container's first frame. With fps given, frame k has the time k / fps.
    """

    def __init__(
        self,
        location: str,
        *,
        fps: float | None = None,
        selection: Selection | None = None,
        resize: Size | None = None,
    ) -> None:
        """Opens the video and reads its header.

        Args:
            location: path of a file, URL of a stream, or camera (/dev/video0).

        Raises:
            InputError: the file is missing, empty, a folder or no video.
            UsageError: a bad option.
        """
        self.name = without_password(location)
        self._location = location
        self.selection = selection or Selection()
        self._given_fps = check_fps(fps)
        self._resize = check_resize(resize)
        self._opened: InputContainer | None = open_video(location)
        stream = self._opened.streams.video[0]
        known_fps = fps or container_fps(stream)
        self.fps = known_fps or DEFAULT_FPS
        self.fps_origin = "given" if fps else "container" if known_fps else "default"
        self._declared_s = declared_duration_s(stream)
        self.frame_count_declared = stream.frames or self._frames_in(self._declared_s)
        self.endless = is_camera(location) or (is_url(location) and not self._opened.duration)
        self.size = resize
        self.original_size: Size | None = None

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
        """Decode from the start.

        Raises:
            InputError: a frame cannot be decoded, changes size or has no rising time; or the file
                ends before 98 % of what it declares.
            UsageError: start skips all frames.
        """
        container = self._opened or open_video(self._location)
        self._opened = None
        with container:
            yield from self._read(container)

    def file_name(self, index: int) -> str | None:
        """None: the frames of a video are not files."""
        return None

    def _read(self, container: InputContainer) -> Iterator[tuple[int, float, Frame]]:
        clock = self._clock(container)
        to_bgr = VideoReformatter()
        decoder = Decoder(container, self.name)
        taken = 0
        time_s = 0.0
        size = None
        for index, picture in enumerate(decoder):
            size = self._same_size(picture, size, index)
            time_s = clock.time_s(index, picture)
            if not self.selection.wants(index):
                continue
            yield index, time_s, self._image(to_bgr, picture)
            taken += 1
            if taken == self.selection.limit:
                return
        self._refuse_cut(container, decoder, time_s)
        self.selection.refuse_nothing(self.name, decoder.count)

    def _clock(self, container: InputContainer) -> ContainerClock | SteadyClock:
        if self._given_fps:
            return SteadyClock(self._given_fps)
        stream = container.streams.video[0]
        return ContainerClock(stream, container.format.name, self.name, self.fps)

    def _same_size(self, picture: VideoFrame, expected: Size | None, index: int) -> Size:
        size = (picture.width, picture.height)
        if expected is not None and size != expected:
            raise InputError(
                f"{self.name}: frame {index + 1} is {size[0]}x{size[1]}, "
                f"but the frames before are {expected[0]}x{expected[1]}"
            )
        return size

    def _image(self, to_bgr: VideoReformatter, picture: VideoFrame) -> Frame:
        image = to_bgr.reformat(picture, format="bgr24").to_ndarray().astype(np.uint8, copy=False)
        if picture.rotation:
            image = np.ascontiguousarray(np.rot90(image, round(picture.rotation / 90)))
        self.original_size = (image.shape[1], image.shape[0])
        image = resized(image, self._resize)
        self.size = (image.shape[1], image.shape[0])
        return image

    def _frames_in(self, duration_s: float | None) -> int | None:
        return None if duration_s is None else round(duration_s * self.fps)

    def _refuse_cut(self, container: InputContainer, decoder: Decoder, last_s: float) -> None:
        """Raise InputError when the video ended well before what its header declares."""
        frames = container.streams.video[0].frames
        declared = frames - decoder.discarded
        found = f"{self.name}: cut short: {decoder.count} frames could be read"
        if declared > BELIEVED_ABOVE and decoder.count < WHOLE_SHARE * declared:
            raise InputError(f"{found}, but the file declares {declared}")
        if frames or not self._declared_s or self._given_fps:
            return
        about = self._frames_in(self._declared_s) or 0
        end_s = last_s + 1 / self.fps
        if about > BELIEVED_ABOVE and end_s < WHOLE_SHARE * self._declared_s:
            raise InputError(
                f"{found} ({end_s:.2f} s), "
                f"but the file declares {self._declared_s:.2f} s, about {about} frames"
            )


def is_url(location: str) -> bool:
    """True for "rtsp://..." and the like."""
    scheme, mark, _ = location.partition("://")
    return bool(mark) and scheme.isalnum()


def is_camera(location: str) -> bool:
    """True for a camera of this machine: "/dev/video0"."""
    return re.fullmatch(r"/dev/video\d+", location) is not None


def without_password(location: str) -> str:
    """The location without the user name and password that a URL may carry."""
    return re.sub(r"://[^/@]*@", "://", location)


def open_video(location: str) -> InputContainer:
    """Open a container that has a video stream; raise InputError that names it."""
    if not is_url(location):
        refuse_no_file(Path(location))
    name = without_password(location)
    timeout = (NETWORK_TIMEOUT_S, NETWORK_TIMEOUT_S) if is_url(location) else None
    device = CAMERA_FORMAT if is_camera(location) else None
    try:
        container = av.open(location, format=device, timeout=timeout)
    except (av.FFmpegError, OSError) as error:
        raise InputError(f"{name}: is not a video that can be read: {reason(error)}") from error
    streams = container.streams.video
    if streams and streams[0].codec_context.name not in TEXT_ART_CODECS:
        return container
    container.close()
    raise InputError(f"{name}: has no video in it")


def refuse_no_file(path: Path) -> None:
    """Raise InputError unless path is a file with something in it."""
    if not path.exists():
        raise InputError(f"{path}: no such file or folder")
    if path.is_file() and path.stat().st_size == 0:
        raise InputError(f"{path}: is an empty file")


def reason(error: Exception) -> str:
    """What FFmpeg says, without number and path."""
    return str(getattr(error, "strerror", None) or error)
