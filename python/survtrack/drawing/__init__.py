# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pictures of results. Every renderer has `annotate(scene, result) -> scene`."""

from survtrack.drawing.boxes import BoxRenderer
from survtrack.drawing.colors import Color, color_of_id
from survtrack.drawing.scene import Renderer, as_scene
from survtrack.drawing.sheet import contact_sheet
from survtrack.drawing.trails import TrailRenderer
from survtrack.drawing.views import VIEW_NAMES, Views

__all__ = [
    "VIEW_NAMES",
    "BoxRenderer",
    "Color",
    "Renderer",
    "TrailRenderer",
    "Views",
    "as_scene",
    "color_of_id",
    "contact_sheet",
]
