# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where results go: MOT text, CSV, events, matrices, masks, track streams, annotated video.

A sink is a context manager with `write(frame, result)`. See Sink for the whole contract.
"""

from survtrack.sinks.base import Sink
from survtrack.sinks.events import EventLines
from survtrack.sinks.folder import RunFolder
from survtrack.sinks.masks import MaskFolder
from survtrack.sinks.matrix import MatrixLines
from survtrack.sinks.mot import MotText
from survtrack.sinks.path_csv import PathCsv
from survtrack.sinks.scene import LearnedScene
from survtrack.sinks.track_stream import TrackStream
from survtrack.sinks.tracks_csv import TracksCsv
from survtrack.sinks.video import AnnotatedVideo

__all__ = [
    "AnnotatedVideo",
    "EventLines",
    "LearnedScene",
    "MaskFolder",
    "MatrixLines",
    "MotText",
    "PathCsv",
    "RunFolder",
    "Sink",
    "TrackStream",
    "TracksCsv",
]
