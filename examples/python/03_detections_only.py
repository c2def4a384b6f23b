# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The detector alone, with another background model: frames in, detections out."""

import numpy as np

import survtrack

config = survtrack.Config(segmenter=survtrack.MovingAverageOptions(window_frames=20))
detector = survtrack.Detector(config)  # looks 10 frames ahead: detections come later
ready = []
for k in range(50):
    frame = np.full((120, 160), 90, np.uint8)
    frame[40:70, 2 * k : 2 * k + 20] = 200
    detections = detector.process(frame, time_s=k / 25)
    if detections is not None:
        ready.append(detections)
ready += detector.finish()
for detections in ready:
    for detection in detections:
        x, y = detection.position
        print(f"frame {detections.index}: {detection.area_px:.0f} px at ({x:.1f}, {y:.1f})")
