# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Folders, globs and lists of image files."""

import glob
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from survtrack.errors import InputError
from survtrack.sources.base import (
    DEFAULT_FPS,
    Frame,
    Size,
    check_fps,
    check_frame,
    check_resize,
    resized,
)
from survtrack.sources.selection import Selection

IMAGE_SUFFIXES = (".bmp", ".jp2", ".jpeg", ".jpg", ".pgm", ".png", ".ppm", ".tif", ".tiff", ".webp")


class ImageSource:
    """Image files in the order given; the k-th file, from 0, has index k and time k / fps.

    Files are 8-bit grey or colour; transparency is ignored, orientation tags are obeyed.
    """

    endless = False

    def __init__(
        self,
        files: Sequence[Path],
        *,
        name: str,
        fps: float | None = None,
        selection: Selection | None = None,
        resize: Size | None = None,
    ) -> None:
        """Opens the first selected image.

        Raises:
            InputError: no files, or the first selected one cannot be read.
            UsageError: a bad option, or one that skips all files.
        """
        self.name = name
        self.fps_origin = "default" if fps is None else "given"
        self.fps = check_fps(fps) or DEFAULT_FPS
        self.selection = selection or Selection()
        self.frame_count_declared = len(files)
        self.selection.refuse_nothing(name, len(files))
        self._files = list(files)
        self._resize = check_resize(resize)
        first = read_image(self._files[self.selection.start])
        self._shape = first.shape
        self.original_size = (first.shape[1], first.shape[0])
        self.size = resize or self.original_size

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
        """Raises InputError that names the file which is broken or unlike the first."""
        for index in self.selection.indices(len(self._files)):
            frame = read_image(self._files[index], self._shape)
            yield index, index / self.fps, resized(frame, self._resize)

    def file_name(self, index: int) -> str | None:
        """Name of the file of frame `index`, without its folder."""
        return self._files[index].name


def read_image(path: Path, expected: tuple[int, ...] | None = None) -> Frame:
    """Read one 8-bit image, HxW or HxWx3 BGR; raise InputError that names the file."""
    import cv2

    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from error
    image = None
    # Older versions of OpenCV fill up the missing part of a JPEG that was cut short with grey.
    if data and not is_cut_jpeg(data):
        flags = cv2.IMREAD_ANYCOLOR | cv2.IMREAD_ANYDEPTH
        image = cv2.imdecode(np.frombuffer(data, np.uint8), flags)
    if image is None:
        raise InputError(f"{path}: is not an image, or a broken one ({len(data)} bytes)")
    return check_frame(image, str(path), expected)


def is_cut_jpeg(data: bytes) -> bool:
    """True for JPEG data whose last scan (FF DA) is not followed by the end marker (FF D9)."""
    return data.startswith(b"\xff\xd8") and data.rfind(b"\xff\xd9") <= data.rfind(b"\xff\xda")


def natural_key(path: Path) -> list[str | int]:
    """Sort key in which digits count as numbers: frame2 comes before frame10."""
    parts = re.split(r"(\d+)", str(path))
    return [int(part) if part.isdigit() else part for part in parts]


def images_in_folder(folder: Path) -> list[Path]:
    """The folder's images in natural order; hidden files and other kinds of files do not count.

    Raises:
        InputError: no images, or images of several kinds (a glob then says which are meant).
    """
    try:
        entries = sorted(folder.iterdir(), key=natural_key)
    except OSError as error:
        raise InputError(f"{folder}: {error.strerror}") from error
    files = [p for p in entries if p.suffix.lower() in IMAGE_SUFFIXES and p.name[0] != "."]
    if not files:
        raise InputError(f"{folder}: no images in this folder; looked for {list_suffixes()}")
    kinds = Counter(path.suffix.lower() for path in files)
    if len(kinds) > 1:
        counts = ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items()))
        raise InputError(
            f"{folder}: images of several kinds ({counts}); say which by a glob such as "
            f"'{folder / ('*' + kinds.most_common(1)[0][0])}'"
        )
    return files


def images_of_glob(pattern: str) -> list[Path]:
    """Files that match the pattern, in natural order; InputError when there are none."""
    files = [Path(name) for name in glob.glob(pattern, recursive=True)]
    files = sorted((path for path in files if path.is_file()), key=natural_key)
    if not files:
        raise InputError(f"{pattern}: no file matches this pattern")
    return files


def list_suffixes() -> str:
    """The suffixes that make a file an image, in words."""
    return ", ".join(IMAGE_SUFFIXES)
