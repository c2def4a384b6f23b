# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The trials of Semko 2007 (V.B and V.C), and the faults of its listing beside what is ours.

D. A. Semko, Optical Flow Analysis and Kalman Filter Tracking in Video Surveillance Algorithms, MSc
thesis, Naval Postgraduate School, 2007.
"""

from survtrack.experiments.semko2007.experiment import Semko2007

__all__ = ["Semko2007"]
