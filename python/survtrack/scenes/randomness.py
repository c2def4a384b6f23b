# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Random numbers: a stream of its own for every purpose and every object.

No stream depends on how many others there are, so that one more object, or noise, changes nothing
that was there before.
"""

from enum import IntEnum

import numpy as np

MAX_SEED = 2**32 - 1


class Purpose(IntEnum):
    """What a stream is drawn for."""

    PLACEMENT = 0
    BACKGROUND = 1
    OBJECT = 2
    OCCLUDER = 3
    NOISE = 4
    MEASUREMENT = 5


def stream(seed: int, purpose: Purpose, key: int = 0) -> np.random.Generator:
    """A fresh generator.

    Args:
        seed: of the scene, 0 to MAX_SEED.
        purpose: what is drawn.
        key: which of its kind: the id of an object, the index of a frame; 0 or more.
    """
    return np.random.default_rng([seed, int(purpose), key])
