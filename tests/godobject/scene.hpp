// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"
#include "tests/limitcurve/shared.hpp"

#include <Eigen/Core>

#include <bit>
#include <optional>

/// What the tests of this folder share: a finger on the plane z = 0, and seeded random numbers.
namespace limitcurve::godobject::test {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using limitcurve::test::apart;
using limitcurve::test::complaint;
using limitcurve::test::expect_mention;
using limitcurve::test::nan;
inline constexpr double infinity = limitcurve::test::inf;

/// A finger at (x, y), `depth` beneath the plane z = 0.
inline Contact on_plane(double x, double y, double depth) {
  return {{x, y, 0.0}, Vector3d::UnitZ(), depth};
}

/// A ball about the origin, because the library's curved surfaces are a leaf.
struct Ball {
  double radius;

  [[nodiscard]] Contact contact(const Vector3d& finger, const ContactMemory& /*memory*/) const noexcept {
    const double distance = finger.norm();
    return {finger * (radius / distance), finger / distance, radius - distance};
  }
};

inline FingerParameters parameters(double mu = 0.6, double radius = 0.005, double stiffness = 1000.0,
                                   double twist_stiffness = 0.04) {
  FingerParameters result;
  result.mu = mu;
  result.radius_law = RadiusLaw::constant(radius);
  result.stiffness = stiffness;
  result.twist_stiffness = twist_stiffness;
  result.max_speed = 500.0;  // tests jump: 0.5 m in a millisecond
  return result;
}

/// Random numbers with a fixed seed: the same on every run.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * unit_(engine_); }
  /// Evenly in the logarithm.
  double logarithmic(double low, double high) { return low * std::pow(high / low, unit_(engine_)); }
  /// Each component within ± size.
  Vector3d vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  std::uint64_t bits() { return engine_(); }
  /// 0, 1, …, count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

constexpr std::array curve_kinds{CurveKind::exact, CurveKind::table, CurveKind::ellipse, CurveKind::box};
constexpr std::array projections{Projection::radial, Projection::c_curve, Projection::closest_point};

/// Every kind of curve of a law, handed to `body(curve)`.
template <class Body>
void for_each_curve(const Law& law, Body&& body) {
  for (const CurveKind kind : curve_kinds) {
    SCOPED_TRACE(testing::Message() << law->name() << ' ' << to_string(kind));
    body(make_finger_curve(kind, law, 1e-8));
  }
}

/// A kind of curve with a projection that it goes with.
struct CurveChoice {
  CurveKind kind;
  Projection projection;
  [[nodiscard]] std::string name() const {
    return std::string(to_string(kind)) + ' ' + std::string(to_string(projection));
  }
};

inline std::vector<CurveChoice> all_curves() {
  std::vector<CurveChoice> result;
  for (const CurveKind kind : curve_kinds) {
    for (const Projection projection : projections) {
      if (kind != CurveKind::box || projection == Projection::closest_point) result.push_back({kind, projection});
    }
  }
  return result;
}

/// All of them, of one law, handed to `body(curve, projection)`.
template <class Body>
void for_each_curve_and_projection(const Law& law, Body&& body) {
  for (const CurveChoice& choice : all_curves()) {
    SCOPED_TRACE(law->name() + ' ' + choice.name());
    body(make_finger_curve(choice.kind, law, 1e-8), choice.projection);
  }
}

/// The finest table of a law.
inline FingerCurve exact_curve(const Law& law) {
  return make_finger_curve(CurveKind::exact, law, 0.0);
}

inline bool same_bits(const Vector3d& a, const Vector3d& b) {
  return std::bit_cast<std::array<double, 3>>(std::array{a.x(), a.y(), a.z()}) == std::array{b.x(), b.y(), b.z()};
}

/// A finger of the Hertz law by the closest point, on the ellipse or the exact curve.
inline SoftFinger hertz_finger(const FingerParameters& with = parameters()) {
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}
inline SoftFinger exact_hertz_finger(const FingerParameters& with = parameters()) {
  return {exact_curve(hertz()), with};
}

/// That nothing differs, not by one bit.
inline void expect_same(const FingerOutput& one, const FingerOutput& other) {
  const auto bits = [](const FingerOutput& out) {
    return std::bit_cast<std::array<std::uint64_t, 15>>(std::array{
        out.proxy.x(), out.proxy.y(), out.proxy.z(), out.normal.x(), out.normal.y(), out.normal.z(), out.force.x(),
        out.force.y(), out.force.z(), out.angle, out.depth, out.load, out.moment, out.cor, out.slip_work});
  };
  EXPECT_EQ(bits(one), bits(other));
  EXPECT_EQ(to_string(one.state), to_string(other.state));
  EXPECT_EQ(to_string(one.fault), to_string(other.fault));
}

/// A friction wrench in units of μP and μPa.
inline UnitWrench unit_wrench(const FingerState& state, double mu, double radius) {
  const double unit = mu * state.limit_load;
  return {state.output.force.norm() / unit, std::fabs(state.output.moment) / (unit * radius)};
}

}  // namespace limitcurve::godobject::test
