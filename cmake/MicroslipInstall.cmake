# The installed package: library, headers, program, and the files that find_package reads.

include(CMakePackageConfigHelpers)

set(microslip_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/microslip")

install(
  TARGETS microslip
  EXPORT microslipTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")

if(TARGET microslip_cli)
  install(TARGETS microslip_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

install(
  EXPORT microslipTargets
  NAMESPACE microslip::
  DESTINATION "${microslip_package_dir}")

# A static library leaves the linking of fmt, TBB, HDF5, matio and zlib to its user; a shared one
# has done it.
get_target_property(microslip_type microslip TYPE)
if(microslip_type STREQUAL "STATIC_LIBRARY")
  string(
    JOIN "\n" microslip_find_dependencies
    "list(APPEND CMAKE_MODULE_PATH \"\${CMAKE_CURRENT_LIST_DIR}\")"
    "find_dependency(fmt)"
    "find_dependency(TBB CONFIG)"
    "find_dependency(Hdf5Library)"
    "find_dependency(Matio)"
    "find_dependency(ZLIB)")
  install(FILES "${PROJECT_SOURCE_DIR}/cmake/FindHdf5Library.cmake"
                "${PROJECT_SOURCE_DIR}/cmake/FindMatio.cmake"
          DESTINATION "${microslip_package_dir}")
else()
  set(microslip_find_dependencies "")
endif()

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/microslipConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/microslipConfig.cmake"
  INSTALL_DESTINATION "${microslip_package_dir}")

# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/microslipConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)

install(
  FILES "${PROJECT_BINARY_DIR}/microslipConfig.cmake"
        "${PROJECT_BINARY_DIR}/microslipConfigVersion.cmake"
  DESTINATION "${microslip_package_dir}")
