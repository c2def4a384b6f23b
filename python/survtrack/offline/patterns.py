# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From the folder of a run to the patterns of activity in it, and what each track does."""

from collections import Counter
from pathlib import Path
from typing import Any

import survtrack
from survtrack import _core
from survtrack._core import Activity, ActivityKind, PatternOptions, Patterns, learn_patterns
from survtrack.errors import InputError, UsageError
from survtrack.evaluation.files import StrPath, read_bytes, require_folder
from survtrack.offline.linking import (
    CARRIED,
    TRACKS_CSV,
    csv_text,
    facts_of_run,
    options_as_toml,
)
from survtrack.offline.tracks_table import TracksTable, read_tracks_csv
from survtrack.sinks.folder import MANIFEST, RunFolder
from survtrack.sinks.part_file import write_whole, write_whole_bytes

PATTERNS, ACTIVITIES, PICTURE = "patterns.json", "activities.csv", "patterns.png"
PATHS = "paths.json"
COLUMNS = (
    "id",
    "first_frame",
    "last_frame",
    "kind",
    "unusual",
    "pattern",
    "partial",
    "distance",
    "angle_deg",
    "speed_px_per_s",
    "speed_ratio",
)


def patterns_of_run(
    run_dir: StrPath,
    out: StrPath | None = None,
    options: PatternOptions | None = None,
    known: StrPath | None = None,
) -> dict[str, Any]:
    """Learn the patterns of a run, or take known ones, and judge each track by them.

    The folder gets patterns.json, activities.csv (a line a track; the columns are COLUMNS),
    paths.json (see paths_of; only when there are any), patterns.png (the ways as arrows; only when
    the size of the frames is known), config.toml (the options) and run.json. A run that was cut
    short is taken as far as it goes; run.json then says so, as the run's does.

    Args:
        run_dir: the folder that `survtrack run` or `survtrack link` left.
        out: where to write; RUN_DIR/patterns when None. Files of an earlier one there are replaced.
        options: when tracks go the same way, and which are unusual; None for the known patterns'
            own, or the defaults.
        known: the patterns.json of an earlier run of the same camera; None: they are learned.

    Returns:
        What the new run.json says, such as "tracks", "patterns" and the number of tracks of each
        kind, "kinds".

    Raises:
        InputError: run_dir is no folder of a run, its tracks.csv cannot be used, or the known
            patterns cannot be read or are of frames of another size.
        UsageError: out is run_dir itself.
        OSError: a file cannot be written; there is then no run.json.
    """
    run_dir = require_folder(Path(run_dir))
    place = run_dir / "patterns" if out is None else Path(out)
    if place.resolve() == run_dir.resolve():
        raise UsageError(f"{place}: is the run's own folder; its files would be overwritten")
    run_facts = facts_of_run(run_dir)
    size = size_of_run(run_facts, run_dir / MANIFEST)
    table = read_tracks_csv(run_dir / TRACKS_CSV)
    history = table.history()
    if known is None:
        patterns = learn_patterns(history, PatternOptions() if options is None else options)
        patterns.frame_size = size
    else:
        patterns = read_patterns(known)
        require_same_size(patterns, size, known)
        patterns.options = patterns.options if options is None else options
    activities = patterns.classify(history)
    texts = {PATTERNS: patterns.to_json() + "\n", ACTIVITIES: _table(activities, table)}
    picture = None if size is None else _picture(patterns, size, run_facts)
    paths, refused = paths_of(patterns)
    if len(paths):
        texts[PATHS] = paths.to_json() + "\n"
    facts = {
        "survtrack": survtrack.__version__,
        "command": "patterns",
        "run": str(run_dir),
        **{name: run_facts.get(name) for name in CARRIED},
        "known": None if known is None else str(known),
        "tracks": len(history),
        "patterns": len(patterns),
        "kinds": _kinds(activities),
        "paths": len(paths),
        "no_path": {str(id): reason for id, reason in refused.items()},
        "outputs": [*texts, *([] if picture is None else [PICTURE])],
    }
    folder = RunFolder(place)
    folder.make()
    # Were the writing cut short, the run.json of an earlier run would speak of what is not its own.
    (place / MANIFEST).unlink(missing_ok=True)
    for name, text in texts.items():
        write_whole(place / name, text)
    if picture is not None:
        write_whole_bytes(place / PICTURE, picture)
    folder.finish(facts, options_as_toml(patterns.options))
    return facts


