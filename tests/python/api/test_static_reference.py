# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A background that is taken once, against its formula; and the blobs that go with it."""

import numpy as np
import pytest

import survtrack
from clips import Image
from scenes import scene
from survtrack import ConfigError, InputError, Segmenter, StaticReferenceOptions

THRESHOLDS = {"threshold_blue": 12.5, "threshold_green": 20, "threshold_red": 31.25}
RANDOM = np.random.default_rng(4)
NOISE = [RANDOM.integers(90, 140, (17, 33, 3), dtype=np.uint8) for _ in range(12)]


def masks(options: StaticReferenceOptions, frames: list[Image]) -> list[Image]:
    segmenter = Segmenter(options)
    return [segmenter.segment(frame, k / 10) for k, frame in enumerate(frames)]


@pytest.mark.parametrize("frames", [1, 4, 5])
@pytest.mark.parametrize("source", ["mean", "median"])
def test_the_mask_is_numpys(source: str, frames: int) -> None:
    """Nashenda 2011, eq. 2, in any channel."""
    options = StaticReferenceOptions(source=source, frames=frames, **THRESHOLDS)
    reference = getattr(np, source)(np.array(NOISE[:frames], float), axis=0)
    for k, mask in enumerate(masks(options, NOISE)):
        expected = (np.abs(NOISE[k] - reference) > list(THRESHOLDS.values())).any(axis=2)
        assert np.array_equal(mask > 0, expected & (k >= frames)), k
    grey = [frame[..., 0] for frame in NOISE]
    reference = reference[..., 0]
    for k, mask in enumerate(masks(options.replace(threshold_grey=22), grey)):
        assert np.array_equal(mask > 0, (np.abs(grey[k] - reference) > 22) & (k >= frames)), k


def test_the_background_is_the_rounded_reference() -> None:
    segmenter = Segmenter(StaticReferenceOptions(frames=4))
    for k, frame in enumerate(NOISE):
        segmenter.segment(frame, k / 10)
        shown = np.array(NOISE[: min(k + 1, 4)], float).mean(axis=0)
        assert np.array_equal(segmenter.background(), np.floor(shown + 0.5)), k


def test_a_picture_can_be_given() -> None:
    options = StaticReferenceOptions(source="picture")
    ground = scene(1)[0]
    for make in (Segmenter, lambda o: survtrack.Detector(survtrack.Config(segmenter=o))):
        with pytest.raises(
            InputError, match=r"^background: segmenter\.source is .* none was given"
        ):
            stage = make(options)
            (stage.segment if isinstance(stage, Segmenter) else stage.process)(ground, 0)
    segmenter = Segmenter(options)
    segmenter.load_background(ground[::-1][::-1])
    frame = ground.copy()
    frame[10:20, 30:50] = 250
    for _ in range(2):
        mask = segmenter.segment(frame, 0)
        assert np.count_nonzero(mask) == 200 and mask[10:20, 30:50].all()
        assert np.array_equal(segmenter.background(), ground)
        with pytest.raises(InputError, match=r"^background: came after the first frame"):
            segmenter.load_background(ground)
        segmenter.reset()


def test_a_pipeline_takes_a_picture_and_keeps_it_over_a_reset() -> None:
    pipeline = survtrack.Pipeline(
        survtrack.Config(segmenter=StaticReferenceOptions(source="picture"))
    )
    frames = scene(30)
    pipeline.load_background(frames[0])
    for _ in range(2):
        found = [pipeline.process(frame, k / 10) for k, frame in enumerate(frames)]
        assert found[-1] is not None and len(found[-1].detections) == 1
        with pytest.raises(InputError, match="came after the first frame"):
            pipeline.load_background(frames[0])
        pipeline.reset()


