# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The command line: `survtrack run`, `segment`, `link`, `evaluate`, `evaluate-masks`,
`reproduce`, `scene`, `presets`."""
