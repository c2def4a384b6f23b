# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command `survtrack presets`."""

from typing import Annotated

import typer

import survtrack


def presets(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Print this preset's TOML.")
    ] = None,
) -> None:
    """List the presets, or print one."""
    if name is not None:
        print(survtrack.preset_text(name), end="")
        return
    names = survtrack.preset_names()
    width = max(map(len, names))
    for known in names:
        print(f"{known:{width}}  {description(survtrack.preset_text(known))}".rstrip())


def description(text: str) -> str:
    """The first comment of a preset's TOML that is not its licence."""
    for line in text.splitlines():
        comment = line.removeprefix("#").strip()
        if line.startswith("#") and comment and not comment.startswith("SPDX-"):
            return comment
    return ""
