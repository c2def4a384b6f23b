# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Optical flow in Middlebury's files, and its error against the truth (Baker et al. 2011)."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from survtrack.errors import InputError
from survtrack.evaluation.files import StrPath, read_bytes

MAGIC = b"PIEH"  # the float 202021.25
HEADER_BYTES = 12
UNKNOWN_PX = 1e9  # a component beyond it says that the truth is not known
LONGEST_SIDE_PX = 1 << 20

Component = NDArray[np.float32]


def read_flo(path: StrPath) -> tuple[Component, Component]:
    """The components (u, v) of a .flo file, float32 HxW in px; NaN where the flow is not known.

    Raises:
        InputError: no such file, no .flo file, or one of another length than it says.
    """
    path = Path(path)
    data = read_bytes(path)
    if len(data) < HEADER_BYTES or data[:4] != MAGIC:
        raise InputError(f"{path}: is no .flo file; expected one that begins with PIEH")
    width, height = (int(n) for n in np.frombuffer(data, "<i4", 2, 4))
    if not (0 < width <= LONGEST_SIDE_PX and 0 < height <= LONGEST_SIDE_PX):
        raise InputError(
            f"{path}: says {width}x{height} px; expected 1 to {LONGEST_SIDE_PX} a side"
        )
    needed = HEADER_BYTES + 8 * width * height
    if len(data) != needed:
        raise InputError(
            f"{path}: has {len(data)} bytes; {needed} expected for {width}x{height} px"
        )
    field = np.frombuffer(data, "<f4", offset=HEADER_BYTES).reshape(height, width, 2)
    known = (np.abs(field) <= UNKNOWN_PX).all(axis=2, keepdims=True)
    u, v = np.moveaxis(np.where(known, field, np.nan).astype(np.float32), 2, 0)
    return np.ascontiguousarray(u), np.ascontiguousarray(v)


def write_flo(path: StrPath, u: Component, v: Component) -> None:
    """Writes components of one size, HxW in px, as a .flo file.

    Raises:
        InputError: components of other shapes than HxW, or of different ones.
    """
    shapes = np.shape(u), np.shape(v)
    if shapes[0] != shapes[1] or len(shapes[0]) != 2 or 0 in shapes[0]:
        raise InputError(f"u, v: have the shapes {shapes[0]}, {shapes[1]}; expected HxW, the same")
    height, width = shapes[0]
    header = MAGIC + np.array([width, height], "<i4").tobytes()
    Path(path).write_bytes(header + np.stack([u, v], axis=2).astype("<f4").tobytes())


@dataclass(frozen=True)
class FlowError:
    """How far a flow field is from the truth, over the pixels whose truth is known."""

    endpoint_px: float  # mean length of the difference
    angular_deg: float  # mean angle between (u, v, 1) and its truth
    pixels: int


def flow_error(flow: tuple[Component, Component], truth: tuple[Component, Component]) -> FlowError:
    """Endpoint and angular error of a flow (u, v) against the truth, HxW in px.

    Args:
        flow: finite wherever the truth is.
        truth: NaN where it is not known.

    Raises:
        InputError: components that are not HxW of one size, a flow that is not finite, or a truth
            that is known nowhere.
    """
    names = ("flow u", "flow v", "truth u", "truth v")
    arrays = [np.asarray(one, np.float64) for one in (*flow, *truth)]
    for name, array in zip(names, arrays, strict=True):
        if array.ndim != 2 or array.shape != arrays[0].shape:
            raise InputError(f"{name}: has the shape {array.shape}; expected HxW, all the same")
    known = np.isfinite(arrays[2]) & np.isfinite(arrays[3])
    if not known.any():
        raise InputError("truth: is known at no pixel; at least one expected")
    u, v, true_u, true_v = (array[known] for array in arrays)
    if not (np.isfinite(u).all() and np.isfinite(v).all()):
        raise InputError("flow: is not finite at some pixel whose truth is known")
    dot = 1 + u * true_u + v * true_v
    lengths = np.sqrt((1 + u * u + v * v) * (1 + true_u * true_u + true_v * true_v))
    angle = np.degrees(np.arccos(np.clip(dot / lengths, -1, 1)))
    endpoint = np.hypot(u - true_u, v - true_v)
    return FlowError(float(endpoint.mean()), float(angle.mean()), int(known.sum()))
