// SPDX-License-Identifier: MIT
#include "godobject/batch/batch.hpp"
#include "tests/godobject/host_settings.hpp"
#include "tests/godobject/host_settings_user.hpp"

namespace limitcurve::godobject::test {
namespace {

/// A batch of contacts that slide and twist; forces of all steps.
std::vector<double> batch_forces(const FingerCurve& curve, const FingerParameters& with, Projection projection) {
  constexpr std::size_t count = 67;  // packs, and some more
  const Batch batch(curve, with, projection);
  ContactArrays arrays(count);
  const ContactBatch contacts = arrays.batch();
  std::vector<double> result;
  for (int step = 0; step < 40; ++step) {
    for (std::size_t i = 0; i < count; ++i) {
      const double phase = static_cast<double>(i) + 0.1 * step;
      arrays.x()[i] = 0.003 * std::sin(phase);
      arrays.y()[i] = 0.002 * std::cos(2.0 * phase);
      arrays.twist()[i] = 0.5 * std::sin(0.7 * phase);
      arrays.depth()[i] = i % 13 == 12 ? 1e-310 : 0.0015 + 0.002 * std::sin(3.0 * phase);
    }
    batch.step(contacts);
    for (std::size_t i = 0; i < count; ++i) {
      result.insert(result.end(),
                    {contacts.fx[i], contacts.fy[i], contacts.moment[i], contacts.proxy_x[i], contacts.proxy_angle[i]});
    }
  }
  return result;
}

TEST(HostSettings, ABatchFeelsTheSameUnderAnyRounding) {
  for (const CurveChoice& choice : all_curves()) {
    const FingerCurve curve = make_finger_curve(choice.kind, hertz(), 1e-8);
    for (const NamedParameters& with : all_parameters()) {
      const std::vector<double> nearest = batch_forces(curve, with.finger, choice.projection);
      for (const Setting& setting : settings()) {
        const std::vector<double> other =
            under(setting, [&] { return batch_forces(curve, with.finger, choice.projection); });
        for (std::size_t i = 0; i < nearest.size(); ++i) {
          ASSERT_NEAR(nearest[i], other[i], 1e-9)
              << choice.name() << ", " << with.name << ", " << setting.name << ' ' << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
