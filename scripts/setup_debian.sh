#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages that are missing.
source "$(dirname "$0")/common.sh"

command -v dpkg-query >/dev/null ||
  fail "this is not Debian; install what scripts/debian-packages.txt lists, then build with pip"

mapfile -t wanted < <(listed scripts/debian-packages.txt)
# Debian's own Python comes without its C headers and, in small images, without venv.
if [[ $("$PYTHON" -c 'import sys; print(sys.base_prefix)') == /usr ]]; then
  wanted+=(python3-dev python3-venv)
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  say "Debian packages: all there"
  exit 0
fi

say "Debian packages to install: ${missing[*]}"
as_root apt-get update -qq
as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" |
  { grep -c '^Setting up' || true; } | sed 's/$/ packages set up/'
