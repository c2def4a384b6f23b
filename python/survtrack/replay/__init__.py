# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""State-only replay: a run as a compact stream of tracked states, and the scene made of it again.

O'Malley 2000: what is sent is the state of what was tracked, not the video. docs/replay.md has the
format to the byte.
"""

from survtrack.replay.damping import lost_damping_s
from survtrack.replay.decoder import TrackStreamDecoder
from survtrack.replay.encoder import TrackStreamEncoder
from survtrack.replay.filling import paced, predicted
from survtrack.replay.film import replay_stream
from survtrack.replay.ground import GroundMap, read_ground
from survtrack.replay.reader import TrackStreamReader, read_track_stream
from survtrack.replay.values import RecordedStream, StreamFrame, StreamHeader, StreamTrack

__all__ = [
    "GroundMap",
    "RecordedStream",
    "StreamFrame",
    "StreamHeader",
    "StreamTrack",
    "TrackStreamDecoder",
    "TrackStreamEncoder",
    "TrackStreamReader",
    "lost_damping_s",
    "paced",
    "predicted",
    "read_ground",
    "read_track_stream",
    "replay_stream",
]