def test_a_background_is_learned_anew_on_demand() -> None:
    options = StaticReferenceOptions(frames=2)
    config = survtrack.Config(segmenter=options)
    segmenter, detector = Segmenter(options), survtrack.Detector(config)
    pipeline = survtrack.Pipeline(config)
    dark, bright = np.full((2, 40, 50), [[[40]], [[180]]], np.uint8)
    for k, frame in enumerate([dark] * 4 + [bright] * 8):
        if k == 6:
            segmenter.relearn()
            detector.relearn_background()
            pipeline.relearn_background()
        whole = pipeline.process(frame, k)
        detections = detector.process(frame, k)
        assert whole is not None and detections is not None
        for mask in (segmenter.segment(frame, k), whole.mask, detections.mask):
            assert mask.all() == mask.any() == (k in (4, 5)), k


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (np.zeros((64, 96), np.float32), "background: "),
        (np.zeros((64, 96, 4), np.uint8), "background: "),
        (np.zeros((0, 96), np.uint8), "background: "),
        ("ground.png", "background: "),
        (None, "background: "),
    ],
)
def test_what_is_no_picture_is_refused(picture: object, words: str) -> None:
    config = survtrack.Config(segmenter=StaticReferenceOptions(source="picture"))
    for taker in (
        survtrack.Pipeline(config),
        survtrack.Detector(config),
        Segmenter(config.segmenter),
    ):
        with pytest.raises(InputError, match=f"^{words}"):
            taker.load_background(picture)  # type: ignore[arg-type]


def test_a_picture_of_another_format_is_refused_with_both_sizes() -> None:
    pipeline = survtrack.Pipeline(
        survtrack.Config(segmenter=StaticReferenceOptions(source="picture"))
    )
    pipeline.load_background(np.zeros((10, 20), np.uint8))
    words = r"^background: the picture is 10x20, the frame 64x96x3; expected the same size"
    with pytest.raises(InputError, match=words):
        pipeline.process(scene(1)[0], 0)


def test_models_without_a_picture_say_so() -> None:
    with pytest.raises(InputError, match="takes no picture"):
        survtrack.Pipeline().load_background(scene(1)[0])
    with pytest.raises(InputError, match=r"expected segmenter\.source picture"):
        Segmenter(StaticReferenceOptions()).load_background(scene(1)[0])


def test_options_are_checked() -> None:
    with pytest.raises(ConfigError, match="frames: 0 is not allowed"):
        StaticReferenceOptions(frames=0)
    with pytest.raises(ConfigError, match="threshold_red"):
        StaticReferenceOptions(threshold_red=float("nan"))
    with pytest.raises(ConfigError, match=r"source.*mean.*median.*picture"):
        StaticReferenceOptions(source="first")


def test_two_erosions_by_three_pixels_are_one_by_five() -> None:
    """The cleanup of Nashenda 2011: bwmorph(fore, 'erode', 2)."""
    noise = (RANDOM.random((60, 80)) < 0.93).astype(np.uint8) * 255
    noise[:, :20] = 255

    def eroded(edge: int, mask: Image) -> Image:
        tiling = survtrack.WholeFrameOptions(erode_px=edge, dilate_px=0)
        return survtrack.clean_mask(mask, survtrack.CleanupOptions(median_px=0, tiling=tiling))

    assert np.array_equal(eroded(5, noise), eroded(3, eroded(3, noise)))
    assert eroded(5, noise).any() and not eroded(5, noise).all()


def test_the_largest_of_the_four_connected_blobs_remains() -> None:
    mask = np.zeros((60, 80), np.uint8)
    mask[5:15, 5:15] = 255  # 100 px
    mask[15:24, 15:26] = 255  # 99 px, at the first one's corner
    mask[40:51, 50:59] = 255  # 99 px
    nashenda = survtrack.BlobOptions(
        min_area_px=100,
        min_area_fraction=0,
        max_blobs=1,
        connectivity="four",
        merge=survtrack.NoMergeOptions(),
    )
    found = survtrack.find_blobs(mask, options=nashenda)
    assert [(d.area_px, tuple(d.box)) for d in found] == [(100, (5, 5, 10, 10))]
    eight = survtrack.find_blobs(mask, options=nashenda.replace(connectivity="eight"))
    assert [d.area_px for d in eight] == [199]
    every = survtrack.find_blobs(mask, options=nashenda.replace(max_blobs=10, min_area_px=99))
    assert sorted(d.area_px for d in every) == [99, 99, 100]
