# The installed package: library, headers, program, and the files that find_package and pkg-config
# read. Two components: `library` is what a project needs that links microslip, `program` what its user
# needs. What Debian keeps in other places is in `plain`; MicroslipPackage.cmake installs it there.

include(CMakePackageConfigHelpers)

set(microslip_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/microslip")

# The library.

install(
  TARGETS microslip
  EXPORT microslipTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT library)

install(
  EXPORT microslipTargets
  NAMESPACE microslip::
  DESTINATION "${microslip_package_dir}"
  COMPONENT library)

# A static library leaves the linking of fmt, TBB, HDF5, matio and zlib to its user; a shared one
# has done it, and no header of microslip includes theirs.
get_target_property(microslip_type microslip TYPE)
if(microslip_type STREQUAL "STATIC_LIBRARY")
  string(
    JOIN "\n  " microslip_find_dependencies
    "list(APPEND CMAKE_MODULE_PATH \"\${CMAKE_CURRENT_LIST_DIR}\")"
    "find_dependency(fmt ${fmt_VERSION_MAJOR})"
    "find_dependency(TBB CONFIG)"
    "find_dependency(Hdf5Library)"
    "find_dependency(Matio)"
    "find_dependency(ZLIB)"
    "list(REMOVE_ITEM CMAKE_MODULE_PATH \"\${CMAKE_CURRENT_LIST_DIR}\")")
  install(
    FILES "${PROJECT_SOURCE_DIR}/cmake/FindHdf5Library.cmake"
          "${PROJECT_SOURCE_DIR}/cmake/FindMatio.cmake"
    DESTINATION "${microslip_package_dir}"
    COMPONENT library)
  # Debian names the serial HDF5 so beside those of MPI.
  set(microslip_hdf5_module hdf5)
  if(Hdf5Library_LIBRARY MATCHES "hdf5_serial")
    set(microslip_hdf5_module hdf5-serial)
  endif()
  set(microslip_requires_private "fmt tbb matio ${microslip_hdf5_module} zlib")
else()
  set(microslip_find_dependencies "")
  set(microslip_requires_private "")
endif()

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/microslipConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/microslipConfig.cmake"
  INSTALL_DESTINATION "${microslip_package_dir}"
  PATH_VARS CMAKE_INSTALL_BINDIR)

# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/microslipConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)

install(
  FILES "${PROJECT_BINARY_DIR}/microslipConfig.cmake"
        "${PROJECT_BINARY_DIR}/microslipConfigVersion.cmake"
  DESTINATION "${microslip_package_dir}"
  COMPONENT library)

# The prefix is that of the file itself, so that the installed package can be moved.
set(microslip_pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(microslip_pkgconfig_prefix "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH microslip_up "/${microslip_pkgconfig_dir}" "/")
  string(REGEX REPLACE "/$" "" microslip_up "${microslip_up}")
  set(microslip_pkgconfig_prefix "\${pcfiledir}/${microslip_up}")
endif()
cmake_path(APPEND microslip_pkgconfig_libdir "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
cmake_path(APPEND microslip_pkgconfig_includedir "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/microslip.pc.in" "${PROJECT_BINARY_DIR}/microslip.pc"
               @ONLY)
install(
  FILES "${PROJECT_BINARY_DIR}/microslip.pc"
  DESTINATION "${microslip_pkgconfig_dir}"
  COMPONENT library)

# The program, with what its help was made into.

if(TARGET microslip_cli)
  install(TARGETS microslip_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
  install(
    DIRECTORY "${MICROSLIP_DOCUMENTS}/man1"
    DESTINATION "${CMAKE_INSTALL_MANDIR}"
    COMPONENT program)
  install(
    FILES "${MICROSLIP_DOCUMENTS}/bash/microslip"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
    COMPONENT program)
  install(
    FILES "${MICROSLIP_DOCUMENTS}/zsh/_microslip"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions"
    COMPONENT plain)
  # The documents, as they lie in the repository, so that their links lead somewhere.
  install(
    FILES "${PROJECT_SOURCE_DIR}/README.md"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    COMPONENT program)
  install(
    DIRECTORY "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/examples"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    COMPONENT program
    PATTERN "api" EXCLUDE
    PATTERN "Doxyfile.in" EXCLUDE
    PATTERN "words.txt" EXCLUDE)
endif()

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT plain)
foreach(library IN ITEMS plotly uplot) # part of the library, and of each report
  install(
    FILES "${PROJECT_SOURCE_DIR}/third_party/${library}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    COMPONENT plain
    RENAME "LICENSE.${library}")
endforeach()

# After all that documents may lead to.
if(TARGET microslip_cli)
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_DOCDIR BASE_DIRECTORY "\${CMAKE_INSTALL_PREFIX}"
             OUTPUT_VARIABLE microslip_doc_dir)
  install(
    CODE "set(FOLDER \"\$ENV{DESTDIR}${microslip_doc_dir}\")
include(\"${PROJECT_SOURCE_DIR}/cmake/CutLinks.cmake\")"
    COMPONENT program)
endif()
