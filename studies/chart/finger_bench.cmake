# SPDX-License-Identifier: MIT
# The target finger_bench, in CMakeLists.txt; and in another commit's tree, with that tree's own adaptor.hpp, where
# scripts/maintain/compare_speed includes this file in its project.
find_path(LIMITCURVE_ADAPTOR adaptor.hpp PATHS ${PROJECT_SOURCE_DIR}/studies/chart ${PROJECT_SOURCE_DIR}/bench NO_DEFAULT_PATH REQUIRED)
add_executable(finger_bench ${CMAKE_CURRENT_LIST_DIR}/finger_bench.cpp)
target_include_directories(finger_bench PRIVATE ${PROJECT_SOURCE_DIR} ${LIMITCURVE_ADAPTOR})
target_link_libraries(finger_bench PRIVATE limitcurve::godobject limitcurve_options)
