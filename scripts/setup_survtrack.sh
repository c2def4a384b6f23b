#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Builds the Python module in build/release, where the C++ tests are built too, and installs the
# package editable: changes in Python need nothing, changes in C++ this script again.
source "$(dirname "$0")/common.sh"

key=$(hash_of CMakeLists.txt cmake cpp benchmarks/cpp presets pyproject.toml "$STAMPS/venv")
if done_before survtrack "$key" && "$VENV/bin/python" -c 'import survtrack' 2>/dev/null; then
  say "survtrack: built from these sources"
  exit 0
fi

say "survtrack: building (log in build/survtrack.log)"
"$VENV/bin/pip" install --disable-pip-version-check --verbose --no-deps --no-build-isolation \
  --config-settings=build-dir="$BUILD" \
  --config-settings=cmake.build-type=Release \
  --config-settings=cmake.define.SURVTRACK_BUILD_TESTS=ON \
  --config-settings=cmake.define.SURVTRACK_BUILD_EXAMPLES=ON \
  --config-settings=cmake.define.SURVTRACK_BUILD_BENCHMARKS=ON \
  --config-settings=cmake.define.SURVTRACK_WARNINGS_AS_ERRORS=ON \
  --editable . >build/survtrack.log 2>&1 || {
  tail -n 60 build/survtrack.log >&2
  fail "survtrack does not build; the whole log is in build/survtrack.log"
}
mark_done survtrack "$key"
