# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What a result looks like: the frame, the mask, the tracks, what they were decided by."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from survtrack.drawing.blobs import BlobRenderer
from survtrack.drawing.boxes import BoxRenderer
from survtrack.drawing.colors import BLACK
from survtrack.drawing.ends import LostContactRenderer
from survtrack.drawing.flow_arrows import FlowRenderer
from survtrack.drawing.flow_field import THRESHOLD_PX
from survtrack.drawing.flow_wheel import FlowColorRenderer
from survtrack.drawing.intensity import IntensityRenderer
from survtrack.drawing.markers import MarkerRenderer
from survtrack.drawing.matrix import MatrixRenderer
from survtrack.drawing.paths import PathRenderer
from survtrack.drawing.regions import RegionRenderer
from survtrack.drawing.scene import Renderer, Scene, as_scene, draw_label
from survtrack.drawing.sheet import grid
from survtrack.drawing.trails import TrailRenderer
from survtrack.drawing.vicinity import VicinityRenderer
from survtrack.errors import UsageError

if TYPE_CHECKING:
    from survtrack._core import FrameResult, Paths

VIEW_NAMES = (
    *("frame", "mask", "background", "blobs", "tracks", "matrix", "vicinity"),
    *("intensity", "flow", "flow_color", "boxes", "markers", "covariance", "lost_contacts"),
    *("path", "regions"),
)
# The extra outputs that some views show.
VIEW_OUTPUTS = {
    "background": "background",
    "matrix": "cost_matrix",
    "vicinity": "vicinity",
    "flow": "flow",
    "flow_color": "flow",
}
COVERAGE = 0.95


class Views:
    """One picture of one or more views, each with a caption when there are several.

    Up to three stand side by side, more in two columns. Trails have a memory, so that one Views
    belongs to one run, in the order of its frames.
    """

    def __init__(
        self,
        names: Sequence[str] = ("tracks",),
        flow_threshold_px: float = THRESHOLD_PX,
        paths: "Paths | None" = None,
    ) -> None:
        """Args:
        names: one or more of VIEW_NAMES, in the order they are shown, none twice.
        flow_threshold_px: flow by no more has no arrow, px a frame pair; 0 or more.
        paths: what the view path draws.

        Raises:
            UsageError: an unknown name, none, or one twice; a threshold out of its range.
        """
        for name in names:
            if name not in VIEW_NAMES:
                raise UsageError(f'views: unknown "{name}"; one of: {", ".join(VIEW_NAMES)}')
        if not names or len(set(names)) < len(names):
            raise UsageError(f"views: {list(names)} is not allowed; each once, at least one")
        self._names = tuple(names)
        self._renderers: dict[str, tuple[Renderer, ...]] = {
            "blobs": (BlobRenderer(),),
            "tracks": (TrailRenderer(), BoxRenderer(), LostContactRenderer()),
            "matrix": (MatrixRenderer(),),
            "vicinity": (VicinityRenderer(),),
            "intensity": (IntensityRenderer(),),
            "flow": (FlowRenderer(flow_threshold_px),),
            "flow_color": (FlowColorRenderer(flow_threshold_px),),
            "boxes": (BoxRenderer(),),
            "markers": (MarkerRenderer(),),
            "covariance": (MarkerRenderer(COVERAGE),),
            "lost_contacts": (LostContactRenderer(),),
            "path": (PathRenderer(paths), BoxRenderer()),
            "regions": (RegionRenderer(), BoxRenderer()),
        }

    def __call__(self, frame: Scene, result: "FrameResult") -> Scene:
        """The picture for one result, HxWx3 BGR.

        Args:
            frame: the result's frame, HxW or HxWx3.

        Raises:
            UsageError: a view shows what the result does not have; see VIEW_OUTPUTS.
        """
        when = f"frame {result.index + 1}, {result.time_s:.2f} s"
        pictures = [self._view(name, frame, result) for name in self._names]
        captions = list(self._names) if len(self._names) > 1 else [""]
        captions[0] = when if captions[0] in ("", "frame") else f"{captions[0]}: {when}"
        for caption, picture in zip(captions, pictures, strict=True):
            draw_label(picture, caption, (0, 0), BLACK)
        return grid(pictures, columns=len(pictures) if len(pictures) < 4 else 2)

    def _view(self, name: str, frame: Scene, result: "FrameResult") -> Scene:
        if name == "mask":
            return as_scene(result.mask)
        if name == "background":
            if result.background is None:
                raise UsageError(
                    "views: background cannot be shown: this config has none, "
                    "or outputs.background is false"
                )
            return as_scene(result.background)
        scene = as_scene(frame)
        for renderer in self._renderers.get(name, ()):
            scene = renderer.annotate(scene, result)
        return scene
