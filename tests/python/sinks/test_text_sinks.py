# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""tracks.txt, tracks.csv and events.jsonl, word for word."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from clips import walking_square
from fakes import Box, Event, Kind, Result, Status, Track, result_of
from survtrack.sinks import EventLines, MotText, TracksCsv
from survtrack.sinks.tracks_csv import COLUMNS

FRAME = walking_square(1)[0]


def three_results() -> list[Result]:
    covariance = np.array([[4.0, 0.5], [0.5, 9.0]])
    seen = Track(7, Box(1.5, 2.25, 10, 20.0004), Status.confirmed, True, (3.0, -4.5), covariance)
    hidden = Track(9, Box(0, 0, 5, 5), Status.tentative, reported=False)
    lost = Track(2, Box(-3, 4, 8, 9), Status.lost, age_frames=6, lost_frames=2)
    lost.mean_color = (10.0, 20.5, 255.0)
    return [
        result_of(FRAME, 4, seen, hidden),
        result_of(FRAME, 5),
        result_of(FRAME, 6, seen, lost),
    ]


def test_mot_rows_count_frames_from_1_and_hold_reported_tracks_by_id(tmp_path: Path) -> None:
    with MotText(tmp_path / "tracks.txt") as sink:
        for result in three_results():
            sink.write(result.frame, result)
    assert (tmp_path / "tracks.txt").read_text() == (
        "5,7,1.500,2.250,10.000,20.000,1,-1,-1,-1\n"
        "7,2,-3.000,4.000,8.000,9.000,1,-1,-1,-1\n"
        "7,7,1.500,2.250,10.000,20.000,1,-1,-1,-1\n"
    )
    assert sink.outputs == ["tracks.txt"]


def test_csv_has_a_row_a_reported_track(tmp_path: Path) -> None:
    names = {4: "in000005.jpg", 5: "unused.jpg", 6: 'odd, "name".jpg'}
    with TracksCsv(tmp_path / "tracks.csv", names.__getitem__) as sink:
        for result in three_results():
            sink.write(result.frame, result)
    with (tmp_path / "tracks.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == COLUMNS
    assert [(row["frame"], row["id"], row["status"], row["file"]) for row in rows] == [
        ("5", "7", "confirmed", "in000005.jpg"),
        ("7", "2", "lost", 'odd, "name".jpg'),
        ("7", "7", "confirmed", 'odd, "name".jpg'),
    ]
    first = {key: float(value) for key, value in rows[0].items() if key.endswith(("px", "px2"))}
    assert first == {
        "left_px": 1.5,
        "top_px": 2.25,
        "width_px": 10,
        "height_px": 20,
        "x_px": 6.5,
        "y_px": 12.25,
        "covariance_xx_px2": 4,
        "covariance_xy_px2": 0.5,
        "covariance_yy_px2": 9,
    }
    assert (rows[0]["velocity_x_px_per_s"], rows[0]["velocity_y_px_per_s"]) == ("3.000", "-4.500")
    assert (rows[0]["time_s"], rows[1]["age_frames"], rows[1]["lost_frames"]) == (
        "0.400000",
        "6",
        "2",
    )
    colors = [(row["mean_blue"], row["mean_green"], row["mean_red"]) for row in rows]
    assert colors[:2] == [("0.000", "0.000", "0.000"), ("10.000", "20.500", "255.000")]


def test_csv_of_a_video_names_no_file(tmp_path: Path) -> None:
    with TracksCsv(tmp_path / "tracks.csv") as sink:
        sink.write(FRAME, three_results()[0])
    assert ",0.400000,,7,confirmed," in (tmp_path / "tracks.csv").read_text()


def test_events_are_one_json_object_a_line(tmp_path: Path) -> None:
    started = Event(
        Kind.track_started, 11, 1.1, 3, [5, 6], (4.0, 5.5), Box(1, 2, 6, 7), "Track 3 started"
    )
    changed = Event(Kind.scene_changed, 12, 1.2, text="Licht än")
    with EventLines(tmp_path / "events.jsonl") as sink:
        sink.write(FRAME, result_of(FRAME, 11, events=[started]))
        sink.write(FRAME, result_of(FRAME, 12, events=[changed]))
    lines = (tmp_path / "events.jsonl").read_text().splitlines()
    assert [json.loads(line) for line in lines] == [
        {
            "frame": 12,
            "time_s": 1.1,
            "kind": "track_started",
            "track_id": 3,
            "other_track_ids": [5, 6],
            "position": [4.0, 5.5],
            "box": [1, 2, 6, 7],
            "position_covariance_px2": [1.0, 0.0, 1.0],
            "place": None,
            "confidence": None,
            "text": "Track 3 started",
        },
        {
            "frame": 13,
            "time_s": 1.2,
            "kind": "scene_changed",
            "track_id": None,
            "other_track_ids": [],
            "position": None,
            "box": None,
            "position_covariance_px2": None,
            "place": None,
            "confidence": None,
            "text": "Licht än",
        },
    ]


def test_events_can_be_followed_while_they_come(tmp_path: Path) -> None:
    event = Event(Kind.track_started, 0, 0.0, 1)
    with EventLines(tmp_path / "events.jsonl") as sink:
        sink.write(FRAME, result_of(FRAME, 0, events=[event]))
        assert (tmp_path / "events.jsonl.part").read_text().count("\n") == 1


@pytest.mark.parametrize("make", [MotText, TracksCsv, EventLines])
def test_a_run_without_tracks_leaves_a_whole_file(tmp_path: Path, make: type) -> None:
    with make(tmp_path / "out") as sink:
        sink.write(FRAME, result_of(FRAME))
    lines = (tmp_path / "out").read_text().splitlines()
    assert lines == ([",".join(COLUMNS)] if make is TracksCsv else [])
