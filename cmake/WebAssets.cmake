# The scripts and styles of the HTML report as C++ strings, so that the program needs no file beside it.
# A raw string literal compiles in no time; an array of bytes of this size takes half a minute.

# microslip_add_web_assets(<output>): writes the source file.
function(microslip_add_web_assets output)
  set(third_party "${PROJECT_SOURCE_DIR}/third_party")
  set(web "${PROJECT_SOURCE_DIR}/src/microslip/report/web")
  # Read in this order: each adds to what the ones before it define.
  set(scripts
      "${web}/theme.js"
      "${web}/table.js"
      "${web}/plot_chart.js"
      "${web}/time_chart.js"
      "${web}/figure.js"
      "${web}/report.js")
  set(MICROSLIP_WEB_ASSETS "")
  foreach(
    asset IN
    ITEMS "kPlotlyScript|${third_party}/plotly/plotly-cartesian.min.js"
          "kUplotScript|${third_party}/uplot/uPlot.iife.min.js"
          "kReportScript|${scripts}"
          "kUplotStyle|${third_party}/uplot/uPlot.min.css"
          "kReportStyle|${web}/report.css"
          "kPlotlyLicence|${third_party}/plotly/LICENSE"
          "kUplotLicence|${third_party}/uplot/LICENSE")
    string(FIND "${asset}" "|" bar)
    string(SUBSTRING "${asset}" 0 ${bar} name)
    math(EXPR bar "${bar} + 1")
    string(SUBSTRING "${asset}" ${bar} -1 files)
    _microslip_read_assets("${files}" text)
    string(SHA256 hash "${text}")
    string(APPEND MICROSLIP_WEB_ASSETS
           "const WebAsset ${name}{R\"asset(${text})asset\",\n    \"${hash}\"};\n")
  endforeach()
  file(READ "${third_party}/package.json" package)
  string(JSON plotly GET "${package}" dependencies plotly.js-cartesian-dist-min)
  string(JSON uplot GET "${package}" dependencies uplot)
  set(MICROSLIP_WEB_LIBRARIES "plotly.js ${plotly}, uPlot ${uplot}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${third_party}/package.json")
  configure_file("${PROJECT_SOURCE_DIR}/src/microslip/report/page/web_assets.cpp.in" "${output}" @ONLY)
endfunction()

# The texts of some files one after the other. A browser takes a carriage return for a line feed, and
# the hash of what it reads would be another one.
function(_microslip_read_assets files result)
  set(text "")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" content)
    string(FIND "${content}" "\r" carriage_return)
    string(FIND "${content}" ")asset\"" end_of_literal)
    string(REGEX MATCH "</(script|style)|<!--" end_of_element "${content}")
    if(NOT carriage_return EQUAL -1 OR NOT end_of_literal EQUAL -1 OR end_of_element)
      message(FATAL_ERROR "${file} cannot stand inside of an HTML element as it is.")
    endif()
    string(APPEND text "${content}")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
