# The installed package: library, headers, program, and the files that find_package and pkg-config
# read. Two components: `library` is what a project needs that links microslip, `program` what its user
# needs. What Debian keeps in other places is in `plain`; MicroslipPackage.cmake installs it there.

include(CMakePackageConfigHelpers)

set(microslip_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/microslip")

# The library: each part as an export set of its own, so that who asks for one needs nothing of the others.

get_property(microslip_parts GLOBAL PROPERTY MICROSLIP_PARTS)
foreach(part IN LISTS microslip_parts)
  install(
    TARGETS microslip_${part}
    EXPORT microslip_${part}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library)
  install(
    EXPORT microslip_${part}
    FILE microslip-${part}.cmake
    NAMESPACE microslip::
    DESTINATION "${microslip_package_dir}"
    COMPONENT library)
endforeach()
# What the library starts to read files of HDF5.
if(MICROSLIP_WITH_HDF5)
  install(
    TARGETS microslip_hdf5_reader
    RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/microslip" COMPONENT program)
  if(BUILD_SHARED_LIBS)
    set_target_properties(microslip_hdf5_reader PROPERTIES INSTALL_RPATH
                                                           "$ORIGIN/../../${CMAKE_INSTALL_LIBDIR}")
  endif()
endif()
get_property(microslip_folders GLOBAL PROPERTY MICROSLIP_FOLDERS)
foreach(folder IN LISTS microslip_folders)
  string(REPLACE "/" "_" target "${folder}")
  get_property(headers TARGET microslip_folder_${target} PROPERTY MICROSLIP_PUBLIC_HEADERS)
  install(
    FILES ${headers}
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/microslip/${folder}"
    COMPONENT library)
  # Where they were before.
  get_property(headers TARGET microslip_folder_${target} PROPERTY MICROSLIP_FORMER_HEADERS)
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH former)
    install(
      FILES "${PROJECT_BINARY_DIR}/include/${target}/former/${header}"
      DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${former}"
      COMPONENT library)
  endforeach()
endforeach()

# The C interface: a shared library, whatever the others are, as those who load it from other languages need.
if(TARGET microslip_c)
  install(
    TARGETS microslip_c
    EXPORT microslip_c
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library)
  install(
    EXPORT microslip_c
    FILE microslip-c.cmake
    NAMESPACE microslip::
    DESTINATION "${microslip_package_dir}"
    COMPONENT library)
  install(
    FILES "${PROJECT_SOURCE_DIR}/src/microslip/bindings/c/microslip.h"
          "${PROJECT_BINARY_DIR}/include/bindings_c/public/microslip.f90"
          "${PROJECT_BINARY_DIR}/include/bindings_c/public/microslip_version.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    COMPONENT library)
endif()

# A static library leaves the linking of fmt, TBB, HDF5 and zlib to its user; a shared one
# has done it, and no header of microslip includes theirs.
get_target_property(microslip_type microslip_core TYPE)
if(microslip_type STREQUAL "STATIC_LIBRARY")
  set(microslip_is_static TRUE)
  set(microslip_requires_private "fmt tbb")
  if(MICROSLIP_WITH_HDF5)
    install(
      FILES "${PROJECT_SOURCE_DIR}/cmake/FindHdf5Library.cmake"
      DESTINATION "${microslip_package_dir}"
      COMPONENT library)
    # Debian names the serial HDF5 so beside those of MPI.
    set(microslip_hdf5_module hdf5)
    if(Hdf5Library_SHARED_LIBRARY MATCHES "hdf5_serial")
      set(microslip_hdf5_module hdf5-serial)
    endif()
    string(APPEND microslip_requires_private " ${microslip_hdf5_module}")
  endif()
  if(MICROSLIP_WITH_MODES)
    install(
      FILES "${PROJECT_SOURCE_DIR}/cmake/FindMumpsSequential.cmake"
      DESTINATION "${microslip_package_dir}"
      COMPONENT library)
  endif()
  if(MICROSLIP_WITH_MAT)
    string(APPEND microslip_requires_private " zlib")
  endif()
else()
  set(microslip_is_static FALSE)
  set(microslip_requires_private "")
endif()

# The calls of fmt in the archive are those of its version when it was compiled.
math(EXPR microslip_next_fmt "${fmt_VERSION_MAJOR} + 1")
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
if(TARGET microslip_c)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/microslip-c.pc.in" "${PROJECT_BINARY_DIR}/microslip-c.pc" @ONLY)
  install(
    FILES "${PROJECT_BINARY_DIR}/microslip-c.pc"
    DESTINATION "${microslip_pkgconfig_dir}"
    COMPONENT library)
endif()

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

# The package of Python: what is compiled, the files beside it, and what reads files of HDF5 for it. Debian has
# another place for it, see MicroslipPackage.cmake.
if(TARGET microslip_python)
  set(microslip_python_default
      "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages/microslip")
  set(MICROSLIP_PYTHON_DIR "${microslip_python_default}" CACHE PATH "Where the package of Python is installed")
  mark_as_advanced(MICROSLIP_PYTHON_DIR)
  # microslip_install_python(<folder> <component> [EXCLUDE_FROM_ALL])
  function(microslip_install_python folder component)
    install(TARGETS microslip_python LIBRARY DESTINATION "${folder}" COMPONENT ${component} ${ARGN})
    install(
      DIRECTORY "${PROJECT_SOURCE_DIR}/src/microslip/bindings/python/microslip/"
      DESTINATION "${folder}"
      COMPONENT ${component} ${ARGN}
      FILES_MATCHING
      PATTERN "*.py"
      PATTERN "*.pyi"
      PATTERN "py.typed"
      PATTERN "__pycache__" EXCLUDE)
    if(MICROSLIP_WITH_HDF5)
      install(
        PROGRAMS "$<TARGET_FILE:microslip_hdf5_reader>"
        DESTINATION "${folder}"
        COMPONENT ${component} ${ARGN})
    endif()
  endfunction()
  microslip_install_python("${MICROSLIP_PYTHON_DIR}" python)
endif()

# What needs MPI, by itself: nobody has to install that for the rest.
if(TARGET microslip_mpi)
  install(TARGETS microslip_mpi RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT mpi)
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
