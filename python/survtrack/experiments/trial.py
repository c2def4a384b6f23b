# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""One configuration on one set of footage, and its scores."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import survtrack
from survtrack.evaluation import Boxes, TrackScores, evaluate_tracks
from survtrack.experiments.footage import Footage
from survtrack.runner import RunSummary, results
from survtrack.sources import ArraySource

if TYPE_CHECKING:
    from survtrack._core import Config, FrameResult


@dataclass(frozen=True)
class Variant:
    """A configuration: a preset, and what differs from it.

    Attributes:
        preset: name of the preset.
        changes: assignments as for --set, left to right.
        in_frames: whether time_unit_s is the frame period, as published presets count time.
    """

    preset: str
    changes: tuple[str, ...] = ()
    in_frames: bool = True

    def assignments(self, frame_period_s: float) -> list[str]:
        """All differences from the preset at this frame period, as for --set."""
        unit = [f"time_unit_s={frame_period_s!r}"] if self.in_frames else []
        return [*unit, *self.changes]

    def config(self, frame_period_s: float) -> "Config":
        """The whole configuration at this frame period; raises ConfigError."""
        config = survtrack.preset(self.preset)
        for assignment in self.assignments(frame_period_s):
            config.set(assignment)
        return config


@dataclass(frozen=True)
class Trial:
    """What came out of one run.

    Attributes:
        scores: of the reported tracks against the truth.
        frames_per_s: of the pipeline, without decoding and scoring; never the same twice.
    """

    scores: TrackScores
    frames_per_s: float

    @property
    def identity_errors(self) -> int:
        """Index and swap errors together: what a correspondence is judged by."""
        return self.scores.index_errors + self.scores.swap_errors


def run_trial(footage: Footage, config: "Config") -> Trial:
    """Run a configuration on a set and score it."""
    watch = RunSummary()
    tracks = boxes_of(results_of(footage, config, watch))
    scores = evaluate_tracks(footage.truth, tracks, frames=(1, len(footage.frames)))
    return Trial(scores, len(footage.frames) / max(watch.pipeline_seconds, 1e-9))


def results_of(
    footage: Footage, config: "Config", watch: RunSummary | None = None
) -> "Iterator[FrameResult]":
    """The result of each frame; the watch gets the seconds spent in the pipeline."""
    source = ArraySource(footage.frames, fps=footage.fps)
    return results(source, survtrack.Pipeline(config), watch)


def boxes_of(answers: "Iterator[FrameResult]") -> Boxes:
    """The boxes of all reported tracks, frames counted from 1."""
    rows = [
        (result.index + 1, track.id, list(track.box))
        for result in answers
        for track in result.tracks
        if track.reported
    ]
    return Boxes([row[0] for row in rows], [row[1] for row in rows], [row[2] for row in rows])
