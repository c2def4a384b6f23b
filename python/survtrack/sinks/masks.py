# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Foreground masks as PNG files, named as CDnet names results."""

import os
import re
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from survtrack.errors import InputError, UsageError
from survtrack.sinks.part_file import naming

if TYPE_CHECKING:
    from survtrack._core import FrameResult
    from survtrack.sources.base import Frame

MASK_GLOB = "bin*.png"
MASK_NAME = re.compile(r"bin\d{6,}\.png")


def masks_in(folder: Path) -> list[Path]:
    """The folder's masks, by name; none when there is no such folder."""
    if not folder.is_dir():
        return []
    return sorted(path for path in folder.iterdir() if MASK_NAME.fullmatch(path.name))


def mask_name(index: int, file_name: str | None) -> str:
    """Name of the mask of frame `index`.

    With a file name, the last six digits of its last number ("in000470.jpg": bin000470.png);
    without, the frame counted from 1.

    Raises:
        InputError: the file's name has no number.
    """
    if file_name is None:
        return f"bin{index + 1:06d}.png"
    numbers = re.findall(r"\d+", Path(file_name).stem)
    if not numbers:
        raise InputError(f"{file_name}: its mask is named by a number, but this name has none")
    return f"bin{numbers[-1][-6:]:0>6}.png"


class MaskFolder:
    """One PNG a frame, 8-bit, 0 for background and 255 for foreground.

    They are written to FOLDER/masks.part and moved to FOLDER when the sink is left; masks of an
    earlier run go away at that moment, so that those which are there belong together.
    """

    def __init__(
        self, folder: Path | str, file_name: Callable[[int], str | None] = lambda index: None
    ) -> None:
        """Args:
        folder: where the masks go; it must exist when the sink is entered.
        file_name: from a frame's index to its file's name, as Source.file_name.
        """
        self._folder = Path(folder)
        self._staging = self._folder / "masks.part"
        self._file_name = file_name
        self._source_of: dict[str, str] = {}
        self._done = False

    @property
    def outputs(self) -> list[str]:
        """The pattern of all masks once they are in place."""
        return [MASK_GLOB] if self._done else []

    def __enter__(self) -> Self:
        with naming(self._staging):
            if self._staging.exists():
                shutil.rmtree(self._staging)
            self._staging.mkdir()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with naming(self._folder):
            for stale in masks_in(self._folder):
                stale.unlink()
            for mask in masks_in(self._staging):
                os.replace(mask, self._folder / mask.name)
            self._staging.rmdir()
        self._done = True

    def write(self, frame: "Frame", result: "FrameResult") -> None:
        """Write one mask.

        Raises:
            InputError: the file's name has no number, or the same as one before.
            OSError: the mask cannot be written; no part of it is left.
        """
        name = self._claim(result.index)
        path = self._staging / name
        try:
            with naming(self._folder / name):
                path.write_bytes(encode_png(result.mask))
        except OSError:
            path.unlink(missing_ok=True)
            raise

    def check_names(self, indices: Iterable[int]) -> None:
        """Raise the InputError that write() would for the name of one of these frames."""
        for index in indices:
            self._claim(index)

    def _claim(self, index: int) -> str:
        file_name = self._file_name(index)
        name = mask_name(index, file_name)
        source = file_name or f"frame {index + 1}"
        other = self._source_of.setdefault(name, source)
        if other != source:
            raise InputError(f"{source}: its mask would be {name}, as that of {other}")
        return name


def encode_png(mask: "Frame") -> bytes:
    """PNG bytes of a grey image; raises UsageError for anything that PNG cannot hold."""
    import cv2

    ok, data = cv2.imencode(".png", mask)
    if not ok:
        raise UsageError(f"mask: shape {mask.shape} and type {mask.dtype} cannot become a PNG")
    return data.tobytes()
