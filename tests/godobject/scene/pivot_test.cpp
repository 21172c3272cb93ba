// SPDX-License-Identifier: MIT
#include "godobject/scene/pivot.hpp"

#include "godobject/scene/gripped_block.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::pivot_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

PivotOptions experiment(PivotCase kind) {
  PivotOptions options;
  options.kind = kind;
  return options;
}

constexpr PivotCase cases[] = {PivotCase::coupled, PivotCase::uncoupled, PivotCase::exact};

/// The whole experiment: the row at time 0 and one for each step.
std::vector<PivotRow> rows_of(const PivotOptions& options) {
  Pivot pivot(options);
  std::vector<PivotRow> rows{pivot.row()};
  while (pivot.step()) rows.push_back(pivot.row());
  return rows;
}

TEST(Pivot, StartsLevelAndAtRest) {
  for (const PivotCase kind : cases) {
    const PivotRow row = Pivot(experiment(kind)).row();
    EXPECT_EQ(row.time, 0.0);
    EXPECT_EQ(row.x, -0.005);
    EXPECT_EQ(row.y, 0.0);
    EXPECT_EQ(row.angle, 0.0);
    EXPECT_EQ(row.load, 0.5);
    EXPECT_EQ(row.state, ContactState::stick);
    EXPECT_NEAR(row.friction_force, 0.981, 1e-12);
    EXPECT_NEAR(row.friction_moment, 0.981 * 0.005, 1e-14);
    PivotOptions constant = experiment(kind);
    constant.grip = {{0.0, 0.5}};
    constant.duration = 1.0;
    const PivotRow end = rows_of(constant).back();
    EXPECT_NEAR(end.time, 1.0, 1e-12);
    EXPECT_NEAR(end.x, -0.005, 1e-12);
    EXPECT_NEAR(end.y, 0.0, 1e-12);
    EXPECT_NEAR(end.angle, 0.0, 1e-10);
    EXPECT_EQ(end.grip_slip, 0.0);
  }
}

// The load at which it begins to slip is the analytic one, to within what the load falls by in one time step.
TEST(Pivot, FirstSlipsAtTheHoldingLoad) {
  for (const PivotCase kind : cases) {
    PivotOptions options = experiment(kind);
    const double expected = Pivot(options).holding_load();
    // Slowly, past the holding load: 1e-6 of it in 100 steps.
    options.grip = {{0.0, expected * (1.0 + 1e-6)}, {0.4, expected * (1.0 - 3e-6)}};
    options.duration = 0.4;
    double found = 0.0;
    for (const PivotRow& row : rows_of(options)) {
      if (row.state != ContactState::slip) continue;
      found = row.load;
      break;
    }
    EXPECT_NEAR(found / expected, 1.0, 1e-6) << to_string(kind);
  }
  // Eq. (19) by hand: (0.4905/1.67)² + (0.4905·5/10.11)².
  EXPECT_NEAR(Pivot(experiment(PivotCase::coupled)).holding_load(), std::hypot(0.4905 / 1.67, 0.4905 * 5.0 / 10.11),
              1e-12);
  EXPECT_NEAR(Pivot(experiment(PivotCase::uncoupled)).holding_load(), 0.4905 / 1.67, 1e-12);
}

// First order: the change from halving the time step halves too. In a short build the steps are sixteen times as long.
TEST(Pivot, ConvergesWithTheTimeStep) {
  for (const PivotCase kind : {PivotCase::coupled, PivotCase::exact}) {
    PivotOptions options = experiment(kind);
    const double load = Pivot(options).holding_load();
    options.grip = {{0.0, load}, {1.5, 0.95 * load}};
    options.duration = 1.5;
    std::vector<PivotRow> ends;
    for (const double time_step : {1e-3, 5e-4, 2.5e-4, 1.25e-4}) {
      options.time_step = tests_are_short ? 16.0 * time_step : time_step;
      ends.push_back(rows_of(options).back());
    }
    EXPECT_GT(ends.back().angle, 5.0 * degree);
    for (std::size_t i = 2; i < ends.size(); ++i) {
      EXPECT_LT(std::fabs(ends[i].angle - ends[i - 1].angle), 0.7 * std::fabs(ends[i - 1].angle - ends[i - 2].angle))
          << to_string(kind);
      EXPECT_LT(std::fabs(ends[i].grip_slip - ends[i - 1].grip_slip),
                0.7 * std::fabs(ends[i - 1].grip_slip - ends[i - 2].grip_slip));
    }
  }
}

// 0.5 N as ever, or what holds: 1.3 times eq. (19)'s load, 1.3 · hypot(0.4905/0.42, 0.4905·5/3.05) = 1.843.
TEST(Pivot, AGripThatIsLeftOpenHoldsTheBlockAtFirst) {
  PivotOptions options;
  EXPECT_EQ(default_load(options), 0.5);
  options.mass = 0.01;
  EXPECT_EQ(default_load(options), 0.5);
  options.mass = 0.1;
  options.mu = 0.42;
  options.mu_r = 0.00305;
  EXPECT_EQ(default_load(options), 1.9);
  options.mass = 100.0;
  EXPECT_EQ(default_load(options), 1900.0);
  options.stiffness = 1e6;  // under which so much weight does not lower the block out of the grip
  options.twist_stiffness = 10.0;
  for (const Law& law : {flat_punch(), power(-0.9), uniform()}) {
    options.kind = PivotCase::exact;
    options.law = law;
    EXPECT_LT(Pivot(options).holding_load(), default_load(options)) << law->name();
  }
  // Where no load holds the block, there is none to find.
  options.mu_r = 0.0;
  EXPECT_EQ(default_load(options), 0.5);
  EXPECT_EQ(Pivot(options).holding_load(), infinity);
}

