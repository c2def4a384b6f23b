# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The filter of O'Malley 2000 in path coordinates, simulated, and its errata.

P. D. O'Malley, Use of a Kalman Filter to Improve Realtime Video Stream Image Processing: An
Example, honours report, University of Florida, 2000.
"""

from survtrack.experiments.omalley2000.experiment import OMalley2000

__all__ = ["OMalley2000"]
