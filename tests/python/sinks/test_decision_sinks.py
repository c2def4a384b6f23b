# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""matrices.jsonl and scene.json."""

import json
from pathlib import Path

import numpy as np
import pytest

from clips import walking_square
from fakes import Match, result_of
from survtrack.errors import UsageError
from survtrack.match_table import match_table
from survtrack.sinks import LearnedScene, MatrixLines

FRAME = walking_square(1)[0]


class Learner:
    def learned_scene(self) -> str:
        return '{"scale": 1}'


def test_a_line_names_rows_and_columns(tmp_path: Path) -> None:
    beliefs = np.array([[0.25, 0.5, 0.25], [0.0, 1 / 3, 2 / 3]])
    result = result_of(
        FRAME,
        4,
        costs=1 - beliefs[:, :-1],
        beliefs=beliefs,
        matrix_track_ids=[7, 0],
        matches=[Match(0, 1), Match(0, 0, assigned=False)],
    )
    costs = result_of(FRAME, 5, costs=np.array([[0.5, np.inf]]), matrix_track_ids=[7])
    with MatrixLines(tmp_path / "matrices.jsonl") as sink:
        sink.write(FRAME, result)
        sink.write(FRAME, costs)
        sink.write(FRAME, result_of(FRAME, 6, costs=np.zeros((0, 0))))
    assert sink.outputs == ["matrices.jsonl"]
    lines = [json.loads(line) for line in (tmp_path / "matrices.jsonl").read_text().splitlines()]
    assert lines[0] == {
        "frame": 5,
        "time_s": 0.4,
        "kind": "belief",
        "track_ids": [7, 0],
        "columns": ["blob 1", "blob 2", "lost"],
        "values": [[0.25, 0.5, 0.25], [0.0, 0.333333, 0.666667]],
        "assigned": [1, None],
    }
    assert (lines[1]["kind"], lines[1]["values"]) == ("cost", [[0.5, None]])
    assert (lines[2]["track_ids"], lines[2]["values"]) == ([], [])
    assert match_table(result).rows == ["track 7", "tentative"]


def test_a_result_without_a_matrix_is_refused() -> None:
    with pytest.raises(UsageError, match=r"outputs.cost_matrix is false"):
        match_table(result_of(FRAME, matrix_track_ids=[1]))


def test_the_scene_is_written_at_the_end(tmp_path: Path) -> None:
    with LearnedScene(tmp_path / "scene.json", Learner()) as sink:
        sink.write(FRAME, result_of(FRAME))
        assert not (tmp_path / "scene.json").exists()
        assert sink.outputs == []
    assert json.loads((tmp_path / "scene.json").read_text()) == {"scale": 1}
    assert sink.outputs == ["scene.json"]
