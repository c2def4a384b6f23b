# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Makes the pictures of docs/narayana2007.md from vtest.avi, which `make demo` leaves in demo/."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.drawing import BlobRenderer, Views, as_scene, contact_sheet
from survtrack.experiments.plotting import BLUE, ORANGE
from survtrack.sources import open_source

if TYPE_CHECKING:
    from survtrack import Config, FrameResult, Pipeline

Picture = NDArray[np.uint8]

ROOT = Path(__file__).resolve().parent.parent
VIDEO = ROOT / "demo" / "vtest.avi"
IMAGES = ROOT / "docs" / "images"
SIZE = (640, 480)
FPS = 7.0  # at which PETS 2009 was taken
SHOWN = 340  # frame from 0


def config_of(preset: str, *changes: str) -> "Config":
    """A preset for this size: lengths are twice those of 320x240."""
    config = survtrack.preset(preset)
    for change in (
        f"time_unit_s={1 / FPS}",
        "blobs.min_area_px=120",
        "blobs.merge.threshold_y_px=10",
        "blobs.merge.threshold_x_px=10",
        "cost.velocity_break_point=20",
        "vicinity.cell_px=60",
        "outputs.background=true",
        "outputs.cost_matrix=true",
        "outputs.vicinity=true",
        *changes,
    ):
        config.set(change)
    return config


def frames(last: int) -> Iterator[tuple[int, float, Picture]]:
    """All that the centred average of frame `last` looks at."""
    yield from open_source(VIDEO, fps=FPS, limit=last + 76, resize=SIZE)


def result_at(index: int, pipeline: "Pipeline") -> "FrameResult":
    """The result of one frame, after all before it."""
    for number, time_s, frame in frames(index):
        result: FrameResult | None = pipeline.process(frame, time_s, number)
        if result is not None and result.index == index:
            return result
    raise SystemExit(f"{VIDEO}: ends before frame {index}")


def save(name: str, picture: Picture, width: int) -> None:
    height = round(picture.shape[0] * width / picture.shape[1])
    small = cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA)
    cv2.imwrite(str(IMAGES / name), small, [cv2.IMWRITE_JPEG_QUALITY, 85])


def crop(picture: Picture) -> Picture:
    """The part of the scene where people walk."""
    return np.ascontiguousarray(picture[100:300])


def segmentation(result: "FrameResult") -> Picture:
    """Frame, average, what differs from it, and what is left by the secondary background."""
    single = config_of("narayana2007", "segmenter.secondary_background=false", "cleanup.open_px=0")
    tails = result_at(SHOWN, survtrack.Pipeline(single))
    assert result.background is not None
    views = (result.frame, result.background, tails.mask, result.mask)
    return contact_sheet([as_scene(crop(view)) for view in views], columns=2)


def merging(result: "FrameResult") -> Picture:
    """Blobs without and with the merge module."""
    apart = config_of("narayana2007")
    apart.set("blobs.merge.model=none")
    before = result_at(SHOWN, survtrack.Pipeline(apart))
    pictures = [
        crop(BlobRenderer().annotate(as_scene(result.frame), shown)) for shown in (before, result)
    ]
    return contact_sheet(pictures, columns=2)


def densities(pipeline: "Pipeline") -> None:
    """The learned densities beside those of the beginning, and the velocity factor."""
    import json

    from matplotlib.figure import Figure

    learned = json.loads(pipeline.learned_scene())["densities"]
    start = json.loads(survtrack.Pipeline(config_of("narayana2007")).learned_scene())["densities"]
    figure = Figure(figsize=(9, 2.8), layout="constrained")
    red, vertical, velocity = figure.subplots(1, 3)
    for axes, label, scale, shape, first, reach in (
        (red, "difference in red, grey levels", 1.0, learned["color"][2], start["color"][2], 50),
        (vertical, "vertical distance, px", SIZE[1], learned["y"], start["y"], 80),
    ):
        for density, color, style, name in (
            (first, ORANGE, "--", "at the beginning"),
            (shape, BLUE, "-", "learned"),
        ):
            values = np.array(density["values"])
            half = density["range"] * (1 - 1 / len(values)) * scale
            x = np.linspace(-half, half, len(values))
            axes.plot(x, values / values.max(), color=color, linestyle=style, label=name)
        axes.set(xlabel=label, xlim=(-reach, reach), ylim=(0, 1.35), ylabel="relative to the peak")
        axes.legend(fontsize=7)
    difference = np.array([0, 20, 30])
    velocity.plot(difference, [2, 0.2, 0.2], color=BLUE, label="of a belief")
    x = np.linspace(0, 30, 200)
    velocity.plot(
        x,
        1 / (2 - 1.8 * np.minimum(x / 20, 1)),
        color=ORANGE,
        linestyle="--",
        label="of a match-matrix entry",
    )
    velocity.set(xlabel="difference in velocity, px per frame", ylabel="velocity factor")
    velocity.legend(fontsize=7, loc="upper left")
    figure.savefig(IMAGES / "narayana2007_densities.png", dpi=110)


def main() -> None:
    bayesian = survtrack.Pipeline(config_of("narayana2007"))
    result = result_at(SHOWN, bayesian)
    euclidean = result_at(SHOWN, survtrack.Pipeline(config_of("narayana2007_euclidean")))
    save("narayana2007_segmentation.jpg", segmentation(result), 960)
    save("narayana2007_merging.jpg", merging(result), 1100)
    save(
        "narayana2007_match_matrix.jpg",
        Views(["blobs", "matrix"])(euclidean.frame, euclidean),
        1100,
    )
    save("narayana2007_beliefs.jpg", Views(["tracks", "matrix"])(result.frame, result), 1100)
    save("narayana2007_vicinity.jpg", Views(["vicinity"])(result.frame, result), 640)
    densities(bayesian)


if __name__ == "__main__":
    main()
