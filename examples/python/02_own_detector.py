# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The tracker alone, on the boxes of another detector: two objects that pass each other."""

import numpy as np

import survtrack

config = survtrack.preset("survtrack")
config.set("lifecycle.confirm_travel=0")  # believe also what stands still
tracker = survtrack.Tracker(config)
for k in range(40):
    boxes = np.array([[5.0 * k, 40, 20, 50], [200 - 5.0 * k, 120, 20, 50]])  # left, top, w, h
    result = tracker.process(boxes, time_s=k / 10)
    for track in result.tracks:
        print(f"{result.time_s:.1f} s: track {track.id} has box {track.detection}")
