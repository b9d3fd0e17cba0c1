# The C library of HDF5, serial. CMake's own module compiles C programs to find it, so that each project
# that uses microslip would have to enable C. Defines the target Hdf5::Hdf5.

find_path(Hdf5Library_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(Hdf5Library_LIBRARY NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial)
mark_as_advanced(Hdf5Library_INCLUDE_DIR Hdf5Library_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  Hdf5Library REQUIRED_VARS Hdf5Library_LIBRARY Hdf5Library_INCLUDE_DIR)

if(Hdf5Library_FOUND AND NOT TARGET Hdf5::Hdf5)
  add_library(Hdf5::Hdf5 UNKNOWN IMPORTED)
  set_target_properties(
    Hdf5::Hdf5
    PROPERTIES IMPORTED_LOCATION "${Hdf5Library_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${Hdf5Library_INCLUDE_DIR}")
endif()
