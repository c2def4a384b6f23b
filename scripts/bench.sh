#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Our pipeline against OpenCV's, in the same run: prints ratios. Arguments go to benchmarks/run.py:
# make bench ARGS="--json bench.json", or scripts/bench.sh --help. First the C++ benchmarks, which have no peers.
source "$(dirname "$0")/common.sh"
bash scripts/setup.sh
bash scripts/setup_bench.sh
bash scripts/demo_footage.sh
cmake --build "$BUILD" --target belief_matrix kalman -- --quiet
"$BUILD/benchmarks/cpp/belief_matrix"
"$BUILD/benchmarks/cpp/kalman"
"$VENV/bin/python" benchmarks/run.py --peers build/bench-venv/bin/python --video demo/vtest.avi "$@"
