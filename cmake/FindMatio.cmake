# libmatio comes without a package file for CMake. Defines the target Matio::Matio. The static library where
# there is one, so that it uses the HDF5 library that the program has already; Hdf5Library must be found
# before.

find_path(Matio_INCLUDE_DIR matio.h)
find_library(Matio_LIBRARY NAMES libmatio.a matio)
mark_as_advanced(Matio_INCLUDE_DIR Matio_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Matio REQUIRED_VARS Matio_LIBRARY Matio_INCLUDE_DIR)

if(Matio_FOUND AND NOT TARGET Matio::Matio)
  add_library(Matio::Matio UNKNOWN IMPORTED)
  set_target_properties(
    Matio::Matio
    PROPERTIES IMPORTED_LOCATION "${Matio_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${Matio_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "Hdf5::Hdf5;z")
endif()
