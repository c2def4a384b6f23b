# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Random scenes for property tests, each of whose objects is in some frame."""

from typing import Any

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st

from survtrack.scenes import Body, Conditions, Pace, Path, Scene, SceneObject, steady, weave
from survtrack.scenes.body import SHAPES

quick = settings(deadline=None, derandomize=True, max_examples=80)
SIZE, FRAMES, FPS = (96, 64), 12, 8.0
bodies = st.builds(Body, st.sampled_from(SHAPES), st.floats(4, 30), st.floats(4, 30))


@st.composite
def objects(draw: st.DrawFn, id: int = 1) -> SceneObject:
    """One that passes a point of the frame while it is filmed."""
    point = draw(st.tuples(st.floats(5, SIZE[0] - 5), st.floats(5, SIZE[1] - 5)))
    heading, speed = draw(st.floats(0, 360)), draw(st.floats(-80, 80))
    passes_s = draw(st.integers(0, FRAMES - 1)) / FPS
    path = Path(point, heading)
    if draw(st.booleans()):
        path = weave(point, heading, draw(st.floats(-120, 120)), draw(st.floats(20, 60)), 200)
    pace = steady(speed, passes_s)
    if draw(st.booleans()):
        pace = Pace((passes_s, passes_s + 1), (speed, draw(st.floats(-80, 80))))
    return SceneObject(id, draw(bodies), path, pace)


@st.composite
def scenes(draw: st.DrawFn, most: int = 3, **conditions: Any) -> Scene:
    """One to `most` objects under the conditions."""
    count = draw(st.integers(1, most))
    things = tuple(draw(objects(id)) for id in range(1, count + 1))
    return Scene("random", things, SIZE, FRAMES, FPS, 5, Conditions(**conditions))


def box_of(mask: np.ndarray) -> tuple[int, int, int, int]:
    """Left, top, width, height of what is set."""
    rows, columns = np.nonzero(mask)
    left, top = columns.min(), rows.min()
    return left, top, columns.max() - left + 1, rows.max() - top + 1
