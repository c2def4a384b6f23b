# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0

# Compiles presets/*.toml into the library: writes a source with one raw string a file.
function(survtrack_embed_presets output)
  file(GLOB presets CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/presets/*.toml)
  list(SORT presets)
  set(entries "")
  foreach(preset IN LISTS presets)
    get_filename_component(name ${preset} NAME_WE)
    file(READ ${preset} text)
    string(APPEND entries "    {\"${name}\", R\"preset(${text})preset\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${preset})
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Made from presets/*.toml by cmake/Presets.cmake.
#include \"pipeline/embedded_presets.hpp\"

namespace survtrack {

const std::vector<EmbeddedPreset>& embedded_presets() {
  static const std::vector<EmbeddedPreset> presets = {
@entries@  };
  return presets;
}

}  // namespace survtrack
")
endfunction()
