# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Prints what pyproject.toml requires, one a line: to build, to run, and all extras.

The package itself is built afterwards without isolation, which needs all of it in place.
"""

import tomllib
from pathlib import Path

pyproject = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text())
project = pyproject["project"]
requirements = set(pyproject["build-system"]["requires"]) | set(project["dependencies"])
for extra in project["optional-dependencies"].values():
    requirements |= {line for line in extra if not line.startswith("survtrack[")}
print("\n".join(sorted(requirements)))
