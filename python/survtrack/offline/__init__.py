# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is done with the tracks of a run that is over: join broken ones, learn where they go.

`survtrack.link_tracks` and `survtrack.learn_patterns` work on tracks in memory, `link_run` and
`patterns_of_run` on the folder that a run left.
"""

from survtrack.offline.linking import link_run
from survtrack.offline.noise import TunedNoise, tune_noise
from survtrack.offline.patterns import paths_of, patterns_of_run, read_patterns
from survtrack.offline.search import FoundTrack, find_tracks
from survtrack.offline.tracks_table import TracksTable, read_tracks_csv

__all__ = [
    "FoundTrack",
    "TracksTable",
    "TunedNoise",
    "find_tracks",
    "link_run",
    "paths_of",
    "patterns_of_run",
    "read_patterns",
    "read_tracks_csv",
    "tune_noise",
]
