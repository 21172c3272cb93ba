// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"

#include "godobject/mesh/mesh.hpp"

#include "limitcurve/internal/number.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
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
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  while (file) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get());
    bytes.append(buffer.data(), count);
    if (count < buffer.size()) break;
  }
  if (!file || std::ferror(file.get()) != 0) throw std::invalid_argument(joined({path, ": ", std::strerror(errno), ", expected a mesh"}));
  return extension == ".obj" ? read_obj(bytes, path, scale) : read_stl(bytes, path, scale);
}

MeshSurface read_mesh(const std::string& path, double scale, int body) {
  return MeshSurface(Mesh(read_triangles(path, scale), body));
}

}  // namespace limitcurve::godobject
