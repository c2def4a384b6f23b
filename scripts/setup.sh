#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Everything a fresh Debian 12 needs: system packages, .venv, survtrack built and installed
# editable. Does only what is missing; PYTHON names the Python to use (3.11 or newer).
source "$(dirname "$0")/common.sh"

command -v "$PYTHON" >/dev/null || fail "no $PYTHON; set PYTHON to a Python 3.11 or newer"
"$PYTHON" -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
  fail "$("$PYTHON" --version) is too old; set PYTHON to a Python 3.11 or newer"

# Neither download needs the other, once this Python can make an environment.
if "$PYTHON" -c 'import ensurepip' 2>/dev/null; then
  bash scripts/setup_venv.sh &
  bash scripts/setup_debian.sh || { kill $!; exit 1; }
  wait $!
else
  bash scripts/setup_debian.sh
  bash scripts/setup_venv.sh
fi
bash scripts/setup_survtrack.sh
