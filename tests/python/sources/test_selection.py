# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""start, step and limit choose frames of the source."""

import pytest

from survtrack.errors import InputError, UsageError
from survtrack.sources import Selection


def test_indices_count_in_the_whole_source() -> None:
    assert list(Selection().indices(4)) == [0, 1, 2, 3]
    assert list(Selection(start=2, step=3).indices(10)) == [2, 5, 8]
    assert list(Selection(start=2, step=3, limit=2).indices(10)) == [2, 5]


def test_wants_agrees_with_indices() -> None:
    selection = Selection(start=3, step=4)
    assert [k for k in range(20) if selection.wants(k)] == list(selection.indices(20))


def test_expected_count() -> None:
    assert Selection(start=5, step=2).expected_count(10) == 3
    assert Selection(start=20).expected_count(10) == 0
    assert Selection(limit=7).expected_count(None) == 7
    assert Selection().expected_count(None) is None


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"start": -1}, "start: -1 is not allowed; 0 or more"),
        ({"step": 0}, "step: 0 is not allowed; 1 or more"),
        ({"limit": 0}, "limit: 0 is not allowed; 1 or more"),
    ],
)
def test_refuses_what_is_out_of_range(options: dict[str, int], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        Selection(**options)


def test_a_source_without_frames_is_bad_input_but_skipping_all_is_misuse() -> None:
    with pytest.raises(InputError, match=r"clip: holds no frames"):
        Selection().refuse_nothing("clip", 0)
    with pytest.raises(UsageError, match=r"start: 9 skips all 9 frames of clip"):
        Selection(start=9).refuse_nothing("clip", 9)
