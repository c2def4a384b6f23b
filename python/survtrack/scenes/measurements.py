# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a sensor would measure of the truth."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from survtrack.scenes.checks import check_number
from survtrack.scenes.randomness import Purpose, stream

if TYPE_CHECKING:
    from survtrack.scenes.scene import Scene

Measured = tuple[int, float, dict[int, tuple[float, float]]]


def measurements(scene: "Scene", sigma_px: float, min_visible: float) -> Iterator[Measured]:
    """See Scene.measurements, whose arguments and errors these are."""
    check_number("sigma_px", sigma_px, least=0)
    check_number("min_visible", min_visible, above=0, most=1)
    truth = scene.truth()
    seen = truth.visible >= min_visible
    found: list[dict[int, tuple[float, float]]] = [{} for _ in range(scene.frame_count)]
    for id in sorted({thing.id for thing in scene.objects}):
        # Drawn for every frame, so that what is missing does not shift the noise of the rest.
        random = stream(scene.seed, Purpose.MEASUREMENT, id)
        noise = sigma_px * random.standard_normal((scene.frame_count, 2))
        rows = seen & (truth.ids == id)
        indices = truth.indices[rows]
        measured = truth.positions[rows] + noise[indices]
        for index, (x, y) in zip(indices.tolist(), measured.tolist(), strict=True):
            found[index][id] = (x, y)
    return ((k, k / scene.fps, positions) for k, positions in enumerate(found))
