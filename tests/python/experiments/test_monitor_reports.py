# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack reproduce semko2007` and `suliman2010`: what they leave, with and without footage."""

import json
from pathlib import Path
from typing import Any

import cv2
import pytest

from clips import walking_square, write_images
from survtrack.cli.main import main
from survtrack.experiments import EXPERIMENTS
from survtrack.experiments.narayana2007 import Narayana2007
from survtrack.experiments.semko2007 import artificial
from survtrack.experiments.semko2007.errata import ERRATA
from survtrack.experiments.suliman2010 import scenes

STILL, COUNT = 40, 70


@pytest.fixture(autouse=True)
def fewer_scenes(monkeypatch: pytest.MonkeyPatch) -> None:
    """One trial of each kind, and no footage but that which is given."""
    every, one = artificial.trials(), scenes.scenes()[:1]
    monkeypatch.setattr(artificial, "trials", lambda: [every[0], every[3]])
    monkeypatch.setattr(artificial, "LOST_WAYS", ("masks",))
    monkeypatch.setattr(scenes, "scenes", lambda: one)
    monkeypatch.delenv("SURVTRACK_DATA", raising=False)


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("clip")
    frames = walking_square(COUNT, width=128, height=96, side=24, still=STILL)
    write_images(folder / "in", frames)
    rows = [f"{k + 1},7,{4 + 2 * (k - STILL)},32,24,24,1,-1,-1,-1\n" for k in range(STILL, COUNT)]
    (folder / "gt.txt").write_text("".join(rows))
    return folder


def made(name: str, out: Path, *given: object) -> tuple[Any, str]:
    assert main(["reproduce", name, *map(str, given), "--out", str(out), "-q"]) == 0
    results = json.loads((out / "results.json").read_text())
    report = (out / "report.md").read_text()
    found = {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()}
    assert found == {*results["outputs"], "results.json"}
    for plot in results["outputs"][1:]:
        assert f"]({plot})" in report
        picture = cv2.imread(str(out / plot))
        assert picture is not None and picture.shape[1] == 880
    return results, report


def test_semko2007_needs_no_footage_and_takes_it(clip: Path, tmp_path: Path) -> None:
    given = ("--source", clip / "in", "--truth", clip / "gt.txt", "--resize", "128x96")
    results, report = made("semko2007", tmp_path, *given)
    assert results["experiment"] == "semko2007"
    assert [trial["name"] for trial in results["trials"]] == ["one_constant", "three_constant"]
    assert results["trials"][1]["masks"]["tracks"] == [1, 2, 3]
    assert results["lost"]["removed, masks"]["frames_to_the_event"] == 13
    assert [claim["holds"] for claim in results["claims"][:4]] == [True] * 4
    for claim in results["claims"]:
        holds = "**yes**" if claim["holds"] else "no"
        assert f"| {claim['claim']} | {holds} | {claim['numbers']} |" in report
    assert [one["key"] for one in results["errata"]] == [key for key, *_ in ERRATA]
    for _, fault, figure, _ in ERRATA:
        assert f"| {fault} | {figure} |" in report
    [one] = results["sets"]
    runs = {run["name"]: run for run in one["runs"]}
    assert list(runs) == ["semko2007", "semko2007_published", "survtrack"]
    assert runs["semko2007"]["set"] == ["time_unit_s=0.04"]
    assert runs["survtrack"]["set"] == []
    assert runs["survtrack"]["markers_in_truth"] == 1
    alone, _ = made("semko2007", tmp_path / "alone")
    assert alone["sets"] == []
    assert alone["trials"] == results["trials"]
    assert alone["errata"] == results["errata"]


def test_suliman2010_needs_no_footage_and_takes_it(clip: Path, tmp_path: Path) -> None:
    given = ("--source", clip / "in", "--truth", clip / "gt.txt", "--resize", "128x96")
    results, report = made("suliman2010", tmp_path, *given)
    for way in ("masks", "flow"):
        assert results["reentry"][way]["tracks"] == [1]
        assert f"| {way} | **yes** | 1 |" in report
    assert set(results["centroid_and_estimate"]) == {"one_constant"}
    assert results["centroid_and_estimate_on_footage"]["in"]["frames"] == COUNT
    assert results["eq6"]["printed_shape"] == [7, 6]
    [one] = results["sets"]
    assert [run["name"] for run in one["runs"]] == ["suliman2010", "survtrack"]
    alone, report = made("suliman2010", tmp_path / "alone")
    assert alone["sets"] == []
    assert "## Footage" not in report


def test_progress_counts_the_frames_of_the_synthetic_runs(tmp_path: Path) -> None:
    for module in (artificial, scenes):
        ticks: list[int] = []
        module.measure(ticks.append)
        assert sum(ticks) == module.frames() > 0


def test_narayana2007_has_no_scenes_of_its_own() -> None:
    assert list(EXPERIMENTS) == [
        "narayana2007",
        "nashenda2011",
        "omalley2000",
        "semko2007",
        "suliman2010",
    ]
    assert Narayana2007.made_frames == 0
    Narayana2007().measure_made(lambda frames: pytest.fail("a run"))


@pytest.mark.parametrize("name", ["semko2007", "suliman2010"])
def test_footage_without_any_flow_is_refused(
    name: str, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    frames = walking_square(1, width=128, height=96, side=24, still=0)
    write_images(tmp_path / "in", frames)
    (tmp_path / "gt.txt").write_text("1,7,4,32,24,24,1,-1,-1,-1\n")
    given = ("--source", str(tmp_path / "in"), "--truth", str(tmp_path / "gt.txt"))
    assert main(["reproduce", name, *given, "--out", str(tmp_path / "out"), "-q"]) == 1
    told = capsys.readouterr().err
    assert "segmenter.frames_back" in told and "1 frame(s)" in told
    assert not (tmp_path / "out" / "results.json").exists()
