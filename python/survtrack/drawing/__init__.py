# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pictures of results. Every renderer has `annotate(scene, result) -> scene`."""

from survtrack.drawing.blobs import BlobRenderer
from survtrack.drawing.boxes import BoxRenderer
from survtrack.drawing.colors import Color, color_of_id
from survtrack.drawing.ends import LostContactRenderer
from survtrack.drawing.flow_arrows import FlowRenderer
from survtrack.drawing.flow_wheel import FlowColorRenderer, flow_colors
from survtrack.drawing.intensity import IntensityRenderer
from survtrack.drawing.markers import MarkerRenderer
from survtrack.drawing.matrix import MatrixRenderer
from survtrack.drawing.paths import PathRenderer, draw_paths
from survtrack.drawing.regions import RegionRenderer
from survtrack.drawing.scene import Renderer, as_scene
from survtrack.drawing.sheet import contact_sheet
from survtrack.drawing.trails import TrailRenderer
from survtrack.drawing.vicinity import VicinityRenderer
from survtrack.drawing.views import VIEW_NAMES, VIEW_OUTPUTS, Views

__all__ = [
    "VIEW_NAMES",
    "VIEW_OUTPUTS",
    "BlobRenderer",
    "BoxRenderer",
    "Color",
    "FlowColorRenderer",
    "FlowRenderer",
    "IntensityRenderer",
    "LostContactRenderer",
    "MarkerRenderer",
    "MatrixRenderer",
    "PathRenderer",
    "RegionRenderer",
    "Renderer",
    "TrailRenderer",
    "VicinityRenderer",
    "Views",
    "as_scene",
    "color_of_id",
    "contact_sheet",
    "draw_paths",
    "flow_colors",
]
