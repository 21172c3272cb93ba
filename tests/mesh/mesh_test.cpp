// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh.hpp"

#include "tests/mesh/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

std::string complaint(const TriangleList& list) {
  try {
    static_cast<void>(Mesh(list));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

void expect_complaint(const TriangleList& list, std::initializer_list<std::string_view> parts) {
  const std::string message = complaint(list);
  for (const std::string_view part : parts) EXPECT_NE(message.find(part), std::string::npos) << message << "\n  lacks " << part;
}

TriangleList cube() {
  return box_triangles(Vector3d::Constant(0.01));
}

TEST(Mesh, KnowsItsVolume) {
  EXPECT_NEAR(Mesh(cube()).volume(), 8e-6, 1e-16);
  EXPECT_EQ(Mesh(cube()).repairs().turned, 0);
  TriangleList far_away = cube();
  for (Vector3d& vertex : far_away.vertices) vertex += Vector3d(1.0, -2.0, 3.0);
  EXPECT_NEAR(Mesh(far_away).volume(), 8e-6, 1e-13);
}

TEST(Mesh, RefusesWhatBoundsNoSolid) {
  TriangleList list = cube();
  list.name = "cube.obj";
  list.faces.pop_back();
  expect_complaint(list, {"cube.obj: face ", "nothing beyond its edge from (", "expected a closed surface",
                          "; open are also the edge from (", ", the edge from (", " of face ", "Close Holes"});
  list.lines.assign(list.faces.size(), 17);
  expect_complaint(list, {"cube.obj:17: face "});

  list = cube();
  list.vertices.push_back({0.03, 0.03, 0.03});
  list.faces.push_back({0, 1, 8});
  expect_complaint(list, {"is one of 3 faces at the edge", "expected two"});

  list = cube();
  list.faces[3] = {0, 1, 8};
  expect_complaint(list, {"mesh: face 3 has the vertex 8, of 8 counted from 0"});
  list.faces[3] = {0, -1, 2};
  expect_complaint(list, {"face 3 has the vertex -1"});

  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e7}) {
    list = cube();
    list.vertices[5].y() = bad;
    expect_complaint(list, {"has a vertex that is not within 1e6 m of the origin"});
  }
  list = cube();
  list.faces.resize(3);
  expect_complaint(list, {"3 faces, expected at least 4"});
  expect_complaint({}, {"0 faces, expected at least 4"});
  expect_complaint(box_triangles(Vector3d::Constant(1e-8)), {"farthest coordinate is 1e-08 m"});
}

// Two cubes that share a corner, and two that share an edge.
TEST(Mesh, RefusesWhatIsNoManifold) {
  TriangleList list = cube();
  add(list, cube(), Vector3d::Constant(0.02));
  expect_complaint(list, {"has a corner (0.01", "where parts of the surface touch in a point"});
  list = cube();
  add(list, cube(), {0.02, 0.02, 0.0});
  expect_complaint(list, {"is one of 4 faces at the edge", "are to be united"});
}

// A Klein bottle as a grid of 8 × 8 squares whose one pair of sides is joined crosswise: closed, but with one side only.
TEST(Mesh, RefusesWhatHasOneSide) {
  TriangleList list;
  constexpr int n = 8;
  Random random(1);
  for (int i = 0; i < n * n; ++i) list.vertices.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  const auto at = [](int i, int j) { return i < n ? i * n + (j + n) % n : (2 * n - j) % n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      list.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      list.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  expect_complaint(list, {"cannot both look outward: expected a surface with two sides"});
}

/// Two fans with a common rim about the z axis: the one to the vertex 0, above, the other to 1.
TriangleList fans(int count, double below, const std::function<Vector3d(int)>& rim) {
  TriangleList list;
  list.vertices = {{0, 0, 0.03}, {0, 0, below}};
  for (int i = 0; i < count; ++i) {
    const int next = 2 + (i + 1) % count;
    list.vertices.push_back(rim(i));
    list.faces.push_back({0, 2 + i, next});
    list.faces.push_back({1, next, 2 + i});
  }
  return list;
}

/// Whether an edge passes through the inside of a face: 1 clearly, 0 clearly not, −1 by hardly more than rounding. Signs of volumes, with
/// every face for every edge; shares no code with the library.
int passes_by_search(const TriangleList& list) {
  const auto at = [&](int i) { return list.vertices[static_cast<std::size_t>(i)]; };
  int found = 0;
  for (const Face& one : list.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int p = one[k], q = one[(k + 1) % 3];
      for (const Face& other : list.faces) {
        if (std::any_of(other.begin(), other.end(), [&](int v) { return v == p || v == q; })) continue;
        const Vector3d a = at(other[0]), b = at(other[1]), c = at(other[2]);
        const auto volume = [](const Vector3d& u, const Vector3d& v, const Vector3d& w) { return u.dot(v.cross(w)); };
        const double before = volume(at(p) - a, b - a, c - a), after = volume(at(q) - a, b - a, c - a);
        const Vector3d way = at(q) - at(p);
        const std::array sides{volume(way, a - at(p), b - at(p)), volume(way, b - at(p), c - at(p)), volume(way, c - at(p), a - at(p))};
        const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
        constexpr double hardly = 1e-12;
        if (before * after < 0 && std::min(std::fabs(before), std::fabs(after)) > hardly && (*least > hardly || *most < -hardly)) return 1;
        if (before * after < hardly * hardly && (*least > -hardly || *most < hardly)) found = -1;
      }
    }
  }
  return found;
}

