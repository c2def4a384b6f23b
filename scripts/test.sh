#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Everything that must hold, from a bare machine; stops at the first failure.
source "$(dirname "$0")/common.sh"

# step NAME COMMAND...: runs it, and prints how long it took.
step() {
  local name=$1 start=$SECONDS
  shift
  say "$name"
  "$@" || fail "$name"
  say "$name: $((SECONDS - start)) s"
}

# A step runs where errors do not end the script: what belongs together is joined by &&.
release() {
  cmake --build "$BUILD" -- --quiet &&
    ctest --test-dir "$BUILD" --output-on-failure --no-tests=error --progress \
      --parallel "$CMAKE_BUILD_PARALLEL_LEVEL"
}

sanitize() {
  cmake --preset sanitize >build/sanitize.log || { cat build/sanitize.log && return 1; }
  cmake --build --preset sanitize -- --quiet &&
    ctest --preset sanitize --progress --parallel "$CMAKE_BUILD_PARALLEL_LEVEL"
}

step "set-up" bash scripts/setup.sh
step "style and types" bash scripts/lint.sh
step "C++ tests" release
step "C++ tests under sanitizers" sanitize
step "Python tests" "$VENV/bin/python" -m pytest -q --numprocesses "$CMAKE_BUILD_PARALLEL_LEVEL"
step "documentation" bash scripts/docs.sh
say "all passed in $SECONDS s"
