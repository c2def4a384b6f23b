# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""A scene on disk: frames, exact masks and truth, laid out as CDnet's sequences are."""

import json
import re
from collections.abc import Callable
from dataclasses import asdict, fields
from pathlib import Path
from typing import TYPE_CHECKING

from survtrack.errors import UsageError
from survtrack.scenes.truth import DEFAULT_MIN_VISIBLE, Truth
from survtrack.sinks.masks import encode_png
from survtrack.sinks.part_file import naming, part_of, write_whole

if TYPE_CHECKING:
    from survtrack.scenes.scene import Scene
    from survtrack.sources.base import Frame

FRAMES, MASKS, TEMPORAL_ROI = "input", "groundtruth", "temporalROI.txt"
BOXES, TABLE, RECIPE = "gt.txt", "truth.csv", "recipe.json"
OUTPUTS = (FRAMES, MASKS, TEMPORAL_ROI, BOXES, TABLE, RECIPE)
IMAGE_NAME = re.compile(r"(in|gt)\d{6,}\.png")
COLUMNS = (
    "frame", "time_s", "id", "x_px", "y_px", "velocity_x_px_per_s", "velocity_y_px_per_s",
    "distance_px", "left_px", "top_px", "width_px", "height_px", "visible", "occluded", "outside",
)  # fmt: skip


def write_scene(
    scene: "Scene",
    folder: Path | str,
    *,
    kind: str = "video",
    min_visible: float = DEFAULT_MIN_VISIBLE,
    progress: Callable[[int], None] | None = None,
) -> None:
    """Write input/inNNNNNN.png, groundtruth/gtNNNNNN.png, gt.txt, truth.csv and recipe.json.

    NNNNNN is the frame counted from 1. recipe.json is recipe.json.part until all is there; the
    images of an earlier scene in the folder are replaced.

    Args:
        scene: what to write.
        folder: made when missing.
        kind: of the frames; see Scene.frames.
        min_visible: rows of objects less visible have the confidence 0 in gt.txt, and are not
            scored.
        progress: called after each frame with the number of frames.

    Raises:
        UsageError: a bad value, or a folder with images that are not of an earlier scene.
        OSError: something cannot be written; it is named.
    """
    folder = Path(folder)
    frames, masks, truth = scene.frames(kind), scene.frames("mask"), scene.truth()
    boxes = mot_text(truth, min_visible)
    _refuse_foreign(folder)
    for place in (folder / FRAMES, folder / MASKS):
        with naming(place):
            place.mkdir(parents=True, exist_ok=True)
    with naming(folder):
        part_of(folder / RECIPE).touch()
        for old in (folder / RECIPE, *_images(folder)):
            old.unlink(missing_ok=True)
    for (index, _, frame), (_, _, mask) in zip(frames, masks, strict=True):
        _write_image(folder / FRAMES / f"in{index + 1:06d}.png", frame)
        _write_image(folder / MASKS / f"gt{index + 1:06d}.png", mask)
        if progress is not None:
            progress(index + 1)
    write_whole(folder / TEMPORAL_ROI, f"1 {scene.frame_count}\n")
    write_whole(folder / BOXES, boxes)
    write_whole(folder / TABLE, csv_text(truth))
    write_whole(folder / RECIPE, _recipe(scene, kind))


def mot_text(truth: Truth, min_visible: float = DEFAULT_MIN_VISIBLE) -> str:
    """MOT text of the boxes: frame, id, left, top, width, height, confidence, class, visible part.

    The confidence is 0 where less than min_visible is seen, else 1; the class is 1 throughout.
    """
    boxes = truth.to_boxes(min_visible)
    visible = truth.visible[truth.boxes[:, 2] > 0]
    rows = zip(boxes.frames, boxes.ids, boxes.boxes, boxes.ignore, visible, strict=True)
    return "".join(
        f"{frame},{id},{box[0]:.0f},{box[1]:.0f},{box[2]:.0f},{box[3]:.0f},"
        f"{0 if ignore else 1},1,{part:.4f}\n"
        for frame, id, box, ignore, part in rows
    )


def csv_text(truth: Truth) -> str:
    """All rows of the truth with a header: COLUMNS; frames counted from 1."""
    rows = zip(*(getattr(truth, field.name).tolist() for field in fields(truth)), strict=True)
    lines = [",".join(COLUMNS)]
    for index, time_s, id, position, velocity, gone, box, *parts in rows:
        numbers = (*position, *velocity, gone, *box, *parts)
        lines.append(",".join([f"{index + 1},{time_s:.6f},{id}", *(f"{x:.6f}" for x in numbers)]))
    return "".join(f"{line}\n" for line in lines)


def _recipe(scene: "Scene", kind: str) -> str:
    """All that the scene is made of, as JSON."""
    from survtrack import __version__

    facts = {
        "survtrack": __version__,
        "kind": kind,
        "scene": asdict(scene),
        "outputs": OUTPUTS,
    }
    return json.dumps(facts, indent=2, allow_nan=False) + "\n"


def _images(folder: Path) -> list[Path]:
    """Images that are named as those of a scene."""
    places = [folder / FRAMES, folder / MASKS]
    entries = [path for place in places if place.is_dir() for path in sorted(place.iterdir())]
    return [path for path in entries if IMAGE_NAME.fullmatch(path.name)]


def _refuse_foreign(folder: Path) -> None:
    ours = (folder / RECIPE).exists() or part_of(folder / RECIPE).exists()
    images = [] if ours else _images(folder)
    if images:
        raise UsageError(
            f"{folder}: holds {len(images)} images ({images[0].name}, ...) that are not of an "
            f"earlier scene with its {RECIPE}; give another folder or remove them"
        )


def _write_image(path: Path, image: "Frame") -> None:
    with naming(path):
        path.write_bytes(encode_png(image))
