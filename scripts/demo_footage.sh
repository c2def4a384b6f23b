#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Puts vtest.avi into demo/: OpenCV's sample of people crossing a campus, from the Debian package
# opencv-doc, which is downloaded (96 MB) and not installed.
source "$(dirname "$0")/common.sh"
FOOTAGE=demo/vtest.avi
IN_PACKAGE=./usr/share/doc/opencv-doc/examples/data/vtest.avi

if [ -f "$FOOTAGE" ]; then
  say "footage: $FOOTAGE is there"
  exit 0
fi

say "footage: vtest.avi out of Debian's package opencv-doc (96 MB)"
mkdir -p demo
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
download() {
  # As root apt would hand over to a user who may not write here.
  (cd "$folder" && apt-get download -qq -o APT::Sandbox::User="$(id -un)" opencv-doc)
}
download 2>/dev/null || { as_root apt-get update -qq && download; }
dpkg-deb --fsys-tarfile "$folder"/opencv-doc_*.deb | tar --extract --to-stdout "$IN_PACKAGE" \
  >"$FOOTAGE.part"
mv "$FOOTAGE.part" "$FOOTAGE"
