# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The guard of the whole scene: what it must tell, and on what it must be silent."""

from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path

import cv2
import numpy as np
import pytest

import survtrack
from clips import Image
from survtrack import ConfigError, GuardOptions, InputError, SceneChangeKind, SceneGuard
from survtrack.scenes import make_scene
from survtrack.sources import open_source

MEASURES = [
    survtrack.BlocksOptions(),
    survtrack.ChangedPixelsOptions(),
    survtrack.HistogramOptions(),
    survtrack.KolmogorovSmirnovOptions(),
]
each_measure = pytest.mark.parametrize("measure", MEASURES, ids=lambda one: one.model)


def told(frames: Iterable[Image], options: GuardOptions | None = None) -> list[tuple[int, str]]:
    """Frame and kind of each change at 25 frames/s."""
    guard, changes = SceneGuard(options or GuardOptions()), []
    for k, frame in enumerate(frames):
        change = guard.look(frame, k / 25).change
        if change is not None:
            changes.append((k, change.kind.name))
    return changes


def footage(data: Path, name: str, count: int = 40) -> list[Image]:
    """Colour frames of public footage, 320x240."""
    source = open_source(str(data / name), resize=(320, 240), limit=count)
    return [frame for _, _, frame in source]


def dimmed(frames: list[Image], gains: Iterable[float]) -> list[Image]:
    return [(frame * gain).astype(np.uint8) for frame, gain in zip(frames, gains, strict=False)]


def infrared(frame: Image) -> Image:
    return np.repeat(cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)[..., None], 3, axis=2)


VTEST, HIGHWAY = "video/vtest.avi", "cdnet/highway/input"


@pytest.mark.parametrize("measure", MEASURES[:3], ids=lambda one: one.model)
def test_a_cut_between_two_public_scenes(data: Path, measure: object) -> None:
    """Their grey levels are distributed too much alike for the fourth measure."""
    frames = footage(data, VTEST) + footage(data, HIGHWAY)
    assert told(frames, GuardOptions(measure=measure)) == [(40, "cut")]


def test_a_lamp_infrared_and_black_frames_in_public_footage(data: Path) -> None:
    day = footage(data, VTEST, 120)
    lamp = day[:40] + dimmed(day[40:80], [0.6] * 40) + day[80:]
    assert told(lamp) == [(40, "brightness"), (80, "brightness")]
    night = day[:40] + [infrared(frame) for frame in day[40:80]] + day[80:]
    assert told(night) == [(40, "infrared"), (80, "infrared")]
    black = day[:40] + [np.full_like(day[0], 6)] * 3 + day[43:]
    assert told(black) == [(40, "black")]


@each_measure
def test_half_of_the_light_is_told_by_every_measure(data: Path, measure: object) -> None:
    day = footage(data, VTEST)
    frames = day + dimmed(day, [0.5] * 40)
    assert told(frames, GuardOptions(measure=measure)) == [(40, "brightness")]


def test_dusk_in_public_footage_is_gradual(data: Path) -> None:
    day = footage(data, VTEST, 300)
    kinds = {kind for _, kind in told(dimmed(day, np.linspace(1, 0.3, 300)))}
    assert kinds == {"gradual"}


@pytest.mark.parametrize("name", ["light_switch", "light_fade"])
def test_made_scenes_with_another_light(name: str) -> None:
    made = make_scene(name, frame_count=200)
    frames = [np.asarray(frame) for _, _, frame in made.frames()]
    changes = told(frames)
    if name == "light_switch":
        assert changes == [(100, "brightness")]
    else:
        assert changes and all(kind == "gradual" and k > 50 for k, kind in changes)
    usual = make_scene("crowd", frame_count=100)
    assert told(np.asarray(frame) for _, _, frame in usual.frames()) == []


SILENT = [
    ("video/vtest.avi", 7),
    ("cdnet/highway/input", 25),
    ("cdnet/pedestrians/input", 25),
    ("caviar/Walk1/input", 25),
    ("caviar/OneLeaveShop1cor/OneLeaveShop1cor.mpg", 25),
    ("video/atrium.mp4", 25),
    ("video/bgslib_video02.avi", 25),
    ("cdnet/canoe/input", 25),
]


@pytest.mark.parametrize(("name", "fps"), SILENT, ids=lambda one: str(one).split("/")[-1])
def test_public_footage_without_a_change_raises_nothing(data: Path, name: str, fps: float) -> None:
    guard = SceneGuard()
    for _, time_s, frame in open_source(str(data / name), fps=fps):
        look = guard.look(frame, time_s)
        assert look.change is None, f"{time_s:.2f} s: {look.against_reference:.2f}"


def detections_of(
    frames: list[Image], **options: object
) -> Iterator[tuple[float, survtrack.Detections]]:
    """Part of the frame that is foreground, and the detections, frame by frame."""
    detector = survtrack.Detector(survtrack.Config(**options))
    for k, frame in enumerate(frames):
        found = detector.process(frame, k / 25)
        assert found is not None
        yield np.count_nonzero(found.mask) / found.mask.size, found


