# SPDX-License-Identifier: MIT
# limitcurve (MODULES of it) within another project, by add_subdirectory and by FetchContent: its libraries alone are there, the project's build type and its
# messages are its own, and nothing of ours is installed.
file(REMOVE_RECURSE ${SCRATCH})

function(configure name how)
  file(WRITE ${SCRATCH}/${name}/CMakeLists.txt "cmake_minimum_required(VERSION 3.23)
project(outer LANGUAGES CXX)
${how}
foreach(module ${MODULES})
  if(NOT TARGET limitcurve::\${module})
    message(FATAL_ERROR \"there is no limitcurve::\${module}\")
  endif()
endforeach()
if(TARGET limitcurve_cli OR TARGET test_limitcurve OR TARGET limitcurve_c)
  message(FATAL_ERROR \"tools or tests within another project\")
endif()
if(CMAKE_BUILD_TYPE)
  message(FATAL_ERROR \"the project's build type became \${CMAKE_BUILD_TYPE}\")
endif()
")
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
      -S ${SCRATCH}/${name} -B ${SCRATCH}/${name}/build
    OUTPUT_VARIABLE output ERROR_VARIABLE errors COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "(limitcurve:|Ceres|SuiteSparse|glog|Eigen)[^\n]*" foreign "${output}${errors}")
  if(foreign)
    message(SEND_ERROR "${name}: a message that is not the project's: ${foreign}")
  endif()
  file(READ ${SCRATCH}/${name}/build/cmake_install.cmake installs)
  file(GLOB_RECURSE ours ${SCRATCH}/${name}/build/*/cmake_install.cmake)
  foreach(script IN LISTS ours)
    file(READ ${script} text)
    string(APPEND installs "${text}")
  endforeach()
  if(installs MATCHES "file\\(INSTALL")
    message(SEND_ERROR "${name}: something of limitcurve is installed")
  endif()
endfunction()

configure(add_subdirectory "add_subdirectory([[${SOURCE}]] limitcurve)")
configure(fetch_content "include(FetchContent)
FetchContent_Declare(limitcurve SOURCE_DIR [[${SOURCE}]])
FetchContent_MakeAvailable(limitcurve)")
