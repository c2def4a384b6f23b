# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The faults of the listing's association. Each function answers (the listing's figure, ours)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from survtrack.experiments.semko2007 import listing, ours
from survtrack.experiments.semko2007.listing import ListingFilter

Floats = NDArray[np.float64]

SETTLE = 40  # frames before anything happens
COLUMNS = (80.0, 190.0, 300.0)
CENTRE = (192.0, 144.0)
FILTERS = 10


def far(true: Floats, at: Floats) -> float:
    """Distance, px."""
    return float(np.hypot(*(np.asarray(true) - np.asarray(at))))


def still(points: Sequence[Sequence[float]]) -> list[ListingFilter]:
    """A settled filter at each point."""
    filters = [ListingFilter(point) for point in points]
    for filter, point in zip(filters, points, strict=True):
        for _ in range(SETTLE):
            filter.step(point)
    return filters


def permuted_twice_rows() -> tuple[Floats, Floats]:
    """Three contacts in the order of their filters, before and after their rows change places."""
    before = np.array([(COLUMNS[0], 100.0), (COLUMNS[1], 105.0), (COLUMNS[2], 110.0)])
    after = np.array([(COLUMNS[0], 106.0), (COLUMNS[1], 111.0), (COLUMNS[2], 104.0)])
    return before, after


def permuted_twice() -> tuple[float, float]:
    """Largest distance of an estimate from its contact in the frame of the change, px."""
    before, after = permuted_twice_rows()
    filters = still(before.tolist())
    by_row = after[np.argsort(after[:, 1])]
    index = listing.nearest_not_successive(np.array([one.position for one in filters]), by_row)
    for k, z in listing.permuted_twice(index, by_row).items():
        filters[k].step(z)
    frames = [*SETTLE * [before.tolist()], after.tolist()]
    _, positions = ours.monitor(frames)[-1]
    return (
        max(far(true, one.position) for true, one in zip(after, filters, strict=True)),
        max(min(far(true, at) for at in positions.values()) for true in after),
    )


def stale_entries() -> tuple[float, float]:
    """Contacts without a filter of their own in the frame after one that only two of three were
    seen in: the listing overwrites as many entries of index as there are measurements."""
    points = [[COLUMNS[0], 60.0], [COLUMNS[1], 140.0], [COLUMNS[2], 220.0]]
    two = np.array(points[1:])
    nearest = listing.nearest_not_successive(np.array(points), two)
    index = listing.stale_index([0, 1, 2], dict(enumerate(nearest)))
    frames = [*SETTLE * [points], points[1:], points]
    _, positions = ours.monitor(frames)[-1]
    ids = list(positions)
    own = {ids[int(np.argmin([far(z, positions[id]) for id in ids]))] for z in np.array(points)}
    return float(len(points) - len(set(index))), float(len(points) - len(own))


SPURIOUS = (COLUMNS[2], 20.0)  # above both, and nearest to the second


def _two_with_spurious() -> list[list[list[float]]]:
    """Frames of two contacts, in the last of which there is a spurious blob."""
    points = [[COLUMNS[0], 100.0], [COLUMNS[2], 200.0]]
    return [*SETTLE * [points], [list(SPURIOUS), *points]]


def _with_newcomer() -> tuple[list[ListingFilter], list[int], Floats]:
    """The listing's filters after that frame, index, and the two contacts.

    A filter that two measurements choose is given the first.
    """
    frames = _two_with_spurious()
    points, blobs = np.array(frames[0]), np.array(frames[-1])
    filters = still(frames[0])
    index = listing.nearest_not_successive(points, blobs)
    for k in set(index):
        filters[k].step(blobs[index.index(k)])
    return filters, index, points


def stolen_filter() -> tuple[float, float]:
    """How far the track that moves most is from its contact after that frame, px."""
    filters, _, points = _with_newcomer()
    _, positions = ours.monitor(_two_with_spurious())[-1]
    return (
        max(far(true, one.position) for true, one in zip(points, filters, strict=True)),
        max(min(far(true, at) for at in positions.values()) for true in points),
    )


def stolen_for_good() -> tuple[float, float]:
    """Contacts whose filter is another's 10 frames after the spurious blob: count = median, so that
    the listing goes on with index as it was left."""
    filters, index, points = _with_newcomer()
    for _ in range(10):
        for k, z in zip(index, points, strict=False):
            filters[k].step(z)
    answers = ours.monitor([*_two_with_spurious(), *10 * [points.tolist()]])
    before, after = answers[SETTLE - 1][1], answers[-1][1]
    swapped = [far(true, one.position) > 50 for true, one in zip(points, filters, strict=True)]
    moved = [id for id, at in before.items() if id not in after or far(at, after[id]) > 50]
    return float(sum(swapped)), float(len(moved))


def shared_filter() -> tuple[float, float]:
    """The third measurement is nearest to the first filter, which the second did not take."""
    before = np.array([(100.0, 100.0), (200.0, 110.0), (60.0, 130.0)])
    after = np.array([(100.0, 100.0), (200.0, 110.0), (85.0, 120.0)])
    index = listing.nearest_not_successive(before, after)
    shared = sum(index.count(k) > 1 for k in index)
    answers = ours.monitor([*SETTLE * [before.tolist()], after.tolist()])
    used = [match.track_id for match in answers[-1][0].matches if match.assigned]
    return float(shared), float(sum(used.count(id) > 1 for id in used))


def crossing_in_row() -> tuple[float, float]:
    """Two contacts far apart, one on its way down, one on its way up; the listing's order is the
    library's assignment row_order."""
    frames = [
        [[100.0, 80.0 + 3.0 * frame], [280.0, 200.0 - 3.0 * frame]] for frame in range(SETTLE)
    ]
    changed = []
    for changes in (("assignment.model=row_order",), ()):
        answers = ours.monitor(frames, *changes)
        first, last = answers[0][1], answers[-1][1]
        moved = [id for id in first if abs(first[id][0] - last[id][0]) > 90]
        changed.append(float(len(moved)))
    return changed[0], changed[1]


def markers_drawn() -> tuple[float, float]:
    """The listing draws all of its filters, those without a contact in the middle of the frame."""
    points = [[80.0, 50.0 + 80.0 * k] for k in range(3)]
    filters = [*points, *(FILTERS - len(points)) * [CENTRE]]
    result, _ = ours.monitor(SETTLE * [points])[-1]
    return float(len(filters)), float(sum(track.reported for track in result.tracks))
