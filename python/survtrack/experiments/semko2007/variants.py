# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The configurations that run on footage."""

from survtrack.experiments.trial import Variant

VARIANTS = {
    name: Variant(name, in_frames=name != "survtrack")
    for name in ("semko2007", "semko2007_published", "survtrack")
}