// Deeper than 0.5 m, where a finger's own sample would be a jump.
TEST(Pivot, ADeepGripHoldsTheBlock) {
  for (const double load : {490.0, 510.0, 1e6, 4e8}) {
    PivotOptions options;
    options.grip = {{0.0, load}};
    options.duration = 0.2;
    for (const PivotCase kind : cases) {
      options.kind = kind;
      Pivot pivot(options);
      while (pivot.step()) {
      }
      EXPECT_EQ(pivot.row().state, ContactState::stick) << load;
      EXPECT_NEAR(pivot.row().friction_force, 0.981, 1e-9) << load;
    }
  }
  PivotOptions far;
  far.grip = {{0.0, 6e8}};
  EXPECT_THROW(Pivot{far}, std::invalid_argument);
}

TEST(Pivot, ABlockThatFallsOutOfTheWorldIsInvalidForAReason) {
  PivotOptions options;
  options.gravity = 1e7;
  options.stiffness = 1e9;
  options.twist_stiffness = 1e6;
  options.grip = {{0.0, 1e7}, {1.0, 0.0}};
  options.time_step = 1.0;
  Pivot pivot(options);
  while (pivot.step() && pivot.row().state != ContactState::invalid) {
  }
  EXPECT_EQ(pivot.row().fault, Fault::force);
}

TEST(GrippedBlock, GoesOnWithOtherFingers) {
  const FingerParameters with = parameters(1.67, 0.01, 1000.0, 0.037);
  GrippedBlock block(PivotOptions{}, hertz_finger(with));
  block.take(0.5);
  GrippedBlock same = block;
  const auto turn = [](GrippedBlock& one) {
    for (int i = 0; i < 400; ++i) one.step(0.3 - 1e-4 * i, 1e-3);
    return one.angle();
  };
  turn(block);
  turn(same);
  same.change_fingers(hertz_finger(with));
  const double angle = turn(block);
  // To the rounding of the equations: a new grasp has no last Jacobian to begin with.
  EXPECT_NEAR(turn(same), angle, 1e-12);
  EXPECT_GT(angle, 0.1);
}

// A bad step moves nothing, and is over with the next. The load is the one asked for where no damper acts, too: after a
// bad step, and in the shortest ones.
TEST(GrippedBlock, RecoversFromBadSteps) {
  FingerParameters with = parameters(1.67, 0.01, 1000.0, 0.037);
  with.damping = 1.0;
  GrippedBlock block(PivotOptions{}, hertz_finger(with));
  block.take(0.5);
  block.step(0.4, 1e-3);
  for (const auto& [load, time_step] : {std::pair{0.4, 0.0}, {0.4, nan}, {0.4, -1e-3}, {infinity, 1e-3}, {nan, 1e-3}}) {
    GrippedBlock same = block;
    block.step(load, time_step);
    EXPECT_EQ(block.grasp().finger(0).output().state, ContactState::invalid);
    block.step(0.4, 1e-3);
    same.step(0.4, 1e-3);
    EXPECT_NE(block.grasp().finger(0).output().state, ContactState::invalid);
    for (const GrippedBlock* one : {&block, &same}) EXPECT_NEAR(one->grasp().finger(0).output().load, 0.4, 1e-12);
  }
  block.step(0.1, 1e-10);
  EXPECT_NEAR(block.grasp().finger(0).output().load, 0.1, 1e-12);
}

TEST(Pivot, NamesWhatIsWrongWithItsOptions) {
  const auto refused = [](auto change, const char* told) {
    PivotOptions options;
    change(options);
    expect_mention(complaint([&] { Pivot{options}; }), told);
  };
  refused([](PivotOptions& o) { o.mass = 0.0; }, "mass");
  refused([](PivotOptions& o) { o.mu = -1.0; }, "mu");
  refused([](PivotOptions& o) { o.offset = 0.06; }, "offset");
  refused([](PivotOptions& o) { o.time_step = 0.0; }, "time_step");
  refused([](PivotOptions& o) { o.stiffness = nan; }, "stiffness");
  // Springs so soft that the block would hang below the grip, or upside down.
  refused([](PivotOptions& o) { o.stiffness = 24.0; }, "stiffness = 24 N/m");
  refused([](PivotOptions& o) { o.stiffness = 25.0; }, "none");
  refused([](PivotOptions& o) { o.twist_stiffness = 7.8e-4; }, "twist_stiffness");
  refused([](PivotOptions& o) { o.twist_stiffness = 7.9e-4; }, "none");
  refused([](PivotOptions& o) { o.grip = {{1.0, 1.0}, {1.0, 2.0}}; }, "time");
  refused([](PivotOptions& o) { o.grip = {{1.0, -1.0}}; }, "load");
  refused(
      [](PivotOptions& o) {
        o.grip = {{0.0, 1.0}};
        o.grip_operator = GripOperator{};
      },
      "grip");
  for (const PivotCase kind : cases) EXPECT_EQ(parse_pivot_case(to_string(kind)), kind);
  EXPECT_THROW(static_cast<void>(parse_pivot_case("both")), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::godobject::test::pivot_test
