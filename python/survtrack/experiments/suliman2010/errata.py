# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Eq. 6 as it is printed beside the library's filter."""

from dataclasses import dataclass

import numpy as np

import survtrack
from survtrack._core import KalmanCaOptions
from survtrack.experiments.semko2007.listing import printed_transition
from survtrack.experiments.suliman2010.scenes import PRESET


@dataclass(frozen=True)
class Eq6:
    """What eq. 6 prints, and what the library has.

    Attributes:
        printed_shape: of the matrix.
        printed_states: names on the right-hand side.
        refusal: what numpy says to the product.
        states: of a filter of the preset.
        covariance_shape: of it.
    """

    printed_shape: tuple[int, ...]
    printed_states: int
    refusal: str
    states: int
    covariance_shape: tuple[int, ...]


def measure_eq6() -> Eq6:
    """Multiply what is printed, and ask a filter."""
    matrix, names = printed_transition()
    refusal = ""
    try:
        np.matmul(matrix, np.zeros(len(names)))
    except ValueError as error:
        refusal = str(error)
    options = survtrack.preset(PRESET).filter
    assert isinstance(options, KalmanCaOptions)
    bank = survtrack.FilterBank(options)
    slot = bank.add(0.0, 0.0)
    return Eq6(
        matrix.shape,
        len(names),
        refusal,
        len(bank.state(slot)),
        bank.state_covariance(slot).shape,
    )
