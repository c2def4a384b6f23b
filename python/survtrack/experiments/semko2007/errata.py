# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Each fault of the listing measured, beside the same in the library."""

from collections.abc import Callable
from dataclasses import dataclass

from survtrack.experiments.semko2007 import errata_contacts, errata_filter, errata_losses


@dataclass(frozen=True)
class Erratum:
    """One number that a fault changes.

    Attributes:
        key: in results.json.
        fault: what the listing does.
        figure: what is measured, with its unit.
        listing: with the fault.
        ours: of the library.
    """

    key: str
    fault: str
    figure: str
    listing: float
    ours: float


Measure = Callable[[], tuple[float, float]]

ERRATA: tuple[tuple[str, str, str, Measure], ...] = (
    (
        "plus_sign_trace",
        "P = (I + K H) P",
        "trace of P after 100 frames, noise of 1 px",
        errata_filter.trace_of_p,
    ),
    (
        "plus_sign_rms",
        "the same: the filter echoes the measurement",
        "rms error, noise of 1 px a coordinate, px",
        errata_filter.rms_with_noise,
    ),
    (
        "folded_exact",
        "H = [I, I, I/2]: the transition is in the measurement",
        "largest difference of the state from the standard form, Q = 0, px",
        errata_filter.folded_without_noise,
    ),
    (
        "folded_noise",
        "the same",
        "largest difference of the position, Q = 0.5 I, px",
        errata_filter.folded_with_noise,
    ),
    (
        "own_estimate",
        "a missing contact is fed its last estimate",
        "off after 12 frames at 2 px a frame, px",
        errata_filter.fed_own_estimate,
    ),
    (
        "own_estimate_variance",
        "the same: P stays small",
        "variance of x after 12 frames, px^2",
        errata_filter.fed_own_variance,
    ),
    (
        "start",
        "filters start in the middle of the frame",
        "largest error of a contact that comes in at the side, px",
        errata_filter.off_at_the_start,
    ),
    (
        "start_rate",
        "velocity and acceleration start at 0.1",
        "largest difference to a start at rest, px",
        errata_filter.start_at_a_tenth,
    ),
    (
        "twice",
        "z is re-ordered and then paired by index all the same",
        "off after a frame in which three contacts' rows change places, px",
        errata_contacts.permuted_twice,
    ),
    (
        "stale",
        "entries of index that no measurement wrote stay",
        "contacts of 3 without a filter of their own, after one was missing",
        errata_contacts.stale_entries,
    ),
    (
        "newcomer",
        "a newcomer is searched among the old filters",
        "a real track moves by one spurious blob, px",
        errata_contacts.stolen_filter,
    ),
    (
        "newcomer_after",
        "the same: index is never restored",
        "contacts of 2 with another's filter, 10 frames later",
        errata_contacts.stolen_for_good,
    ),
    (
        "not_permuted",
        "after a loss states move up, covariances do not",
        "variance of x of a contact that stays, in parts of that before",
        errata_losses.covariance_of_another,
    ),
    (
        "not_reset",
        "the same: the freed filter is not reset",
        "variance of x of the next newcomer, px^2",
        errata_losses.covariance_of_a_newcomer,
    ),
    (
        "sums",
        "the lost filter is the difference of two sums of indices",
        "of 2 lost at once, how many are found",
        errata_losses.two_lost_at_once,
    ),
    (
        "gained",
        "newcomers are searched among the old filters",
        "of 2 gained at once, how many get a filter of their own",
        errata_losses.two_gained_at_once,
    ),
    (
        "successive",
        "only two successive measurements are kept off the same filter",
        "contacts of 3 that share a filter with another",
        errata_contacts.shared_filter,
    ),
    (
        "summed_marker",
        "positions lost within 50 frames are added",
        "the marker from the nearest place of two losses, px",
        errata_losses.marker_of_two_losses,
    ),
    (
        "more_than_13",
        "more than 13 (IV.C.2c); 13 (IV.C.3)",
        "frames from the loss to the event",
        errata_losses.frames_to_the_event,
    ),
    (
        "row_order",
        "count = median: in the order of rows",
        "contacts of 2 that change their identity where they cross in row",
        errata_contacts.crossing_in_row,
    ),
    (
        "markers",
        "inactive filters are drawn too",
        "markers for 3 contacts",
        errata_contacts.markers_drawn,
    ),
)


def measure_errata() -> list[Erratum]:
    """All of them; the same each time."""
    return [Erratum(key, fault, figure, *measure()) for key, fault, figure, measure in ERRATA]
