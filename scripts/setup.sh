#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Everything a fresh Debian 12 needs: system packages, .venv, survtrack built and installed
# editable. Does only what is missing; PYTHON names the Python to use (3.11 or newer).
source "$(dirname "$0")/common.sh"

bash scripts/setup_debian.sh
bash scripts/setup_venv.sh
bash scripts/setup_survtrack.sh
