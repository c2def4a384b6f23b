# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Makes the picture of docs/flow.md from vtest.avi, which `make demo` leaves in demo/."""

from pathlib import Path

import cv2

import survtrack
from survtrack.drawing import Views
from survtrack.sources import open_source

ROOT = Path(__file__).resolve().parent.parent
VIDEO = ROOT / "demo" / "vtest.avi"
PICTURE = ROOT / "docs" / "images" / "flow_views.jpg"
FPS = 7.0  # at which PETS 2009 was taken
SHOWN = 340  # frame from 0
CHANGES = (
    "segmenter.model=horn_schunck",
    "segmenter.frames_back=2",
    "segmenter.magnitude_threshold=0.1",
    "cleanup.tiling.model=quadrants",
    "blobs.min_area_px=100",
    "outputs.flow=true",
)


def main() -> None:
    config = survtrack.preset("survtrack")
    for change in CHANGES:
        config.set(change)
    pipeline = survtrack.Pipeline(config)
    render = Views(["intensity", "flow", "flow_color", "markers"], flow_threshold_px=0.1)
    for index, time_s, frame in open_source(VIDEO, fps=FPS, limit=SHOWN + 1, resize=(384, 288)):
        result = pipeline.process(frame, time_s, index)
        if result is not None:
            picture = render(frame, result)
    cv2.imwrite(str(PICTURE), picture, [cv2.IMWRITE_JPEG_QUALITY, 80])


if __name__ == "__main__":
    main()
