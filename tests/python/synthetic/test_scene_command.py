# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack scene`: what it lists, what it writes, what it refuses."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from survtrack.cli.main import main
from survtrack.errors import UsageError
from survtrack.evaluation import read_mot
from survtrack.scenes import OUTPUTS, make_scene, scene_names, write_scene


def scene(*args: object) -> int:
    return main(["scene", *(str(arg) for arg in args)])


def test_scenes_and_their_options_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert scene() == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == scene_names()
    assert scene("pillar") == 0
    out = capsys.readouterr().out
    assert "--set pillar_width_px=40.0" in out and "--set occluders=[[140.0, 0.0" in out


def test_every_listed_option_can_be_given_as_it_stands(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert scene("pillar") == 0
    listed = capsys.readouterr().out.splitlines()[1:]
    options = [part for line in listed for part in line.strip().split(" ", 1)]
    assert scene("pillar", "--out", tmp_path, "--frames", 60, "-q", *options) == 0
    made = json.loads((tmp_path / "recipe.json").read_text())["scene"]
    assert made["conditions"]["occluders"] == [[140, 0, 40, 240]]


def test_what_is_written_is_the_scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "a" / "b"
    options = ("--size", "160x120", "--frames", 80, "--seed", 4, "--set", "noise_sigma=2")
    assert scene("constant", "--out", folder, "--set", "contacts=2", *options) == 0
    assert capsys.readouterr().out.splitlines() == [
        "80 frames of 160x120, 2 objects, 3.2 s",
        f"{folder}: {', '.join(OUTPUTS)}",
    ]
    made = make_scene(
        "constant", size=(160, 120), frame_count=80, seed=4, contacts=2, noise_sigma=2
    )
    assert sorted(path.name for path in folder.iterdir()) == sorted(OUTPUTS)
    for (index, _, frame), (_, _, mask) in zip(made.frames(), made.frames("mask"), strict=True):
        image = cv2.imread(str(folder / f"input/in{index + 1:06d}.png"), cv2.IMREAD_UNCHANGED)
        assert np.array_equal(image, frame)
        image = cv2.imread(str(folder / f"groundtruth/gt{index + 1:06d}.png"), cv2.IMREAD_UNCHANGED)
        assert np.array_equal(image, mask)
    truth = made.truth()
    boxes, read = truth.to_boxes(), read_mot(folder / "gt.txt", truth=True)
    scored = ~boxes.ignore
    assert np.array_equal(read.frames, boxes.frames[scored])
    assert np.array_equal(read.ids, boxes.ids[scored])
    assert np.array_equal(read.boxes, boxes.boxes[scored])
    table = np.genfromtxt(folder / "truth.csv", delimiter=",", names=True)
    assert np.array_equal(table["frame"], truth.indices + 1)
    assert np.allclose(table["x_px"], truth.positions[:, 0], atol=1e-6)
    assert np.allclose(table["velocity_y_px_per_s"], truth.velocities_px_per_s[:, 1])
    assert np.allclose(table["visible"], truth.visible, atol=1e-6)
    recipe = json.loads((folder / "recipe.json").read_text())
    assert (recipe["kind"], recipe["outputs"]) == ("video", list(OUTPUTS))
    assert (recipe["scene"]["seed"], recipe["scene"]["objects"][1]["id"]) == (4, 2)


@pytest.mark.parametrize(("kind", "shape"), [("mask", (48, 64)), ("grey", (48, 64))])
def test_kinds(tmp_path: Path, kind: str, shape: tuple[int, int]) -> None:
    options = ("--kind", kind, "--size", "64x48", "--frames", 40, "--quiet")
    assert scene("constant", "--out", tmp_path, *options) == 0
    image = cv2.imread(str(tmp_path / "input/in000040.png"), cv2.IMREAD_UNCHANGED)
    assert image.shape == shape


def test_what_it_writes_is_a_sequence_for_the_other_commands(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made, out = tmp_path / "made", tmp_path / "out"
    assert scene("constant", "--out", made, "--json") == 0
    assert json.loads(capsys.readouterr().out)["objects"] == 1
    assert main(["run", f"{made}/input", "--out", str(out), "-q"]) == 0
    assert main(["evaluate", f"{made}/gt.txt", f"{out}/tracks.txt", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["IDF1"] > 80
    assert main(["segment", f"{made}/input", "--out", str(out), "-q"]) == 0
    assert main(["evaluate-masks", str(made), str(out), "--json"]) == 0
    capsys.readouterr()


def test_a_shorter_scene_leaves_nothing_of_a_longer_one(tmp_path: Path) -> None:
    write_scene(make_scene("constant", size=(64, 48), frame_count=50), tmp_path)
    (tmp_path / "input" / "notes.txt").write_text("the user's own")
    write_scene(make_scene("constant", size=(64, 48), frame_count=40), tmp_path)
    assert len(list((tmp_path / "input").glob("*.png"))) == 40
    assert len(list((tmp_path / "groundtruth").iterdir())) == 40
    assert (tmp_path / "input" / "notes.txt").exists()


def test_a_scene_that_was_interrupted_says_so_and_can_be_made_again(tmp_path: Path) -> None:
    made = make_scene("constant", size=(64, 48), frame_count=40)

    def stop(frames: int) -> None:
        if frames == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_scene(made, tmp_path, progress=stop)
    assert not (tmp_path / "recipe.json").exists()
    assert (tmp_path / "recipe.json.part").exists()
    write_scene(made, tmp_path)
    assert not (tmp_path / "recipe.json.part").exists()


def test_images_of_others_are_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "input").mkdir()
    (tmp_path / "input" / "in000007.png").write_bytes(b"precious")
    with pytest.raises(UsageError, match=r"holds 1 images \(in000007\.png, \.\.\.\)"):
        write_scene(make_scene("constant"), tmp_path)
    assert (tmp_path / "input" / "in000007.png").read_bytes() == b"precious"


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (["nonesuch"], 'unknown scene "nonesuch"; one of: constant, '),
        (["nonesuch", "--out", "x"], 'unknown scene "nonesuch"'),
        (["constant", "--out", "x", "--frames", "0"], "--frames"),
        (["constant", "--out", "x", "--size", "64"], "--size 64: width x height"),
        (["constant", "--out", "x", "--fps", "0"], "fps: 0"),
        (["constant", "--out", "x", "--seed", "-1"], "seed: -1"),
        (["constant", "--out", "x", "--kind", "depth"], 'kind: unknown "depth"'),
        (
            ["constant", "--out", "x", "--set", "contacts"],
            '--set "contacts" is not allowed; expected option=value',
        ),
        (["constant", "--out", "x", "--set", "contacts=many"], "contacts: 'many'"),
        (["constant", "--out", "x", "--set", "sped=3"], 'unknown option "sped"'),
        (["constant", "--out", "x", "--set", "speed_px_per_s=0.05"], "never in the frame"),
    ],
)
def test_misuse_ends_with_2_and_leaves_nothing(
    args: list[str],
    words: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert scene(*args) == 2
    out, err = capsys.readouterr()
    assert out == "" and words in err and err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_made_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert scene("constant", "--out", tmp_path / "file") == 1
    assert str(tmp_path / "file") in capsys.readouterr().err
