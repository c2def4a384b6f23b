# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What Suliman et al. 2010 show (figure 7): a marker that follows one contact and waits for it.

C. Suliman, C. Cruceru, F. Moldoveanu, Kalman Filter Based Tracking in an Video Surveillance
System, DAS 2010.
"""

from survtrack.experiments.suliman2010.experiment import Suliman2010

__all__ = ["Suliman2010"]
