# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""survtrack against the usual OpenCV recipe, in the same run; `make bench` calls it.

Speed needs one video; accuracy needs public footage with ground truth, found by SURVTRACK_DATA.
"""

import argparse
import json
import os
import platform
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import cv2
import filters
import flow
from accuracy import measure_masks, measure_tracks
from peers import Peers
from speed import measure

import survtrack

Row = dict[str, Any]
PARTS = ("speed", "accuracy", "flow", "filters")


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peers", type=Path, required=True, help="the peers' python")
    parser.add_argument("--video", type=Path, required=True, help="footage for the speed rows")
    parser.add_argument("--frames", type=int, default=200, help="frames a round")
    parser.add_argument("--rounds", type=int, default=7, help="rounds, of which the median counts")
    parser.add_argument("--only", choices=PARTS, help="leave the others out")
    parser.add_argument("--json", type=Path, metavar="FILE", help="also write the results there")
    return parser.parse_args()


def machine(peers: Peers) -> Row:
    """What the figures depend on."""
    cpu = Path("/proc/cpuinfo")
    lines = cpu.read_text().splitlines() if cpu.exists() else []
    names = [line.split(":")[1].strip() for line in lines if line.startswith("model name")]
    return {
        "cpu": names[0] if names else platform.processor(),
        "cores": os.cpu_count(),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        "survtrack": survtrack.__version__,
        "cv2": cv2.__version__,
        "trackers": peers.ask(do="versions")["trackers"],
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
    }


def cell(value: object) -> str:
    if not isinstance(value, float):
        return str(value)
    return f"{value:.1f}" if abs(value) >= 10 else f"{value:.3f}"


def print_table(title: str, rows: list[Row]) -> None:
    if not rows:
        return
    table = [list(rows[0]), *([cell(value) for value in row.values()] for row in rows)]
    widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
    numbers = [isinstance(value, (int, float)) for value in rows[0].values()]
    print(f"\n{title}")
    for row in table:
        cells = [
            text.rjust(width) if number else text.ljust(width)
            for text, width, number in zip(row, widths, numbers, strict=True)
        ]
        print("  " + "  ".join(cells))


def main() -> None:
    asked = arguments()
    results: dict[str, Any] = {}
    with Peers(asked.peers) as peers:
        results["machine"] = machine(peers)
        print(", ".join(f"{key} {value}" for key, value in results["machine"].items()))
        if asked.only in (None, "speed"):
            results["speed"] = measure(peers, str(asked.video), asked.frames, asked.rounds)
            title = f"Speed: one thread, {asked.frames} frames in memory, median of {asked.rounds}"
            print_table(title, results["speed"])
        if asked.only in (None, "accuracy"):
            data = Path(os.environ.get("SURVTRACK_DATA", "SURVTRACK_DATA-is-not-set"))
            results["tracks"], no_tracks = measure_tracks(peers, data)
            print_table("Tracks: vtest.avi against PETS09-S2L1, IoU 0.5", results["tracks"])
            results["masks"], no_masks = measure_masks(data)
            print_table("Masks: F, each after a 5x5 median", results["masks"])
            for missing in (*no_tracks, *no_masks):
                print(f"left out: {missing} is missing (SURVTRACK_DATA names the folder)")
        if asked.only in (None, "flow"):
            results["flow_speed"] = flow.measure_speed(peers, str(asked.video), asked.rounds)
            title = f"Horn-Schunck flow: one thread, processor time, median of {asked.rounds}"
            print_table(title, results["flow_speed"])
            results["flow"], no_flow = flow.measure_accuracy()
            print_table("Flow: Middlebury's pairs, mean endpoint error", results["flow"])
            for missing in no_flow:
                print(f"left out: {missing} is missing (SURVTRACK_DATA names the folder)")
        if asked.only in (None, "filters"):
            results["filters"] = filters.measure(asked.rounds)
            title = f"Kalman filters: a step of {filters.TRACKS} tracks of 4 states, one thread"
            print_table(title, results["filters"])
    if asked.json:
        asked.json.write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()
