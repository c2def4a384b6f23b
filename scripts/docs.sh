#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Builds the documentation into site/; a warning is an error.
source "$(dirname "$0")/common.sh"
bash scripts/setup.sh

"$VENV/bin/mkdocs" build --strict --quiet
say "documentation: site/index.html"
