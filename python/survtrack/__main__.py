# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""`python -m survtrack`: the command line."""

import sys

from survtrack.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
