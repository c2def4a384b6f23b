# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Regions that are read instead of whole frames."""

import copy
import math
import pickle

import numpy as np
import pytest

import survtrack
from scenes import FPS, config_of, run, scene

# In frames as small as these pieces of rows cost more than their pixels spare.
PREDICTED = survtrack.PredictedRegionsOptions(
    acquisition="border", border=0.1, refresh_frames=20, whole_above=100
)
SOON = survtrack.SelectiveOptions(update_time_s=0.2)  # whole frames for 0.4 s only


def kinds(result: survtrack.FrameResult) -> list[str]:
    return kinds_of(result.detections)


def kinds_of(detections: survtrack.Detections) -> list[str]:
    return [region.kind.name for region in detections.regions]


def test_the_same_tracks_in_fewer_pixels() -> None:
    frames = scene()
    expected = run(survtrack.Pipeline(), frames)
    found = run(survtrack.Pipeline(config_of(regions=PREDICTED, segmenter=SOON)), frames)
    area = frames[0].shape[0] * frames[0].shape[1]
    assert {result.pixels_read for result in expected} == {area}
    assert kinds(expected[-1]) == ["whole_frame"]
    assert sum(result.pixels_read for result in found) < 0.75 * area * len(found)
    assert [t.id for t in found[-1].tracks] == [t.id for t in expected[-1].tracks] == [1]
    assert survtrack.iou(found[-1].tracks[0].box, expected[-1].tracks[0].box) > 0.9
    assert kinds(found[0]) == ["acquisition"] * 4 + ["whole_frame"]
    assert kinds(found[6]) == ["acquisition"] * 4 + ["refresh"]
    region = next(r for r in found[-1].regions if r.track_id == 1)
    assert region.kind is survtrack.RegionKind.predicted
    assert survtrack.iou(region.box, found[-1].tracks[0].box) > 0.1
    assert found[-1].detections.regions == found[-1].regions
    assert found[-1].detections.pixels_read == found[-1].pixels_read
    assert "predicted" in repr(region) and hash(region) == hash(region)


def test_nothing_outside_of_the_regions_is_looked_at() -> None:
    frames = scene()
    detector = survtrack.Detector(config_of(segmenter=SOON))
    detector.process(frames[0], 0.0)
    whole = detector.process(frames[0], 0.1, regions=[survtrack.Box(4, 6, 10, 8)])
    assert whole is not None and kinds_of(whole) == ["predicted", "whole_frame"], (
        "the background is young"
    )
    detector.process(frames[0], 1.0)
    moved = 255 - frames[0]
    seen = detector.process(moved, 1.1, regions=[survtrack.Box(4, 6, 10, 8)])
    assert seen is not None and seen.mask is not None and seen.pixels_read == 80
    assert seen.mask.sum() == seen.mask[6:14, 4:14].sum() > 0
    with pytest.raises(survtrack.InputError, match=r"^regions\[0\]: .* lies outside"):
        detector.process(moved, 1.2, regions=[survtrack.Box(-20, 0, 10, 10)])
    assert detector.process(moved, 1.2) is not None, "the frame was not taken"
    other = survtrack.Detector(config_of(segmenter=survtrack.KnnOptions()))
    with pytest.raises(survtrack.InputError, match="reads whole frames"):
        other.process(moved, 0.1, regions=[survtrack.Box(4, 6, 10, 8)])


def test_zones() -> None:
    options = PREDICTED.replace(acquisition="zones", refresh_frames=0)
    pipeline = survtrack.Pipeline(config_of(regions=options, segmenter=SOON))
    with pytest.raises(survtrack.InputError, match="needs zones"):
        pipeline.process(scene()[0], 0.0)
    with pytest.raises(survtrack.InputError, match="zones: are none"):
        pipeline.load_zones([])
    pipeline.load_zones([survtrack.Box(0, 0, 20, 1000)])
    results = run(pipeline, scene())
    height = scene()[0].shape[0]
    assert results[6].pixels_read == 20 * height
    assert results[6].regions[0].box == survtrack.Box(0, 0, 20, height), "cut to the frame"
    with pytest.raises(survtrack.InputError, match="no use for them"):
        survtrack.Pipeline().load_zones([survtrack.Box(0, 0, 20, 20)])
    with pytest.raises(survtrack.InputError, match="after the first frame"):
        pipeline.load_zones([survtrack.Box(0, 0, 20, 20)])


def test_a_tracker_alone_says_where_to_look() -> None:
    tracker = survtrack.Tracker(config_of(regions=PREDICTED, segmenter=SOON))
    assert tracker.predict(0.0).regions == [], "the size is not known"
    tracker.update(survtrack.Detections([[50, 40, 10, 20]], 0.0, frame_size=(160, 120)))
    expected = tracker.predict(0.1)
    assert [r.kind.name for r in expected.regions] == ["acquisition"] * 4 + ["predicted"]
    box = expected.regions[-1].box
    assert box.x < 50 and box.right > 60 and box.y < 40 and box.bottom > 60
    fresh = survtrack.Tracker(config_of(regions=PREDICTED, segmenter=SOON))
    assert len(fresh.predict(0.0, frame_size=(160, 120)).regions) == 4


