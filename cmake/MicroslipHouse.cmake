# The house, kept by the compiler and the linker. Each folder of src/microslip is a target whose include
# paths lead to its own headers and to the public ones of the folders that it uses, so that an arrow
# against the order, or another folder's private header, is a file that the compiler does not find. Parts
# are what is linked: one library of one or more folders.
#
# A folder below another is called by both, as io/uff, and is one like any other: what lies in io/ is no folder
# itself then, but io stands for all of its folders where a part or a test names it. Target names have `_` for `/`.
#
# What lies on the include paths are files of one line in the build tree, each of which includes the header
# of its name: the headers themselves lie beside their sources, public and private in one folder.

# microslip_add_folder(<name>
#   [NUMERIC]               its loops take the time of users: optimised most, which takes the compiler longest
#   [LIGHT]                 its own work takes no time to speak of: optimised least
#   [JOBS <count>]          with CMAKE_UNITY_BUILD: compiled as so many files, 1 unless given
#   [USES <folder>...]      whose public headers this one may include
#   [WAS <folder>]          where its public headers were: who links the library still finds them there
#   [MOVED <header> <path> ...]  that header was there, under another name or in another folder
#   [LINKS <target>...]     libraries outside of this project, for the folder alone
#   PUBLIC <header>...      installed, and seen by who uses the folder
#   [INTERNAL <header>...]  seen by other folders, but not installed
#   PRIVATE <file>...)      sources, and headers for the folder alone
function(microslip_add_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 folder "NUMERIC;LIGHT" "JOBS;WAS"
                        "USES;MOVED;LINKS;PUBLIC;INTERNAL;PRIVATE")
  string(REPLACE "/" "_" target "${name}")
  set(tree "${PROJECT_BINARY_DIR}/include/${target}")

  set(private_headers ${folder_PRIVATE})
  list(FILTER private_headers INCLUDE REGEX "\\.hpp$")
  _microslip_make_absolute(private_headers)
  set(public_headers ${folder_PUBLIC})
  _microslip_make_absolute(public_headers)
  set(internal_headers ${folder_INTERNAL})
  _microslip_make_absolute(internal_headers)
  _microslip_forward_headers("${tree}/public/microslip/${name}" ${public_headers} ${internal_headers})
  _microslip_forward_headers("${tree}/private/microslip/${name}" ${private_headers})

  _microslip_former_headers(former_headers "${tree}/former" ${name} "${folder_WAS}" "${folder_PUBLIC}"
                            "${folder_MOVED}")

  add_library(microslip_headers_${target} INTERFACE)
  target_compile_features(microslip_headers_${target} INTERFACE cxx_std_20)
  target_include_directories(microslip_headers_${target} INTERFACE "${tree}/public")
  list(TRANSFORM folder_USES REPLACE "/" "_")
  list(TRANSFORM folder_USES PREPEND microslip_headers_)
  target_link_libraries(microslip_headers_${target} INTERFACE ${folder_USES})

  _microslip_taken_objects(taken ${name})
  if(taken)
    list(FILTER folder_PRIVATE EXCLUDE REGEX "\\.cpp$")
  endif()
  add_library(microslip_folder_${target} OBJECT ${folder_PRIVATE} ${folder_PUBLIC} ${folder_INTERNAL})
  get_property(several GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG) # each has objects of its own
  if(MICROSLIP_BUILD_TESTS AND NOT taken AND NOT several)
    file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/objects/${target}.objects"
         CONTENT "$<JOIN:$<TARGET_OBJECTS:microslip_folder_${target}>,\n>\n")
  endif()
  target_include_directories(microslip_folder_${target} PRIVATE "${tree}/private")
  target_link_libraries(microslip_folder_${target} PRIVATE microslip_headers_${target} ${folder_LINKS})
  # Nobody replaces a function of the library by one of another: GCC may inline position-independent ones, as
  # Clang does.
  target_compile_options(microslip_folder_${target}
                         PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  if("${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-O3" AND NOT folder_NUMERIC) # less only than what was asked for
    target_compile_options(microslip_folder_${target}
                           PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${folder_LIGHT}>,-O1,-O2>>)
  endif()
  set(batch 0) # all
  if(folder_JOBS)
    set(sources ${folder_PRIVATE})
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(LENGTH sources count)
    math(EXPR batch "(${count} + ${folder_JOBS} - 1) / ${folder_JOBS}")
  endif()
  set_target_properties(
    microslip_folder_${target}
    PROPERTIES POSITION_INDEPENDENT_CODE ON
               LINKER_LANGUAGE CXX # of one that holds headers alone, too
               UNITY_BUILD_BATCH_SIZE ${batch}
               MICROSLIP_TAKEN_OBJECTS "${taken}"
               MICROSLIP_PUBLIC_HEADERS "${public_headers}"
               MICROSLIP_FORMER_HEADERS "${former_headers}")
  set_property(GLOBAL APPEND PROPERTY MICROSLIP_FOLDERS ${name})
endfunction()

# microslip_add_part(<name>
#   FOLDERS <folder>...     or what lies above folders: all of them
#   [USES <part>...]        linked by who links this part
#   [LINKS <target>...])    libraries outside of this project that have to be linked
# The library microslip_<name>, as microslip::<name> here and where it is installed.
function(microslip_add_part name)
  cmake_parse_arguments(PARSE_ARGV 1 part "" "" "FOLDERS;USES;LINKS")
  set(library microslip_${name})
  foreach(folder IN LISTS part_FOLDERS)
    microslip_folders_below(below ${folder})
    if(NOT below)
      message(FATAL_ERROR "There is no folder ${folder} in src/microslip.")
    endif()
  endforeach()
  microslip_folders_below(part_FOLDERS ${part_FOLDERS})
  list(TRANSFORM part_FOLDERS REPLACE "/" "_")
  add_library(${library})
  # Of a template that several objects hold the linker takes the first: what is compiled here before what is taken.
  set(last "")
  foreach(folder IN LISTS part_FOLDERS)
    get_target_property(taken microslip_folder_${folder} MICROSLIP_TAKEN_OBJECTS)
    if(taken)
      list(APPEND last ${folder})
    else()
      _microslip_add_objects(${library} ${folder})
    endif()
  endforeach()
  foreach(folder IN LISTS last)
    _microslip_add_objects(${library} ${folder})
  endforeach()
  add_library(microslip::${name} ALIAS ${library})
  target_compile_features(${library} INTERFACE cxx_std_20)
  set_target_properties(${library} PROPERTIES MICROSLIP_FOLDERS "${part_FOLDERS}"
                                              MICROSLIP_USES "${part_USES}" MICROSLIP_LINKS "${part_LINKS}")
  list(TRANSFORM part_USES PREPEND microslip_)
  target_link_libraries(${library} PUBLIC ${part_USES} PRIVATE ${part_LINKS})
  target_include_directories(${library} INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  set_target_properties(
    ${library}
    PROPERTIES EXPORT_NAME ${name}
               LINKER_LANGUAGE CXX
               VERSION "${PROJECT_VERSION}"
               SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  foreach(folder IN LISTS part_FOLDERS)
    target_include_directories(
      ${library} INTERFACE "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/${folder}/public>"
                           "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/${folder}/former>")
  endforeach()
  if(BUILD_SHARED_LIBS)
    set_target_properties(${library} PROPERTIES INSTALL_RPATH "$ORIGIN") # the other parts lie beside it
    target_link_options(${library} PRIVATE -Wl,--no-undefined)
  endif()
  set_property(GLOBAL APPEND PROPERTY MICROSLIP_PARTS ${name})
endfunction()

# microslip_link_into_shared(<target> PARTS <part>... EXPORTS <pattern>...)
# All of these parts and what they use, for a shared object that other programs load: a module of Python, a library
# with a C interface. Of a static build the objects themselves, with the shared HDF5, as Debian's static one is
# not position-independent. `EXPORTS` names what the loading program sees; all else stays inside.
function(microslip_link_into_shared target)
  cmake_parse_arguments(PARSE_ARGV 1 shared "" "" "PARTS;EXPORTS")
  if(BUILD_SHARED_LIBS)
    list(TRANSFORM shared_PARTS PREPEND microslip::)
    target_link_libraries(${target} PRIVATE ${shared_PARTS})
  else()
    _microslip_parts_below(parts ${shared_PARTS})
    foreach(part IN LISTS parts)
      get_target_property(folders microslip_${part} MICROSLIP_FOLDERS)
      get_target_property(links microslip_${part} MICROSLIP_LINKS)
      string(REPLACE "Hdf5::Hdf5" "Hdf5::Shared" links "${links}")
      foreach(folder IN LISTS folders)
        _microslip_add_objects(${target} ${folder})
        target_link_libraries(${target} PRIVATE microslip_headers_${folder})
      endforeach()
      target_link_libraries(${target} PRIVATE ${links})
    endforeach()
  endif()
  list(JOIN shared_EXPORTS ";\n    " exports)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${target}.map"
       CONTENT "{\n  global:\n    ${exports};\n  local:\n    *;\n};\n")
  target_link_options(${target} PRIVATE "-Wl,--version-script=${CMAKE_CURRENT_BINARY_DIR}/${target}.map"
                      -Wl,--gc-sections)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${CMAKE_CURRENT_BINARY_DIR}/${target}.map")
endfunction()

# microslip_prefer_parts(<target> <part>...)
# An executable takes what these parts and those that they use have compiled before what its own objects have. Of a
# template or an inline function that both hold the linker keeps the first, in the order of its command, and that of
# an object which is little optimised (a test, a subcommand) would slow the library down: pexp() of Eigen by four
# times.
function(microslip_prefer_parts target)
  if(BUILD_SHARED_LIBS) # nothing to choose between at that time
    return()
  endif()
  _microslip_parts_below(parts ${ARGN})
  list(REVERSE parts) # what computes first
  list(TRANSFORM parts REPLACE "(.+)" "$<TARGET_FILE:microslip_\\1>")
  list(JOIN parts " " files)
  target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive ${files} -Wl,--no-whole-archive")
endfunction()

# microslip_folders_below(<variable> <name>...)
# The folders of these names, and those that lie in one of them, in the order in which they were added.
function(microslip_folders_below variable)
  get_property(all GLOBAL PROPERTY MICROSLIP_FOLDERS)
  set(folders "")
  foreach(name IN LISTS ARGN)
    set(below ${all})
    list(FILTER below INCLUDE REGEX "^${name}(/|$)")
    list(APPEND folders ${below})
  endforeach()
  set(${variable} ${folders} PARENT_SCOPE)
endfunction()

# microslip_private_trees(<variable> <name>...)
# The include paths of the private headers of these folders, for their tests.
function(microslip_private_trees variable)
  microslip_folders_below(folders ${ARGN})
  list(TRANSFORM folders REPLACE "/" "_")
  list(TRANSFORM folders REPLACE "(.+)" "${PROJECT_BINARY_DIR}/include/\\1/private")
  set(${variable} ${folders} PARENT_SCOPE)
endfunction()

# microslip_private_headers(<target> <folder> <header>...)
# Headers of a folder below bindings, for that target alone.
function(microslip_private_headers target folder)
  set(tree "${PROJECT_BINARY_DIR}/include/bindings_${folder}/private")
  set(headers ${ARGN})
  _microslip_make_absolute(headers)
  _microslip_forward_headers("${tree}/microslip/bindings/${folder}" ${headers})
  target_include_directories(${target} PRIVATE "${tree}")
endfunction()

# The object files of a folder in the other build tree, where MICROSLIP_TAKEN_FOLDERS has it taken from there and it
# is compiled: what another compiler would only compile once more. Empty otherwise.
function(_microslip_taken_objects variable name)
  set(objects "")
  string(REGEX MATCH "^[^/]+" room "${name}")
  string(REPLACE "/" "_" target "${name}")
  set(list "${MICROSLIP_TEST_OBJECTS}/objects/${target}.objects")
  if(room IN_LIST MICROSLIP_TAKEN_FOLDERS AND EXISTS "${list}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list}")
    file(STRINGS "${list}" objects)
    foreach(object IN LISTS objects)
      if(NOT EXISTS "${object}")
        set(objects "")
        break()
      endif()
    endforeach()
  endif()
  set(${variable} ${objects} PARENT_SCOPE)
endfunction()

# Links the objects of a folder, its own or those taken from another build tree.
function(_microslip_add_objects target folder)
  get_target_property(taken microslip_folder_${folder} MICROSLIP_TAKEN_OBJECTS)
  if(taken)
    target_sources(${target} PRIVATE ${taken})
    set_source_files_properties(${taken} TARGET_DIRECTORY ${target} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  else()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:microslip_folder_${folder}>)
  endif()
endfunction()

# The parts and those that they use, directly or not.
function(_microslip_parts_below list)
  set(parts ${ARGN})
  foreach(part IN LISTS ARGN)
    get_target_property(uses microslip_${part} MICROSLIP_USES)
    if(uses)
      _microslip_parts_below(below ${uses})
      list(APPEND parts ${below})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES parts)
  set(${list} ${parts} PARENT_SCOPE)
endfunction()

# Writes the files of one line for `headers` into a folder and removes those of headers that are no more.
function(_microslip_forward_headers into)
  file(GLOB stale RELATIVE "${into}" "${into}/*")
  foreach(header IN LISTS ARGN)
    cmake_path(GET header FILENAME file)
    file(CONFIGURE OUTPUT "${into}/${file}" CONTENT "#include \"${header}\"\n")
    list(REMOVE_ITEM stale "${file}")
  endforeach()
  list(TRANSFORM stale PREPEND "${into}/")
  if(stale)
    file(REMOVE ${stale})
  endif()
endfunction()

# Writes a file of one line at each path where a public header of a folder was, and removes those of headers that
# are no more. `list` takes the paths as they are included.
function(_microslip_former_headers list into name was headers moved)
  set(paths "")
  file(GLOB_RECURSE stale RELATIVE "${into}" "${into}/*")
  if(was)
    foreach(header IN LISTS headers)
      list(FIND moved "${header}" at)
      if(at EQUAL -1)
        list(APPEND moved "${header}" "${was}/${header}")
      endif()
    endforeach()
  endif()
  while(moved)
    list(POP_FRONT moved header path)
    file(CONFIGURE OUTPUT "${into}/microslip/${path}" CONTENT "#include \"microslip/${name}/${header}\"\n")
    list(APPEND paths "microslip/${path}")
  endwhile()
  if(stale AND paths)
    list(REMOVE_ITEM stale ${paths})
  endif()
  list(TRANSFORM stale PREPEND "${into}/")
  if(stale)
    file(REMOVE ${stale})
  endif()
  set(${list} ${paths} PARENT_SCOPE)
endfunction()

function(_microslip_make_absolute list)
  set(paths "")
  foreach(path IN LISTS ${list})
    cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    list(APPEND paths "${path}")
  endforeach()
  set(${list} "${paths}" PARENT_SCOPE)
endfunction()