// Many faces around a vertex, some of them moved: refused where a comparison of every edge with every face finds a crossing, and nowhere else.
TEST(Mesh, FindsCrossingsAroundAVertexOfManyFaces) {
  Random random(30);
  int refused = 0;
  int accepted = 0;
  for (int trial = 0; trial < 150; ++trial) {
    constexpr int count = 90;
    TriangleList list = fans(count, random.uniform(-0.03, 0.02), [&](int i) -> Vector3d {
      const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / count;
      return Vector3d(std::cos(angle), std::sin(angle), random.uniform(-0.1, 0.1)) * random.uniform(0.01, 0.03);
    });
    if (trial % 3 != 0) {
      const auto which = static_cast<std::size_t>(2 + random.bits() % count);
      list.vertices[which] +=
          Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) * random.logarithmic(1e-4, 0.03);
    }
    const int expected = passes_by_search(list);
    if (expected < 0) continue;
    const std::string message = complaint(list);
    ASSERT_EQ(message.find("meets face") != std::string::npos, expected == 1) << trial << ' ' << message;
    (expected == 1 ? refused : accepted) += 1;
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(accepted, 20);
}

// 1e5 faces around each of two vertices: by pairs it would not end within the suite's time.
TEST(Mesh, ManyFacesAroundAVertexTakeNoSquareOfTheirNumber) {
  constexpr int count = 100'000;
  const Mesh cone(fans(count, 0.0, [](int i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    return Vector3d(0.02 * std::cos(angle), 0.02 * std::sin(angle), 0.0);
  }));
  EXPECT_NEAR(cone.volume(), std::numbers::pi * 0.02 * 0.02 * 0.03 / 3.0, 1e-13);
}

TEST(Mesh, RefusesTangles) {
  // Two cubes that cross, that touch with faces, with a corner on a face, with an edge on a face.
  for (const Vector3d& by : {Vector3d(0.011, 0.012, 0.013), Vector3d(0.02, 0.003, 0.004), Vector3d(0.0, 0.0, 0.02)}) {
    TriangleList list = cube();
    TriangleList other = cube();
    if (by.x() == 0.0) {
      for (Vector3d& vertex : other.vertices) vertex *= 0.5;
      add(list, other, {0.001, 0.002, 0.015});
    } else {
      add(list, other, by);
    }
    expect_complaint(list, {"meets face ", "where they share neither edge nor vertex", "unite them"});
  }
  TriangleList list = cube();
  list.vertices.insert(list.vertices.end(), {{0.0, 0.0, 0.01}, {0.005, 0.001, 0.03}, {-0.005, 0.002, 0.03}, {0.001, 0.005, 0.03}});
  for (const Face& face : {Face{8, 9, 10}, Face{8, 10, 11}, Face{8, 11, 9}, Face{9, 11, 10}}) list.faces.push_back(face);
  expect_complaint(list, {"meets face "});

  // A cube with one corner pulled through the opposite face, and one with a face folded back on to another.
  list = cube();
  list.vertices[7] = {-0.02, -0.005, -0.004};
  expect_complaint(list, {"meets face ", "Remesh"});
  list = cube();
  list.vertices.push_back({0.0, 0.0, 0.01});
  // A pocket without depth in the top.
  const auto top =
      std::find_if(list.faces.begin(), list.faces.end(), [](const Face& face) { return (face[0] & face[1] & face[2] & 1) != 0; });
  ASSERT_NE(top, list.faces.end());
  const auto [a, b, c] = *top;
  const auto at = [&](int vertex) { return list.vertices[static_cast<std::size_t>(vertex)]; };
  list.vertices.push_back((at(a) + at(b) + at(8)) / 3.0);
  *top = {a, b, 8};
  list.faces.push_back({b, c, 8});
  list.faces.push_back({c, 9, 8});
  list.faces.push_back({c, a, 9});
  list.faces.push_back({a, 8, 9});
  expect_complaint(list, {"folds back on to face "});
}

