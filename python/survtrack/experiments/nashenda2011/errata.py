# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Each fault of the print measured, beside the same in the library."""

from survtrack.experiments.nashenda2011 import errata_filter, errata_mask
from survtrack.experiments.semko2007.errata import Erratum, Measure

ERRATA: tuple[tuple[str, str, str, Measure], ...] = (
    (
        "r_smallest",
        "R = [[0.2877, 1.1909], [1.1909, 1.1465]] is no covariance",
        "its smallest eigenvalue, px^2",
        errata_filter.smallest_eigenvalue_of_r,
    ),
    (
        "r_largest",
        "the same",
        "its largest eigenvalue, px^2",
        errata_filter.largest_eigenvalue_of_r,
    ),
    (
        "r_innovation",
        "the same",
        "frames of 121 with an indefinite innovation covariance, q = 1",
        errata_filter.indefinite_innovations,
    ),
    (
        "r_rms",
        "the same: the bad showing of q = 1",
        "rms error of a coordinate, steady target, no B u, q = 1, px",
        errata_filter.rms_of_q_1,
    ),
    (
        "input_y",
        "B u = (0, 0, 0, 8): px added to px/s, to y, where x falls by 7.98 px a frame",
        "prediction of one who goes by that step, off in y, q = 10, px",
        errata_filter.input_in_y,
    ),
    (
        "input_q_0",
        "the same",
        "error of y of one who stands, after 121 frames, q = 0, px",
        errata_filter.input_at_q_0,
    ),
    (
        "input_q_10",
        "the same: a higher q hides it",
        "error of y of one who stands, after 121 frames, q = 10, px",
        errata_filter.input_at_q_10,
    ),
    (
        "skip_q_0",
        "`continue` on a missing blob: the filter goes on from (0, 0)",
        "off in the first frame after a gap of 2, no noise, q = 0, px",
        errata_filter.skipped_at_q_0,
    ),
    (
        "skip_q_100",
        "the same: a high q hides it",
        "off in the first frame after a gap of 2, no noise, q = 100, px",
        errata_filter.skipped_at_q_100,
    ),
    (
        "start",
        "the start is (rows / 2, columns / 2): axes swapped",
        "from the middle of a frame of 384x288, px",
        errata_filter.start,
    ),
    (
        "start_outside",
        "the same",
        "below a frame of 1280x480, px",
        errata_filter.start_outside,
    ),
    (
        "plus_sign",
        "eq. 22 of 4.2.3.4: z + H x-, and no gain; here with the gain",
        "x of one who stands, off after 5 frames, px",
        errata_filter.update_with_a_plus,
    ),
    (
        "ekf",
        "eqs. 26 and 28: f of the estimate of the same frame, so twice",
        "prediction at the printed speed, off by, px",
        errata_filter.ekf_ahead,
    ),
    (
        "one_sided",
        "4.3: the test of the first channel is one-sided",
        "pixels found of 400 that are darker by 60 in the first channel",
        errata_mask.darker_in_the_first_channel,
    ),
    (
        "at_least",
        "eq. 26 of 4.3 has >= T, eq. 2 and the listing > T",
        "pixels found of 400 that differ by T in all channels",
        errata_mask.at_the_threshold,
    ),
    (
        "misprint",
        "P- of q = 10: 11.1871",
        "row 4, column 1, where row 1, column 4 is 1.1871",
        errata_filter.misprint,
    ),
    (
        "truth",
        "the truth is the measurement itself",
        "rms error at q = 100 in parts of that at q = 0, steady target",
        errata_filter.truth_is_the_measurement,
    ),
)


def measure_errata() -> list[Erratum]:
    """All of them; the same each time."""
    return [Erratum(key, fault, figure, *measure()) for key, fault, figure, measure in ERRATA]
