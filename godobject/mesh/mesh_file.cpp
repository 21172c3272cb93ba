// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"

#include "limitcurve/number.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace limitcurve::godobject {

TriangleList read_triangles(const std::string& path, double scale) {
  if (!(scale >= 1e-9 && scale <= 1e9)) throw out_of_range("scale", scale, "m", "1e-9 to 1e9");
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& character : extension) {
    if (character >= 'A' && character <= 'Z') character = static_cast<char>(character - 'A' + 'a');
  }
  if (extension != ".obj" && extension != ".stl") {
    throw std::invalid_argument(joined({path, ": a mesh of type '", extension, "', expected .obj or .stl"}));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  // A folder opens, but has nothing to read.
  if (!file || !bytes.assign(std::istreambuf_iterator<char>(file), {}).size() || file.bad()) {
    throw std::invalid_argument(joined({path, ": ", errno != 0 ? std::strerror(errno) : "it is empty", ", expected a mesh"}));
  }
  return extension == ".obj" ? read_obj(bytes, path, scale) : read_stl(bytes, path, scale);
}

MeshSurface read_mesh(const std::string& path, double scale) {
  return MeshSurface(Mesh(read_triangles(path, scale)));
}

}  // namespace limitcurve::godobject
