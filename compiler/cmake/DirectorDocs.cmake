# SPDX-License-Identifier: MIT
# director_add_docs(<target> <file.yaml>... [FORMAT html|markdown] [OUTPUT <folder>] [LINK <address>] [BUILD <folder>] [BOUND <states>])
#
# Adds the target <target>, which is built only on request. It calls `directorc docs`, which writes a page about each behaviour, and does not rewrite
# a page whose content is the same.
#
#   FORMAT    html, the default: one file that needs no other; or markdown
#   OUTPUT    folder of the pages, relative to the current build folder; the default is <target>
#   BUILD     folder with compile_commands.json, for states whose values are those of a C++ enum; relative to the current build folder
#   LINK      address of a line, with {file} and {line} in it. Each place that a page names becomes a link
#   BOUND     decides the assertions within so many states instead of 100000 (directorc docs --bound)
#
# HTML needs the program dot of Graphviz.

cmake_policy(PUSH)
cmake_policy(VERSION 3.20...3.25)

function(director_add_docs)
  set(usage "director_add_docs(<target> <file.yaml>... [FORMAT html|markdown] [OUTPUT <folder>] [LINK <address>] [BUILD <folder>] [BOUND <states>])")
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "FORMAT;OUTPUT;LINK;BUILD;BOUND" "")
  list(LENGTH arg_UNPARSED_ARGUMENTS count)
  if(count LESS 2)
    message(FATAL_ERROR "director_add_docs: the target and a behaviour's file are needed: ${usage}")
  endif()
  foreach(keyword FORMAT OUTPUT LINK BUILD BOUND)
    if("${keyword}" IN_LIST ARGV AND "${arg_${keyword}}" STREQUAL "") # also an empty value, such as a variable that is not set
      message(FATAL_ERROR "director_add_docs: nothing stands behind ${keyword}: ${usage}")
    endif()
  endforeach()
  if("BOUND" IN_LIST ARGV AND NOT arg_BOUND MATCHES "^[1-9][0-9]*$")
    message(FATAL_ERROR "director_add_docs: BOUND needs a number of states, such as 1000000: ${usage}")
  endif()
  if(NOT arg_FORMAT)
    set(arg_FORMAT html)
  endif()
  if(NOT arg_FORMAT MATCHES "^(html|markdown)$")
    message(FATAL_ERROR "director_add_docs: there is no format ${arg_FORMAT}: ${usage}")
  endif()
  list(POP_FRONT arg_UNPARSED_ARGUMENTS target)
  if(TARGET ${target})
    message(FATAL_ERROR "director_add_docs: there is a target ${target} already; the pages are a target of their own")
  endif()
  set(files "")
  foreach(given IN LISTS arg_UNPARSED_ARGUMENTS)
    cmake_path(ABSOLUTE_PATH given BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE file)
    if(NOT EXISTS ${file} OR IS_DIRECTORY ${file})
      cmake_path(IS_ABSOLUTE given is_absolute)
      if(is_absolute)
        message(FATAL_ERROR "director_add_docs: there is no file ${file}; it must exist when CMake configures")
      endif()
      message(FATAL_ERROR "director_add_docs: there is no file ${file}; a relative path begins at the folder of the CMakeLists.txt that calls")
    endif()
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_SOURCE_DIR}) # findings and links on the page contain this path
    list(APPEND files ${file})
  endforeach()
  if(NOT arg_OUTPUT)
    set(arg_OUTPUT ${target})
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE OUTPUT_VARIABLE folder)
  set(link "")
  if(arg_LINK)
    string(REPLACE ";" "$<SEMICOLON>" link "--link=${arg_LINK}") # else the command would have an argument for each part
  endif()
  set(build "")
  if(arg_BUILD)
    cmake_path(ABSOLUTE_PATH arg_BUILD BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
    set(build --build ${arg_BUILD})
  endif()
  set(bound "")
  if(arg_BOUND)
    set(bound --bound=${arg_BOUND})
  endif()
  if(NOT TARGET Director::directorc)
    message(FATAL_ERROR "director_add_docs: there is no directorc; find_package(Director COMPONENTS compiler REQUIRED) finds it")
  endif()
  add_custom_target(
    ${target}
    COMMAND Director::directorc docs ${files} -o ${folder} --format=${arg_FORMAT} ${link} ${build} ${bound}
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Writing pages about behaviours into ${folder}"
    VERBATIM)
endfunction()

cmake_policy(POP)
