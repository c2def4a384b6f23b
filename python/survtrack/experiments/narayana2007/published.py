# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The numbers that the thesis prints: errors of its three subsequences, in that order.

Its percentages of the totals are means of the three percentages (tables 5.2, 5.4, 5.6 and 7.2);
here they are of the totals themselves, errors / instances.
"""

from dataclasses import dataclass

from survtrack.experiments.markdown import percent

INSTANCES = (116, 55, 121)  # cars, frame by frame
TOTAL_INSTANCES = sum(INSTANCES)
FRAMES_PER_S = 18  # 320x240, JPEG in and out, 3 GHz Pentium


@dataclass(frozen=True)
class Errors:
    """Errors of one kind with one method.

    Attributes:
        each: counts of subsequences 1, 2 and 3.
        printed_percent: what the thesis prints for the total.
    """

    each: tuple[int, int, int]
    printed_percent: float

    @property
    def total(self) -> int:
        """Errors of all three."""
        return sum(self.each)

    @property
    def percent(self) -> float:
        """Of all instances."""
        return percent(self.total, TOTAL_INSTANCES)


# By the key of the merging (variants.Merging). The base of the vicinity factor is 10 px (6.4).
NUMBER_OF_BLOBS = {
    "none": Errors((24, 5, 29), 17.9),
    "fixed_10": Errors((23, 5, 23), 16.0),
    "fixed_15": Errors((27, 2, 19), 14.2),
    "fixed_20": Errors((34, 2, 20), 16.5),
    "vicinity_published": Errors((23, 2, 20), 13.3),
}
# Without and with the velocity factor.
INDEX = {False: Errors((13, 0, 32), 12.6), True: Errors((11, 1, 13), 7.3)}
SWAP = {False: Errors((5, 0, 13), 5.0), True: Errors((5, 2, 7), 4.6)}
