# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The configuration that finds the person in footage."""

import survtrack
from survtrack import Config

# As the dissertation segments (4.3): what differs from a still background by more than 37 in any
# channel, twice eroded by 3x3, one blob of 100 px or more. Not quite the same: the background
# is the first frame instead of the mean of five, and while young it takes in what stands still.
_CHANGES = (
    "segmenter.model=selective",
    "segmenter.threshold=37",
    "segmenter.noise_gain=0",
    "segmenter.update_time_s=1000000",
    "segmenter.absorb_time_s=60",
    "segmenter.remove_shadows=false",
    "segmenter.scene_change_fraction=1",
    "cleanup.median_px=0",
    "cleanup.tiling.model=whole",
    "cleanup.tiling.erode_px=5",
    "cleanup.tiling.dilate_px=0",
    "blobs.min_area_px=100",
    "blobs.min_area_fraction=0",
    "blobs.max_blobs=1",
    "blobs.share_blobs=false",
    "blobs.min_relative_height=0",
)


def preset_config() -> Config:
    """The dissertation's segmentation and largest blob; a preset of its name belongs here."""
    config = survtrack.preset("survtrack")
    for change in _CHANGES:
        config.set(change)
    return config
