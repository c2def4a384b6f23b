# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0

# The flags of every target of ours, as an interface target.
add_library(survtrack_settings INTERFACE)
target_compile_features(survtrack_settings INTERFACE cxx_std_20)
target_compile_options(survtrack_settings INTERFACE
  -Wall -Wextra -Wconversion -Wshadow
  # Same bytes everywhere: no fused multiply-add and no reassociation.
  -ffp-contract=off
  # Without these gcc does not vectorise float pixel loops; they change no result.
  -fno-math-errno -fno-trapping-math)
if(SURVTRACK_WARNINGS_AS_ERRORS)
  target_compile_options(survtrack_settings INTERFACE -Werror)
endif()
if(SURVTRACK_SANITIZE)
  target_compile_options(survtrack_settings INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(survtrack_settings INTERFACE -fsanitize=address,undefined)
endif()
