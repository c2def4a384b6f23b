# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the report prints (2 and appendix A). Lengths are the track's own unit."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LENGTH = 278.586
PERIOD_S = 1 / 15
START = np.array([2.0, 1.83, 77.0, 0.3])  # S, T, vS, vT
SHOWN = 200  # data points of figures 5 to 9
DATAPOINTS = 276  # of the new algorithm, table 3
WRAP_OVER = 200.0  # the listing's fixed difference from which it takes l off the state
LARGEST_ERROR = 0.014  # of S, in parts of the length (figure 6)
SIGMAS_S = 3.0
AREAS = (2001.25, 2995.26)  # of the new and the old region, table 3
SMALLER = 0.331


@dataclass(frozen=True, eq=False)
class Noises:
    """Q (4, 4) of S, T, vS, vT and R (2, 2) of S, T."""

    Q: Floats
    R: Floats


TEXT = Noises(0.01 * np.diag([1.0, 10.0, 1.0, 10.0]), 0.0001 * np.diag([1.0, 20000.0]))
LISTING = Noises(0.01 * np.diag([1.0, 10.0, 20.0, 10.0]), 0.0001 * np.diag([0.01, 20000.0]))
VALUES = {"text": TEXT, "listing": LISTING}
