# `cmake --build build/release --target package`: Debian packages, microslip with the program, libmicroslip-dev
# with the static library and, as nothing else of ours loads it, the shared one of the C interface with the package of
# Octave, and python3-microslip with the package of Python. Where Debian's tools are missing, or the library is
# shared, an archive of the installed files instead.

set(MICROSLIP_MAINTAINER
    "The microslip authors <microslip@example.org>"
    CACHE STRING "Name and address in the Debian packages")
mark_as_advanced(MICROSLIP_MAINTAINER)

set(CPACK_PACKAGE_NAME microslip)
set(CPACK_PACKAGE_CONTACT "${MICROSLIP_MAINTAINER}")
set(CPACK_PACKAGE_VENDOR "The microslip authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(DPKG_SHLIBDEPS)
if(NOT DPKG_SHLIBDEPS OR NOT microslip_type STREQUAL "STATIC_LIBRARY" OR NOT TARGET microslip_cli)
  set(CPACK_GENERATOR TGZ)
  include(CPack)
  return()
endif()

set(MICROSLIP_COMPONENTS program library)
set(debian_packages microslip libmicroslip-dev)
if(TARGET microslip_python)
  list(APPEND MICROSLIP_COMPONENTS python)
  list(APPEND debian_packages python3-microslip)
endif()

# What Debian wants beside the components of MicroslipInstall.cmake.

set(debian "${PROJECT_SOURCE_DIR}/cmake/debian")
set(debian_changelog "${PROJECT_BINARY_DIR}/debian/changelog.gz")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${debian}/changelog")
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/debian")
execute_process(
  COMMAND gzip -9nc "${debian}/changelog"
  OUTPUT_FILE "${debian_changelog}"
  COMMAND_ERROR_IS_FATAL ANY)

foreach(component package IN ZIP_LISTS MICROSLIP_COMPONENTS debian_packages)
  install(
    FILES "${debian}/copyright" "${debian_changelog}"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT debian_${component}
    EXCLUDE_FROM_ALL)
endforeach()
install(
  FILES "${MICROSLIP_DOCUMENTS}/zsh/_microslip"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions"
  COMPONENT debian_program
  EXCLUDE_FROM_ALL)

if(TARGET microslip_python)
  microslip_install_python(lib/python3/dist-packages/microslip debian_python EXCLUDE_FROM_ALL)
endif()

set(MICROSLIP_MAKES_DEBIAN_PACKAGES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program debian_program library debian_library)
if(TARGET microslip_python)
  list(APPEND CPACK_COMPONENTS_ALL debian_python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME microslip)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# What the program loads while it runs, dpkg-shlibdeps does not see.
get_property(loaded GLOBAL PROPERTY MICROSLIP_LOADED_LIBRARIES)
foreach(library IN LISTS loaded)
  execute_process(
    COMMAND dpkg-query --search "*/${library}"
    OUTPUT_VARIABLE owner
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "^[^:]+" owner "${owner}")
  list(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${owner}")
endforeach()
list(JOIN CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ", " CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS)
# The pictures, and the shared objects of FMUs; without gnuplot or a compiler all else works.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS
    "gnuplot-nox | gnuplot-qt | gnuplot-x11, fonts-dejavu-core, gcc | c-compiler")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "microslip turns the energy that a bolted or frictional joint dissipates
per vibration cycle, measured at rising amplitude, into the slip-force
density of an Iwan model of the joint, with a band of confidence, and
simulates the joint.
.
It reads recordings in CSV, universal (UFF), MATLAB and HDF5 files.")

# The archive holds calls of these libraries, of the versions whose headers it was compiled with.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libmicroslip-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libfmt-dev (>= ${fmt_VERSION_MAJOR}), libfmt-dev (<< ${microslip_next_fmt}), libtbb-dev (>= ${TBB_VERSION_MAJOR}), libhdf5-dev, zlib1g-dev"
)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "microslip, cmake | pkgconf, gfortran, octave")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
    "Headers and static libraries of microslip, with the files by which CMake
(find_package) and pkg-config find them; its interface in C as a shared
library, with a module of Fortran and a package of Octave.")

# The module is of one version of Python.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-microslip)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(TARGET microslip_python)
  math(EXPR microslip_next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${microslip_next_python}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas, python3-scipy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "microslip for Python 3: identifies slip-force densities of bolted and
frictional joints from levels of dissipation or recordings, and predicts
the vibration of structures with such joints. Arrays of NumPy in and out.")

include(CPack)
foreach(component IN LISTS MICROSLIP_COMPONENTS)
  cpack_add_component_group(${component})
  cpack_add_component(${component} GROUP ${component})
  cpack_add_component(debian_${component} GROUP ${component})
endforeach()
