#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Makes build/bench-venv with the peers that benchmarks/requirements.txt names.
source "$(dirname "$0")/common.sh"
PEERS=$PWD/build/bench-venv

cv2=$("$VENV/bin/pip" list --format freeze | grep '^opencv-python-headless==')
key="$(hash_of benchmarks/requirements.txt) $cv2 $("$VENV/bin/python" -VV | tr '\n' ' ')"
if done_before bench-venv "$key" && [ -x "$PEERS/bin/python" ]; then
  say "peers: all there"
  exit 0
fi

say "peers: $PEERS"
"$VENV/bin/python" -m venv --clear "$PEERS"
pip() { "$PEERS/bin/pip" --quiet --disable-pip-version-check "$@"; }
pip install -r benchmarks/requirements.txt
# The same cv2 for both sides, and one that needs no libGL.
pip uninstall --yes opencv-python
pip install --no-deps --force-reinstall "$cv2"
mark_done bench-venv "$key"
