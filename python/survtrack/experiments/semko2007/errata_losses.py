# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the listing's counting. Each function answers (the listing's figure, ours)."""

import numpy as np

from survtrack.experiments.semko2007 import listing, ours
from survtrack.experiments.semko2007.errata_contacts import COLUMNS, SETTLE, far, still
from survtrack.experiments.semko2007.listing import ListingFilter

LOST_AFTER = 13


def _one_of_two_lost() -> list[list[list[float]]]:
    """Frames in which the first of two contacts is missing until it is lost."""
    both = [[COLUMNS[0], 100.0], [COLUMNS[2], 200.0]]
    return [*SETTLE * [both], *LOST_AFTER * [both[1:]]]


def _after_the_loss() -> tuple[list[ListingFilter], float]:
    """The listing's filters when the first is lost (it only predicted, so that nothing else is
    wrong), and the variance of the other's x before."""
    frames = _one_of_two_lost()
    filters = still(frames[0])
    for _ in range(LOST_AFTER):
        filters[0].step(None)
        filters[1].step(frames[-1][0])
    before = float(filters[1].P[0, 0])
    return listing.drop_state(filters, lost=0), before


def covariance_of_another() -> tuple[float, float]:
    """The variance of x of the contact that stays, after the loss in parts of that before."""
    filters, before = _after_the_loss()
    answers = ours.monitor(_one_of_two_lost())
    [kept] = set(answers[-1][1])
    variances = [
        float(track.position_covariance_px2[0, 0])
        for result, _ in answers[-2:]
        for track in result.tracks
        if track.id == kept
    ]
    return float(filters[0].P[0, 0]) / before, variances[1] / variances[0]


def covariance_of_a_newcomer() -> tuple[float, float]:
    """The variance of x that the next contact starts with: in the listing what the contact that
    stays had, in ours P0."""
    filters, _ = _after_the_loss()
    both = [[COLUMNS[0], 100.0], [COLUMNS[2], 200.0]]
    for result, _ in ours.monitor([*_one_of_two_lost(), *25 * [both]]):
        for event in result.events:
            if event.kind.name == "track_started" and event.track_id > 2:
                [new] = [track for track in result.tracks if track.id == event.track_id]
                return float(filters[1].P[0, 0]), float(new.position_covariance_px2[0, 0])
    raise AssertionError("no newcomer")


def two_lost_at_once() -> tuple[float, float]:
    """Of the contacts 2 and 3 of four, lost in one frame."""
    four = [[80.0, 50.0 + 60.0 * k] for k in range(4)]
    seen = [four[0], four[3]]
    answers = ours.monitor([*SETTLE * [four], *LOST_AFTER * [seen]])
    lost = listing.lost_by_sums(4, [1, 4])
    return float(lost in (2, 3)), float(len(ours.ended(answers[-1][0])))


def two_gained_at_once() -> tuple[float, float]:
    """Of two that come in beside two, those that get a filter when the median rises."""
    four = [[80.0, 50.0 + 60.0 * k] for k in range(4)]
    index = listing.nearest_not_successive(np.array(four[:2]), np.array(four))
    answers = ours.monitor([*SETTLE * [four[:2]], *LOST_AFTER * [four]])
    started = [event for event in answers[-1][0].events if event.kind.name == "track_started"]
    return float(len(set(index) - {0, 1})), float(len(started))


def marker_of_two_losses() -> tuple[float, float]:
    """Distance of the place that is told from the nearest of two contacts that are lost 20 frames
    after one another, px."""
    points = [[100.0, 60.0], [120.0, 200.0], [300.0, 130.0]]
    frames = [*SETTLE * [points], *20 * [points[1:]], *LOST_AFTER * [points[2:]]]
    told = [place for result, _ in ours.monitor(frames) for place in ours.ended(result).values()]
    marker = listing.summed_marker([(13, points[0]), (33, points[1])], 40)
    return (
        min(far(np.array(point), marker) for point in points[:2]),
        max(min(far(np.array(point), np.array(one)) for point in points[:2]) for one in told),
    )


def frames_to_the_event() -> tuple[float, float]:
    """From the first frame without the contact, counted as 1."""
    late = listing.frames_until_lost(25 * [1], 2, more_than=13)
    both = [[COLUMNS[0], 100.0], [COLUMNS[2], 200.0]]
    answers = ours.monitor([*SETTLE * [both], *25 * [both[1:]]])
    frames = [k for k, (result, _) in enumerate(answers, 1 - SETTLE) if ours.ended(result)]
    return float(late or 0), float(frames[0])