/// A tetrahedron with a vertex beside the middle of an edge, and between them the cap 5.
TriangleList with_cap(double beside) {
  TriangleList list;
  list.vertices = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}, {0.005, -beside, 0}};
  list.faces = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}};
  return list;
}

// A cap of up to two spacings of a float (9e-10 at 1 cm) is taken out, and one above 1e-6 of its
// edge has a side.
TEST(Mesh, RefusesFacesTooThinToHaveASide) {
  expect_complaint(with_cap(5e-9), {"face 5 is a sliver: its height is 5e-07 of its longest edge", "Remove T-Vertices"});
  EXPECT_EQ(Mesh(with_cap(1e-7)).repairs().slivers, 0);
  for (const double beside : {0.0, 1e-9}) {
    const Mesh mesh(with_cap(beside));
    EXPECT_EQ(mesh.repairs().slivers, 1);
    EXPECT_EQ(mesh.faces().size(), 6U);
    EXPECT_NEAR(mesh.volume(), 1e-6 / 6.0, 1e-18 + 2e-5 * beside);
  }
}

// Tetrahedra thinner than the rounding of their volume: the outward side is exact. Below 1e-13 rad at an edge it is undefined.
TEST(Mesh, ABladeIsNotInsideOut) {
  const double step = std::ldexp(1.0, -38);
  TriangleList blade;
  blade.vertices = {step * Vector3d(41731340695, -15346146825, 11037043370), step * Vector3d(-41730666537, 15347495141, -11037717528),
                    step * Vector3d(3025583153, -1113635696, 800745229), step * Vector3d(-4011142953, 1475370201, -1061035052)};
  blade.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const Mesh mesh(blade);
  // The determinant in steps³ by integers of any length.
  EXPECT_DOUBLE_EQ(mesh.volume(), 709281980661792.0 * step * step * step / 6.0);
  for (const auto& [a, b, c] : mesh.faces()) {
    const auto v = [&](int i) { return mesh.vertices()[static_cast<std::size_t>(i)]; };
    const int opposite = 6 - a - b - c;
    EXPECT_LT(mesh.grid().sign(v(opposite) - v(a), v(b) - v(a), v(c) - v(a)), 0);
  }

  TriangleList sharp;
  sharp.vertices = {{0.11792332661570981, -0.034016344216070138, -0.13538504997995915},
                    {0.073176491758204065, 0.06306714795937296, -0.1365123163050157},
                    {-0.091461451211216627, -0.023184073324955534, 0.13591963332146406},
                    {0.029346612012886908, 0.0090678449378174264, -0.044627562368987128}};
  sharp.faces = blade.faces;
  expect_complaint(sharp, {"mesh: face 0 folds back on to face ", " rad, expected >= 1e-13", "Solidify"});
}

// Along an edge of a cube the two faces have points of their own, off the edge by the rounding of
// a float: between them are caps, needles, rows of both, or back to back.
TEST(Mesh, TakesOutSliversOfRounding) {
  Random random(40);
  const double spacing = std::ldexp(1.0, -30);  // of floats at 0.01
  int slivers = 0;
  for (int round = 0; round < 300; ++round) {
    TriangleList list = cube();
    // Without (0, 5, 1) and (0, 1, 3), which the points along z divide.
    for (const std::ptrdiff_t face : {5, 0}) list.faces.erase(list.faces.begin() + face);
    std::map<double, int> along;
    for (std::size_t i = 1 + random.bits() % 5; i > 0; --i) {
      const double z = random.uniform(-0.009, 0.009);
      along[z] = static_cast<int>(random.bits() % 2);
      if (random.bits() % 2 != 0) along[z + spacing] = static_cast<int>(random.bits() % 2);
    }
    std::array<int, 2> last{0, 0};
    const auto advance = [&](int side, int to) {
      const int from = last[static_cast<std::size_t>(side)], beside = last[static_cast<std::size_t>(1 - side)];
      list.faces.push_back(side == 0 ? Face{from, to, 3} : Face{to, from, 5});
      if (from != beside && to != beside) list.faces.push_back(side == 0 ? Face{to, from, beside} : Face{from, to, beside});
      last[static_cast<std::size_t>(side)] = to;
    };
    for (const auto& [z, side] : along) {
      advance(side, static_cast<int>(list.vertices.size()));
      const auto off = [&] { return -0.01 + spacing * static_cast<double>(random.bits() % 2); };
      list.vertices.push_back({off(), off(), z});
    }
    advance(0, 1);
    advance(1, 1);
    const Mesh mesh(list);
    EXPECT_NEAR(mesh.volume(), 8e-6, 1e-12);
    slivers += mesh.repairs().slivers;
  }
  EXPECT_GT(slivers, 600);
}

