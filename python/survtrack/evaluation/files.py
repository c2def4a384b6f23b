# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Opening what a user named, with an error that says what is wrong with it."""

import os
from pathlib import Path

from survtrack.errors import InputError

StrPath = str | os.PathLike[str]


def read_bytes(path: Path) -> bytes:
    """The whole file, or an InputError that names it."""
    try:
        return path.read_bytes()
    except IsADirectoryError as error:
        raise InputError(f"{path}: is a folder, a file is needed") from error
    except FileNotFoundError as error:
        raise InputError(f"{path}: no such file") from error
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error


def require_folder(path: Path) -> Path:
    """The path itself when it is a folder, otherwise an InputError that names it."""
    if not path.is_dir():
        problem = "is a file, a folder is needed" if path.exists() else "no such folder"
        raise InputError(f"{path}: {problem}")
    return path
