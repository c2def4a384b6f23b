#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Style and types.
source "$(dirname "$0")/common.sh"
bash scripts/setup.sh

say "ruff"
"$VENV/bin/ruff" check --quiet .
"$VENV/bin/ruff" format --quiet --check .
say "mypy"
"$VENV/bin/mypy" --no-error-summary
