# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Synthetic scenes: frames made on the spot, with exact truth.

    from survtrack.scenes import make_scene

    scene = make_scene("crossing", seed=3, noise_sigma=4)
    for index, time_s, frame in scene.frames():
        ...
    truth = scene.truth()

Everything follows from the scene's values and its seed: the same ones give the same bytes. A
scene of one's own is a Scene of SceneObjects.
"""

from survtrack.scenes.body import Body
from survtrack.scenes.conditions import Conditions
from survtrack.scenes.making import make_scene, scene_names, scene_options, scene_summary
from survtrack.scenes.objects import SceneObject
from survtrack.scenes.pace import Pace, steady, surging
from survtrack.scenes.path import Path, oval, weave
from survtrack.scenes.scene import Scene
from survtrack.scenes.source import SceneSource
from survtrack.scenes.truth import Truth
from survtrack.scenes.writing import OUTPUTS, write_scene

__all__ = [
    "OUTPUTS",
    "Body",
    "Conditions",
    "Pace",
    "Path",
    "Scene",
    "SceneObject",
    "SceneSource",
    "Truth",
    "make_scene",
    "oval",
    "scene_names",
    "scene_options",
    "scene_summary",
    "steady",
    "surging",
    "weave",
    "write_scene",
]
