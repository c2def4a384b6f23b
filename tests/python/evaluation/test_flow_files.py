# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Middlebury's .flo files and the errors of optical flow."""

import struct
from pathlib import Path

import numpy as np
import pytest

from survtrack.errors import InputError
from survtrack.evaluation import flow_error, read_flo, write_flo


def component(*rows: list[float]) -> np.ndarray:
    return np.array(rows, np.float32)


def test_a_file_is_its_bytes(tmp_path: Path) -> None:
    """By hand: the magic number, width, height, then u and v of each pixel, row by row."""
    path = tmp_path / "two.flo"
    path.write_bytes(struct.pack("<f2i4f", 202021.25, 2, 1, 1.5, -2.0, 1666666752.0, 0.0))
    u, v = read_flo(path)
    assert u.shape == v.shape == (1, 2) and u.dtype == v.dtype == np.float32
    assert (u[0, 0], v[0, 0]) == (1.5, -2.0)
    assert np.isnan(u[0, 1]) and np.isnan(v[0, 1]), "not known"


def test_what_was_written_is_read(tmp_path: Path) -> None:
    u, v = np.random.default_rng(1).normal(0, 5, (2, 7, 4)).astype(np.float32)
    write_flo(tmp_path / "field.flo", u, v)
    for written, read in zip((u, v), read_flo(tmp_path / "field.flo"), strict=True):
        assert np.array_equal(written, read)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "is no .flo file"),
        (b"PIEH\x01\0\0\0", "is no .flo file"),
        (struct.pack("<f2i2f", 1.0, 1, 1, 0, 0), "is no .flo file"),
        (struct.pack("<f2i", 202021.25, 0, 3), "says 0x3 px; expected 1 to"),
        (struct.pack("<f2i", 202021.25, 3, -1), "says 3x-1 px"),
        (struct.pack("<f2i3f", 202021.25, 1, 1, 0, 0, 0), "has 24 bytes; 20 expected for 1x1 px"),
    ],
)
def test_broken_files(tmp_path: Path, data: bytes, message: str) -> None:
    path = tmp_path / "broken.flo"
    path.write_bytes(data)
    with pytest.raises(InputError, match=rf"broken\.flo: {message}"):
        read_flo(path)
    with pytest.raises(InputError, match=r"none\.flo: no such file"):
        read_flo(tmp_path / "none.flo")
    with pytest.raises(InputError, match=r"^u, v: have the shapes \(1, 2\), \(2, 1\)"):
        write_flo(path, component([1, 2]), component([1], [2]))


def test_errors_by_hand() -> None:
    """Endpoints 5 and 0 px away; (0, 0, 1) and (1, 0, 1) are 45 degrees apart."""
    truth = component([3, 0], [np.nan, 1]), component([4, 0], [np.nan, 0])
    flow = component([0, 0], [9, 1]), component([0, 0], [9, 0])
    found = flow_error(flow, truth)
    assert found.pixels == 3
    assert found.endpoint_px == pytest.approx(5 / 3)
    one = flow_error((component([0]), component([0])), (component([1]), component([0])))
    assert (one.endpoint_px, one.angular_deg) == (pytest.approx(1), pytest.approx(45))


def test_fields_that_do_not_fit() -> None:
    one, two = component([0]), component([0, 0])
    with pytest.raises(InputError, match=r"^truth u: has the shape \(1, 2\); expected HxW, all"):
        flow_error((one, one), (two, two))
    with pytest.raises(InputError, match=r"^truth: is known at no pixel"):
        flow_error((one, one), (one + np.nan, one))
    with pytest.raises(InputError, match=r"^flow: is not finite"):
        flow_error((one + np.nan, one), (one, one))
