# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What can be known before the first frame is done leaves no outputs and keeps an earlier run."""

import os
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from clips import cut_short, walking_square, write_images, write_video
from survtrack.cli.main import main

FRAMES = walking_square(12, width=128, height=96, side=20, still=5)
GRID = ("--preset", "narayana2007", "--set")
TOO_LARGE_A_CELL = (
    "vicinity.cell_px: 97 is larger than the frame of 128x96 px",
    (*GRID, "vicinity.cell_px=97", "--set", "segmenter.window=causal"),
)
TOO_LARGE_A_CELL_LATE = (
    "vicinity.cell_px: 97 is larger than the frame of 128x96 px",
    (*GRID, "vicinity.cell_px=97"),
)
TOO_SMALL_TILES = (
    "mask: is 96x128, which makes tile (row 1, column 1) 48x64 px; expected at least its edge of "
    "49 px",
    (
        "--set",
        "cleanup.tiling={model='quadrants', overlap_px=40, erode_top_left_px=49}",
    ),
)


@pytest.fixture
def images(tmp_path: Path) -> Path:
    return write_images(tmp_path / "in", FRAMES)


@pytest.fixture
def earlier(images: Path, tmp_path: Path) -> Path:
    """A folder with a run and its masks."""
    assert main(["run", str(images), "--out", str(tmp_path / "out"), "--video", "--quiet"]) == 0
    assert main(["segment", str(images), "--out", str(tmp_path / "masks"), "--quiet"]) == 0
    return tmp_path


def contents(folder: Path) -> dict[str, tuple[int, bytes]]:
    return {
        path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in sorted(folder.iterdir())
    }


@dataclass
class Refusal:
    """Runs commands that must fail and leave the folder as it was."""

    capsys: pytest.CaptureFixture[str]

    def __call__(
        self,
        command: str,
        source: Path,
        out: Path,
        options: tuple[str, ...],
        code: int,
        message: str,
    ) -> None:
        before = contents(out) if out.exists() else None
        self.capsys.readouterr()
        assert main([command, str(source), "--out", str(out), *options]) == code
        told, err = self.capsys.readouterr()
        assert told == ""
        assert err.startswith("survtrack: error: ") and err.count("\n") == 1
        assert message in err
        assert (contents(out) if out.exists() else None) == before


@pytest.fixture
def refuse(capsys: pytest.CaptureFixture[str]) -> Refusal:
    return Refusal(capsys)


@pytest.mark.parametrize("options", [(), ("--json",)])
@pytest.mark.parametrize(
    ("message", "wrong"), [TOO_LARGE_A_CELL, TOO_LARGE_A_CELL_LATE, TOO_SMALL_TILES]
)
def test_a_config_that_the_frames_do_not_fit(
    earlier: Path,
    refuse: Refusal,
    message: str,
    wrong: tuple[str, ...],
    options: tuple[str, ...],
) -> None:
    for out in (earlier / "out", earlier / "new" / "folder"):
        refuse("run", earlier / "in", out, (*wrong, *options), 1, message)
    for out in (earlier / "masks", earlier / "new" / "folder"):
        refuse("segment", earlier / "in", out, (*wrong, *options), 1, message)
    assert not (earlier / "new").exists()


@pytest.mark.parametrize("late", [(), ("--set", "segmenter.window=causal")])
def test_a_scene_of_frames_of_another_size(
    earlier: Path, refuse: Refusal, late: tuple[str, ...]
) -> None:
    options = ("--preset", "narayana2007", *late)
    small = ("--resize", "64x48", "--out", str(earlier / "small"), "--quiet")
    assert main(["run", str(earlier / "in"), *options, *small]) == 0
    scene = ("--scene", str(earlier / "small" / "scene.json"))
    message = "frame: is 128x96 px, and the scene was learned on frames of 64x48 px"
    for out in (earlier / "out", earlier / "new"):
        refuse("run", earlier / "in", out, (*options, *scene), 1, message)


def test_a_video_of_which_nothing_can_be_read(earlier: Path, refuse: Refusal) -> None:
    path = write_video(earlier / "clip.mp4", FRAMES)
    data = bytearray(path.read_bytes())
    start = data.index(b"mdat") + 4
    length = int.from_bytes(data[start - 8 : start - 4], "big") - 8
    data[start : start + length] = bytes(length)
    path.write_bytes(bytes(data))
    for command, out in (("run", "out"), ("run", "new"), ("segment", "masks")):
        refuse(command, path, earlier / out, (), 1, str(path))


def test_a_selection_without_frames(earlier: Path, refuse: Refusal) -> None:
    path = write_video(earlier / "clip.mp4", FRAMES)
    message = f"start: 50 skips all 12 frames of {path}"
    for command, out in (("run", "out"), ("run", "new"), ("segment", "masks")):
        refuse(command, path, earlier / out, ("--start", "50"), 2, message)


def test_flow_to_a_frame_before_the_first(earlier: Path, refuse: Refusal) -> None:
    model = ("--set", "segmenter.model=horn_schunck", "--set")
    message = "segmenter.frames_back: 12 is not allowed with the 12 frame(s) of"
    for command, out in (("run", "out"), ("run", "new"), ("segment", "masks")):
        refuse(
            command, earlier / "in", earlier / out, (*model, "segmenter.frames_back=12"), 1, message
        )
    fits = ("--out", str(earlier / "new"), *model, "segmenter.frames_back=11", "--quiet")
    assert main(["run", str(earlier / "in"), *fits]) == 0


def test_names_that_cannot_become_masks(earlier: Path, refuse: Refusal) -> None:
    frame = FRAMES[:1]
    write_images(earlier / "named", frame, pattern="a000001.png")
    write_images(earlier / "named", frame, pattern="b000001.png")
    message = "b000001.png: its mask would be bin000001.png, as that of a000001.png"
    for out in (earlier / "masks", earlier / "new"):
        refuse("segment", earlier / "named", out, (), 1, message)
    write_images(earlier / "named", frame, pattern="still.png")
    refuse("segment", earlier / "named", earlier / "masks", ("--start", "1"), 1, "still.png: its")
    assert main(["run", str(earlier / "named"), "--out", str(earlier / "new"), "--quiet"]) == 0


def test_an_error_in_the_second_frame_is_one_amid_the_run(earlier: Path) -> None:
    cut_short(earlier / "in" / "in000002.png", 0.5)
    assert main(["run", str(earlier / "in"), "--out", str(earlier / "out"), "--quiet"]) == 1
    assert '"complete": false' in (earlier / "out" / "run.json").read_text()
    assert '"count": 1' in (earlier / "out" / "run.json").read_text()
    assert not (earlier / "out" / "annotated.mp4").exists()


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupted_before_the_first_frame(
    earlier: Path, number: signal.Signals, code: int
) -> None:
    """While the first image is being read."""
    before = contents(earlier / "out")
    waits = earlier / "waits"
    write_images(waits, FRAMES[:2])
    program = (
        "import sys, time, survtrack.sources.images as images\n"
        "from survtrack.cli.main import main\n"
        "read = images.read_image\n"
        "def slow(path, expected=None):\n"
        "    if expected is not None:\n"
        "        print('waits', flush=True)\n"
        "        time.sleep(3)\n"
        "    return read(path, expected)\n"
        "images.read_image = slow\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", program, "run", str(waits), "--out", str(earlier / "out")],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "waits\n"
    os.kill(process.pid, number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == code
    words = "interrupted before the first frame was done; nothing was written"
    assert err == f"survtrack: error: {words}\n"
    assert contents(earlier / "out") == before
