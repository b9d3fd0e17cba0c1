# The C library of HDF5, serial. CMake's own module compiles C programs to find it, so that each project
# that uses microslip would have to enable C. Defines the target Hdf5::Hdf5, and Hdf5::Shared, the shared
# library where there is one, whatever the first is.
#
# The static library where there is one: of Debian's shared one a program takes over curl, Kerberos and
# some thirty more, for files on the web that nothing here reads. What becomes a shared library itself
# takes the shared one, for Debian's static one is not position-independent: set Hdf5Library_USE_STATIC to
# OFF.

set(Hdf5Library_USE_STATIC "" CACHE STRING "Link HDF5 statically: ON, OFF, or empty for what is usual")
set(Hdf5Library_static "${Hdf5Library_USE_STATIC}")
if(Hdf5Library_static STREQUAL "" AND NOT BUILD_SHARED_LIBS)
  set(Hdf5Library_static ON)
endif()

find_path(Hdf5Library_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(Hdf5Library_SHARED_LIBRARY NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial)
find_library(Hdf5Library_STATIC_LIBRARY libhdf5.a PATH_SUFFIXES hdf5/serial)
find_library(Hdf5Library_SZIP_LIBRARY libsz.a)
find_library(Hdf5Library_AEC_LIBRARY libaec.a)
mark_as_advanced(
  Hdf5Library_USE_STATIC Hdf5Library_INCLUDE_DIR Hdf5Library_SHARED_LIBRARY
  Hdf5Library_STATIC_LIBRARY Hdf5Library_SZIP_LIBRARY Hdf5Library_AEC_LIBRARY)

set(Hdf5Library_LIBRARY "${Hdf5Library_SHARED_LIBRARY}")
set(Hdf5Library_BEHIND "")
if(Hdf5Library_static
   AND Hdf5Library_STATIC_LIBRARY
   AND Hdf5Library_SZIP_LIBRARY
   AND Hdf5Library_AEC_LIBRARY)
  set(Hdf5Library_LIBRARY "${Hdf5Library_STATIC_LIBRARY}")
  set(Hdf5Library_BEHIND "${Hdf5Library_SZIP_LIBRARY}" "${Hdf5Library_AEC_LIBRARY}" z
                         ${CMAKE_DL_LIBS} m)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  Hdf5Library REQUIRED_VARS Hdf5Library_LIBRARY Hdf5Library_INCLUDE_DIR)

if(Hdf5Library_FOUND AND NOT TARGET Hdf5::Hdf5)
  add_library(Hdf5::Hdf5 UNKNOWN IMPORTED)
  set_target_properties(
    Hdf5::Hdf5
    PROPERTIES IMPORTED_LOCATION "${Hdf5Library_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${Hdf5Library_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "${Hdf5Library_BEHIND}")
endif()
if(Hdf5Library_FOUND AND Hdf5Library_SHARED_LIBRARY AND NOT TARGET Hdf5::Shared)
  add_library(Hdf5::Shared UNKNOWN IMPORTED)
  set_target_properties(
    Hdf5::Shared
    PROPERTIES IMPORTED_LOCATION "${Hdf5Library_SHARED_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${Hdf5Library_INCLUDE_DIR}")
endif()
