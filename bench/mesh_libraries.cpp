// SPDX-License-Identifier: MIT
// The closest point on a ball of 8192 triangles for a point one millimetre below or above it, with the libraries of Debian 12 and with
// ours: nanoseconds and allocator calls a query. `cmake --build --preset ci --target mesh_libraries`.
#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/mesh/triangle.hpp"
#include "tests/mesh/shapes.hpp"
#include "tests/touch.hpp"

#include <unsupported/Eigen/BVH>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>

#if __has_include(<fcl/fcl.h>)
#define HAS_FCL 1
#include <fcl/fcl.h>
#endif
#if __has_include(<boost/geometry.hpp>)
#define HAS_BOOST 1
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#endif
#if __has_include(<embree3/rtcore.h>)
#define HAS_EMBREE 1
#include <embree3/rtcore.h>
#endif
#if __has_include(<CGAL/AABB_tree.h>)
#define HAS_CGAL 1
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#endif
#if __has_include(<bullet/btBulletCollisionCommon.h>)
#define HAS_BULLET 1
#include <bullet/btBulletCollisionCommon.h>
#endif

namespace {
bool watching = false;
long calls = 0;
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
void* malloc(std::size_t size) {
  calls += watching;
  return __libc_malloc(size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  calls += watching;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr;
}
void free(void* memory) {
  __libc_free(memory);
}
}

using namespace limitcurve::godobject;
using Eigen::Vector3d;

namespace {

constexpr double radius = 0.05;
constexpr std::size_t count = 2000;

/// Best of many runs, and allocations of one run; the distance of the query is checked.
template <class Query>
void row(const char* name, const char* what, const std::vector<Vector3d>& points, double tolerance, Query&& query) {
  static_cast<void>(query(points[0]));
  double best = 1e300;
  double wrong = 0.0;
  for (int run = 0; run < 25; ++run) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0.0;
    for (const Vector3d& point : points) sum += query(point);
    best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / count);
    if (!(sum > 0.0)) std::abort();
  }
  calls = 0;
  watching = true;
  for (const Vector3d& point : points) wrong = std::max(wrong, std::fabs(query(point) - std::fabs(point.norm() - radius)));
  watching = false;
  std::printf("%-22s %-34s %9.0f %9.2f   %s\n", name, what, best, static_cast<double>(calls) / count,
              wrong < tolerance ? "" : "(not the distance)");
}

struct Ball {
  std::vector<Vector3d> vertices;
  std::vector<Face> faces;
  [[nodiscard]] const Vector3d& corner(int face, std::size_t i) const {
    return vertices[static_cast<std::size_t>(faces[static_cast<std::size_t>(face)][i])];
  }
};

struct ByEigen {
  const Ball& ball;
  Vector3d point;
  using Scalar = double;
  double minimumOnVolume(const Eigen::AlignedBox3d& box) const { return box.squaredExteriorDistance(point); }
  double minimumOnObject(int face) const {
    return (nearest_on_triangle(ball.corner(face, 0), ball.corner(face, 1), ball.corner(face, 2), point).point - point).squaredNorm();
  }
};

#ifdef HAS_BULLET
struct Nearest : btTriangleCallback {
  Vector3d point;
  double least = 1e300;
  void processTriangle(btVector3* t, int, int) override {
    const auto v = [](const btVector3& p) { return Vector3d(p.x(), p.y(), p.z()); };
    least = std::min(least, (nearest_on_triangle(v(t[0]), v(t[1]), v(t[2]), point).point - point).norm());
  }
};
#endif

}  // namespace

int main() {
  const TriangleList list = limitcurve::godobject::test::ball_triangles(radius, 5);
  const MeshSurface surface{Mesh(list)};
  const Mesh& mesh = surface.mesh();
  const Ball ball{{mesh.vertices().begin(), mesh.vertices().end()}, {mesh.faces().begin(), mesh.faces().end()}};
  // A finger's path: steps of about 0.3 mm, in and out.
  limitcurve::godobject::test::Random random(1);
  std::vector<Vector3d> points;
  Vector3d direction = Vector3d::UnitX();
  for (std::size_t i = 0; i < count; ++i) {
    direction = (direction + 0.006 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))).normalized();
    points.push_back((radius + (i / 50 % 2 == 0 ? -0.001 : 0.001)) * direction);
  }
  std::printf("%-22s %-34s %9s %9s\n", "library", "query", "ns", "calls");

  ContactMemory memory;
  row("limitcurve::mesh", "MeshSurface::contact, a step", points, 1e-4,
      [&](const Vector3d& p) { return std::fabs(touch(surface, p, memory).depth); });
  row("limitcurve::mesh", "Mesh::settle, tracked", points, 1e-4, [&, place = MeshPlace{}](const Vector3d& p) mutable {
    place = mesh.settle(place.face, place.point, p);
    return (place.point - p).norm();
  });
  row("limitcurve::mesh", "Mesh::nearest, from a far guess", points, 1e-4,
      [&](const Vector3d& p) { return (mesh.nearest(p, 0).point - p).norm(); });

  Eigen::KdBVH<double, 3, int> kd_tree;
  {
    std::vector<int> objects(ball.faces.size());
    std::vector<Eigen::AlignedBox3d> boxes;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      objects[i] = static_cast<int>(i);
      Eigen::AlignedBox3d box(ball.corner(static_cast<int>(i), 0));
      box.extend(ball.corner(static_cast<int>(i), 1)).extend(ball.corner(static_cast<int>(i), 2));
      boxes.push_back(box);
    }
    kd_tree.init(objects.begin(), objects.end(), boxes.begin(), boxes.end());
  }
  row("Eigen KdBVH", "BVMinimize", points, 1e-4, [&](const Vector3d& p) {
    ByEigen query{ball, p};
    return std::sqrt(Eigen::BVMinimize(kd_tree, query));
  });

