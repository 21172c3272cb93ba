# SPDX-License-Identifier: MIT
# Where the version stands beside limitcurve/version.hpp, it is the same.
string(REGEX MATCH "^[0-9]+\\.[0-9]+" minor ${VERSION})
foreach(place "CITATION.cff:\nversion: ${VERSION}\n" "package.xml:<version>${VERSION}</version>" "CHANGELOG.md:\n## ${minor}" "docs/interfaces.md:\nVersion ${minor} "
    "docs/interfaces.md:find_package(limitcurve ${minor} " "examples/CMakeLists.txt:find_package(limitcurve ${minor} "
    "scripts/maintain/packaging/debian/changelog:limitcurve (${VERSION}-1)" "scripts/maintain/packaging/vcpkg/vcpkg.json:\"version\": \"${VERSION}\"")
  string(REGEX MATCH "^[^:]+" file "${place}")
  file(READ ${SOURCE}/${file} text)
  string(REGEX REPLACE "^[^:]+:" "" words "${place}")
  string(FIND "${text}" "${words}" found)
  if(found EQUAL -1)
    message(SEND_ERROR "${file}: no '${words}', expected the version of limitcurve/version.hpp")
  endif()
endforeach()
