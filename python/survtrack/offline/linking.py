# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From the folder of a run to one with the tracks joined and cleared of short ones."""

import csv
import io
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import survtrack
from survtrack._core import Linked, LinkOptions, PatternOptions, link_tracks
from survtrack.errors import InputError, UsageError
from survtrack.evaluation.files import StrPath, read_bytes, require_folder
from survtrack.offline.tracks_table import BOX, TracksTable, read_tracks_csv
from survtrack.sinks.folder import MANIFEST, RunFolder
from survtrack.sinks.part_file import write_whole

TRACKS_CSV = "tracks.csv"
# What run.json of the linked tracks says as that of the run does.
CARRIED = (
    "source",
    "preset",
    "complete",
    "error",
    "frames",
    "fps",
    "fps_origin",
    "size",
    "original_size",
)


def link_run(
    run_dir: StrPath, out: StrPath | None = None, options: LinkOptions | None = None
) -> dict[str, Any]:
    """Link the tracks of a run and write them as a folder of their own.

    The folder gets tracks.txt and tracks.csv (rows of the run's, ids changed), link.jsonl (a line
    a join and a dropped track), config.toml (the options) and run.json. A run that was cut short
    is linked as far as it goes; run.json then says so, as the run's does.

    Args:
        run_dir: the folder that `survtrack run` left.
        out: where to write; RUN_DIR/linked when None. Files of an earlier run there are replaced.
        options: when tracks are one, and which are too short; the defaults when None.

    Returns:
        What the new run.json says, such as "tracks_before", "joined", "dropped" and "tracks".

    Raises:
        InputError: run_dir is no folder of a run, or its tracks.csv cannot be used.
        UsageError: out is run_dir itself.
        OSError: a file cannot be written; there is then no run.json.
    """
    run_dir = require_folder(Path(run_dir))
    place = run_dir / "linked" if out is None else Path(out)
    if place.resolve() == run_dir.resolve():
        raise UsageError(f"{place}: is the run's own folder; its tracks would be overwritten")
    options = LinkOptions() if options is None else options
    run_facts = facts_of_run(run_dir)
    table = read_tracks_csv(run_dir / TRACKS_CSV)
    history = table.history()
    linked = link_tracks(history, options)
    texts = _texts(table, linked)
    facts = {
        "survtrack": survtrack.__version__,
        "command": "link",
        "run": str(run_dir),
        **{name: run_facts.get(name) for name in CARRIED},
        "tracks_before": len(history),
        "joined": len(linked.links),
        "dropped": len(linked.dropped),
        "tracks": len(linked.history),
        "outputs": list(texts),
    }
    folder = RunFolder(place)
    folder.make()
    # Were the writing cut short, the run.json of an earlier run would speak of what is not its own.
    (place / MANIFEST).unlink(missing_ok=True)
    for name, text in texts.items():
        write_whole(place / name, text)
    folder.finish(facts, options_as_toml(options))
    return facts


def options_as_toml(options: LinkOptions | PatternOptions) -> str:
    """The options as a TOML file, each with its meaning and unit."""
    return "".join(
        f"{name} = {json.dumps(value)}  # {getattr(type(options), name).__doc__}\n"
        for name, value in options.to_dict().items()
    )


def facts_of_run(run_dir: Path) -> dict[str, Any]:
    """What run.json says; raises InputError when that is no word of a whole tracks.csv."""
    path = run_dir / MANIFEST
    if not path.exists():
        raise InputError(f"{run_dir}: has no {MANIFEST}, so it is no folder of `survtrack run`")
    try:
        facts: Any = json.loads(read_bytes(path))
        listed = TRACKS_CSV in facts["outputs"]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(f"{path}: is not that of a run") from error
    if not listed:
        raise InputError(f"{run_dir}: the run left no {TRACKS_CSV}, says its {MANIFEST}")
    return dict(facts)


def _texts(table: TracksTable, linked: Linked) -> dict[str, str]:
    """The files to write, by name."""
    new_ids = _new_ids(table, linked)
    order = [row for row, _ in sorted(new_ids.items(), key=lambda e: (table.frames[e[0]], e[1]))]
    id_place = table.columns.index("id")
    mot_places = [table.columns.index(name) for name in ("frame", "id", *BOX)]
    rows = []
    for row in order:
        cells = list(table.rows[row])
        cells[id_place] = str(new_ids[row])
        rows.append(cells)
    mot = [",".join(cells[place].strip() for place in mot_places) for cells in rows]
    return {
        "tracks.txt": "".join(f"{line},1,-1,-1,-1\n" for line in mot),
        TRACKS_CSV: csv_text([list(table.columns), *rows]),
        "link.jsonl": "".join(f"{json.dumps(line)}\n" for line in decisions(linked)),
    }


def _new_ids(table: TracksTable, linked: Linked) -> dict[int, int]:
    """The id of each row that is kept, by row."""
    first_of: dict[int, int] = {}
    for link in linked.links:  # in the order of time: the earlier one's own first is known
        first_of[link.later_id] = first_of.get(link.earlier_id, link.earlier_id)
    dropped = {track.id for track in linked.dropped}
    ids = [first_of.get(identity, identity) for identity in table.ids.tolist()]
    return {row: identity for row, identity in enumerate(ids) if identity not in dropped}


def csv_text(rows: Iterable[list[str]]) -> str:
    """Lines of CSV, quoted where a cell needs it."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def decisions(linked: Linked) -> list[dict[str, object]]:
    """The lines of link.jsonl: every join and every dropped track, with what decided it."""
    joined: list[dict[str, object]] = [
        {
            "kind": "joined",
            "earlier_id": link.earlier_id,
            "later_id": link.later_id,
            "gap_s": round(link.gap_s, 6),
            "distance": round(link.distance, 6),
            "speed_difference": round(link.speed_difference, 6),
            "color_difference": round(link.color_difference, 6),
            "cost": round(link.cost, 6),
        }
        for link in linked.links
    ]
    dropped: list[dict[str, object]] = [
        {
            "kind": "dropped",
            "id": track.id,
            "frames": track.frames,
            "duration_s": round(track.duration_s, 6),
            "travel": round(track.travel, 6),
        }
        for track in linked.dropped
    ]
    return joined + dropped
