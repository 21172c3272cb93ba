# SPDX-License-Identifier: MIT
# The target finger_bench, in bench/CMakeLists.txt; and in another commit's tree, with that tree's own bench/adaptor.hpp, where
# scripts/maintain/compare_speed includes this file in its project.
add_executable(finger_bench ${CMAKE_CURRENT_LIST_DIR}/finger_bench.cpp)
target_include_directories(finger_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(finger_bench PRIVATE LIMITCURVE_MESHES="${CMAKE_CURRENT_LIST_DIR}/../data/meshes")
target_link_libraries(finger_bench PRIVATE limitcurve::mesh limitcurve_options)
# The widest vectors that may be used, of 128, 256 and 512 bits; without it, as the processor has them.
if(LIMITCURVE_BENCH_VECTOR_BITS)
  target_sources(finger_bench PRIVATE ${CMAKE_CURRENT_LIST_DIR}/vector_bits.cpp)
  set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/vector_bits.cpp
    PROPERTIES COMPILE_DEFINITIONS LIMITCURVE_BENCH_VECTOR_BITS=${LIMITCURVE_BENCH_VECTOR_BITS})
  target_link_options(finger_bench PRIVATE -Wl,--wrap=__cpu_indicator_init)
endif()