// Two boxes that overlap, and one apart: any loads alone; the one apart with one of the others.
TEST(Mesh, LoadsOneBody) {
  TriangleList list = box_triangles({0.01, 0.02, 0.03});
  add(list, cube(), {0.005, 0.006, 0.007});
  list.name = "two.stl";
  expect_complaint(list,
                   {"two.stl: face ", " meets face ", "Its closed bodies overlap: unite them (", "or load one alone, as body=2 of 2"});
  EXPECT_NEAR(Mesh(list, 1).volume(), 4.8e-5, 1e-15);
  EXPECT_NEAR(Mesh(list, 2).volume(), 8e-6, 1e-15);
  for (const int body : {-1, 3}) EXPECT_THROW(Mesh(list, body), std::invalid_argument);
  // One of them open, and counted by its first face.
  std::rotate(list.faces.begin(), list.faces.end() - 1, list.faces.end());
  list.faces.pop_back();
  expect_complaint(list, {"has nothing beyond its edge", "closes them, or load one alone, as body=2 of 2"});
  EXPECT_NEAR(Mesh(list, 2).volume(), 4.8e-5, 1e-15);
  EXPECT_THROW(Mesh(list, 1), std::invalid_argument);
}

TEST(Mesh, MendsWhatCanBeMendedInOneWay) {
  // As in an STL: no vertex is shared.
  const TriangleList shared = cube();
  TriangleList list;
  for (const Face& face : shared.faces) {
    for (const int corner : face) {
      // Two that differ by less than the grid are one.
      list.vertices.push_back(shared.vertices[static_cast<std::size_t>(corner)] * (list.vertices.size() % 2 == 0 ? 1.0 : 1.0 + 1e-15));
    }
    const int last = static_cast<int>(list.vertices.size());
    list.faces.push_back({last - 3, last - 2, last - 1});
  }
  EXPECT_EQ(Mesh(list).repairs().welded, 28);
  EXPECT_EQ(Mesh(list).vertices().size(), 8U);

  // Needles of no width between two faces.
  list.faces.push_back({0, 1, 1});
  list.faces.push_back({3, 3, 3});
  EXPECT_EQ(Mesh(list).repairs().dropped, 2);
  EXPECT_EQ(Mesh(list).faces().size(), 12U);

  // Some faces look inward, or all.
  list = cube();
  for (const std::size_t face : {0U, 3U, 4U, 11U}) std::swap(list.faces[face][0], list.faces[face][2]);
  EXPECT_EQ(Mesh(list).repairs().turned, 4);
  EXPECT_NEAR(Mesh(list).volume(), 8e-6, 1e-16);
  list = cube();
  for (Face& face : list.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(Mesh(list).repairs().turned, 12);
  for (int i = 0; i < 12; ++i)
    EXPECT_GT(Mesh(list).normal(i).dot(list.vertices[static_cast<std::size_t>(list.faces[static_cast<std::size_t>(i)][0])]), 0.0);
}

// A cube with a hollow in which a smaller cube floats: outward is out of the matter, however the faces were given.
TEST(Mesh, KnowsHollows) {
  TriangleList list = cube();
  for (const double scale : {0.6, 0.3}) {
    TriangleList inner = cube();
    for (Vector3d& vertex : inner.vertices) vertex *= scale;
    add(list, inner);
  }
  const Mesh mesh(list);
  EXPECT_EQ(mesh.repairs().turned, 12);
  EXPECT_NEAR(mesh.volume(), 8e-6 * (1.0 - 0.216 + 0.027), 1e-16);
  for (const auto& [x, inside] : {std::pair(0.009, true), {0.005, false}, {0.002, true}, {0.011, false}}) {
    EXPECT_EQ(mesh.holds({x, 0.0001, 0.0002}), inside) << x;
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
