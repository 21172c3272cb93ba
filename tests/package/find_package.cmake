# SPDX-License-Identifier: MIT
# What find_package(limitcurve) takes and what it refuses, and with which words: the copy at PREFIX, less its fit, is asked for version ranges,
# for fit, for a component whose dependency is missing, and for one that nobody knows.
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${PREFIX}/ DESTINATION ${SCRATCH}/prefix)
file(GLOB_RECURSE fit ${SCRATCH}/prefix/limitcurve-fit*.cmake)
if(fit)
  file(REMOVE ${fit})
endif()

# Asks by find_package(limitcurve ARGUMENTS); the complaint "" is none. The languages of the project are to be none: asking needs no compiler.
function(expect arguments complaint)
  file(WRITE ${SCRATCH}/consumer/CMakeLists.txt
    "cmake_minimum_required(VERSION 3.23)\nproject(consumer LANGUAGES NONE)\nfind_package(limitcurve ${arguments})\n")
  file(REMOVE_RECURSE ${SCRATCH}/consumer/build)
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} ${ARGN}
      -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -S ${SCRATCH}/consumer -B ${SCRATCH}/consumer/build
    RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
  # CMake breaks lines.
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${complaint}" place)
  if(complaint STREQUAL "" AND NOT status EQUAL 0)
    message(SEND_ERROR "find_package(limitcurve ${arguments}): expected success, found (status ${status}): ${said}")
  elseif(NOT complaint STREQUAL "" AND (status EQUAL 0 OR place EQUAL -1))
    message(SEND_ERROR "find_package(limitcurve ${arguments}): expected a failure that says \"${complaint}\", found (status ${status}): ${said}")
  endif()
endfunction()

expect("REQUIRED COMPONENTS fit" "the component 'fit' was not built into this installation")
expect("REQUIRED COMPONENTS limitcurve gadobject" "there is no component 'gadobject': expected limitcurve|engines|godobject|fit|c|c_fit")
expect("REQUIRED COMPONENTS godobject" "the component 'godobject' needs Eigen3, which is not found" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
expect("REQUIRED COMPONENTS limitcurve OPTIONAL_COMPONENTS fit" "")
foreach(wanted ${MAJOR}.${MINOR} ${VERSION} ${MAJOR}.${MINOR}...<1.0 ${MAJOR}.${MINOR}...1 0...<9)
  expect("${wanted} REQUIRED COMPONENTS limitcurve" "")
endforeach()
math(EXPR next "${MINOR} + 1")
foreach(refused ${MAJOR}.${next} 9...10 0.0...<${MAJOR}.${MINOR})
  expect("${refused} REQUIRED COMPONENTS limitcurve" "compatible with requested version")
endforeach()
