# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the dissertation prints (4.5 and 5.1), and the matrices that its filter comes to."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

FRAMES = 121
SIZE = (384, 288)  # (width, height) of the listing's frames, px
PERIOD_S = 0.2685  # 1 / 3.724
SWEEP = (0.0, 1.0, 10.0, 50.0, 100.0)  # q of Q = q I
START_VARIANCE = 100.0  # P0 = 100 I
R = np.array([[0.2877, 1.1909], [1.1909, 1.1465]])
INPUT = np.array([0.0, 0.0, 0.0, 8.0])  # B u
STEP_PX = 374.4236 - 366.4458  # by which x falls in a frame, 4.5.3
THRESHOLD = 37

ENTERS = np.array([367.0, 274.0])  # where the person is when the estimate is judged
ESTIMATE = np.array([367.6224, 274.6981])  # at that time, q = 100
ACCURACY = (0.9983, 0.9975)  # 6.1


@dataclass(frozen=True, eq=False)
class Printed:
    """One printed matrix.

    Attributes:
        q: of Q = q I.
        name: "P-" (predicted), "K" (gain) or "P" (updated).
        updates: after which it is the filter's.
        values: as printed, to four decimals; "P-" of q = 10 with the misprint.
    """

    q: float
    name: str
    updates: int
    values: Floats


MISPRINT = (3, 0)  # row and column, from 0, of 11.1871 in P- of q = 10; it is 1.1871

# The covariances settle, so that any late update would do; q = 0 and q = 1 do not, theirs is 108.
PRINTED = (
    Printed(0.0, "K", 108, np.array([
        [0.0365, 0.0], [0.0, 0.0365], [0.0019, 0.0], [0.0, 0.0019],
    ])),
    Printed(1.0, "K", 108, np.array([
        [1.4773, -0.6126], [-0.6126, 1.0355], [1.4039, -0.6727], [-0.6727, 0.9188],
    ])),
    Printed(10.0, "P-", FRAMES, np.array([
        [13.3580, 1.6698, 11.6210, 1.1871], [1.6698, 14.5621, 1.1871, 12.4771],
        [11.6210, 1.1871, 52.7167, 0.9202], [11.1871, 12.4771, 0.9202, 53.3803],
    ])),
    Printed(10.0, "K", FRAMES, np.array([
        [0.9946, -0.0748], [-0.0748, 0.9406], [0.8690, -0.0827], [-0.0827, 0.8093],
    ])),
    Printed(10.0, "P", FRAMES, np.array([
        [0.1970, 1.0987, 0.1515, 0.9401], [1.0987, 0.9893, 0.9401, 0.8294],
        [0.1515, 0.9401, 42.7167, 0.9202], [0.9401, 0.8294, 0.9202, 43.3803],
    ])),
    Printed(50.0, "P-", FRAMES, np.array([
        [65.7521, 1.7842, 57.4486, 1.2843], [1.7842, 67.0388, 1.2843, 58.3748],
        [57.4486, 1.2843, 263.1132, 1.0029], [1.2843, 58.3748, 1.0029, 263.8365],
    ])),
)  # fmt: skip
