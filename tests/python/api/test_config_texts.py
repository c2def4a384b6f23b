# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Configs from presets, TOML, JSON and single settings, and back."""

import json
import tomllib
from typing import Any

import pytest

import survtrack
from survtrack import Config, ConfigError

PRESETS = survtrack.preset_names()


def test_the_default_preset_comes_first_and_is_the_default_config() -> None:
    assert PRESETS[0] == "survtrack"
    assert "narayana2007" in PRESETS
    assert survtrack.preset() == survtrack.preset("survtrack") == Config()
    assert survtrack.Pipeline().config == survtrack.Pipeline.from_preset().config == Config()


def holds(values: dict[str, Any], table: dict[str, Any]) -> bool:
    """Whether all entries of a table, and of those in it, are among the values."""
    return all(
        holds(values[name], entry) if isinstance(entry, dict) else values[name] == entry
        for name, entry in table.items()
    )


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_is_its_file_on_top_of_the_defaults(name: str) -> None:
    text = survtrack.preset_text(name)
    config = survtrack.preset(name)
    assert config == Config.from_toml(text)
    assert survtrack.Pipeline.from_preset(name).config == config
    table = tomllib.loads(text)
    below = survtrack.preset(table.pop("base", "survtrack"))
    below.update_from_json(json.dumps(table))
    assert config == below
    assert holds(json.loads(config.to_json()), table)
    assert [line for line in text.splitlines() if line.startswith("#")], "says nothing of itself"


def test_the_published_preset_holds_the_published_numbers() -> None:
    config = survtrack.preset("narayana2007")
    assert config.time_unit_s == 0.04
    assert config.segmenter == survtrack.MovingAverageOptions()
    assert (config.segmenter.window_frames, config.segmenter.threshold) == (150, 10.0)
    assert config.cleanup == survtrack.CleanupOptions(median_px=0, open_px=3)
    assert config.filter == survtrack.MeanVelocityOptions(window_steps=5)
    assert config.lifecycle == survtrack.LostCountOptions(lost_after_frames=5)
    assert (config.cost.model, config.assignment.model) == ("belief", "oldest_first")
    assert (config.vicinity.cell_px, config.vicinity.max_factor) == (30, 5.0)


@pytest.mark.parametrize("function", [survtrack.preset, survtrack.preset_text])
def test_an_unknown_preset_is_refused_with_the_choices(function: Any) -> None:
    with pytest.raises(ConfigError, match=r'^preset: unknown "semko"; one of: survtrack, naray'):
        function("semko")
    with pytest.raises(ConfigError, match="one of: survtrack"):
        survtrack.Pipeline.from_preset("")


@pytest.mark.parametrize("name", PRESETS)
def test_texts_and_dicts_give_the_same_config(name: str) -> None:
    config = survtrack.preset(name)
    assert Config.from_toml(config.to_toml()) == config
    assert Config.from_json(config.to_json()) == config
    assert Config(**config.to_dict()) == config
    values = json.loads(config.to_json())
    assert tomllib.loads(config.to_toml()) == values
    assert json.loads(json.dumps(config.to_dict())) == values  # lists of numbers are tuples


def test_every_option_of_the_text_is_explained() -> None:
    for line in Config().to_toml().splitlines():
        assert not line or "  # " in line, line


def test_set_takes_numbers_words_and_booleans() -> None:
    config = Config()
    config.set("segmenter.threshold=12.5")
    config.set(" cleanup.open_px =  3 ")
    config.set("filter.noise_unit=px")
    config.set('filter.noise_unit="px"')
    config.set("outputs.background=true")
    config.set("time_unit_s=1")
    expected = Config(
        segmenter=survtrack.SelectiveOptions(threshold=12.5),
        cleanup=survtrack.CleanupOptions(open_px=3),
        filter=survtrack.KalmanCvOptions(noise_unit="px"),
        outputs=survtrack.OutputOptions(background=True),
    )
    assert config == expected


def test_set_takes_lists_of_numbers() -> None:
    config = Config()
    config.set("filter.model=kalman_discrete")
    config.set("filter.process_variances=[1,2,3,4]")
    config.set(" filter.measurement_covariance = [0.2877, 0, 1.1465] ")
    assert config.filter == survtrack.KalmanDiscreteOptions(
        process_variances=(1, 2, 3, 4), measurement_covariance=(0.2877, 0, 1.1465)
    )
    assert Config.from_toml(config.to_toml()) == Config.from_json(config.to_json()) == config
    assert "process_variances = [1.0,2.0,3.0,4.0]  # px^2, (px/unit)^2; " in config.to_toml()
    with pytest.raises(ConfigError, match=r"^filter\.process_variances\[2\]: -3 is not allowed; "):
        config.set("filter.process_variances=[1,2,-3,4]")
    with pytest.raises(ConfigError, match=r"^street\.toml: filter\.process_variances: \[1,2\] is"):
        config.update_from_toml("filter.process_variances = [1, 2]", "street.toml")


