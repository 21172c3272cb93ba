# SPDX-License-Identifier: MIT
# The target finger_bench, in bench/CMakeLists.txt; and in another commit's tree, with that tree's own bench/adaptor.hpp, where
# scripts/maintain/compare_speed includes this file in its project.
add_executable(finger_bench ${CMAKE_CURRENT_LIST_DIR}/finger_bench.cpp)
target_include_directories(finger_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(finger_bench PRIVATE limitcurve::godobject limitcurve_options)
