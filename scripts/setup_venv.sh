#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Makes .venv with the Python packages that pyproject.toml and scripts/python-no-deps.txt name.
source "$(dirname "$0")/common.sh"

version=$("$PYTHON" -VV | tr '\n' ' ')
key="$(hash_of pyproject.toml scripts/python-no-deps.txt) $version"
if done_before venv "$key" && [ -x "$VENV/bin/python" ]; then
  say "Python packages: all there"
  exit 0
fi

say "Python packages: $("$PYTHON" --version) in $VENV"
# An environment of another Python is made anew.
clear=(--clear)
[ "$("$VENV/bin/python" -VV 2>/dev/null | tr '\n' ' ')" != "$version" ] || clear=()
"$PYTHON" -m venv "${clear[@]}" "$VENV"
mapfile -t requirements < <("$VENV/bin/python" scripts/requirements.py)
"$VENV/bin/pip" install --quiet --disable-pip-version-check "${requirements[@]}"
"$VENV/bin/pip" install --quiet --disable-pip-version-check --no-deps -r scripts/python-no-deps.txt
mark_done venv "$key"
