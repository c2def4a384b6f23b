# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The artificial trials, run: as masks, as noisy measurements, and as video through the flow."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import survtrack
from survtrack.experiments.following import (
    Followed,
    Seen,
    follow,
    of_masks,
    of_measurements,
    of_video,
    rms,
)
from survtrack.experiments.semko2007.trials import Trial, hidden, removed, trials

if TYPE_CHECKING:
    from survtrack._core import Config, Event

SIGMA_PX = 1.0  # of each coordinate: what R = I stands for
LIMIT_PX, LIMIT_FRAMES = 1.0, 25  # "near zero well within 25 frames", V.B
WAYS, LOST_WAYS = ("masks", "noise", "flow"), ("masks", "flow")


@dataclass(frozen=True, eq=False)
class Run:
    """One trial in one way.

    followed: of each contact.
    ended: the events of ended tracks.
    paths: (N, 3) frame, x, y of each reported track, by its id, where nothing is measured too.
    """

    followed: list[Followed]
    ended: "list[Event]"
    paths: dict[int, NDArray[np.float64]]

    @property
    def settled_after(self) -> int | None:
        """The most frames that a contact's norm takes to stay under LIMIT_PX; None: never."""
        each = [one.settled_after(LIMIT_PX) for one in self.followed]
        return None if None in each else max(one for one in each if one is not None)

    @property
    def largest_px(self) -> float:
        """The largest norm of any contact from LIMIT_FRAMES after its first estimate on."""
        kept = [one.norms[(one.start or 0) + LIMIT_FRAMES :] for one in self.followed]
        return float(np.nanmax(np.concatenate(kept)))

    @property
    def rms_px(self) -> float:
        """Of all norms from there on."""
        kept = [one.norms[(one.start or 0) + LIMIT_FRAMES :] for one in self.followed]
        return rms(np.concatenate(kept))

    @property
    def lag(self) -> tuple[float, float, float]:
        """Means over the contacts: see Followed.lag."""
        each = np.array([one.lag() for one in self.followed]).mean(axis=0)
        return float(each[0]), float(each[1]), float(each[2])


@dataclass(frozen=True, eq=False)
class Made:
    """All that was run on synthetic scenes.

    runs: of each trial, by its key, of each way in WAYS.
    lost: of each of lost_trials, by "key, way", of each way in LOST_WAYS.
    """

    trials: list[Trial]
    runs: dict[str, dict[str, Run]]
    lost: dict[str, Run]
    lost_trials: list[Trial]


HOW: dict[str, Callable[[Trial, "Config"], list[Seen]]] = {
    "masks": lambda trial, config: of_masks(trial.scene, config),
    "noise": lambda trial, config: of_measurements(trial.scene, config, SIGMA_PX),
    "flow": lambda trial, config: of_video(trial.scene, config),
}


def run_trial(trial: Trial, way: str, preset: str = "semko2007") -> Run:
    """One trial in one way."""
    seen = HOW[way](trial, survtrack.preset(preset))
    ended = [
        event
        for one in seen
        for event in one.events
        if event.kind == survtrack.EventKind.track_ended
    ]
    paths: dict[int, list[tuple[float, ...]]] = {}
    for one in seen:
        for id, at in one.positions.items():
            paths.setdefault(id, []).append((one.index, *at))
    return Run(follow(trial.scene, seen), ended, {id: np.array(path) for id, path in paths.items()})


def measure(tick: Callable[[int], None]) -> Made:
    """Run everything; `tick` gets the number of frames of each run."""

    def ticked(trial: Trial, way: str) -> Run:
        run = run_trial(trial, way)
        tick(trial.scene.frame_count)
        return run

    every, losses = trials(), [removed(), hidden()]
    return Made(
        every,
        {trial.key: {way: ticked(trial, way) for way in WAYS} for trial in every},
        {f"{trial.key}, {way}": ticked(trial, way) for trial in losses for way in LOST_WAYS},
        losses,
    )


def frames() -> int:
    """Of all runs."""
    every, losses = trials(), [removed(), hidden()]
    return sum(
        len(ways) * trial.scene.frame_count
        for each, ways in ((every, WAYS), (losses, LOST_WAYS))
        for trial in each
    )
