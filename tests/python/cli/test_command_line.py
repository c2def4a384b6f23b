# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The program as a whole: help, version, presets, errors in one line, exit codes, Ctrl-C."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import survtrack
from clips import walking_square, write_images
from survtrack.cli.main import main
from survtrack.cli.options import parse_size
from survtrack.cli.presets import description
from survtrack.cli.progress import progress_line, show_progress
from survtrack.errors import UsageError

COMMANDS = (
    "run",
    "segment",
    "link",
    "evaluate",
    "evaluate-masks",
    "reproduce",
    "scene",
    "presets",
)


@pytest.fixture
def images(tmp_path: Path) -> Path:
    return write_images(tmp_path / "in", walking_square(6))


def error_of(args: list[object], code: int, capsys: pytest.CaptureFixture[str]) -> str:
    """The one line on stderr of a command that ends with `code`."""
    assert main([str(arg) for arg in args]) == code
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("survtrack: error: ")
    assert err.count("\n") == 1
    return err.removeprefix("survtrack: error: ").rstrip("\n")


@pytest.mark.parametrize("flag", ["-h", "--help"])
@pytest.mark.parametrize("command", [(), *((name,) for name in COMMANDS)])
def test_help_works_everywhere(
    command: tuple[str, ...], flag: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*command, flag]) == 0
    out = capsys.readouterr().out
    assert "Usage: survtrack" in out
    if not command:
        assert all(name in out for name in COMMANDS)


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"survtrack {survtrack.__version__}\n"


