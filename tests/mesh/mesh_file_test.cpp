// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"
#include "godobject/mesh/mesh.hpp"

#include "tests/mesh/shapes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

template <class Body>
std::string complaint_of(Body&& body) {
  try {
    body();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

std::string obj_complaint(std::string_view text) {
  return complaint_of([&] { static_cast<void>(read_obj(text, "a.obj")); });
}
std::string stl_complaint(std::string_view text) {
  return complaint_of([&] { static_cast<void>(read_stl(text, "a.stl")); });
}

TEST(MeshFile, ReadsWhatTheScriptWrote) {
  struct Known {
    std::string name;
    std::size_t faces, vertices;
    double volume;
  };
  for (const Known& known : {Known{"block.obj", 12, 8, 0.12 * 0.04 * 0.04},
                             {"plate.stl", 12, 8, 0.06 * 0.04 * 0.001},
                             {"bracket.stl", 20, 12, (0.06 * 0.02 + 0.04 * 0.02) * 0.04}}) {
    const MeshSurface surface = read_mesh(data_mesh(known.name));
    EXPECT_EQ(surface.mesh().faces().size(), known.faces) << known.name;
    EXPECT_EQ(surface.mesh().vertices().size(), known.vertices) << known.name;
    EXPECT_NEAR(surface.mesh().volume(), known.volume, 1e-6 * known.volume) << known.name;
    EXPECT_EQ(surface.mesh().repairs().turned, 0) << known.name;
  }
  EXPECT_EQ(read_mesh(data_mesh("ball.obj")).mesh().faces().size(), 320U);
  EXPECT_EQ(read_mesh(data_mesh("star.obj")).mesh().faces().size(), 240U);
  // In millimetres.
  EXPECT_NEAR(read_mesh(data_mesh("block.obj"), 0.001).mesh().volume(), 1.92e-13, 1e-22);
}

TEST(MeshFile, ReadsObjAsProgramsWriteIt) {
  const TriangleList list = read_obj(
      "# exported\r\nmtllib x.mtl\r\no Thing\r\nv 0 0 0 1.0\r\nv\t1 0 0\t0.5 0.5 0.5\r\nv 0 +1 0\r\nv 0 0 1e0\r\nvn 0 0 1\r\n"
      "vt 0.5 0.5\r\ng part\r\nusemtl grey\r\ns off\r\nf 1 2 3\r\nf 1/1 2/1/1 4//1\r\nf -4 -2 -1\r\n\r\nf 2 3 4   \r\nl 1 2\r\nf 1 2 3 4",
      "a.obj", 2.0);
  EXPECT_EQ(list.vertices.size(), 4U);
  EXPECT_EQ(list.vertices[2], Vector3d(0.0, 2.0, 0.0));
  EXPECT_EQ(list.faces, (std::vector<Face>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(list.lines, (std::vector<int>{13, 14, 15, 17, 19, 19}));
}

TEST(MeshFile, NamesThePlaceInAnObj) {
  EXPECT_EQ(obj_complaint("v 0 0 0\nv 1 x 0\n"), "a.obj:2:5: 'x', expected a finite number");
  EXPECT_EQ(obj_complaint("v 0 0\n"), "a.obj:1:6: the line ends, expected a finite number");
  EXPECT_EQ(obj_complaint("v 0 0 inf"), "a.obj:1:7: 'inf', expected a finite number");
  EXPECT_EQ(obj_complaint("v 0 0 nan"), "a.obj:1:7: 'nan', expected a finite number");
  EXPECT_EQ(obj_complaint("v 0 0 0 1 2 3 4 5"), "a.obj:1:17: '5', expected the line to end");
  EXPECT_EQ(obj_complaint("v 0 0 0\n\n  f 1 1 2"),
            "a.obj:3:9: '2', expected a vertex before this line: 1 to 1, or from the last, -1 to -1");
  EXPECT_EQ(obj_complaint("v 0 0 0\nf 1 0 1"), "a.obj:2:5: '0', expected a vertex before this line: 1 to 1, or from the last, -1 to -1");
  EXPECT_EQ(obj_complaint("v 0 0 0\nf 1 1"), "a.obj:2:6: the line ends, expected three vertices at least");
  for (const std::string_view word : {"1.5", "x", "/1", "1/x", "99999999999999999999", "--1"}) {
    const std::string text = std::string("v 0 0 0\nf ").append(word);
    EXPECT_EQ(obj_complaint(text).substr(0, 11), "a.obj:2:3: ") << word;
  }
  EXPECT_EQ(obj_complaint("vertex 0 0 0"),
            "a.obj:1:1: 'vertex', expected v, f, or what a mesh does without (vn, vt, o, g, s, usemtl, mtllib, …)");
  // What a terminal would take for a command stays out of the complaint.
  EXPECT_EQ(obj_complaint("v 0 0 \x1b[31m").find('\x1b'), std::string::npos);
  EXPECT_EQ(obj_complaint(""), "none");
}

constexpr std::string_view tetrahedron =
    "solid t\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "  facet normal nan nan nan\n outer loop\n vertex 0 0 0\n vertex 0 0 1\n vertex 0 1 0\n endloop\n endfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid t\n";

TEST(MeshFile, ReadsStlAsText) {
  const TriangleList list = read_stl(tetrahedron, "a.stl", 0.01);
  EXPECT_EQ(list.faces.size(), 4U);
  EXPECT_EQ(list.lines, (std::vector<int>{2, 9, 16, 23}));
  const Mesh mesh(list);
  EXPECT_EQ(mesh.repairs().welded, 8);
  EXPECT_NEAR(mesh.volume(), 1e-6 / 6.0, 1e-17);
}

TEST(MeshFile, NamesThePlaceInAnStl) {
  const auto with = [](std::string_view what, std::string_view instead) {
    std::string text(tetrahedron);
    return stl_complaint(text.replace(text.find(what), what.size(), instead));
  };
  EXPECT_EQ(with("outer loop", "inner loop"), "a.stl:3:1: 'inner', expected outer");
  EXPECT_EQ(with("vertex 0 1 0", "vertex 0 inf 0"), "a.stl:5:10: 'inf', expected a finite number");
  EXPECT_EQ(with("vertex 0 1 0", "vertex 0 1 0 0"), "a.stl:5:14: '0', expected the line to end");
  EXPECT_EQ(with("endloop", "vertex 0 0 0"), "a.stl:7:1: 'vertex', expected endloop");
  EXPECT_EQ(with("endsolid t\n", ""), "a.stl:29:9: the text ends, expected facet or endsolid");
  EXPECT_EQ(with("facet normal 1 1 1", "triangle"), "a.stl:23:1: 'triangle', expected facet or endsolid");
  EXPECT_EQ(stl_complaint("solid"), "a.stl:1:6: the text ends, expected facet or endsolid");
  EXPECT_EQ(stl_complaint("solid x\nendsolid x\n"), "a.stl:2:11: the text ends, expected solid");
}

// Keywords in other case, and a byte order mark, as some programs write them.
TEST(MeshFile, ReadsTextsOfOtherPrograms) {
  std::string upper(tetrahedron);
  for (char& character : upper) {
    if (character >= 'a' && character <= 'z' && character != 'n') character = static_cast<char>(character - 'a' + 'A');
  }
  std::string title(tetrahedron);
  title[0] = 'S';
  const std::string mark = "\xef\xbb\xbf";
  for (const std::string& text : {upper, title, mark + std::string(tetrahedron)}) {
    EXPECT_EQ(read_stl(text, "a.stl").faces, read_stl(tetrahedron, "a.stl").faces) << text;
  }
  EXPECT_EQ(read_obj(mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").faces.size(), 1U);
  EXPECT_EQ(obj_complaint(std::string("v\0 \0000 \0", 8)), "a.obj: a byte 0, expected a text in UTF-8");
}

TEST(MeshFile, NamesAConcavePolygon) {
  const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 1 0 0\n";
  // From a corner that all of it is seen from it is divided well, from another not.
  EXPECT_EQ(obj_complaint(corners + "f 4 5 1 2 3\n"), "none");
  EXPECT_EQ(obj_complaint(corners + "f 1 2 3 4 5\n"),
            "a.obj:7:12: a polygon that is not convex, expected triangles or convex polygons: triangulate it");
  // Corners on one line are left to the checks of the mesh.
  EXPECT_EQ(obj_complaint(corners + "f 1 6 2 3\n"), "none");
}

TEST(MeshFile, NamesThePlaceInABinaryStl) {
  std::ifstream file(data_mesh("bracket.stl"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(read_stl(bytes, "a.stl").faces.size(), 20U);
  EXPECT_EQ(stl_complaint(bytes.substr(0, bytes.size() - 1)),
            "a.stl: 1083 bytes, expected 1084 of a binary file with its count of faces: it is damaged");
  // Some programs begin the header with "solid".
  std::string headed = bytes.substr(0, bytes.size() - 1);
  headed.replace(0, 6, "solid ");
  EXPECT_EQ(stl_complaint(headed), "a.stl: 1083 bytes, expected 1084 of a binary file with its count of faces: it is damaged");
  EXPECT_EQ(stl_complaint(bytes.substr(0, 50) + '\0'), "a.stl: 51 bytes, expected 84 or more of a binary file");
  EXPECT_EQ(stl_complaint("abc"), "a.stl: neither a text that begins with solid nor a binary file of 84 bytes or more");
  std::string bad = bytes;
  for (std::size_t i = 0; i < 4; ++i) bad[84 + 50 * 7 + 12 + 4 + i] = '\xff';
  EXPECT_EQ(stl_complaint(bad), "a.stl: face 7 has a coordinate that is not a finite number");
}

/// A file in a folder for tests: binary STL, whose numbers are floats, or OBJ.
std::string written(const std::string& name, const TriangleList& list) {
  const std::string path = ::testing::TempDir() + "/" + name;
  std::ofstream file(path, std::ios::binary);
  if (name.back() == 'j') {
    for (const Vector3d& vertex : list.vertices) file << "v " << vertex.cast<float>().transpose().format({9}) << '\n';
    for (const auto& [a, b, c] : list.faces) file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    return path;
  }
  const auto count = static_cast<std::uint32_t>(list.faces.size());
  file << std::string(80, ' ');
  file.write(reinterpret_cast<const char*>(&count), 4);
  for (const Face& face : list.faces) {
    Eigen::Matrix<float, 3, 4> rows = Eigen::Matrix<float, 3, 4>::Zero();
    for (int i = 0; i < 3; ++i) rows.col(i + 1) = list.vertices[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])].cast<float>();
    file.write(reinterpret_cast<const char*>(rows.data()), 48).write("\0\0", 2);
  }
  return path;
}

// A cube one of whose edges has a cap of 1 nm, in metres and millimetres, and two boxes that
// overlap.
TEST(MeshFile, ReadsWhatOtherProgramsRound) {
  TriangleList capped = box_triangles(Vector3d::Constant(0.01));
  capped.vertices.push_back({-0.01, -0.01 + 1e-9, 0.001});
  capped.faces[0] = {0, 8, 3};  // was 0, 1, 3
  capped.faces.insert(capped.faces.end(), {{8, 1, 3}, {1, 8, 0}});
  TriangleList millimetres = capped;
  for (Vector3d& vertex : millimetres.vertices) vertex *= 1000.0;
  TriangleList two = box_triangles({0.01, 0.02, 0.03});
  add(two, box_triangles(Vector3d::Constant(0.01)), {0.005, 0.006, 0.007});
  for (const std::string extension : {"stl", "obj"}) {
    const std::string metres = written("capped." + extension, capped), large = written("large." + extension, millimetres);
    for (const MeshSurface& surface : {read_mesh(metres), read_mesh(large, 0.001)}) {
      EXPECT_EQ(surface.mesh().repairs().slivers, 1);
      EXPECT_EQ(surface.mesh().faces().size(), 14U);
      EXPECT_NEAR(surface.mesh().volume(), 8e-6, 1e-12);
    }
    const std::string both = written("two." + extension, two);
    EXPECT_NE(complaint_of([&] { static_cast<void>(read_mesh(both)); }).find("overlap: unite them"), std::string::npos);
    EXPECT_NEAR(read_mesh(both, 1.0, 2).mesh().volume(), 8e-6, 1e-12);
    EXPECT_NE(complaint_of([&] {
                static_cast<void>(read_mesh(both, 1.0, 3));
              }).find("two." + extension + ": body = 3 is out of range: expected 1 to 2"),
              std::string::npos);
    for (const std::string& path : {metres, large, both}) std::filesystem::remove(path);
  }
}

TEST(MeshFile, RefusesFilesThatAreNoMesh) {
  const auto complaint = [](const std::string& path, double scale = 1.0) {
    return complaint_of([&] { static_cast<void>(read_mesh(path, scale)); });
  };
  EXPECT_EQ(complaint("no/such.obj"), "no/such.obj: No such file or directory, expected a mesh");
  EXPECT_EQ(complaint("thing.ply"), "thing.ply: a mesh of type '.ply', expected .obj or .stl");
  EXPECT_EQ(complaint(data_mesh("block.obj"), 0.0).substr(0, 25), "scale = 0 m is out of ran");
  const std::string folder = ::testing::TempDir() + "/folder.OBJ";
  std::filesystem::create_directories(folder);
#ifdef _WIN32
  const std::string reason = "Permission denied";
#else
  const std::string reason = "Is a directory";
#endif
  EXPECT_NE(complaint(folder).find("folder.OBJ: " + reason + ", expected a mesh"), std::string::npos) << complaint(folder);
  const std::string open_box = ::testing::TempDir() + "/open.obj";
  std::ofstream(open_box) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\n";
  EXPECT_NE(complaint(open_box).find("open.obj:7: face 1 has nothing beyond its edge from (1, 0, 0) to (0, 0, 1)"), std::string::npos)
      << complaint(open_box);
  std::filesystem::remove(open_box);
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace limitcurve::godobject::test
