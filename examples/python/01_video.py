# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Track what moves in a video and print what happens.

usage: 01_video.py VIDEO
"""

import sys

import survtrack

for _, result in survtrack.track(sys.argv[1]):
    for event in result.events:
        x, y = event.position
        print(f"{event.time_s:8.2f} s: {event.text} at ({x:.0f}, {y:.0f})")
