# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The view of what was read."""

import numpy as np

import survtrack
from scenes import config_of, run, scene
from survtrack.drawing import RegionRenderer, Views, as_scene

# In frames as small as these pieces of rows cost more than their pixels spare.
PREDICTED = survtrack.PredictedRegionsOptions(
    acquisition="border", border=0.1, refresh_frames=20, whole_above=100
)
SOON = survtrack.SelectiveOptions(update_time_s=0.2)  # whole frames for 0.4 s only


def test_what_was_not_read_is_dark() -> None:
    result = run(survtrack.Pipeline(config_of(regions=PREDICTED, segmenter=SOON)), scene())[-1]
    drawn = RegionRenderer().annotate(as_scene(result.frame), result)
    read = np.zeros(drawn.shape[:2], bool)
    for region in result.regions:
        x, y, width, height = (round(value) for value in region.box)
        read[max(y - 1, 0) : y + height + 2, max(x - 1, 0) : x + width + 2] = True
    read[-24:, :80] = True  # the label
    assert (~read).any()
    assert drawn[~read].mean() < 0.4 * as_scene(result.frame)[~read].mean()
    assert ((drawn == (255, 0, 255)).all(axis=2)).any(), "the region of the track"
    assert ((drawn == (0, 200, 255)).all(axis=2)).any(), "the border"


def test_a_frame_that_was_read_whole_stays_bright() -> None:
    result = run(survtrack.Pipeline(), scene())[-1]
    drawn = Views(["regions"])(result.frame, result)
    same = (drawn == as_scene(result.frame)).all(axis=2)
    assert same[20:44].mean() > 0.7, "but for the labels"
