# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Whatever comes in: an answer of finite numbers, or an error that names what is wrong."""

import contextlib
import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import survtrack
from clips import Image
from option_strategies import SECTIONS, configs, options_found, with_parts_in, with_paths
from scenes import CLASSES, MEASURES, MERGES, MODELS, TILINGS, answer, rows
from survtrack import Config, Detections, InputError, NoAppearanceOptions, Pipeline, Tracker

settings.register_profile("survtrack", deadline=None, derandomize=True, max_examples=200)
settings.load_profile("survtrack")

SHAPES = st.tuples(st.integers(1, 48), st.integers(1, 70))
STEPS_S = st.floats(1e-3, 1e3)


def assert_finite(*structured: np.ndarray) -> None:
    for array in structured:
        for name in array.dtype.names or ():
            assert np.isfinite(array[name]).all(), f"{name}: {array[name]}"


def assert_sound(result: survtrack.FrameResult, shape: tuple[int, ...]) -> None:
    """No number of a result is NaN or infinite."""
    assert result.mask.shape == shape[:2] and set(np.unique(result.mask)) <= {0, 255}
    assert_finite(result.track_array, result.detection_array)
    assert all(np.isfinite(match.cost) for match in result.matches)
    places = [place for event in result.events for place in (*event.box, *event.position)]
    for track in result.tentative:
        places += [*track.box, *track.position, *track.velocity_px_per_s]
        places += [*track.predicted_position, *track.position_covariance_px2.ravel()]
    assert np.isfinite(places).all()
    costs = result.costs
    assert costs is None or not (np.isnan(costs) | np.isneginf(costs)).any()


@st.composite
def clips(draw: Any) -> list[Image]:
    """Frames of noise over a ground, some with a square that jumps about."""
    height, width = draw(SHAPES)
    shape = (height, width, 3) if draw(st.booleans()) else (height, width)
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    ground = random.integers(0, 256, shape)
    noise = draw(st.sampled_from([0, 3, 40, 255]))
    side = draw(st.integers(0, 20))
    frames = []
    for _ in range(draw(st.integers(1, 14))):
        frame = ground + random.integers(-noise, noise + 1, shape)
        left, top = random.integers(0, width), random.integers(0, height)
        frame[top : top + side, left : left + side] = random.integers(0, 256)
        frames.append(np.clip(frame, 0, 255).astype(np.uint8))
    return frames


def test_every_option_is_varied() -> None:
    """What the reference page says is all there is."""
    found = set(options_found())
    for options_class in CLASSES:
        model = getattr(options_class, "model", None)
        named = [section for section, models in MODELS.items() if options_class in models]
        section = (
            named[0]
            if named
            else "blobs.merge"
            if options_class in MERGES
            else "cleanup.tiling"
            if options_class in TILINGS
            else "scene_change.measure"
            if options_class in MEASURES
            else {"C": "cleanup", "B": "blobs", "O": "outputs"}[options_class.__name__[0]]
        )
        expected = {
            (section, model, option)
            for option, value in options_class().to_dict().items()
            if option != "model" and not isinstance(value, dict)
        }
        assert expected <= found
        found -= expected
    assert found == set()
    inner = {"blobs.merge", "cleanup.tiling", "scene_change.measure"}
    assert set(SECTIONS) == {*Config().to_dict(), *inner} - {"time_unit_s"}


@given(configs(), clips(), st.data())
def test_any_config_takes_any_frames(config: Config, frames: list[Image], data: Any) -> None:
    config = with_parts_in(frames[0].shape, config)
    pipeline, again = Pipeline(config), Pipeline(config)
    for one in (pipeline, again):
        with_paths(one, config, (frames[0].shape[1], frames[0].shape[0]))
    time_s, results, others = 0.0, [], []
    for frame in frames:
        time_s += data.draw(STEPS_S)
        results.append(pipeline.process(frame, time_s))
        others.append(again.process(frame, time_s))
    late = [one for one in results if one is not None] + pipeline.finish()
    assert [result.index for result in late] == list(range(len(frames)))
    for result in late:
        assert_sound(result, frames[0].shape)
    assert answer(late) == answer([one for one in others if one is not None] + again.finish())