#ifdef HAS_FCL
  {
    auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    std::vector<fcl::Triangle> triangles;
    for (const Face& f : ball.faces) triangles.emplace_back(f[0], f[1], f[2]);
    model->beginModel();
    model->addSubModel(ball.vertices, triangles);
    model->endModel();
    fcl::CollisionObjectd object(model);
    fcl::CollisionObjectd finger(std::make_shared<fcl::Sphered>(1e-9));
    row("FCL", "distance(sphere, BVHModel<OBBRSS>)", points, 1e-4, [&](const Vector3d& p) {
      finger.setTranslation(p);
      fcl::DistanceRequestd request;
      fcl::DistanceResultd result;
      return fcl::distance(&finger, &object, request, result);
    });
  }
#endif
#ifdef HAS_BOOST
  {
    namespace bg = boost::geometry;
    using Point = bg::model::point<double, 3, bg::cs::cartesian>;
    using Value = std::pair<bg::model::box<Point>, int>;
    std::vector<Value> values;
    for (int i = 0; i < static_cast<int>(ball.faces.size()); ++i) {
      const Vector3d low = ball.corner(i, 0).cwiseMin(ball.corner(i, 1)).cwiseMin(ball.corner(i, 2));
      const Vector3d high = ball.corner(i, 0).cwiseMax(ball.corner(i, 1)).cwiseMax(ball.corner(i, 2));
      values.push_back({{Point(low.x(), low.y(), low.z()), Point(high.x(), high.y(), high.z())}, i});
    }
    const bg::index::rtree<Value, bg::index::rstar<8>> tree(values);
    // The nearest boxes; the nearest triangle may be in another one.
    row("Boost.Geometry rtree", "query(nearest, 8 boxes)", points, 1e-4, [&](const Vector3d& p) {
      double least = 1e300;
      for (auto i = tree.qbegin(bg::index::nearest(Point(p.x(), p.y(), p.z()), 8)); i != tree.qend(); ++i) {
        const int face = i->second;
        least =
            std::min(least, (nearest_on_triangle(ball.corner(face, 0), ball.corner(face, 1), ball.corner(face, 2), p).point - p).norm());
      }
      return least;
    });
  }
#endif
#ifdef HAS_EMBREE
  {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, ball.vertices.size()));
    auto* indices =
        static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, ball.faces.size()));
    for (const Vector3d& v : ball.vertices) {
      for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(v[i]);
    }
    for (const Face& f : ball.faces) {
      for (const int i : f) *indices++ = static_cast<unsigned>(i);
    }
    struct Context {
      const Ball* ball;
      Vector3d point;
      double least;
    };
    rtcSetGeometryPointQueryFunction(geometry, [](RTCPointQueryFunctionArguments* arguments) {
      auto& context = *static_cast<Context*>(arguments->userPtr);
      const int face = static_cast<int>(arguments->primID);
      const double distance =
          (nearest_on_triangle(context.ball->corner(face, 0), context.ball->corner(face, 1), context.ball->corner(face, 2), context.point)
               .point -
           context.point)
              .norm();
      if (distance >= context.least) return false;
      context.least = distance;
      arguments->query->radius = static_cast<float>(distance);
      return true;
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);
    row("Embree (float boxes)", "rtcPointQuery", points, 1e-4, [&](const Vector3d& p) {
      Context own{&ball, p, 1e300};
      RTCPointQuery query{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0F,
                          std::numeric_limits<float>::infinity()};
      RTCPointQueryContext context;
      rtcInitPointQueryContext(&context);
      rtcPointQuery(scene, &query, &context, nullptr, &own);
      return own.least;
    });
  }
#endif
#ifdef HAS_CGAL
  {
    using Kernel = CGAL::Simple_cartesian<double>;
    std::vector<Kernel::Triangle_3> triangles;
    const auto at = [](const Vector3d& v) { return Kernel::Point_3(v.x(), v.y(), v.z()); };
    for (int i = 0; i < static_cast<int>(ball.faces.size()); ++i)
      triangles.emplace_back(at(ball.corner(i, 0)), at(ball.corner(i, 1)), at(ball.corner(i, 2)));
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::iterator>;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(), triangles.end());
    tree.build();
    tree.accelerate_distance_queries();
    row("CGAL AABB_tree", "squared_distance", points, 1e-4, [&](const Vector3d& p) { return std::sqrt(tree.squared_distance(at(p))); });
  }
#endif
#ifdef HAS_BULLET
  {
    btTriangleMesh triangles;
    const auto at = [](const Vector3d& v) {
      return btVector3(static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z()));
    };
    for (int i = 0; i < static_cast<int>(ball.faces.size()); ++i)
      triangles.addTriangle(at(ball.corner(i, 0)), at(ball.corner(i, 1)), at(ball.corner(i, 2)));
    const btBvhTriangleMeshShape shape(&triangles, true);
    row(sizeof(btScalar) == 4 ? "Bullet (float)" : "Bullet", "processAllTriangles, box of 4 mm", points, 1e-4, [&](const Vector3d& p) {
      Nearest nearest;
      nearest.point = p;
      const Vector3d reach = Vector3d::Constant(0.002);
      shape.processAllTriangles(&nearest, at(p - reach), at(p + reach));
      return nearest.least;
    });
  }
#endif
}
