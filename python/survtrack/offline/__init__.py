# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is done with the tracks of a run that is over: join broken ones, drop too short ones.

`survtrack.link_tracks` works on tracks in memory, `link_run` on the folder that a run left.
"""

from survtrack.offline.linking import link_run
from survtrack.offline.tracks_table import TracksTable, read_tracks_csv

__all__ = ["TracksTable", "link_run", "read_tracks_csv"]
