# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Option classes are values: made by keywords, compared, copied, pickled, never changed."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import survtrack
from scenes import CLASSES, MODELS, PARTS
from survtrack import ConfigError

WITH_CONFIG = [*CLASSES, survtrack.Config]
OTHER_CHOICES = {
    "object_size": "px",
    "centred": "causal",
    "free": "published",
    "bgr": "lab",
    "settling": "published_mean",
    "square": "ellipse",
    "continuous": "identity",
    "hs1981": "sobel",
    "strip": "border",
    "detection": "frame_center",
    "checked": "as_published",
    "mean": "median",
    "running": "previous",
    "restart": "relearn",
    "eight": "four",
}


def values_of(options: Any) -> dict[str, Any]:
    """Its options by name, without the name of its model."""
    return {name: value for name, value in options.to_dict().items() if name != "model"}


def another(value: Any) -> Any:
    """A value that the option of this value takes too, and that is not it."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return OTHER_CHOICES[value]
    if isinstance(value, dict):
        if value["model"] == "changed_pixels":
            return survtrack.BlocksOptions()
        whole = survtrack.WholeFrameOptions()
        return whole if value["model"] == "none" else survtrack.NoMergeOptions()
    if isinstance(value, tuple):
        return tuple(another(number) for number in value)
    if isinstance(value, int) and value > 1000:
        return value // 2
    if isinstance(value, int):
        return 3 if value != 3 else 5
    return value / 2 if value else 1.0


@pytest.mark.parametrize("options_class", WITH_CONFIG)
def test_options_are_read_as_attributes(options_class: type[Any]) -> None:
    options = options_class()
    for name, value in options.to_dict().items():
        read = getattr(options, name)
        if isinstance(value, dict):
            read = read.to_dict()
        assert read == value and type(read) is type(value)
    for name in values_of(options):
        assert getattr(options_class, name).__doc__, "an option has no docstring"
    assert ("model" in options.to_dict()) == hasattr(options_class, "model")


@pytest.mark.parametrize("options_class", WITH_CONFIG)
def test_repr_makes_the_same_options(options_class: type[Any]) -> None:
    options = options_class()
    assert eval(repr(options), vars(survtrack).copy()) == options
    assert options_class(**values_of(options)) == options


@pytest.mark.parametrize("options_class", CLASSES)
def test_replace_changes_a_copy(options_class: type[Any]) -> None:
    for name, value in values_of(options_class()).items():
        options = options_class()
        changed = options.replace(**{name: another(value)})
        assert getattr(changed, name) == another(value)
        assert changed != options and options == options_class()
        assert changed == options_class(**{name: another(value)})
        assert changed.replace(**{name: value}) == options


@pytest.mark.parametrize("options_class", CLASSES)
def test_options_cannot_be_assigned_and_the_error_says_what_to_do(options_class: type[Any]) -> None:
    options = options_class()
    for name, value in values_of(options).items():
        with pytest.raises(AttributeError, match=rf"^{name}: .*config\.set.*replace\({name}="):
            setattr(options, name, another(value))
    with pytest.raises(AttributeError, match="no_such_option"):
        options.no_such_option = 1
    assert options == options_class()


def test_a_part_of_a_config_is_a_copy() -> None:
    config = survtrack.Config()
    part = config.cleanup
    config.set("cleanup.median_px=9")
    assert (part.median_px, config.cleanup.median_px) == (5, 9)


@pytest.mark.parametrize("options_class", WITH_CONFIG)
def test_equality_is_of_class_and_values(options_class: type[Any]) -> None:
    assert options_class() == options_class()
    assert (options_class() != options_class()) is False
    assert [one for one in WITH_CONFIG if one() == options_class()] == [options_class]
    assert options_class() != options_class().to_dict()
    with pytest.raises(TypeError, match="unhashable"):
        hash(options_class())


@pytest.mark.parametrize("options_class", WITH_CONFIG)
@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_pickling_and_copying_keep_all_options(options_class: type[Any], protocol: int) -> None:
    options = options_class()
    if options_class is survtrack.Config:
        options = survtrack.preset("narayana2007")
    for name, value in values_of(options).items():
        if not isinstance(value, dict):
            options = options.replace(**{name: another(value)})
    assert pickle.loads(pickle.dumps(options, protocol)) == options
    assert copy.copy(options) == options
    assert copy.deepcopy([options]) == [options]


def test_a_copied_config_is_another_one() -> None:
    config = survtrack.Config()
    for made in (copy.copy(config), copy.deepcopy(config), config.replace()):
        made.time_unit_s = 0.5
        assert made != config
    assert config == survtrack.Config()


@pytest.mark.parametrize(
    ("section", "options_class"),
    [(section, one) for section, models in MODELS.items() for one in models] + [*PARTS.items()],
)
def test_a_section_takes_options_of_any_of_its_classes(
    section: str, options_class: type[Any]
) -> None:
    options = options_class()
    for name, value in values_of(options).items():
        options = options.replace(**{name: another(value)})
    config = survtrack.preset("narayana2007")
    setattr(config, section, options)
    assert getattr(config, section) == options
    assert getattr(survtrack.Config(**{section: options}), section) == options
    assert getattr(survtrack.Config().replace(**{section: options}), section) == options


def test_a_section_refuses_options_of_another() -> None:
    config = survtrack.Config()
    with pytest.raises(ConfigError, match=r'^segmenter\.model: unknown "kalman_cv"; one of: sel'):
        config.segmenter = survtrack.KalmanCvOptions()  # type: ignore[assignment]
    with pytest.raises(ConfigError, match=r"^cleanup\.min_area_px: unknown option; one of: median"):
        config.cleanup = survtrack.BlobOptions()  # type: ignore[assignment]
    assert config == survtrack.Config()


@pytest.mark.parametrize("number", [np.int8(7), np.uint64(7), np.int64(7), np.array(7)])
def test_numpy_integers_are_integers(number: Any) -> None:
    assert survtrack.CleanupOptions(median_px=number).median_px == 7
    assert survtrack.SelectiveOptions(threshold=number).threshold == 7.0


@pytest.mark.parametrize("number", [np.float16(7.5), np.float32(7.5), np.float64(7.5)])
def test_numpy_floats_are_numbers(number: Any) -> None:
    assert survtrack.SelectiveOptions(threshold=number).threshold == 7.5


VARIANCES = (1.0, 2.0, 3.0, 4.0)


@pytest.mark.parametrize(
    "numbers",
    [
        *(VARIANCES, list(VARIANCES), range(1, 5), np.array(VARIANCES), np.arange(1, 5)),
        *(np.array(VARIANCES, np.float32), [1, np.float64(2), np.int8(3), 4.0]),
    ],
    ids=repr,
)
def test_any_sequence_of_numbers_is_a_list_and_becomes_a_tuple(numbers: Any) -> None:
    options = survtrack.KalmanDiscreteOptions(process_variances=numbers)
    assert options.process_variances == VARIANCES
    assert type(options.process_variances) is tuple
    assert all(type(number) is float for number in options.process_variances)
    assert options.to_dict()["process_variances"] == VARIANCES


ITSELF: list[Any] = [1.0, 2.0, 3.0]
ITSELF.append(ITSELF)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (3.0, r": 3.0 is not allowed; expected 4 numbers, each between 0 and 1000000000000"),
        ("1234", r': "1234" is not allowed; expected 4 numbers'),
        (b"1234", r": .* is not allowed; expected 4 numbers"),
        (None, r": null is not allowed; expected 4 numbers"),
        (iter(VARIANCES), r": .* is not allowed; expected 4 numbers"),
        (set(VARIANCES), r": .* is not allowed; expected 4 numbers"),
        ([1, 2, 3], r": \[1,2,3\] is not allowed; expected 4 numbers"),
        (range(10**12), r": .* is not allowed; expected 4 numbers"),
        (np.ones((2, 4)), r": .* is not allowed; expected 4 numbers"),
        (np.ones((4, 1)), r"\[0\]: .* is not allowed; expected a number"),
        ([1, 2, -3, 4], r"\[2\]: -3 is not allowed; expected between 0 and"),
        ([1, 2, 3, float("nan")], r"\[3\]: nan is not allowed; expected between 0 and"),
        ([1, True, 3, 4], r"\[1\]: true is not allowed; expected a number"),
        ([1, 2, "3", 4], r'\[2\]: "3" is not allowed; expected a number'),
        (ITSELF, r"\[3\]: .* is not allowed; expected a number"),
    ],
)
def test_what_is_no_list_of_numbers_is_refused_by_its_place(value: Any, message: str) -> None:
    with pytest.raises(ConfigError, match=rf"^KalmanDiscreteOptions\.process_variances{message}"):
        survtrack.KalmanDiscreteOptions(process_variances=value)


def test_numpy_booleans_are_booleans() -> None:
    assert survtrack.SelectiveOptions(remove_shadows=np.False_).remove_shadows is False


NOT_INTEGERS: list[object] = [
    *(True, False, np.True_, 3.0, np.float32(3), "3", None, [3], (3,), {"a": 3}),
    *(b"3", 3 + 0j, ..., np.array([3]), np.array([3, 5]), np.array([])),
    *(float("nan"), float("inf"), 10**30, -(10**30)),
]


@pytest.mark.parametrize("value", NOT_INTEGERS, ids=repr)
def test_what_is_no_integer_is_refused(value: Any) -> None:
    expected = r"^CleanupOptions\.median_px: .* is not allowed; expected .*between 0 and 31, 0 or "
    with pytest.raises(ConfigError, match=expected):
        survtrack.CleanupOptions(median_px=value)


@pytest.mark.parametrize(
    "value",
    [True, np.True_, "3", None, [3.0], 3j, ..., np.array([3.0]), np.zeros(2)],
    ids=repr,
)
def test_what_is_no_number_is_refused(value: Any) -> None:
    expected = (
        r"^SelectiveOptions\.threshold: .* is not allowed; expected a number, between 0 and 255"
    )
    with pytest.raises(ConfigError, match=expected):
        survtrack.SelectiveOptions(threshold=value)


@pytest.mark.parametrize("value", [1, 0, "true", None, 1.0, np.int8(1)], ids=repr)
def test_what_is_no_boolean_is_refused(value: Any) -> None:
    expected = r"^OutputOptions\.background: .* is not allowed; expected true or false$"
    with pytest.raises(ConfigError, match=expected):
        survtrack.OutputOptions(background=value)


@pytest.mark.parametrize(
    ("options_class", "options", "message"),
    [
        (survtrack.CleanupOptions, {"median_px": 4}, "4 is not allowed; expected between 0 and 31"),
        (survtrack.CleanupOptions, {"median_px": -1}, "-1 is not allowed"),
        (survtrack.CleanupOptions, {"open_px": 101}, "open_px: 101 is not allowed"),
        (
            survtrack.KalmanCvOptions,
            {"position_noise": 0},
            "0 is not allowed; expected between 1e-06",
        ),
        (survtrack.KalmanCvOptions, {"position_noise": float("nan")}, "nan is not allowed"),
        (survtrack.KalmanCvOptions, {"position_noise": float("inf")}, "inf is not allowed"),
        (survtrack.KalmanCvOptions, {"noise_unit": "cm"}, '"cm" is .*one of: object_size, px$'),
        (survtrack.KalmanCvOptions, {"noise_unit": 3}, "3 is not .*one of: object_size, px$"),
        (survtrack.MovingAverageOptions, {"window": ""}, '"" is not .*one of: centred, causal$'),
        (survtrack.HungarianOptions, {"x": 1}, r"HungarianOptions\.x: unknown .*: confirmed_first"),
        (survtrack.OldestFirstOptions, {"x": 1}, "unknown option; there are none here"),
        (
            survtrack.Config,
            {"time_unit_s": 0},
            r"Config\.time_unit_s: 0 is not .* between 1e-06 and 3600$",
        ),
        (
            survtrack.Config,
            {"tracker": {}},
            "tracker: unknown option; one of: time_unit_s, scene_change, seg",
        ),
        (survtrack.Config, {"cleanup": {"median": 3}}, r"Config\.cleanup\.median: unknown option"),
        (survtrack.Config, {"filter": {"model": "x"}}, r'Config\.filter\.model: unknown "x"; one'),
        (survtrack.Config, {"filter": {"model": 3}}, r"filter\.model: 3 is not allowed; .*kalman"),
        (
            survtrack.Config,
            {"filter": "kalman_ca"},
            '"kalman_ca" is .* expected a table of options',
        ),
        (survtrack.Config, {"cleanup": None}, r"Config\.cleanup: null is not allowed"),
    ],
)
def test_refused_options_are_named_with_path_and_choices(
    options_class: type[Any], options: dict[str, Any], message: str
) -> None:
    with pytest.raises(ConfigError, match=message) as caught:
        options_class(**options)
    assert str(caught.value).startswith(f"{options_class.__name__}.")
    with pytest.raises(ConfigError, match=message):
        options_class().replace(**options)


def test_options_go_by_keyword_only() -> None:
    with pytest.raises(TypeError):
        survtrack.CleanupOptions(3)  # type: ignore[misc]
    with pytest.raises(TypeError):
        survtrack.Config({})  # type: ignore[misc]
