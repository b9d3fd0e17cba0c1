# With CMAKE_UNITY_BUILD the files of each folder of a target are compiled as one: the headers that they
# share, most of the time of a build, are then read once. Names in the unnamed namespaces of a folder must
# differ for that.

function(microslip_compile_folders_as_one target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME group)
    if(group STREQUAL "")
      set(group ${target})
    endif()
    if(source MATCHES "\\.cpp$")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
