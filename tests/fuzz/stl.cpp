// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"
#include "tests/fuzz/mesh.hpp"

using namespace limitcurve;

/// A mesh as STL: triangles, or a complaint that names the file; what they bound, if anything, can be touched.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  godobject::TriangleList list;
  const auto complaint = fuzz::complaint_of([&] { list = godobject::read_stl(fuzz::as_text(data, size), "file"); });
  if (complaint) {
    fuzz::require(complaint->substr(0, 5) == "file:", "a complaint that does not name the file");
    return 0;
  }
  fuzz::touch(list);
  return 0;
}
