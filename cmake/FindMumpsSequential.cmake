# MUMPS without MPI, real numbers in double precision. It comes without a package file for CMake. Defines the
# target MumpsSequential::MumpsSequential. Its libraries have functions of the names of MPI that do nothing:
# nothing that runs on MPI may link it.

find_path(MumpsSequential_INCLUDE_DIR dmumps_c.h)
find_library(MumpsSequential_LIBRARY NAMES dmumps_seq)
find_library(MumpsSequential_COMMON_LIBRARY NAMES mumps_common_seq)
mark_as_advanced(MumpsSequential_INCLUDE_DIR MumpsSequential_LIBRARY MumpsSequential_COMMON_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  MumpsSequential REQUIRED_VARS MumpsSequential_LIBRARY MumpsSequential_COMMON_LIBRARY
                                MumpsSequential_INCLUDE_DIR)

if(MumpsSequential_FOUND AND NOT TARGET MumpsSequential::MumpsSequential)
  add_library(MumpsSequential::MumpsSequential UNKNOWN IMPORTED)
  set_target_properties(
    MumpsSequential::MumpsSequential
    PROPERTIES IMPORTED_LOCATION "${MumpsSequential_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${MumpsSequential_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "${MumpsSequential_COMMON_LIBRARY}")
endif()
