# SPDX-License-Identifier: MIT
# What find_package(limitcurve) says of a component that is not there (issue 9, point 13): the copy at PREFIX, less its fit, is asked for fit, and
# for a component that nobody knows.
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${PREFIX}/ DESTINATION ${SCRATCH}/prefix)
file(GLOB_RECURSE fit ${SCRATCH}/prefix/limitcurve-fit*.cmake)
if(fit)
  file(REMOVE ${fit})
endif()

function(expect_complaint component complaint)
  file(WRITE ${SCRATCH}/${component}/CMakeLists.txt
    "cmake_minimum_required(VERSION 3.23)\nproject(consumer LANGUAGES CXX)\nfind_package(limitcurve REQUIRED COMPONENTS limitcurve ${component})\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
      -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -S ${SCRATCH}/${component} -B ${SCRATCH}/${component}/build
    RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
  # CMake breaks lines.
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${complaint}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "asked for ${component}: expected a failure that says \"${complaint}\", found (status ${status}): ${said}")
  endif()
endfunction()

expect_complaint(fit "the component 'fit' was not built into this installation")
expect_complaint(gadobject "there is no component 'gadobject': expected limitcurve, godobject, mesh, fit or c")
