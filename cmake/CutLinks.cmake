# Cuts those links of installed Markdown files that lead to what is not installed, such as the sources: their
# text stays. Argument: FOLDER, in which the documents lie as in the repository.

file(GLOB_RECURSE documents "${FOLDER}/*.md")
foreach(document IN LISTS documents)
  cmake_path(GET document PARENT_PATH parent)
  file(READ "${document}" text)
  # Without the square brackets, which would be those of a list.
  string(REGEX MATCHALL "\\([A-Za-z0-9_./-]+(#[^ ()]*)?\\)" links "${text}")
  list(REMOVE_DUPLICATES links)
  set(cut "${text}")
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^\\(([^#)]*).*$" "\\1" target "${link}")
    if(NOT EXISTS "${parent}/${target}")
      string(REGEX REPLACE "([.+*?(){}|^$])" "\\\\\\1" pattern "${link}")
      string(REGEX REPLACE "\\[([^][]*)\\]${pattern}" "\\1" cut "${cut}")
    endif()
  endforeach()
  if(NOT cut STREQUAL text)
    file(WRITE "${document}" "${cut}")
  endif()
endforeach()
