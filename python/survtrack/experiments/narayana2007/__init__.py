# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The experiments of Narayana 2007 (5, 7 and 9), its counts of errors beside today's scores.

M. Narayana, Automatic Tracking of Moving Objects in Video for Surveillance Applications, MSc
thesis, University of Kansas, 2007.
"""

from survtrack.experiments.narayana2007.experiment import Narayana2007

__all__ = ["Narayana2007"]
