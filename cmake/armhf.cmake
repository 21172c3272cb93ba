# SPDX-License-Identifier: MIT
# Linux on 32-bit ARM, whose long double is double, from Debian or Ubuntu (g++-arm-linux-gnueabihf; qemu-user runs the tests):
#     cmake -S . -B build/armhf -DCMAKE_TOOLCHAIN_FILE=cmake/armhf.cmake -DLIMITCURVE_C=ON
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # notes about compilers before GCC 10
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm -L /usr/arm-linux-gnueabihf)
include(${CMAKE_CURRENT_LIST_DIR}/cross_libraries.cmake)
