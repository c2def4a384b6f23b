# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The frames of a scene as a source."""

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from survtrack.errors import UsageError
from survtrack.scenes.rendering import MaskRenderer, Renderer, VideoRenderer
from survtrack.sources.base import Frame, Size
from survtrack.sources.selection import Selection

if TYPE_CHECKING:
    from survtrack.scenes.scene import Scene

KINDS: dict[str, Callable[["Scene"], Renderer]] = {
    "video": lambda scene: VideoRenderer(scene, grey=False),
    "grey": lambda scene: VideoRenderer(scene, grey=True),
    "mask": MaskRenderer,
}


class SceneSource:
    """Frames made one after the other; fits survtrack.sources.Source.

    Every iteration starts again and gives the same bytes; each frame is a new array.
    """

    endless = False
    fps_origin = "given"

    def __init__(self, scene: "Scene", kind: str, selection: Selection | None = None) -> None:
        """Raises UsageError for an unknown kind, or a selection without frames."""
        if kind not in KINDS:
            raise UsageError(f'kind: unknown "{kind}"; one of: {", ".join(KINDS)}')
        self.name = f"scene {scene.name}"
        self.size: Size | None = scene.size
        self.original_size: Size | None = scene.size
        self.fps = scene.fps
        self.frame_count_declared: int | None = scene.frame_count
        self.selection = selection or Selection()
        self.selection.refuse_nothing(self.name, scene.frame_count)
        self._scene = scene
        self._kind = kind

    def __iter__(self) -> Iterator[tuple[int, float, Frame]]:
        """(index, time_s, frame): see Source."""
        renderer = KINDS[self._kind](self._scene)
        for index in self.selection.indices(self._scene.frame_count):
            yield index, index / self.fps, renderer.frame(index)

    def file_name(self, index: int) -> str | None:
        """None: the frames are not files."""
        return None
