#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Tracks people in real footage, and says where to look.
source "$(dirname "$0")/common.sh"
bash scripts/setup.sh
bash scripts/demo_footage.sh

# The file's header says 10 frames/s; the scene (PETS09-S2L1) was taken at 7.
say "survtrack run demo/vtest.avi --fps 7 --out demo/out --video"
"$VENV/bin/survtrack" run demo/vtest.avi --fps 7 --out demo/out --video
"$VENV/bin/python" scripts/contact_sheet.py demo/out/annotated.mp4 demo/out/contact_sheet.png

cat <<END

Look at
  demo/out/annotated.mp4      the video, with boxes, ids and trails
  demo/out/contact_sheet.png  six frames of it
  demo/out/tracks.txt         the tracks (MOT: frame, id, left, top, width, height, ...)
  demo/out/events.jsonl       what happened, one event a line
END