def read_patterns(path: StrPath) -> Patterns:
    """Patterns as patterns_of_run() wrote them; raises InputError that names file and entry."""
    path = Path(path)
    try:
        text = read_bytes(path).decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8 text") from error
    return Patterns.from_json(text, str(path))


def paths_of(patterns: Patterns) -> tuple[_core.Paths, dict[int, str]]:
    """The ways of patterns as paths, "pattern 1" and so on, and why others are none, by id.

    A path is a curve, closed when the way comes back to within the objects' size of its start. What
    is farther from it than options.max_distance object sizes, as from the pattern, is not on it.
    """
    paths: dict[str, _core.Path] = {}
    refused: dict[int, str] = {}
    for pattern in patterns.patterns:
        most_px = patterns.options.max_distance * pattern.size_px
        try:
            path = _core.Path.from_pattern(pattern, max_distance_px=most_px)
        except InputError as error:
            refused[pattern.id] = str(error)
        else:
            paths[f"pattern {pattern.id}"] = path
    return _core.Paths(paths, patterns.frame_size), refused


def size_of_run(facts: dict[str, Any], manifest: Path) -> tuple[int, int] | None:
    """(width, height) of the run's frames by its run.json; None when there were none."""
    match facts.get("size"):
        case None:
            return None
        case [int(width), int(height)] if 0 < width <= 100_000 and 0 < height <= 100_000:
            return width, height
        case size:
            raise InputError(f'{manifest}: "size" is {size!r}; expected [width, height] in px')


def require_same_size(patterns: Patterns, size: tuple[int, int] | None, known: StrPath) -> None:
    """Raise InputError, beginning with `known`, for patterns of frames of another size."""
    if size is not None and patterns.frame_size not in (None, size):
        learned, seen = ("x".join(map(str, each or ())) for each in (patterns.frame_size, size))
        raise InputError(f"{known}: was learned from frames of {learned}, the run's are {seen}")


def _kinds(activities: list[Activity]) -> dict[str, int]:
    counts = Counter(activity.kind.name for activity in activities)
    return {kind.name: counts[kind.name] for kind in ActivityKind}


def _table(activities: list[Activity], table: TracksTable) -> str:
    """The text of activities.csv."""
    seen: dict[int, tuple[int, int]] = {}
    for identity, frame in zip(table.ids.tolist(), table.frames.tolist(), strict=True):
        first, last = seen.get(identity, (frame, frame))
        seen[identity] = min(first, frame), max(last, frame)
    rows = [[str(cell) for cell in _cells(each, *seen[each.track_id])] for each in activities]
    return csv_text([list(COLUMNS), *rows])


def _cells(activity: Activity, first: int, last: int) -> list[object]:
    return [
        activity.track_id,
        first,
        last,
        activity.kind.name,
        int(activity.unusual),
        "" if activity.pattern is None else activity.pattern,
        int(activity.partial),
        _rounded(activity.distance),
        _rounded(activity.angle_deg),
        _rounded(activity.speed_px_per_s),
        _rounded(activity.speed_ratio),
    ]


def _rounded(value: float | None) -> str:
    return "" if value is None else f"{value:.3f}"


def _picture(patterns: Patterns, size: tuple[int, int], facts: dict[str, Any]) -> bytes:
    """patterns.png: the ways over a frame of the run's source, or over plain grey."""
    from survtrack.drawing.patterns import draw_patterns, paper
    from survtrack.sinks.masks import encode_png

    return encode_png(draw_patterns(paper(_frame_of(facts, size), size), patterns))


def _frame_of(facts: dict[str, Any], size: tuple[int, int]) -> Any:
    """The first frame of the run, HxW or HxWx3; None when its source is no file that is there."""
    import glob

    from survtrack.sources import open_source

    source, frames = facts.get("source"), facts.get("frames")
    first = frames.get("first") if isinstance(frames, dict) else None
    if not isinstance(source, str) or not isinstance(first, int) or first < 1:
        return None
    path = Path(source)
    if not (path.is_file() or path.is_dir() or ("://" not in source and glob.glob(source))):
        return None
    for _, _, frame in open_source(source, start=first - 1, limit=1, resize=size):
        return frame
    return None
