# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Where frames come from: video files and streams, folders and globs of images, arrays.

A source is iterated: `for index, time_s, frame in source`. See Source for the whole contract and
open_source for the usual way to get one.
"""

from survtrack.sources.arrays import ArraySource
from survtrack.sources.base import DEFAULT_FPS, Frame, Source
from survtrack.sources.images import ImageSource
from survtrack.sources.opening import open_source
from survtrack.sources.prefetch import Prefetch
from survtrack.sources.selection import Selection
from survtrack.sources.video import VideoSource

__all__ = [
    "DEFAULT_FPS",
    "ArraySource",
    "Frame",
    "ImageSource",
    "Prefetch",
    "Selection",
    "Source",
    "VideoSource",
    "open_source",
]
