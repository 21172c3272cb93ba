# SPDX-License-Identifier: MIT
# macOS on arm64 from any system, by compiler, headers and linker of the Python package ziglang (pip install ziglang). Nothing runs there:
#     cmake -S . -B build/macos -DCMAKE_TOOLCHAIN_FILE=cmake/macos.cmake -DLIMITCURVE_C=ON
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
find_program(LIMITCURVE_ZIG NAMES python-zig zig REQUIRED)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES LIMITCURVE_ZIG)
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_TARGET aarch64-macos.13.3)
endforeach()
set(CMAKE_C_COMPILER ${LIMITCURVE_ZIG};cc)
set(CMAKE_CXX_COMPILER ${LIMITCURVE_ZIG};c++)
foreach(tool ar ranlib)
  string(TOUPPER CMAKE_${tool} variable)
  file(WRITE ${CMAKE_BINARY_DIR}/zig-${tool} "#!/bin/sh\nexec ${LIMITCURVE_ZIG} ${tool} \"$@\"\n")
  file(CHMOD ${CMAKE_BINARY_DIR}/zig-${tool} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  set(${variable} ${CMAKE_BINARY_DIR}/zig-${tool} CACHE FILEPATH "")
endforeach()
# After its <cmath>, <float.h> lacks FLT_RADIX, which Boost needs.
set(CMAKE_CXX_FLAGS_INIT "-include float.h")
# CMake asks for it at configuration; only an installation would run it.
set(CMAKE_INSTALL_NAME_TOOL true CACHE FILEPATH "")
set(CMAKE_OSX_SYSROOT "" CACHE STRING "")
set(CMAKE_OSX_DEPLOYMENT_TARGET "" CACHE STRING "")
include(${CMAKE_CURRENT_LIST_DIR}/cross_libraries.cmake)
