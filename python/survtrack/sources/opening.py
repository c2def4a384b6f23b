# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From what the user typed to a source."""

import glob
import os
from collections.abc import Iterable
from pathlib import Path

from survtrack.errors import InputError, UsageError
from survtrack.sources.arrays import ArraySource
from survtrack.sources.base import Frame, Size, Source
from survtrack.sources.images import (
    IMAGE_SUFFIXES,
    ImageSource,
    images_in_folder,
    images_of_glob,
)
from survtrack.sources.selection import Selection


def open_source(
    spec: str | os.PathLike[str] | Iterable[Frame] | Source,
    *,
    fps: float | None = None,
    start: int = 0,
    step: int = 1,
    limit: int | None = None,
    resize: Size | None = None,
) -> Source:
    """Open whatever holds frames.

    Args:
        spec: a video file; the URL of a stream; a camera (/dev/video0); a folder of images, an
            image, or a glob of images ("in/*.jpg"), in natural order of their names; an iterable
            of uint8 arrays; or a Source, which is returned as it is and takes no options.
        fps: frames per second; overrides the container's times. Images and arrays: 25 when None.
        start: how many frames are skipped first.
        step: every step-th frame is taken.
        limit: most frames taken.
        resize: (width, height) in pixels to scale frames to. Everything found is then in pixels
            of the scaled frames.

    Raises:
        InputError: nothing there that can be read; the message names it.
        UsageError: a bad option, or any option with a Source.
    """
    if isinstance(spec, Source):
        refuse_options(spec, fps=fps, start=start, step=step, limit=limit, resize=resize)
        return spec
    selection = Selection(start, step, limit)
    if not isinstance(spec, (str, os.PathLike)):
        return ArraySource(spec, fps=fps, selection=selection, resize=resize)
    text = os.fspath(spec)
    files = image_files(text)
    if files is not None:
        return ImageSource(files, name=text, fps=fps, selection=selection, resize=resize)
    from survtrack.sources.video import VideoSource

    return VideoSource(text, fps=fps, selection=selection, resize=resize)


def refuse_options(
    source: Source,
    *,
    fps: float | None,
    start: int,
    step: int,
    limit: int | None,
    resize: Size | None,
) -> None:
    """Raise UsageError for an option that is not the default: the source is open already."""
    given = {"fps": fps, "start": start, "step": step, "limit": limit, "resize": resize}
    usual = {"fps": None, "start": 0, "step": 1, "limit": None, "resize": None}
    for name, value in given.items():
        if value != usual[name]:
            raise UsageError(
                f"{name}: {value} is not allowed with {source.name}, which is a source already; "
                "give the option where that is made"
            )


def image_files(text: str) -> list[Path] | None:
    """Image files that a folder, image or glob stands for; None when it is none of them."""
    if not text:
        raise InputError("the source has an empty name")
    path = Path(text)
    if path.is_dir():
        return images_in_folder(path)
    if path.is_file() and path.suffix.lower() in IMAGE_SUFFIXES:
        return [path]
    if not path.exists() and "://" not in text and glob.has_magic(text):
        return images_of_glob(text)
    return None


def bytes_of_files(source: Source) -> int | None:
    """Size of the file or files that a source reads; None unless it reads the whole of them."""
    selection = source.selection
    if source.endless or selection.start or selection.limit is not None:
        return None
    path = Path(source.name)
    try:
        files = [path] if path.is_file() else image_files(source.name)
        return None if files is None else sum(file.stat().st_size for file in files)
    except (InputError, OSError):
        return None