def test_presets_are_listed_with_what_they_are(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["presets"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == survtrack.preset_names()
    assert all(len(line.split(maxsplit=1)[1]) > 10 for line in lines)
    assert not any("SPDX" in line for line in lines)


def test_a_preset_is_printed_as_toml(capsys: pytest.CaptureFixture[str]) -> None:
    for name in survtrack.preset_names():
        assert main(["presets", name]) == 0
        text = capsys.readouterr().out
        assert text == survtrack.preset_text(name)
        assert survtrack.Config.from_toml(text).to_toml() == survtrack.preset(name).to_toml()


def test_description_skips_the_licence() -> None:
    assert description("# SPDX-Foo: x\n#\n# What it is.\n# More.\na = 1\n") == "What it is."
    assert description("a = 1\n") == ""


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--preset", "nonesuch"], "nonesuch"),
        (["--set", "filter.nonesuch=3"], "filter.nonesuch"),
        (["--set", "filter.model=kalmann"], "kalmann"),
        (["--set", "time_unit_s=-1"], "time_unit_s"),
        (["--set", "time_unit_s"], "time_unit_s"),
        (["--fps", "0"], "fps: 0"),
        (["--fps", "fast"], "--fps"),
        (["--start", "-1"], "--start"),
        (["--start", "6"], "start: 6 skips all 6 frames"),
        (["--step", "0"], "--step"),
        (["--limit", "0"], "--limit"),
        (["--resize", "640"], "--resize 640: width x height"),
        (["--resize", "0x5"], "--resize 0x5: width x height"),
        (["--views", "mask"], "add --video"),
        (["--video", "--views", "mask,trakcs"], 'unknown "trakcs"; one of: frame, mask'),
        (["--nonesuch"], "--nonesuch"),
        (["another source"], "another source"),
    ],
)
def test_misuse_ends_with_2_and_names_what_is_wrong(
    images: Path, options: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    out = images.parent / "out"
    assert words in error_of(["run", images, "--out", out, *options], 2, capsys)
    assert not out.exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [("time_unit_s = 'x'", "time_unit_s"), ("nonesuch = 1", "nonesuch"), ("a = [", "my.toml")],
)
def test_a_config_file_that_is_wrong_is_named(
    images: Path, text: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    config = images.parent / "my.toml"
    config.write_text(text)
    out = images.parent / "out"
    error = error_of(["run", images, "--out", out, "--config", config], 2, capsys)
    assert words in error and "my.toml" in error


def test_a_config_file_that_cannot_be_read(
    images: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    missing, binary = images.parent / "missing.toml", images.parent / "binary.toml"
    binary.write_bytes(b"\xff\xfe\x00")
    for config, words in ((missing, "No such file"), (binary, "is not UTF-8 text")):
        args = ["run", images, "--out", images.parent / "out", "--config", config]
        assert error_of(list(args), 1, capsys).startswith(f"{config}: {words}")


def test_missing_arguments_and_unknown_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert "'--out'" in error_of(["run", "clip.mp4"], 2, capsys)
    assert "SOURCE" in error_of(["run", "--out", "x"], 2, capsys)
    assert "nonesuch" in error_of(["nonesuch"], 2, capsys)
    assert "nonesuch" in error_of(["presets", "nonesuch"], 2, capsys)


def test_without_arguments_there_is_help_and_misuse(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    assert "Usage: survtrack" in "".join(capsys.readouterr())


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "no such file or folder"), (b"", "is an empty file"), (b"text" * 99, "is not a video")],
)
def test_a_source_that_is_none_ends_with_1(
    tmp_path: Path, content: bytes | None, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    source = tmp_path / "clip.avi"
    if content is not None:
        source.write_bytes(content)
    for command in ("run", "segment"):
        error = error_of([command, source, "--out", tmp_path / "out"], 1, capsys)
        assert error.startswith(f"{source}: {words}")
    assert not (tmp_path / "out").exists()


def test_the_traceback_is_there_for_who_asks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SURVTRACK_TRACEBACK", "1")
    with pytest.raises(survtrack.InputError):
        main(["run", str(tmp_path / "none.avi"), "--out", str(tmp_path)])


def test_sizes() -> None:
    assert parse_size(None) is None
    assert parse_size("640x480") == (640, 480)
    for text in ("640X480", "640x", "x480", "-1x4", "640x480x3", " 640x480", "999999x1"):
        with pytest.raises(UsageError):
            parse_size(text)


def test_progress_lines() -> None:
    assert progress_line(120, 795, 10) == ("survtrack: 120 of 795 frames, 12.0 frames/s, 56 s left")
    assert progress_line(120, None, 10) == "survtrack: 120 frames, 12.0 frames/s"
    # Some files declare less than they hold.
    assert progress_line(120, 3, 10) == "survtrack: 120 of 3 frames, 12.0 frames/s"


def test_progress_is_lines_now_and_then_where_there_is_no_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    times = iter([0.0, 4.0, 10.0, 12.0, 20.0])
    monkeypatch.setattr("survtrack.cli.progress.monotonic", lambda: next(times))
    with show_progress(100, quiet=False) as update:
        assert update is not None
        for frames in (10, 20, 30, 40):
            update(frames)
    assert capsys.readouterr().err.splitlines() == [
        "survtrack: 20 of 100 frames, 2.0 frames/s, 40 s left",
        "survtrack: 40 of 100 frames, 2.0 frames/s, 30 s left",
    ]
    with show_progress(100, quiet=True) as update:
        assert update is None


def test_progress_is_a_bar_on_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    with show_progress(100, quiet=False) as update:
        assert update is not None
        for frames in range(1, 51):
            update(frames)
            time.sleep(0.005)
    err = capsys.readouterr().err
    assert "50/100" in err and "frames/s" in err and "left" in err


def start_run(folder: Path, *options: str) -> "subprocess.Popen[str]":
    """`survtrack run` on 3000 large frames: many seconds of work."""
    write_images(folder / "in", walking_square(1, width=1280, height=720))
    frame = folder / "in" / "in000001.png"
    for k in range(2, 3000):
        os.link(frame, folder / "in" / f"in{k:06d}.png")
    command = [sys.executable, "-m", "survtrack", "run", str(folder / "in")]
    return subprocess.Popen(
        [*command, "--out", str(folder / "out"), *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_run_finishes_its_files(
    tmp_path: Path, number: signal.Signals, code: int
) -> None:
    process = start_run(tmp_path, "--json", "--video", "--views", "mask")
    part = tmp_path / "out" / "annotated.mp4.part"
    deadline = time.monotonic() + 60
    while not (part.exists() and part.stat().st_size > 0) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert process.poll() is None
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert process.returncode == code
    assert "Traceback" not in err
    facts = json.loads((tmp_path / "out" / "run.json").read_text())
    assert (facts["complete"], facts["error"]) == (False, "interrupted")
    assert 0 < facts["frames"]["count"] < 2999
    assert json.loads(out)["frames"] == facts["frames"]["count"]
    assert err.splitlines()[-1] == (
        f"survtrack: error: interrupted after frame {facts['frames']['last']}; "
        f"what was found until then is in {tmp_path / 'out'}"
    )
    assert not [name for name in os.listdir(tmp_path / "out") if name.endswith(".part")]
