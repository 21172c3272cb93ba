// SPDX-License-Identifier: MIT
// What fingers, a batch, a scene and curves give, on one path. `drive write FILE` writes it; `drive compare FILE`,
// compiled for the processor
// (-march=native), compares: what the library gives is the same to the last bit, what this file makes of the library's
// templates to 1e-12.
#include "godobject/batch/batch.hpp"
#include "godobject/body/grasp.hpp"
#include "godobject/friction.hpp"
#include "godobject/godobject.hpp"
#include "godobject/scene/replay.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "limitcurve/contact/load_to_hold.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

struct Number {
  const char* origin;
  double value;
  double tolerance;  // 0: the same bits
};
std::vector<Number> numbers_so_far;

void keep(const char* origin, std::initializer_list<double> values, double tolerance = 0.0) {
  for (const double value : values) numbers_so_far.push_back({origin, value, tolerance});
}

// Here and below inputs are multiples of powers of 2, or products: a multiplication fused with an addition gives the
// same.
constexpr double tick = 0x1p-10;  // [s]

void drive_fingers(const FingerCurve& curve) {
  const FingerParameters skin{.mu = 0.6,
                              .radius_law = RadiusLaw::power(0.00207, 0.259),
                              .stiffness = 1000.0,
                              .twist_stiffness = 0.002,
                              .damping = 1.0};
  const AnySurface ball(SphereSurface(0.05));
  for (const Projection projection : {Projection::radial, Projection::c_curve, Projection::closest_point}) {
    SoftFinger finger(curve, skin, projection);
    for (int step = 0; step < 500; ++step) {
      const double time = tick * step;
      const Eigen::Quaterniond turn(std::cos(time), 0.0, 0.0, std::sin(time));
      const FingerOutput felt =
          finger.update(ball, {{0.048 * std::sin(time), 0.0, 0.048 * std::cos(time)}, turn}, tick);
      keep("finger", {felt.force.x(), felt.force.y(), felt.force.z(), felt.moment, felt.load, finger.margin(),
                      finger.load_to_hold()});
    }
  }
}

void step_batch(const Table& table) {
  const Batch batch(
      table, {.mu = 0.6, .radius_law = RadiusLaw::constant(0.005), .stiffness = 1000.0, .twist_stiffness = 0.002});
  ContactArrays arrays(5);  // packs, and a rest
  const auto contacts = arrays.batch();
  for (int step = 0; step < 200; ++step) {
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      arrays.x()[i] = 0x1p-17 * step * static_cast<double>(i + 1);
      arrays.twist()[i] = tick * step;
      arrays.depth()[i] = 0x1p-9 + 0x1p-20 * step;
    }
    batch.step(contacts);
  }
  for (std::size_t i = 0; i < arrays.size(); ++i) keep("batch", {contacts.fx[i], contacts.fy[i], contacts.moment[i]});
}

// Poses in arrays, and in an object that the library writes to.
void replay_scene() {
  ReplayOptions options;
  options.law = hertz();
  options.finger = {.mu = 0.6,
                    .radius_law = RadiusLaw::constant(0.005),
                    .stiffness = 1000.0,
                    .twist_stiffness = 0.002,
                    .damping = 1.0};
  options.surface = AnySurface(BoxSurface({0.02, 0.02, 0.02}));
  options.fingers = 2;
  options.motion = BodyMotion::free;
  options.body = BodyParameters::block(0.1, {0.04, 0.04, 0.04});
  Replay replay(options);
  for (int step = 0; step < 200; ++step) {
    const double time = tick * step;
    const Eigen::Quaterniond turn(std::cos(time), std::sin(time), 0.0, 0.0);
    replay.step(
        time, std::vector<DevicePose>{{{0.019, 0x1p-17 * step, 0.0}, turn}, {{-0.019, 0x1p-16 * step, 0x1p-10}, turn}});
    for (const SceneContact& contact : replay.contacts())
      keep("scene", {contact.force.x(), contact.force.y(), contact.moment, contact.load});
    keep("body", {replay.body().position.z(), replay.body().orientation.x(), replay.body().angular_velocity.x()});
  }
}

