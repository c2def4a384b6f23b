# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The tables of options in docs/offline.md are those of the library."""

import json
import re
from typing import Any

import pytest

import survtrack
from documents import ROOT

ROW = re.compile(r"^\| `(\w+)` \| `([^`]+)` \| ([^|]*)\|$", re.MULTILINE)


HALVES = (ROOT / "docs" / "offline.md").read_text().split("\n# Patterns of activity\n")


@pytest.mark.parametrize(
    ("text", "kind"),
    [*zip(HALVES, (survtrack.LinkOptions, survtrack.PatternOptions), strict=True)],
)
def test_the_documented_options_are_those_there_are(text: str, kind: Any) -> None:
    table = ROW.findall(text)
    options = kind().to_dict()
    assert {name: json.loads(default) for name, default, _ in table} == options
    assert [name for name, _, _ in table] == list(options)
    for name, _, unit in table:
        doc = getattr(kind, name).__doc__
        assert doc.endswith(f" [{unit.strip()}]") if unit.strip() else "[" not in doc
