# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0

# The package an outside project finds with find_package(survtrack). Headers and library are the
# component "development"; the Python module is a component of its own (cpp/bindings).
include(CMakePackageConfigHelpers)
set(survtrack_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/survtrack)

# A minor version may break the binary interface while the major version is 0.
set_target_properties(survtrack PROPERTIES
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

install(TARGETS survtrack EXPORT survtrackTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
          NAMELINK_COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cpp/include/survtrack
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(EXPORT survtrackTargets NAMESPACE survtrack::
  DESTINATION ${survtrack_package_dir} COMPONENT development)

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/survtrackConfig.cmake.in
  ${PROJECT_BINARY_DIR}/survtrackConfig.cmake
  INSTALL_DESTINATION ${survtrack_package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/survtrackConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/survtrackConfig.cmake
  ${PROJECT_BINARY_DIR}/survtrackConfigVersion.cmake
  DESTINATION ${survtrack_package_dir} COMPONENT development)
