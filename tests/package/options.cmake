# SPDX-License-Identifier: MIT
# Every option of the build, and what is decided by what is found, has its row in docs/interfaces.md.
file(READ ${SOURCE}/docs/interfaces.md page)
foreach(list ${SOURCE}/CMakeLists.txt ${SOURCE}/tests/CMakeLists.txt)
  file(STRINGS ${list} lines REGEX "^ *(option|limitcurve_part)\\(LIMITCURVE_")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "LIMITCURVE_[A-Z_]+" option "${line}")
    string(REPLACE "LIMITCURVE" "" short ${option})
    if(NOT page MATCHES "`${option}`" AND NOT page MATCHES "`${short}`")
      message(SEND_ERROR "${option}: no row in docs/interfaces.md")
    endif()
  endforeach()
endforeach()
