# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From a track stream to a video of the scene, and what both cost."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from survtrack.errors import UsageError
from survtrack.evaluation.files import StrPath
from survtrack.path_file import require_frame_size
from survtrack.replay.figures import StreamFigures, source_bytes_of
from survtrack.replay.filling import MAX_GAP_S, Shown, paced
from survtrack.replay.ground import GroundMap
from survtrack.replay.reader import TrackStreamReader
from survtrack.replay.values import StreamFrame, StreamHeader

if TYPE_CHECKING:
    from survtrack._core import Paths
    from survtrack.sources.base import Frame

VIEWS = ("over", "above")


def replay_stream(
    path: StrPath,
    out: StrPath | None = None,
    *,
    background: "Frame | None" = None,
    view: str = "over",
    ground: GroundMap | None = None,
    fps: float | None = None,
    max_gap_s: float = MAX_GAP_S,
    paths: "Paths | None" = None,
    progress: Callable[[int], None] | None = None,
) -> dict[str, Any]:
    """Make the scene of a track stream again, without its video, and count what the stream costs.

    Args:
        path: the stream; one that is cut or damaged is replayed as far as it is whole.
        out: the MP4 to write; None: only count.
        background: HxW or HxWx3 uint8 to draw over; plain ground when None.
        view: "over": as the camera saw it; "above": on a plan of the ground.
        ground: from pixels to the ground, for "above"; in px when None.
        fps: pictures per second; the stream's own when None.
        max_gap_s: how long missing frames are predicted, see paced().
        paths: what tracks near them are predicted along; drawn in the view "over".
        progress: called after each picture with their number.

    Returns:
        "file", "complete", "error" (why there may have been more; null), "size", "frames" (first,
        last, count; from 1), "seconds", "tracks", "stream_bytes", "raw_bytes" (3 a pixel and
        frame), "source_bytes" (null when not known), each also with "_per_s", "raw_ratio" and
        "source_ratio" (their bytes by the stream's), "out" (null: no video was written), "view",
        "fps", "pictures" and "predicted_pictures".

    Raises:
        InputError: the stream cannot be read, the background has another form than its frames, or
            the paths are drawn on frames of another size.
        UsageError: an unknown view, what only the other view takes, or a number out of its bounds.
        OSError: the video cannot be written.
    """
    _check(view, background, ground)
    path = Path(path)
    reader = TrackStreamReader(path)
    header = reader.header
    if paths is not None:
        require_frame_size(paths, (header.width_px, header.height_px), "paths")
    fps = header.fps if fps is None else fps
    paced([], fps, max_gap_s=max_gap_s)
    source_bytes = source_bytes_of(path)
    render, figures = _prepared(reader, background, view, ground, paths)
    facts = {
        "file": str(path),
        "complete": reader.problem is None,
        "error": reader.problem,
        **figures.facts(source_bytes),
        "out": None,
        "view": view,
        "fps": fps,
        "pictures": 0,
        "predicted_pictures": 0,
    }
    if out is not None:
        # The file may grow meanwhile: what is drawn is what was counted.
        frames = _first(TrackStreamReader(path), figures.frames)
        shown = paced(
            frames, fps, lost_damping_s=header.lost_damping_s, max_gap_s=max_gap_s, paths=paths
        )
        facts.update(_write(Path(out), shown, render, fps, progress))
        facts["out"] = str(out) if facts["pictures"] else None
    return facts


def _check(view: str, background: "Frame | None", ground: GroundMap | None) -> None:
    if view not in VIEWS:
        raise UsageError(f'view: unknown "{view}"; one of: {", ".join(VIEWS)}')
    if view == "above" and background is not None:
        raise UsageError(
            "background: the view above has none; leave it out, or choose the view over"
        )
    if view == "over" and ground is not None:
        raise UsageError("ground: is for the view above; leave it out, or choose that view")


def _prepared(
    reader: TrackStreamReader,
    background: "Frame | None",
    view: str,
    ground: GroundMap | None,
    paths: "Paths | None",
) -> "tuple[Callable[[Shown], Frame], StreamFigures]":
    """Reads all of the stream once: its figures, and who draws it."""
    from survtrack.drawing.plan import Extent, PlanView
    from survtrack.drawing.replay import OverView

    header: StreamHeader = reader.header
    size = (header.width_px, header.height_px)
    figures = StreamFigures(reader)
    if view == "over":
        render: Callable[[Shown], Frame] = OverView(size, background, paths)
        for _ in figures.counted():
            pass
        return render, figures
    plan = GroundMap.of_pixels(*size) if ground is None else ground
    extent = Extent(plan)
    for frame in figures.counted():
        extent.add(frame)
    return PlanView(plan, extent), figures


def _first(frames: TrackStreamReader, count: int) -> Iterator[StreamFrame]:
    for _, frame in zip(range(count), frames, strict=False):
        yield frame


def _write(
    out: Path,
    pictures: Iterator[Shown],
    render: "Callable[[Shown], Frame]",
    fps: float,
    progress: Callable[[int], None] | None,
) -> dict[str, int]:
    """The video; how many pictures it has, and how many of them are predictions."""
    from survtrack.sinks.video import VideoFile

    count = predictions = 0
    with VideoFile(out, fps=fps) as video:
        for shown in pictures:
            video.append(render(shown))
            count += 1
            predictions += shown.frame.predicted_s > 0
            if progress is not None:
                progress(count)
    return {"pictures": count, "predicted_pictures": predictions}
