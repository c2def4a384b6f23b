# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Tracks of many runs that go a known way: an archive is searched without viewing it."""

from collections.abc import Collection, Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from survtrack._core import Activity, ActivityKind, Patterns
from survtrack.errors import UsageError
from survtrack.evaluation.files import StrPath, require_folder
from survtrack.offline.linking import TRACKS_CSV, facts_of_run
from survtrack.offline.patterns import require_same_size, size_of_run
from survtrack.offline.tracks_table import TracksTable, read_tracks_csv
from survtrack.sinks.folder import MANIFEST


@dataclass(frozen=True)
class FoundTrack:
    """A track and what it does by the patterns; see survtrack.Activity for the numbers.

    run: the run's folder.
    id: of the track in that run.
    first_frame, last_frame: counted from 1.
    first_s, last_s: their times.
    kind: of what it does, such as "usual" or "other_way".
    pattern: the one that it follows, or None.
    distance: from that way, or the nearest, object sizes; None as of Activity.
    speed_px_per_s: mean.
    """

    run: str
    id: int
    first_frame: int
    last_frame: int
    first_s: float
    last_s: float
    kind: str
    pattern: int | None
    distance: float | None
    speed_px_per_s: float

    def to_dict(self) -> dict[str, Any]:
        """As printed by --json."""
        return asdict(self)


def find_tracks(
    run_dirs: Iterable[StrPath],
    patterns: Patterns,
    *,
    ids: Collection[int] = (),
    kinds: Collection[str] = (),
) -> list[FoundTrack]:
    """All tracks of the runs that follow one of these patterns, or do one of these things.

    Args:
        run_dirs: folders that `survtrack run` or `survtrack link` left, of one camera.
        patterns: what the tracks are judged by; see survtrack.learn_patterns and read_patterns.
        ids: of patterns; a track that follows none of them is left out. None given: any.
        kinds: names of ActivityKind, as for ids.

    Returns:
        In the order of the runs, then of the tracks' ids.

    Raises:
        UsageError: a pattern or a kind that there is not.
        InputError: a folder that is none of a run, or of frames of another size than the patterns.
    """
    known = [pattern.id for pattern in patterns.patterns]
    for identity in ids:
        if identity not in known:
            raise UsageError(f"pattern {identity}: is not there; one of: {known}")
    names = [kind.name for kind in ActivityKind]
    for name in kinds:
        if name not in names:
            raise UsageError(f'kind: unknown "{name}"; one of: {", ".join(names)}')
    return [
        found
        for run_dir in run_dirs
        for found in _of_run(Path(run_dir), patterns)
        if (not ids or found.pattern in ids) and (not kinds or found.kind in kinds)
    ]


def _of_run(run_dir: Path, patterns: Patterns) -> list[FoundTrack]:
    run_dir = require_folder(run_dir)
    size = size_of_run(facts_of_run(run_dir), run_dir / MANIFEST)
    require_same_size(patterns, size, str(run_dir))
    table = read_tracks_csv(run_dir / TRACKS_CSV)
    return [_found(run_dir, each, table) for each in patterns.classify(table.history())]


def _found(run_dir: Path, activity: Activity, table: TracksTable) -> FoundTrack:
    own = table.ids == activity.track_id
    frames, times_s = table.frames[own], table.times_s[own]
    return FoundTrack(
        str(run_dir),
        activity.track_id,
        int(frames.min()),
        int(frames.max()),
        float(times_s.min()),
        float(times_s.max()),
        activity.kind.name,
        activity.pattern,
        activity.distance,
        activity.speed_px_per_s,
    )
