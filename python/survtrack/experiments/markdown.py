# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pieces of a Markdown page."""

from collections.abc import Sequence


def table(header: Sequence[str], rows: Sequence[Sequence[str]], left: int = 1) -> str:
    """A table; the first `left` columns hold words, the others numbers and are set to the right."""
    rule = ["---" if column < left else "---:" for column in range(len(header))]
    return "\n".join(_line(cells) for cells in (header, rule, *rows)) + "\n"


def _line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def counted(errors: int, of: int) -> str:
    """A count with its percentage: "45 (15.4 %)"."""
    return f"{errors} ({percent(errors, of):.1f} %)"


def percent(part: float, whole: float) -> float:
    """100 part / whole."""
    return 100 * part / whole
