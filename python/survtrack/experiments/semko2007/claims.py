# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the thesis says of its trials, and whether the numbers of this run say the same."""

from dataclasses import dataclass

from survtrack.experiments.marked_set import MarkedSet
from survtrack.experiments.semko2007.artificial import LIMIT_FRAMES, LIMIT_PX, Made, Run
from survtrack.experiments.semko2007.trials import AWAY, REMOVED

LOST_AFTER = 13
REAL_TIME = 30  # times as fast as the footage: what is wanted of 384x288
LEAST_TIMED = 100  # frames: of fewer the first ones, without flow, make up too much


@dataclass(frozen=True)
class Claim:
    """One statement, whether it holds, and the numbers behind it."""

    claim: str
    holds: bool
    numbers: str


def claims(made: Made, every: list[MarkedSet]) -> list[Claim]:
    """All statements, those about footage for each set."""
    masks = [made.runs[trial.key]["masks"] for trial in made.trials]
    settled = [run.settled_after for run in masks]
    largest = max(run.largest_px for run in masks)
    noisy = [made.runs[trial.key]["noise"].rms_px for trial in made.trials]
    event = event_after(made.lost["removed, masks"])
    undue = [run.ended for trial in made.runs.values() for run in trial.values()]
    undue += [run.ended for key, run in made.lost.items() if key.startswith("hidden")]
    told = [
        Claim(
            f"The norm is under {LIMIT_PX:g} px within {LIMIT_FRAMES} frames, in every trial",
            all(each is not None and each <= LIMIT_FRAMES for each in settled),
            f"after {_spread(settled)} frames; from {LIMIT_FRAMES} on at most {largest:.2f} px",
        ),
        Claim(
            "With measurement noise the estimate is nearer to the truth than the measurement",
            max(noisy) < 2**0.5,
            f"rms {min(noisy):.2f} to {max(noisy):.2f} px; of the measurements {2**0.5:.2f} px",
        ),
        Claim(
            f"A removed contact raises the event in the frame in which {LOST_AFTER} of the last "
            "25 counts are lower",
            event == LOST_AFTER,
            f"in frame {event} without it",
        ),
        Claim(
            f"No event comes in any other trial, nor when the contact is back after {AWAY} frames",
            not any(undue),
            f"{sum(map(len, undue))} events in {len(undue)} runs",
        ),
    ]
    return told + [_speed(one) for one in every if one.frames >= LEAST_TIMED]


def event_after(run: Run) -> int | None:
    """Frames without the removed contact until the event, the frame of the event included."""
    return run.ended[0].index - REMOVED + 1 if len(run.ended) == 1 else None


def _speed(one: MarkedSet) -> Claim:
    speed = one.marked["semko2007"].trial.frames_per_s
    return Claim(
        f"{one.name}: {REAL_TIME} times as fast as the footage, or more, on one core",
        speed >= REAL_TIME * one.fps,
        f"{speed:.0f} frames/s, {speed / one.fps:.0f} times",
    )


def _spread(values: list[int | None]) -> str:
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return "never, or after more"
    low, high = min(known), max(known)
    return f"{low}" if low == high else f"{low} to {high}"
