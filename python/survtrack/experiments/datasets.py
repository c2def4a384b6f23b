# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Sets of footage with true tracks: the public ones, and where they lie in a folder of data."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from survtrack.errors import UsageError
from survtrack.evaluation.files import require_folder


@dataclass(frozen=True)
class Dataset:
    """Footage and its truth.

    Attributes:
        name: short, for tables and file names.
        source: a video file, a folder or a glob of images.
        truth: MOT text or CVML; None where there is none.
        fps: frames per second; None: what the source says.
        offset: frame f of the source, counted from 1, is frame f + offset of the truth.
        objects: what moves in it, in a word.
    """

    name: str
    source: str
    truth: Path | None
    fps: float | None = None
    offset: int = 0
    objects: str = "objects"


# Paths as in docs/data_sets.md. vtest.avi says 10 frames/s, but was taken at 7. Walk1 starts at
# frame 236 of its truth, counted from 0 as CVML does, so its first frame is number 237 from 1.
PUBLIC = {
    entry.name: entry
    for entry in (
        Dataset(
            "vtest", "video/vtest.avi", Path("mot/PETS09-S2L1/gt/gt.txt"), 7.0, objects="people"
        ),
        Dataset("Walk1", "caviar/Walk1/input", Path("caviar/Walk1/wk1gt.xml"), 25.0, 236, "people"),
        Dataset(
            "OneLeaveShop1cor",
            "caviar/OneLeaveShop1cor/OneLeaveShop1cor.mpg",
            Path("caviar/OneLeaveShop1cor/cols1gt.xml"),
            25.0,
            objects="people",
        ),
        Dataset(
            "TUD-Campus",
            "mot/TUD-Campus/img1",
            Path("mot/TUD-Campus/gt/gt.txt"),
            25.0,
            objects="people",
        ),
        Dataset("motorway", "video/bgslib_video02.avi", None, 25.0, objects="cars"),
    )
}


def find_datasets(data: Path, names: Sequence[str]) -> list[Dataset]:
    """Those of the named public sets whose footage and truth lie under `data`, in that order.

    Raises:
        InputError: `data` is no folder.
        UsageError: it holds none of them; the message says what was looked for.
    """
    require_folder(data)
    named = [PUBLIC[name] for name in names]
    found = [
        Dataset(
            entry.name,
            str(data / entry.source),
            None if entry.truth is None else data / entry.truth,
            entry.fps,
            entry.offset,
            entry.objects,
        )
        for entry in named
        if all((data / part).exists() for part in _parts(entry))
    ]
    if not found:
        looked_for = "; ".join(" with ".join(map(str, _parts(entry))) for entry in named)
        raise UsageError(f"{data}: holds none of these sets: {looked_for}")
    return found


def _parts(entry: Dataset) -> list[str | Path]:
    """Footage and, if it has one, truth."""
    return [entry.source] if entry.truth is None else [entry.source, entry.truth]


def own_dataset(source: str, truth: Path, fps: float | None, offset: int) -> Dataset:
    """A set of the user's; its name is that of the footage, fit for file names."""
    path = Path(source)
    stem = path.name if path.is_dir() else path.stem
    name = re.sub(r"[^0-9A-Za-z._-]+", "_", stem).strip("._") or "footage"
    return Dataset(name, source, truth, fps, offset)