@pytest.mark.parametrize("change", ["cut", "lamp", "infrared", "black", "dusk"])
def test_masks_of_a_fixed_background_are_not_flooded(data: Path, change: str) -> None:
    day = footage(data, VTEST, 80)
    other: dict[str, Callable[[], list[Image]]] = {
        "cut": lambda: footage(data, HIGHWAY),
        "lamp": lambda: dimmed(day[40:], [1.4] * 40),
        "infrared": lambda: [infrared(frame) for frame in day[40:]],
        "black": lambda: [np.zeros_like(day[0])] * 5 + day[45:],
        "dusk": lambda: dimmed(day[40:], np.linspace(1, 0.4, 40)),
    }
    frames = day[:40] + other[change]()
    fixed = survtrack.StaticReferenceOptions(source="median")
    unguarded = [part for part, _ in detections_of(frames, segmenter=fixed)]
    both = {"segmenter": fixed, "scene_change": GuardOptions()}
    guarded = list(detections_of(frames, **both))
    events = [event for _, found in guarded for event in found.events]
    assert events and {event.kind for event in events} == {survtrack.EventKind.scene_changed}
    assert events[0].index == 40 or change == "dusk"
    assert all("The scene changed (" in event.text for event in events)
    most = max(part for part, _ in guarded)
    print(f"{change}: {max(unguarded):.3f} of the frame without a guard, {most:.3f} with it")
    # What changes slowly is told when nearly half of the frame is far from its mean, not before.
    assert max(unguarded) > (1.5 if change == "dusk" else 2) * most
    assert most < 0.6


def test_the_background_before_black_frames_is_used_again(data: Path) -> None:
    day = footage(data, HIGHWAY, 60)
    black = [np.zeros_like(day[0])] * 4
    with_black = day[:30] + black + day[34:]
    for segmenter in (survtrack.SelectiveOptions(), survtrack.StaticReferenceOptions()):
        both = {"segmenter": segmenter, "scene_change": GuardOptions()}
        gap = [part for part, _ in detections_of(with_black, **both)]
        whole = [part for part, _ in detections_of(day, **both)]
        assert gap[:30] == whole[:30]
        assert gap[30:34] == [0.0] * 4
        assert gap[34:] == pytest.approx(whole[34:], abs=0.02)
        assert max(gap[34:]) > 0.01


def test_the_default_is_as_it_was_without_a_guard() -> None:
    assert survtrack.Config().scene_change == survtrack.NoSceneChangeOptions()


def test_a_guard_shows_what_it_measures() -> None:
    guard = SceneGuard(GuardOptions(samples=300, low_pass_px=0))
    assert guard.sample_count == 0
    frame = np.full((30, 40, 3), (10, 60, 30), np.uint8)
    look = guard.look(frame, 0)
    assert 200 < guard.sample_count <= 300
    assert (look.change, look.black, look.against_reference, look.color) == (None, False, 0, 50)
    changed = frame.copy()
    changed[:15] = 250
    look = guard.look(changed, 1)
    assert 0.4 <= look.against_reference <= 0.6 and look.against_before == look.against_reference
    assert look.reference_color == 50 and look.correlation == 0
    guard.reset()
    assert guard.look(np.zeros((5, 5), np.uint8), 0).change is None


def test_a_change_says_what_showed_it() -> None:
    guard = SceneGuard()
    random = np.random.default_rng(1)
    guard.look(np.full((60, 80), 90, np.uint8), 0)
    change = guard.look(random.integers(0, 256, (60, 80), dtype=np.uint8), 1).change
    assert change is not None
    assert (change.kind, change.measure) == (SceneChangeKind.cut, "changed_pixels")
    assert change.value > change.threshold == 0.45


def test_bad_frames_times_and_options_are_refused() -> None:
    guard = SceneGuard()
    guard.look(np.zeros((6, 6), np.uint8), 0)
    for frame, time_s in (
        (np.zeros((6, 6), np.uint8), 0),
        (np.zeros((6, 6), np.uint8), float("nan")),
        (np.zeros((6, 7), np.uint8), 1),
        (np.zeros((6, 6, 3), np.uint8), 1),
        (np.full((6, 6), np.nan), 1),
    ):
        with pytest.raises(InputError, match=r"^(frame|time_s): "):
            guard.look(frame, time_s)
    with pytest.raises(ConfigError, match=r"measure\.bins: 1 is not allowed"):
        GuardOptions(measure=survtrack.HistogramOptions(bins=2).to_dict() | {"bins": 1})
    with pytest.raises(ConfigError, match=r"memory_s: 0.* is not allowed"):
        GuardOptions(memory_s=0)
    config = survtrack.Config()
    with pytest.raises(ConfigError, match=r'scene_change\.model: unknown "cuts"; one of'):
        config.set("scene_change.model=cuts")


def test_strided_views_and_copies_give_the_same(data: Path) -> None:
    frames = list(islice(footage(data, VTEST), 10))
    guards = SceneGuard(), SceneGuard()
    for k, frame in enumerate(frames):
        views = frame[::-1, ::2], np.ascontiguousarray(frame[::-1, ::2])
        looks = [guard.look(view, k) for guard, view in zip(guards, views, strict=True)]
        assert looks[0].against_reference == looks[1].against_reference
        assert looks[0].correlation == looks[1].correlation
