// SPDX-License-Identifier: MIT
// Parameters that move by 1e-12 of themselves, or from 0 to almost 0, move what a finger feels by no more than that: on
// every surface, with every curve, projection and set of parameters.
#include "tests/godobject/scene/metamorphic/metamorphic.hpp"

namespace limitcurve::godobject::test::metamorphic {
namespace {

constexpr double little = 1e-12;

/// Moves one parameter of a finger a little; false where it has none of it.
struct Change {
  std::string name;
  std::function<bool(FingerParameters&, Projection)> apply;
};

Change grown(const std::string& name, double FingerParameters::*member) {
  return {name, [member](FingerParameters& finger, Projection) {
            finger.*member *= 1.0 + little;
            return finger.*member > 0.0;
          }};
}

/// From 0 to `least`.
Change begun(const std::string& name, double FingerParameters::*member, double least) {
  return {name + " from 0", [member, least](FingerParameters& finger, Projection) {
            if (finger.*member > 0.0) return false;
            finger.*member = least;
            return true;
          }};
}

/// Less by `little`, or from 0 to `little`.
void move(double& value) {
  value = value > 0.0 ? value * (1.0 - little) : little;
}

/// Moment over load. Where it is almost 0 the radial projections keep the ratio of force and moment, however large, and
/// so no force either: their own limit there is not that of a contact without torsion.
Change coefficient(const std::string& name, std::optional<double> FingerParameters::*member) {
  return {name, [member](FingerParameters& finger, Projection projection) {
            std::optional<double>& value = finger.*member;
            if (!value || (*value == 0.0 && projection != Projection::closest_point)) return false;
            move(*value);
            return true;
          }};
}

bool move_mu_dynamic(FingerParameters& finger, Projection) {
  if (finger.mu_dynamic) move(*finger.mu_dynamic);
  return finger.mu_dynamic.has_value();
}

bool give_mu_dynamic(FingerParameters& finger, Projection) {
  if (finger.mu_dynamic || finger.mu == 0.0) return false;
  finger.mu_dynamic = finger.mu;
  move(*finger.mu_dynamic);
  return true;
}

/// a = cP^γ: both c and γ, which may be 0, a little more.
bool move_radius(FingerParameters& finger, Projection) {
  finger.radius_law =
      RadiusLaw::power(finger.radius_law.radius(1.0) * (1.0 + little), finger.radius_law.exponent() + little);
  return !finger.mu_r.has_value();
}

std::vector<Change> changes() {
  return {grown("mu", &FingerParameters::mu),
          grown("stiffness", &FingerParameters::stiffness),
          grown("twist_stiffness", &FingerParameters::twist_stiffness),
          grown("rest_margin", &FingerParameters::rest_margin),
          grown("fault_decay", &FingerParameters::fault_decay),
          grown("damping", &FingerParameters::damping),
          grown("twist_damping", &FingerParameters::twist_damping),
          begun("mu", &FingerParameters::mu, little),
          // What counts is b/Δt beside the stiffness: 1e-12 of it.
          begun("damping", &FingerParameters::damping, little),
          begun("twist_damping", &FingerParameters::twist_damping, 3e-17),
          coefficient("mu_r", &FingerParameters::mu_r),
          coefficient("mu_r_dynamic", &FingerParameters::mu_r_dynamic),
          {"mu_dynamic", move_mu_dynamic},
          {"mu_dynamic given", give_mu_dynamic},
          {"radius", move_radius}};
}

/// What a finger does along a path, with some samples refused.
std::vector<FingerOutput> outputs(SoftFinger finger, const AnySurface& surface, const std::vector<DevicePose>& path) {
  std::vector<FingerOutput> result;
  for (const DevicePose& device : path) result.push_back(finger.update(surface, device, time_step));
  return result;
}

void expect_near(const FingerOutput& one, const FingerOutput& other, const Tolerance& within) {
  ASSERT_EQ(one.state == ContactState::invalid, other.state == ContactState::invalid);
  ASSERT_EQ(one.state == ContactState::free, other.state == ContactState::free);
  ASSERT_LE((one.proxy - other.proxy).norm(), within.length);
  ASSERT_NEAR(one.angle, other.angle, within.angle);
  ASSERT_NEAR(one.load, other.load, within.force);
  ASSERT_LE((one.force - other.force).norm(), within.force);
  ASSERT_NEAR(one.moment, other.moment, within.moment);
}

TEST(Metamorphic, AParameterMovedALittleMovesTheForceALittle) {
  const std::vector<Change> all = changes();
  std::vector<int> compared(all.size());
  for_each_choice(11, [&](const Choice& choice, Random& random) {
    const FingerCurve curve = make_finger_curve(choice.curve.kind, hertz(), 1e-8);
    const RandomDevice device(choice.surface.surface, random);
    std::vector<DevicePose> path;
    for (int i = 0; i < rows; ++i) path.push_back(device.at(i * time_step));
    for (std::size_t i = 100; i < 105; ++i) path[i].position.x() = std::numeric_limits<double>::quiet_NaN();
    const auto felt = [&](const FingerParameters& with) {
      return outputs(SoftFinger(curve, with, choice.curve.projection), choice.surface.surface, path);
    };
    const std::vector<FingerOutput> before = felt(choice.parameters.finger);
    // Deflections are some 5 mm and 1 rad.
    const Tolerance within = Tolerance::of(choice.parameters.finger, time_step, 0.005 * little, little, rows);
    for (std::size_t change = 0; change < all.size(); ++change) {
      FingerParameters changed = choice.parameters.finger;
      if (!all[change].apply(changed, choice.curve.projection)) continue;
      const std::vector<FingerOutput> after = felt(changed);
      for (std::size_t i = 0; i < path.size(); ++i) {
        SCOPED_TRACE(all[change].name + ", row " + std::to_string(i));
        expect_near(before[i], after[i], within);
        if (testing::Test::HasFatalFailure()) return;
        ++compared[change];
      }
    }
  });
  for (std::size_t change = 0; change < all.size(); ++change) EXPECT_GT(compared[change], rows) << all[change].name;
}

}  // namespace
}  // namespace limitcurve::godobject::test::metamorphic