void use_curve(const FingerCurve& curve) {
  FrictionMemory<double> memory;
  for (int step = 1; step < 16; ++step) {
    const double part = 0x1p-4 * step;
    const UnitWrench direction{1.0 - part, 0.5 * part};
    const auto [point, normal] = curve.along(direction);
    keep("curve", {curve.gauge(direction), point.force, point.moment, normal.slide, curve.wrench({part, 1.0}).force});
    double gauge = 0.0;
    const CurvePoint<double> on_ray = point_on_ray(curve.view(), direction.force, direction.moment, 0.0, gauge);
    const FrictionResult<double> rubbed =
        apply_friction(curve.view(), Projection::closest_point, {{1.0, 0.005}, {1.0, 0.005}, 25000.0},
                       {2.0 - part, 0.01 * part}, memory);
    keep("template",
         {gauge, on_ray.force, on_ray.moment, rubbed.force_fraction, rubbed.moment_fraction,
          load_to_hold(curve, {.mu = 0.6, .radius_law = RadiusLaw::power(0.00207, 0.259)}, part, 0.001)},
         1e-12);
  }
}

// Inlined functions are this file's, the others and spans the library's.
template <class Real>
void use_table(const BasicTable<Real>& table, const Ellipse& ellipse) {
  constexpr double inlined = sizeof(Real) == sizeof(float) ? 1e-6 : 1e-12;
  std::vector<SlipTwist> twists;
  for (int i = 0; i <= 2000; ++i) twists.push_back(SlipTwist{std::sqrt(0x1p-10 * i), std::sqrt(2.0 - 0x1p-10 * i)});
  std::vector<UnitWrench> wrenches(twists.size());
  std::vector<double> gauges(twists.size());
  table.wrench(twists, wrenches);
  table.gauge(wrenches, gauges);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    const auto [point, normal] = table.along(wrenches[i]);
    keep("table",
         {wrenches[i].force, wrenches[i].moment, gauges[i], point.force, point.moment, normal.slide, normal.spin});
    const UnitWrench single = table.wrench(twists[i]);
    const UnitWrench of_ellipse = ellipse.wrench(twists[i]);
    keep("inlined",
         {single.force, single.moment, table.point(twists[i]).wrench.moment, table.gauge(wrenches[i]), of_ellipse.force,
          of_ellipse.moment},
         inlined);
  }
}

// A user's own matrices of the sizes that the library has.
void invert() {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity();
  for (int i = 0; i < 36; ++i) matrix(i / 6, i % 6) += 0.5 / (1.0 + i);
  const Eigen::Matrix<double, 6, 1> solution = matrix.partialPivLu().solve(Eigen::Matrix<double, 6, 1>::Ones());
  keep("matrix", {solution.sum()}, 1e-12);
}

int compare(std::FILE* file) {
  int differ = 0;
  for (const Number& number : numbers_so_far) {
    double expected = 0.0;
    if (std::fscanf(file, "%la", &expected) != 1) return 1;
    const bool is_same = number.value == expected || (std::isnan(number.value) && std::isnan(expected));
    if (is_same || std::fabs(number.value - expected) < number.tolerance * std::fmax(1.0, std::fabs(expected)))
      continue;
    if (++differ <= 10) std::printf("%s: %a, expected %a\n", number.origin, number.value, expected);
  }
  std::printf("%d of %zu numbers differ\n", differ, numbers_so_far.size());
  return differ > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const Table table = Table::build(hertz(), 1e-8);
  const FingerCurve curves[] = {table, Ellipse::through_intercepts(hertz()->moment_ratio())};
  for (const FingerCurve& curve : curves) {
    drive_fingers(curve);
    use_curve(curve);
  }
  use_table(table, Ellipse::through_intercepts(table.moment_ratio()));
  use_table(FloatTable::build(hertz(), 1e-6), Ellipse::through_intercepts(table.moment_ratio()));
  step_batch(table);
  replay_scene();
  invert();
  for (const char* law : {"hertz", "xydas-kao:k=3", "gaussian:sigma=0.4"})
    keep(law, {parse_law(law)->forces(0.7).force, parse_law(law)->moment_ratio()});
  const bool writes = std::strcmp(argv[1], "write") == 0;
  std::FILE* file = std::fopen(argv[2], writes ? "w" : "r");
  if (file == nullptr) return 2;
  int status = 0;
  if (!writes) status = compare(file);
  for (const Number& number : numbers_so_far) {
    if (writes) std::fprintf(file, "%a\n", number.value);
  }
  std::fclose(file);
  return status;
}
