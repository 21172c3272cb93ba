// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace limitcurve::godobject::test {
namespace {

ReplayOptions options(BoundaryKind boundary = BoundaryKind::table, ProjectionKind projection = ProjectionKind::closest_point) {
  ReplayOptions result;
  result.law = hertz();
  result.radius_law = RadiusLaw::constant(0.005);
  result.mu = 0.6;
  result.stiffness = 1000.0;
  result.twist_stiffness = 0.04;
  result.boundary = boundary;
  result.projection = projection;
  result.tolerance = 1e-8;
  return result;
}

std::vector<TraceSample> slide_and_twist() {
  std::vector<TraceSample> trace;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * 1e-3;
    trace.push_back({t, 0.01 * t, 0.02 * t * t, 0.0005 - 0.004 * t * (1.0 - t) * 4.0, 2.0 * t});
  }
  return trace;
}

constexpr BoundaryKind boundaries[] = {BoundaryKind::exact,        BoundaryKind::table,   BoundaryKind::ellipse,
                                       BoundaryKind::superellipse, BoundaryKind::quartic, BoundaryKind::box};
constexpr ProjectionKind projections[] = {ProjectionKind::radial, ProjectionKind::c_curve, ProjectionKind::closest_point};

TEST(Replay, RunsEveryBoundaryWithEveryProjection) {
  const std::vector<TraceSample> trace = slide_and_twist();
  for (const BoundaryKind boundary : boundaries) {
    for (const ProjectionKind projection : projections) {
      Replay whole(options(boundary, projection));
      Replay stepwise(options(boundary, projection));
      std::vector<ReplayRow> rows(trace.size());
      whole.run(trace, rows);
      int slips = 0;
      for (std::size_t i = 0; i < trace.size(); ++i) {
        const ReplayRow row = stepwise.step(trace[i]);
        ASSERT_EQ(row.state, rows[i].state);
        ASSERT_EQ(row.fx, rows[i].fx);
        ASSERT_EQ(row.moment, rows[i].moment);
        slips += row.state == ContactState::slip;
      }
      EXPECT_GT(slips, 100) << to_string(boundary) << ' ' << to_string(projection);
      EXPECT_EQ(rows.front().state, ContactState::free);
      EXPECT_EQ(rows.back().state, ContactState::free);
      EXPECT_EQ(rows.back().px, trace.back().x);
      EXPECT_EQ(rows.back().angle, trace.back().twist);
      EXPECT_EQ(rows.back().load, 0.0);
      EXPECT_EQ(rows.back().depth, -trace.back().z);
      EXPECT_TRUE(std::isnan(rows.back().cor));
    }
  }
}

TEST(Replay, SettlesAtTheImposedCentreOfRotation) {
  for (const double kappa : {0.1, 1.0, 10.0}) {
    ReplayOptions with = options();
    const double m0 = hertz()->moment_ratio();
    with.twist_stiffness = kappa * with.stiffness * (m0 * 0.005) * (m0 * 0.005);
    Replay replay(with);
    ReplayRow row;
    const double c = 0.005;
    // At κ = 0.1 the twist spring gives way by four radians.
    for (int i = 0; i <= 20000; ++i) row = replay.step({i * 1e-3, i * 2e-5, 0.0, -0.002, i * 2e-5 / c});
    const UnitForces<double> exact = hertz()->forces(1.0);
    EXPECT_NEAR(row.fx, -1.2 * exact.force, 1e-6 * 1.2);
    EXPECT_NEAR(row.moment, -1.2 * 0.005 * exact.moment, 1e-6 * 1.2 * 0.005);
    EXPECT_NEAR(row.cor, c, 1e-5 * c);
  }
}

TEST(Replay, HoldsOnSamplesThatAreNotUsable) {
  ReplayOptions with = options();
  with.hold_share = 1.0;
  Replay replay(with);
  static_cast<void>(replay.step({0.0, 0.0, 0.0, -0.002, 0.0}));
  const ReplayRow good = replay.step({0.001, 0.0003, 0.0, -0.002, 0.0});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TraceSample& bad : {TraceSample{0.002, nan, 0.0, -0.002, 0.0}, TraceSample{0.002, 0.0, 0.0, nan, 0.0},
                                 TraceSample{nan, 0.0, 0.0, -0.002, 0.0}, TraceSample{0.0005, 0.0, 0.0, -0.002, 0.0}}) {
    const ReplayRow row = replay.step(bad);
    EXPECT_EQ(row.state, ContactState::invalid);
    EXPECT_EQ(row.fx, good.fx);
    EXPECT_EQ(row.px, good.px);
    EXPECT_EQ(row.load, good.load);
  }
  EXPECT_EQ(replay.step({0.002, 0.0003, 0.0, -0.002, 0.0}).state, ContactState::stick);
}

TEST(Replay, NamesWhatIsWrongWithItsOptions) {
  const auto message = [](auto change) -> std::string {
    ReplayOptions with = options();
    change(with);
    try {
      Replay replay(with);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message([](ReplayOptions& with) { with.law = nullptr; }).find("law"), std::string::npos);
  EXPECT_NE(message([](ReplayOptions& with) { with.mu = -0.1; }).find("mu"), std::string::npos);
  EXPECT_NE(message([](ReplayOptions& with) { with.stiffness = 0.0; }).find("stiffness"), std::string::npos);
  EXPECT_NE(message([](ReplayOptions& with) { with.twist_stiffness = -1.0; }).find("twist_stiffness"), std::string::npos);
  EXPECT_NE(message([](ReplayOptions& with) { with.tolerance = 0.0; }).find("tolerance"), std::string::npos);
}

TEST(Kinds, ReadBackAsTheyArePrinted) {
  for (const BoundaryKind kind : boundaries) EXPECT_EQ(parse_boundary_kind(to_string(kind)), kind);
  for (const ProjectionKind kind : projections) EXPECT_EQ(parse_projection_kind(to_string(kind)), kind);
  EXPECT_THROW(static_cast<void>(parse_boundary_kind("circle")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(parse_projection_kind("")), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::godobject::test
