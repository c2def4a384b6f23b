# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Boxes from a file of whichever known format."""

from pathlib import Path

from survtrack.errors import InputError
from survtrack.evaluation.boxes import Boxes
from survtrack.evaluation.cvml import read_cvml
from survtrack.evaluation.files import StrPath, read_bytes
from survtrack.evaluation.mot import LAYOUT, read_mot


def read_boxes(path: StrPath, *, truth: bool = False) -> Boxes:
    """Read truth (MOT text or CVML) or tracks (MOT text only); the content decides which.

    Raises:
        InputError: as read_mot and read_cvml do; XML where tracks are expected.
    """
    path = Path(path)
    start = read_bytes(path)[:1024].removeprefix(b"\xef\xbb\xbf").lstrip()
    is_xml = start.startswith(b"<") or path.suffix.lower() == ".xml"
    if not is_xml:
        return read_mot(path, truth=truth)
    if not truth:
        raise InputError(f"{path}: is XML, but tracks are expected as MOT text: {LAYOUT}")
    return read_cvml(path)
