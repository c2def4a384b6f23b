# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`survtrack tune-noise`: what it finds, writes and refuses."""

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest

import survtrack
from clips import walking_square, write_images
from survtrack.cli.main import main
from survtrack.scenes import make_scene
from survtrack.scenes.writing import write_scene


@pytest.fixture(scope="module")
def footage(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Frames of a contact whose direction changes."""
    folder = tmp_path_factory.mktemp("scene") / "made"
    write_scene(make_scene("varying_direction", seed=4), folder)
    return folder / "input"


def tune(*args: object) -> int:
    return main(["tune-noise", *map(str, args)])


def facts_of(capsys: pytest.CaptureFixture[str], *args: object) -> dict[str, Any]:
    assert tune(*args, "--json", "--quiet") == 0
    found = json.loads(capsys.readouterr().out)
    assert isinstance(found, dict)
    return found


def test_finds_noises_and_writes_a_config_that_run_takes(
    footage: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "tuned.toml"
    facts = facts_of(capsys, footage, "--out", out)
    assert (
        facts["model"] == "kalman_cv"
        and facts["frames"] == make_scene("varying_direction").frame_count
    )
    assert facts["steps"] >= 50 and facts["measurements"] > facts["steps"]
    assert facts["left_out"]["at_border"] > 0 and facts["out"] == str(out)
    assert set(facts["noises"]) == {"velocity_noise", "position_noise", "initial_velocity"}
    assert facts["noises"]["velocity_noise"]["now"] == 0.75
    assert facts["after"]["log_likelihood"] > facts["before"]["log_likelihood"]
    # The contact is drawn exactly: its box is off by a part of a pixel, not by 0.06 of its size.
    assert facts["noises"]["position_noise"]["identified"] < 0.03
    tables = tomllib.loads(out.read_text())
    for name, noise in facts["noises"].items():
        assert tables["filter"][name] == pytest.approx(noise["identified"], rel=1e-12)
    assert tables["time_unit_s"] == 1.0 and tables["filter"]["lost_damping_time"] == 2.0
    run = ("run", footage, "--config", out, "--out", tmp_path / "run", "-q")
    assert main([*map(str, run)]) == 0
    config = survtrack.Config.from_toml((tmp_path / "run" / "config.toml").read_text())
    assert isinstance(config.filter, survtrack.KalmanCvOptions)
    assert config.filter.velocity_noise == tables["filter"]["velocity_noise"]
    # Where the likelihood is largest it stays.
    again = facts_of(capsys, footage, "--config", out)
    low, high = again["after"]["nis_band"]
    assert low < again["after"]["nis_mean"] < high


def test_prints_a_table_and_the_options(footage: Path, capsys: pytest.CaptureFixture[str]) -> None:
    args = ("--set", "filter.model=kalman_ca", "--fps", 25)
    assert tune(footage, *args) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("measurements: ") and "cut by the frame's border" in lines[0]
    names = [line.split()[0] for line in lines if line.strip()]
    for name in ("acceleration_noise", "position_noise", "initial_velocity"):
        assert f"filter.{name}" in names
    assert {"log-likelihood", "mean", "correlation"} <= set(names)
    text = "\n".join(lines[lines.index("") :])
    assert tomllib.loads(text)["filter"]["noise_unit"] == "object_size"
    assert survtrack.Config.from_toml(text).filter.model == "kalman_ca"


def test_is_the_same_every_time(footage: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert facts_of(capsys, footage, "--joint") == facts_of(capsys, footage, "--joint")


def test_refuses_what_it_cannot_do(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    images = write_images(tmp_path / "in", walking_square(12, width=128, height=96, side=20))
    out = tmp_path / "tuned.toml"
    for code, message, args in (
        (1, "tracks: 0 with 0 steps from one measurement to the next are too few", ()),
        (2, 'filter.model: the noises of "mean_velocity" are not identified; choose kalman_cv',
         ("--set", "filter.model=mean_velocity", "--set", "cost.model=distance")),
        (2, "filter.velocity_noise: -1 is not allowed", ("--set", "filter.velocity_noise=-1")),
        (2, 'preset: unknown "none"', ("--preset", "none")),
        (2, "--min-steps", ("--min-steps", 3)),
    ):  # fmt: skip
        assert tune(images, "--out", out, *args) == code, message
        told = capsys.readouterr()
        assert told.out == "" and message in told.err, told.err
    assert not out.with_name("tuned.toml.part").exists()
    assert tune(images, "--out", tmp_path / "none" / "tuned.toml") == 1
    told = capsys.readouterr()
    assert "none/tuned.toml: No such file or directory" in told.err and "0 steps" not in told.err
    out.mkdir()
    assert tune(images, "--out", out) == 1
    told = capsys.readouterr()
    assert "tuned.toml: Is a directory" in told.err and "0 steps" not in told.err
    assert not out.with_name("tuned.toml.part").exists()
    out.rmdir()
    assert tune(tmp_path / "none") == 1
    assert "none" in capsys.readouterr().err
    assert not out.exists()


def test_takes_a_background_and_zones(
    footage: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    first = min(footage.iterdir())
    reference = ("--set", "segmenter.model=static_reference", "--set", "segmenter.source=picture")
    assert tune(footage, *reference) == 2
    assert "segmenter.source: picture needs one; add --background FILE" in capsys.readouterr().err
    assert facts_of(capsys, footage, *reference, "--background", first)["steps"] > 50
    zones = ("--set", "regions.model=predicted", "--set", "regions.acquisition=zones")
    whole = facts_of(capsys, footage)
    found = facts_of(capsys, footage, *zones, "--zone", "0,0,320,240")
    assert found["steps"] > 50 and found["frames"] == whole["frames"]
    assert tune(footage, "--zone", "0,0,320,240") != 0
    assert "zone" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["vtest.avi", "bgslib_video02.avi"])
def test_real_footage_is_fitted_better_than_before(
    name: str, data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    facts = facts_of(capsys, data / "video" / name, "--fps", 7, "--limit", 300)
    assert facts["steps"] > 300
    assert facts["after"]["log_likelihood"] > facts["before"]["log_likelihood"]
    assert facts["after"]["nis_mean"] == pytest.approx(2, abs=0.1)