def test_hit_rate_is_that_of_theory() -> None:
    """Of positions drawn from the model so many lie within k sigmas along and across."""
    rng = np.random.default_rng(3)
    covariance = np.diag([9.0, 4.0])
    for k, share in ((1.0, 0.6827**2), (2.0, 0.9545**2), (3.0, 0.9973**2)):
        options = survtrack.PredictedRegionsOptions(
            sigmas_along=k, sigmas_across=k, whole_object=True, margin=0.0, growth=0.0
        )
        box = survtrack.Box(95, 47, 10, 6)
        region = survtrack.predicted_region(options, (80, 50), (100, 50), covariance, box)
        drawn = rng.multivariate_normal((100, 50), covariance, 20000)
        half = np.array([5, 3])
        low, high = drawn - half, drawn + half
        inside = (low >= (region.x, region.y)) & (high <= (region.right, region.bottom))
        assert inside.all(axis=1).mean() == pytest.approx(share, abs=0.01)


def test_on_a_path() -> None:
    path = survtrack.Path([(0, 0), (100, 0), (100, 100), (0, 100)], closed=True)
    options = survtrack.PredictedRegionsOptions(
        sigmas_along=3, sigmas_across=1, forward_only=True, whole_object=False, margin=0, growth=0
    )
    region = survtrack.predicted_region_on_path(
        options, path, (390, 0), (10, 0), np.diag([4.0, 0.0]), (4, 4)
    )
    assert list(region) == pytest.approx([0, 0, 16, 10])
    with pytest.raises(survtrack.InputError, match="symmetric 2x2"):
        survtrack.predicted_region_on_path(
            options, path, (390, 0), (10, 0), np.array([[4.0, 1.0], [0.0, 4.0]]), (4, 4)
        )
    with pytest.raises(survtrack.InputError, match="no size"):
        survtrack.predicted_region(options, (0, 0), (1, 0), np.eye(2), survtrack.Box(0, 0, 0, 4))


def test_time_goes_on_in_what_is_refreshed() -> None:
    """Outside of regions the background follows the light by its strips."""
    frames = [np.full((120, 160, 3), 90, np.uint8) for _ in range(10)]
    frames += [np.full((120, 160, 3), 90 + i // 4, np.uint8) for i in range(60)]
    options = PREDICTED.replace(refresh_frames=10)
    config = config_of(
        regions=options, segmenter=SOON, outputs=survtrack.OutputOptions(background=True)
    )
    last = run(survtrack.Pipeline(config), frames, FPS)[-1]
    assert last.background is not None
    assert abs(int(last.background[60, 80, 0]) - 104) < 8
    assert last.detections.mask is not None and last.detections.mask.max() == 0


def test_a_region_of_ones_own_is_equal_to_the_detectors() -> None:
    kind = survtrack.RegionKind.predicted
    region = survtrack.Region(survtrack.Box(1, 2, 3, 4), kind, 5)
    assert (list(region.box), region.kind, region.track_id) == ([1, 2, 3, 4], kind, 5)
    assert region == survtrack.Region(survtrack.Box(1, 2, 3, 4), kind, track_id=5)
    assert region != survtrack.Region(survtrack.Box(1, 2, 3, 4), kind)
    with pytest.raises(survtrack.InputError, match="track_id: -1 is not allowed"):
        survtrack.Region(survtrack.Box(1, 2, 3, 4), kind, -1)


BAD_BOXES = [
    (math.nan, 0, 4, 4),
    (0, math.inf, 4, 4),
    (0, 0, math.inf, 4),
    (0, 0, 4, math.nan),
    (0, 0, 0, 4),
    (0, 0, 4, -1),
]


@pytest.mark.parametrize("numbers", BAD_BOXES)
def test_a_region_has_finite_numbers_and_a_size(numbers: tuple[float, ...]) -> None:
    box = survtrack.Box(*numbers)
    with pytest.raises(survtrack.InputError) as caught:
        survtrack.Region(box, survtrack.RegionKind.refresh)
    assert str(caught.value) == (
        f"box: {box!r} is not allowed; expected finite numbers, with a width and height above 0"
    )


def test_only_a_predicted_region_is_of_a_track() -> None:
    box = survtrack.Box(1, 2, 3, 4)
    for kind in set(survtrack.RegionKind) - {survtrack.RegionKind.predicted}:
        assert survtrack.Region(box, kind).track_id == 0
        words = f"^track_id: 7 is not allowed of the kind {kind.name}; expected 0, or the kind"
        with pytest.raises(survtrack.InputError, match=words):
            survtrack.Region(box, kind, 7)


def test_boxes_and_regions_are_copied_and_pickled() -> None:
    box = survtrack.Box(0.1, -2.5, 1e-300, 7e10)
    values = [box, survtrack.Box(math.inf, 0, -1, 0)]
    values += [survtrack.Region(box, kind) for kind in survtrack.RegionKind]
    values += [survtrack.Region(box, survtrack.RegionKind.predicted, 2**53)]
    for value in values:
        for copied in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
            assert copied == value and copied is not value and type(copied) is type(value)