@given(configs())
def test_any_config_survives_every_text(config: Config) -> None:
    assert Config.from_toml(config.to_toml()) == config
    assert Config.from_json(config.to_json()) == config
    assert Config(**config.to_dict()) == config
    assert pickle.loads(pickle.dumps(config)) == config
    assert eval(repr(config), vars(survtrack).copy()) == config


@given(
    arrays.arrays(
        dtype=st.one_of(
            arrays.scalar_dtypes(), st.just(np.dtype(np.uint8)), st.just(np.dtype(object))
        ),
        shape=arrays.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5),
    )
)
def test_any_array_is_a_frame_or_is_refused(array: np.ndarray) -> None:
    shape_fits = array.ndim == 2 or (array.ndim == 3 and array.shape[2] == 3)
    if array.dtype == np.uint8 and shape_fits and array.size > 0:
        result = Pipeline().process(array, 0.0)
        assert result.frame is array
        assert_sound(result, array.shape)
    else:
        with pytest.raises(InputError, match=r"^frame: is .*; expected"):
            Pipeline().process(array, 0.0)


@given(st.data(), st.booleans())
def test_any_view_counts_as_its_copy(data: Any, grey: bool) -> None:
    whole = np.random.default_rng(0).integers(0, 256, (6, 40, 60, 6), dtype=np.uint8)
    height, width = whole.shape[1:3]
    index = data.draw(
        arrays.basic_indices((height, width), min_dims=2, max_dims=2, allow_ellipsis=False)
    )
    channel = data.draw(
        st.sampled_from([0, 5] if grey else [slice(3), slice(None, None, 2), slice(2, None, -1)])
    )
    order = data.draw(st.permutations([0, 1]))
    views = [frame[..., channel][index] for frame in whole]
    views = [
        view.transpose(*order, 2) if view.ndim == 3 else view.transpose(*order) for view in views
    ]
    if views[0].size == 0:
        with pytest.raises(InputError, match="at least one pixel"):
            Pipeline().process(views[0], 0.0)
        return
    one, two = Pipeline(), Pipeline()
    seen = [one.process(view, float(k)) for k, view in enumerate(views)]
    copied = [two.process(view.copy(order="C"), float(k)) for k, view in enumerate(views)]
    assert answer(seen) == answer(copied)


BOXES = arrays.arrays(
    np.float64, st.tuples(st.integers(0, 6), st.just(4)), elements=st.floats(1e-3, 1e8)
)


@given(st.lists(BOXES, min_size=1, max_size=12), configs(), st.data())
def test_any_boxes_are_tracked(boxes: list[np.ndarray], config: Config, data: Any) -> None:
    config.appearance = NoAppearanceOptions()  # boxes have no colours
    tracker, time_s = Tracker(with_parts_in((48, 64), config)), 0.0
    with_paths(tracker, config, (64, 48))
    for k, array in enumerate(boxes):
        time_s += data.draw(STEPS_S)
        result = tracker.process(Detections(array, time_s, index=k, frame_size=(64, 48)))
        assert_finite(result.track_array)
        # The contact monitor lets newcomers wait until the median rises; some are off every path.
        waits = config.lifecycle.model == "count_median" or config.filter.model == "kalman_path"
        assert waits or len(result.tracks) + len(result.tentative) >= (len(array) > 0)
        ids = [track.id for track in result.tracks]
        assert ids == sorted(set(ids)) and 0 not in ids


@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 4), st.just(4))))
def test_any_numbers_are_boxes_or_are_refused(boxes: np.ndarray) -> None:
    tracker, undisturbed = Tracker(), Tracker()
    good = [[1.0, 2, 30, 40]]
    for k in range(6):
        if k == 3:
            with contextlib.suppress(InputError):
                result = tracker.process(boxes, 0.3)
                assert_finite(result.track_array)
                return
        one, two = tracker.process(good, k / 10), undisturbed.process(good, k / 10)
        assert rows(one.track_array) == rows(two.track_array)
