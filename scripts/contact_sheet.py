# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Six frames of a video, evenly spread, in one picture.

usage: contact_sheet.py VIDEO PICTURE
"""

import sys
from pathlib import Path

import cv2

from survtrack import InputError
from survtrack.drawing import contact_sheet
from survtrack.sources import open_source

FRAMES = 6


def make_contact_sheet(video: Path, picture: Path) -> None:
    """Writes the picture; raises InputError for a bad video, OSError when it cannot be written."""
    count = open_source(video).frame_count_declared
    if count is None or count < FRAMES:
        raise InputError(f"{video}: declares {count} frames; at least {FRAMES} are needed")
    step = count // FRAMES
    chosen = [frame for _, _, frame in open_source(video, start=step // 2, step=step, limit=FRAMES)]
    encoded, data = cv2.imencode(picture.suffix, contact_sheet(chosen, columns=3))
    if not encoded:
        raise OSError(f"{picture}: cannot be encoded")
    picture.write_bytes(data.tobytes())


if __name__ == "__main__":
    make_contact_sheet(Path(sys.argv[1]), Path(sys.argv[2]))
