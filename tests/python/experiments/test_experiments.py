# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What all experiments share: sets, footage in memory, trials, the report's folder."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from clips import walking_square, write_images
from survtrack.errors import UsageError
from survtrack.evaluation import Boxes
from survtrack.experiments import (
    Dataset,
    ReportFolder,
    Variant,
    find_datasets,
    load,
    own_dataset,
    run_trial,
)
from survtrack.experiments.datasets import PUBLIC
from survtrack.experiments.markdown import counted, table
from survtrack.experiments.scene import describe


def test_frames_and_truth_are_scaled_alike(tmp_path: Path) -> None:
    write_images(tmp_path / "in", walking_square(6, width=100, height=60, side=10))
    truth = tmp_path / "gt.txt"
    truth.write_text("2,1,10,20,30,40,1\n5,1,0,0,8,4,1\n5,2,1,1,2,2,1\n9,1,0,0,8,4,1\n")
    footage = load(Dataset("made", str(tmp_path / "in"), truth, fps=7, offset=2), (50, 120))
    assert (footage.size, footage.source_size) == ((50, 120), (100, 60))
    assert [frame.shape for frame in footage.frames] == [(120, 50, 3)] * 6
    assert footage.frame_period_s == 1 / 7
    # Frame 5 of the truth is frame 3 here; 2 and 9 are outside of frames 3 to 8.
    assert footage.truth.frames.tolist() == [3, 3]
    assert footage.truth.boxes.tolist() == [[0, 0, 4, 8], [0.5, 2, 1, 4]]


def test_a_trial_scores_what_the_pipeline_reports(tmp_path: Path) -> None:
    write_images(tmp_path / "in", walking_square(90, side=10, still=60))
    truth = tmp_path / "gt.txt"
    truth.write_text("".join(f"{k + 1},1,{4 + 2 * (k - 60)},21,10,10,1\n" for k in range(60, 90)))
    footage = load(Dataset("made", str(tmp_path / "in"), truth), (96, 64))
    variant = Variant("narayana2007_euclidean")
    trial = run_trial(footage, variant.config(footage.frame_period_s))
    assert trial.scores.truth_boxes == 30
    assert trial.scores.hota > 80
    assert trial.identity_errors == trial.scores.index_errors + trial.scores.swap_errors
    assert trial.frames_per_s > 0


def test_facts_of_a_scene() -> None:
    """Object 1 makes steps of 5 and 10, object 2 appears in frames that do not follow."""
    truth = Boxes(
        [1, 2, 3, 1, 3, 1],
        [1, 1, 1, 2, 2, 3],
        [
            [0, 0, 10, 20],
            [3, 4, 10, 20],
            [9, 12, 10, 20],
            [5, 5, 20, 40],
            [100, 0, 20, 40],
            [6, 6, 5, 5],
        ],
        [False, False, False, False, False, True],
    )
    scene = describe(truth)
    assert (scene.width_px, scene.height_px) == (10, 20)
    assert scene.fast_step_px == pytest.approx(np.percentile([5, 10], 95))
    assert scene.overlapping == 2 / 5
    still = describe(Boxes([1], [1], [[0, 0, 3, 4]]))
    assert (still.fast_step_px, still.overlapping) == (0, 0)


def test_public_sets_are_those_that_are_there(tmp_path: Path) -> None:
    names = ("vtest", "Walk1")
    with pytest.raises(UsageError, match=r"holds none of these sets: video/vtest\.avi with mot/"):
        find_datasets(tmp_path, names)
    walk = PUBLIC["Walk1"]
    (tmp_path / walk.source).mkdir(parents=True)
    (tmp_path / walk.truth).touch()
    (tmp_path / "video").mkdir()
    (tmp_path / "video" / "vtest.avi").touch()  # its truth is missing
    [found] = find_datasets(tmp_path, names)
    assert found == replace(walk, source=str(tmp_path / walk.source), truth=tmp_path / walk.truth)


@pytest.mark.parametrize(
    ("source", "name"),
    [("a/street.mp4", "street"), ("in/*.png", "footage"), ("a b|c.avi", "a_b_c")],
)
def test_own_footage_has_a_name_that_is_fit_for_files(source: str, name: str) -> None:
    assert own_dataset(source, Path("gt.txt"), None, 0).name == name


def test_a_report_replaces_an_earlier_one_and_nothing_else(tmp_path: Path) -> None:
    first = ReportFolder(tmp_path)
    first.add_plot("old", b"1")
    first.add_report("# old\n")
    first.finish({"a": 1})
    (tmp_path / "plots" / "mine.png").write_bytes(b"2")
    second = ReportFolder(tmp_path)
    assert (tmp_path / "results.json").exists()  # until something is written
    assert second.add_plot("new", b"3") == "plots/new.png"
    assert not (tmp_path / "results.json").exists()
    second.add_report("# new\n")
    second.finish({"a": 2})
    assert json.loads((tmp_path / "results.json").read_text()) == {
        "a": 2,
        "outputs": ["report.md", "plots/new.png"],
    }
    names = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()}
    assert names == {"report.md", "results.json", "plots/new.png", "plots/mine.png"}


def test_a_strange_results_json_removes_nothing(tmp_path: Path) -> None:
    (tmp_path / "keep.png").touch()
    (tmp_path / "results.json").write_text('{"outputs": ["plots/../keep.png", 3]}')
    ReportFolder(tmp_path).add_plot("a", b"1")
    assert (tmp_path / "keep.png").exists()


def test_markdown_tables() -> None:
    assert table(["a", "b"], [["x|y", "1"]]) == "| a | b |\n| --- | ---: |\n| x\\|y | 1 |\n"
    assert counted(45, 292) == "45 (15.4 %)"


def test_the_offset_of_walk1_fits_best(data: Path) -> None:
    """Its first image is frame 236 of a truth that counts from 0."""
    [walk] = find_datasets(data, ["Walk1"])
    variant = Variant("narayana2007", ("blobs.merge.model=none",))
    fits = {}
    for shift in (-1, 0, 1):
        footage = load(replace(walk, offset=walk.offset + shift), (320, 240))
        trial = run_trial(footage, variant.config(footage.frame_period_s))
        fits[shift] = trial.scores.motp
    assert max(fits, key=fits.__getitem__) == 0


def test_public_sets_are_whole(data: Path) -> None:
    [campus] = find_datasets(data, ["TUD-Campus"])
    footage = load(campus, (320, 240))
    assert (len(footage.frames), footage.source_size, len(footage.truth)) == (71, (640, 480), 359)
    assert len(find_datasets(data, list(PUBLIC))) == 5