def test_choosing_a_model_resets_its_options() -> None:
    config = Config()
    config.set("filter.position_noise=0.5")
    config.set("filter.model=kalman_cv")
    assert config == Config()
    config.set("filter.model=kalman_ca")
    config.set("filter.acceleration_noise=2")
    assert config.filter == survtrack.KalmanCaOptions(acceleration_noise=2)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("filter.model=kalmann", r'filter\.model: unknown "kalmann"; one of: kalman_cv, kalman_ca'),
        ("filter.model", r'"filter\.model" is not allowed; expected option=value'),
        ("=3", '"=3" is not allowed; expected option=value'),
        ("", '"" is not allowed; expected option=value'),
        ("treshold=3", "treshold: unknown option; one of: time_unit_s, scene_change, segmenter"),
        ("filter=3", "filter: 3 is not allowed; expected a table"),
        (
            "filter.position_noise=abc",
            r'filter\.position_noise: "abc" is not allowed; expected a n',
        ),
        (
            "filter.position_noise=-1",
            r"filter\.position_noise: -1 is not allowed; expected between 1e-06",
        ),
        ("filter.position_noise=nan", r"filter\.position_noise: nan is not allowed"),
        ("filter.position_noise=true", r"filter\.position_noise: true is not allowed"),
        ("cleanup.median_px=5.0", r"cleanup\.median_px: 5\.0 is not allowed; expected an integer"),
        ("cleanup.median_px=", r'cleanup\.median_px: "" is not allowed'),
        ("cleanup.median_px=[5]", r"cleanup\.median_px: \[5\] is not allowed"),
        ("cleanup..median_px=5", r"cleanup\.: unknown option"),
        ("segmenter.window=causal", r"segmenter\.window: unknown option; one of: model, threshold"),
        (
            "outputs.background=yes",
            r'outputs\.background: "yes" is not allowed; expected true or f',
        ),
    ],
)
def test_a_refused_setting_is_named_and_leaves_the_config(setting: str, message: str) -> None:
    config = survtrack.Config(time_unit_s=0.5)
    with pytest.raises(ConfigError, match=f"^{message}"):
        config.set(setting)
    assert config == survtrack.Config(time_unit_s=0.5)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[segmenter]\nmodel = "mog2"\nhistory_frames = 0', r"segmenter\.history_frames: 0 is not"),
        ("cleanup.median_px = 3\n[segmenter\n", r"2:\d+: "),
        ("time_unit_s = 2001-01-01", "time_unit_s: "),
        ("time_unit_s = [1, 2]", r"time_unit_s: \[1,2\] is not allowed"),
        ("cleanup = 3", "cleanup: 3 is not allowed"),
        ("cleanup.median_px = 3\ncleanup.median_px = 3", "2:"),
    ],
)
def test_refused_toml_is_named_with_its_source(text: str, message: str) -> None:
    config = Config(time_unit_s=0.5)
    with pytest.raises(ConfigError, match=rf"^street\.toml: ?{message}"):
        config.update_from_toml(text, "street.toml")
    with pytest.raises(ConfigError, match=message):
        Config.from_toml(text)
    assert config == Config(time_unit_s=0.5)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "is not JSON"),
        ("", "is not JSON"),
        ("[]", r"\[\] is not allowed"),
        ('{"cleanup": null}', "cleanup: null is not allowed"),
        ('{"cleanup": {"median_px": 4}}', r"cleanup\.median_px: 4 is not allowed"),
        ('{"time_unit_s": 1e400}', "."),
        ('{"time_unit_s": NaN}', "is not JSON"),
    ],
)
def test_refused_json_is_named_with_its_source(text: str, message: str) -> None:
    config = Config(time_unit_s=0.5)
    with pytest.raises(ConfigError, match=rf"^street\.json: .*{message}"):
        config.update_from_json(text, "street.json")
    assert config == Config(time_unit_s=0.5)


def test_texts_are_read_on_top_of_the_present_options() -> None:
    config = survtrack.preset("narayana2007")
    config.update_from_toml("[segmenter]\nthreshold = 15")
    config.update_from_json('{"lifecycle": {"lost_after_frames": 9}}')
    assert config.segmenter == survtrack.MovingAverageOptions(threshold=15)
    assert config.lifecycle == survtrack.LostCountOptions(lost_after_frames=9)
    assert config.filter == survtrack.MeanVelocityOptions()


def test_a_pipeline_keeps_its_config() -> None:
    config = Config(time_unit_s=0.5)
    pipeline = survtrack.Pipeline(config)
    config.time_unit_s = 2
    assert pipeline.config == Config(time_unit_s=0.5)


def test_the_reference_names_every_option() -> None:
    reference = survtrack.options_reference()
    for section, options in Config().to_dict().items():
        assert f"`[{section}]`" in reference or f"`{section}`" in reference
        for option in set(options) - {"model"} if isinstance(options, dict) else ():
            assert f"`{section}.{option}`" in reference or f"`[{section}.{option}]`" in reference
