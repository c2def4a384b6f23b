# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Annotated video that a browser plays."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

import av
import numpy as np
from av.container import OutputContainer
from av.video.stream import VideoStream

from survtrack.sinks.part_file import naming, part_of

if TYPE_CHECKING:
    from survtrack._core import FrameResult
    from survtrack.sources.base import Frame

# Quality 23 is x264's own default; "veryfast" costs some 20 % in size and keeps writing from being
# what a run waits for.
ENCODER_OPTIONS = {"crf": "23", "preset": "veryfast"}
CONTAINER_OPTIONS = {"movflags": "+faststart"}


class VideoFile:
    """MP4 with H.264, yuv420p, index at the front; pictures at a steady rate.

    H.264 wants even sides: a last column or row is repeated where a side is odd.
    """

    def __init__(self, path: Path | str, *, fps: float) -> None:
        """Args:
        path: the file to write.
        fps: frames per second of the video.
        """
        self._path = Path(path)
        self._rate = Fraction(fps).limit_denominator(100_000)
        self._container: OutputContainer | None = None
        self._stream: VideoStream | None = None
        self._failed = False
        self._done = False

    @property
    def outputs(self) -> list[str]:
        """The file's name once it is in place."""
        return [self._path.name] if self._done else []

    def __enter__(self) -> Self:
        # FFmpeg opens the file with the first picture; a place that cannot be written shows now.
        with naming(self._path):
            part_of(self._path).write_bytes(b"")
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._container is None:
            part_of(self._path).unlink(missing_ok=True)
            return
        container, stream = self._container, self._stream
        self._container = self._stream = None
        told = self._failed
        try:
            with encoding(self._path):
                if stream is not None and not told:
                    container.mux(stream.encode(None))
                container.close()
        except OSError:
            self._failed = True
            if not told:
                raise
        finally:
            # Without its index an MP4 cannot be played; its room may let other files be finished.
            if self._failed:
                part_of(self._path).unlink(missing_ok=True)
        if self._failed:
            return
        with naming(self._path):
            os.replace(part_of(self._path), self._path)
        self._done = True

    def append(self, picture: "Frame") -> None:
        """Append a picture, HxWx3 BGR of one size; raises OSError when it cannot be written."""
        picture = even_sided(picture)
        try:
            with encoding(self._path):
                self._append(picture)
        except OSError:
            self._failed = True
            raise

    def _append(self, picture: "Frame") -> None:
        if self._container is None or self._stream is None:
            self._container = av.open(
                str(part_of(self._path)), "w", format="mp4", options=CONTAINER_OPTIONS
            )
            self._stream = self._container.add_stream(
                "libx264", rate=self._rate, options=ENCODER_OPTIONS
            )
            self._stream.height, self._stream.width = picture.shape[:2]
            self._stream.pix_fmt = "yuv420p"
        image = av.VideoFrame.from_ndarray(picture, format="bgr24")
        self._container.mux(self._stream.encode(image))


class AnnotatedVideo(VideoFile):
    """One picture a result."""

    def __init__(
        self,
        path: Path | str,
        render: "Callable[[Frame, FrameResult], Frame]",
        *,
        fps: float,
    ) -> None:
        """Args:
        path: the file to write.
        render: makes the picture, HxWx3 BGR, of the same size for every frame; such as Views.
        fps: frames per second of the video.
        """
        super().__init__(path, fps=fps)
        self._render = render

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Append the picture of one result; raises OSError when it cannot be written."""
        self.append(self._render(frame, result))


@contextmanager
def encoding(path: Path) -> Iterator[None]:
    """As naming, and make an OSError of what FFmpeg itself finds wrong."""
    with naming(path):
        try:
            yield
        except OSError:
            raise
        except av.FFmpegError as error:
            raise OSError(f"cannot be encoded: {error.strerror}") from error


def even_sided(picture: "Frame") -> "Frame":
    """The picture with its last column and row repeated where a side is odd."""
    height, width = picture.shape[:2]
    if height % 2 == 0 and width % 2 == 0:
        return picture
    return np.pad(picture, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
