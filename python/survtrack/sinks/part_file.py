# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A file that gets its name when it is whole."""

import errno
import os
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, AnyStr, Generic


def part_of(path: Path) -> Path:
    """Where `path` is written before it is whole: the same name and ".part"."""
    return path.with_name(path.name + ".part")


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Make an OSError raised inside name the file: a full disk names none by itself."""
    try:
        yield
    except OSError as error:
        if error.errno is None:
            raise OSError(f"{path}: {error}") from error
        raise OSError(error.errno, error.strerror, str(path)) from error


class _PartFile(ABC, Generic[AnyStr]):
    """Text or bytes written to NAME.part and renamed to NAME, in one step, by finish().

    Attributes:
        path: the final name.
        done: True once the file has its final name.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.done = False
        self._file: IO[AnyStr] | None = None
        self._failed = False

    @property
    def failed(self) -> bool:
        """True once a write failed."""
        return self._failed

    def open(self) -> None:
        """Start an empty NAME.part; raises OSError, also where NAME is a folder."""
        with naming(self.path):
            if self.path.is_dir():
                raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
            self._file = self._opened(part_of(self.path))

    @abstractmethod
    def _opened(self, part: Path) -> IO[AnyStr]:
        """The part, empty."""

    def write(self, text: AnyStr) -> None:
        """Append; raises OSError, after which the file can no longer become whole."""
        if self._file is None:
            raise ValueError(f"{self.path}: written to while it is not open")
        try:
            with naming(self.path):
                self._file.write(text)
        except OSError:
            self._failed = True
            raise

    def flush(self) -> None:
        """Let readers of NAME.part see what was written."""
        if self._file is not None:
            with naming(self.path):
                self._file.flush()

    def finish(self) -> None:
        """Close and rename; after a failed write only close, and leave NAME.part as it is."""
        if self._file is None:
            return
        file, self._file = self._file, None
        try:
            with naming(self.path):
                file.close()
        except OSError:
            if self._failed:
                return
            raise
        if not self._failed:
            with naming(self.path):
                os.replace(part_of(self.path), self.path)
            self.done = True

    def discard(self) -> None:
        """Close, and leave no part."""
        if self._file is not None:
            file, self._file = self._file, None
            file.close()
            part_of(self.path).unlink(missing_ok=True)


class PartFile(_PartFile[str]):
    """UTF-8 text."""

    def _opened(self, part: Path) -> IO[str]:
        return part.open("w", encoding="utf-8", newline="\n")


class BytesPartFile(_PartFile[bytes]):
    """Bytes."""

    def _opened(self, part: Path) -> IO[bytes]:
        return part.open("wb")


def write_whole(path: Path, text: str) -> None:
    """Write a small file by way of its part; raises OSError."""
    file = PartFile(path)
    file.open()
    try:
        file.write(text)
    finally:
        file.finish()


def write_whole_bytes(path: Path, data: bytes) -> None:
    """The same for what is no text; no part of it is left when it fails."""
    part = part_of(path)
    try:
        with naming(path):
            part.write_bytes(data)
            os.replace(part, path)
    except OSError:
        part.unlink(missing_ok=True)
        raise
