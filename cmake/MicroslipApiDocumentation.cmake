# The documentation of the C++ interface: target api_documentation, where there is a Doxygen.
# docs/Doxyfile.in says how; what is read are the headers that are installed.

find_program(DOXYGEN_PROGRAM doxygen)
mark_as_advanced(DOXYGEN_PROGRAM)

set(MICROSLIP_API_DOCUMENTATION "${PROJECT_BINARY_DIR}/api_documentation")
set(MICROSLIP_DOXYFILE "${PROJECT_BINARY_DIR}/Doxyfile")

get_property(microslip_folders GLOBAL PROPERTY MICROSLIP_FOLDERS)
set(MICROSLIP_API_INPUT "")
foreach(folder IN LISTS microslip_folders)
  string(REPLACE "/" "_" target "${folder}")
  get_property(headers TARGET microslip_folder_${target} PROPERTY MICROSLIP_PUBLIC_HEADERS)
  foreach(file IN LISTS headers)
    string(APPEND MICROSLIP_API_INPUT " \\\n  \"${file}\"")
  endforeach()
endforeach()
string(APPEND MICROSLIP_API_INPUT " \\\n  \"${PROJECT_SOURCE_DIR}/src/microslip/bindings/c/microslip.h\"")
configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${MICROSLIP_DOXYFILE}" @ONLY)

if(DOXYGEN_PROGRAM)
  add_custom_target(
    api_documentation
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${MICROSLIP_API_DOCUMENTATION}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${MICROSLIP_API_DOCUMENTATION}"
    COMMAND "${DOXYGEN_PROGRAM}" "${MICROSLIP_DOXYFILE}"
    COMMENT "Writing ${MICROSLIP_API_DOCUMENTATION}/html/index.html"
    VERBATIM)
endif()
