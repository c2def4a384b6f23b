# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The sweep of Q of Nashenda 2011 (5 and 6), as printed and as it should be, and each erratum.

H. T. Nashenda, Uncertain Input Estimation with Application to Kalman Tracking, MSc dissertation,
University of Cape Town, 2011.
"""

from survtrack.experiments.nashenda2011.experiment import Nashenda2011

__all__ = ["Nashenda2011"]
