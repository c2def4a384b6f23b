# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The table of options in docs/offline.md is that of the library."""

import json
import re

import survtrack
from documents import ROOT

ROW = re.compile(r"^\| `(\w+)` \| `([^`]+)` \| ([^|]*)\|$", re.MULTILINE)


def test_the_documented_options_are_those_there_are() -> None:
    table = ROW.findall((ROOT / "docs" / "offline.md").read_text())
    options = survtrack.LinkOptions().to_dict()
    assert {name: json.loads(default) for name, default, _ in table} == options
    assert [name for name, _, _ in table] == list(options)
    for name, _, unit in table:
        doc = getattr(survtrack.LinkOptions, name).__doc__
        assert doc.endswith(f" [{unit.strip()}]") if unit.strip() else "[" not in doc
