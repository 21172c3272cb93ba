// SPDX-License-Identifier: MIT
// The C interface gives the bits of the C++ library, on 10^5 random inputs each.
#include "tests/c/handle.hpp"
#include "tests/godobject/batch/batch_cases.hpp"

namespace limitcurve {
namespace {

using namespace godobject;

constexpr std::size_t count = 100000;

std::uint64_t bits(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

// With a moment coefficient the radius during slip may be larger than at rest: only force and moment fall.
TEST(SameBits, FrictionTakesTheLimitsOfEveryFinger) {
  TableHandle ellipse;
  ASSERT_EQ(limitcurve_table_ellipse(1.0, 0.6, ellipse.made()), LIMITCURVE_OK);
  const FingerCurve same = Ellipse(1.0, 0.6);
  for (const double mu_dynamic : {0.0, 0.1, 0.6}) {
    for (const double mu_r : {0.0, 0.002, 1.0 / 3.0}) {
      for (const double part : {0.0, 0.3, 1.0}) {
        FingerParameters parameters;
        parameters.mu = 0.6;
        parameters.mu_dynamic = mu_dynamic;
        parameters.mu_r = mu_r;
        parameters.mu_r_dynamic = part * mu_r;
        parameters.gamma = 1.0;
        const ContactLimits of_finger(parameters, 0.6);
        for (const double load : {0.0, 1e-300, 0.7, 1e9}) {
          const FrictionLimits<double> at = of_finger.at<double>(load, 25000.0);
          const limitcurve_limits limits{
              at.sticking.force, at.sticking.radius, at.sliding.force, at.sliding.radius, at.stiffness_ratio, 0.5, 0.5};
          limitcurve_memory memory{};
          limitcurve_friction found{};
          ASSERT_EQ(limitcurve_apply_friction(ellipse, LIMITCURVE_CLOSEST_POINT, &limits, 1.0, 0.01, &memory, &found),
                    LIMITCURVE_OK)
              << limitcurve_error() << " mu_dynamic " << mu_dynamic << " mu_r " << mu_r << " part " << part << " load "
              << load;
          FrictionMemory<double> remembered;
          const FrictionResult<double> expected = apply_friction(
              same.view(), Projection::closest_point,
              {at.sticking, at.sliding, at.stiffness_ratio, 0.5, 0.5, has_torsion(at.sticking.radius, 25000.0)},
              FrictionTrial<double>{1.0, 0.01}, remembered);
          ASSERT_EQ(bits(found.force_fraction), bits(expected.force_fraction));
          ASSERT_EQ(bits(found.moment_fraction), bits(expected.moment_fraction));
        }
      }
    }
  }
  const limitcurve_limits grows{1.0, 0.01, 0.5, 0.021, 25000.0, 1.0, 1.0};
  limitcurve_memory memory{};
  limitcurve_friction found{};
  EXPECT_EQ(limitcurve_apply_friction(ellipse, LIMITCURVE_CLOSEST_POINT, &grows, 1.0, 0.01, &memory, &found),
            LIMITCURVE_INVALID);
  // Without a moment in slip the force alone is held: 0.5 of 2.
  const limitcurve_limits no_moment{1.0, 0.01, 0.5, 0.0, 25000.0, 1.0, 1.0};
  EXPECT_EQ(limitcurve_apply_friction(ellipse, LIMITCURVE_CLOSEST_POINT, &no_moment, 2.0, 0.01, &memory, &found),
            LIMITCURVE_OK);
  EXPECT_NEAR(found.force_fraction, 0.25, 1e-12);
}

/// A box has two slip states and two shares of rest, which C passes on each for itself.
TEST(SameBits, FrictionOfABoxWhoseTestsComeToRestApart) {
  TableHandle box;
  ASSERT_EQ(limitcurve_table_box(1, 0.6, box.made()), LIMITCURVE_OK);
  const FingerCurve same = limitcurve::box(1, 0.6);
  const limitcurve_limits limits{1.2, 0.006, 0.9, 0.005, 25000, 0.9, 0.5};
  const FrictionLimits<double> same_limits{{1.2, 0.006}, {0.9, 0.005}, 25000, 0.9, 0.5};
  limitcurve_memory memory{};
  FrictionMemory<double> same_memory;
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> share(0, 1.5);
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < count; ++i) {
    const double force = 1.2 * share(random);
    const double moment = 1.2 * 0.006 * 0.6 * share(random);
    limitcurve_friction friction;
    ASSERT_EQ(limitcurve_apply_friction(box, LIMITCURVE_CLOSEST_POINT, &limits, force, moment, &memory, &friction),
              LIMITCURVE_OK);
    const auto expected = apply_friction(same.view(), Projection::closest_point, same_limits,
                                         FrictionTrial<double>{force, moment}, same_memory);
    ASSERT_EQ(bits(friction.force_fraction), bits(expected.force_fraction));
    ASSERT_EQ(bits(friction.moment_fraction), bits(expected.moment_fraction));
    ASSERT_EQ(memory.force_slides != 0, same_memory.force_slides);
    ASSERT_EQ(memory.moment_slides != 0, same_memory.moment_slides);
    ++seen[static_cast<std::size_t>(2 * memory.force_slides + memory.moment_slides)];
    // By hand: a contact that turned keeps turning until the moment is below half of the sliding limit, 0.9 N * 5 mm *
    // 0.6.
    if (memory.moment_slides == 0) {
      ASSERT_TRUE(moment <= 1.2 * 0.006 * 0.6);
    } else if (moment < 0.5 * 0.9 * 0.005 * 0.6) {
      ADD_FAILURE() << "still turns at " << moment;
    }
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 1000);
}

TEST(SameBits, UpdateOfAFinger) {
  LawHandle law;
  TableHandle table;
  FingerHandle finger;
  FingerHandle second;
  ASSERT_EQ(limitcurve_law_parse("hertz", law.made()), LIMITCURVE_OK);
  ASSERT_EQ(limitcurve_table_build(law, 1e-6, table.made()), LIMITCURVE_OK);
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.mu = 0.6;
  parameters.mu_dynamic = 0.5;
  parameters.radius_law = "power:c=0.00207,gamma=0.259";
  parameters.damping = 1;
  parameters.twist_damping = 1e-5;
  for (FingerHandle* const made : {&finger, &second})
    ASSERT_EQ(limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, made->made()), LIMITCURVE_OK);
  FingerParameters same;
  same.mu = 0.6;
  same.mu_dynamic = 0.5;
  same.radius_law = RadiusLaw::power(0.00207, 0.259);
  same.damping = 1;
  same.twist_damping = 1e-5;
  SoftFinger expected_finger(Table::build(hertz(), 1e-6), same);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  limitcurve_contact contact{{0, 0, 0}, {0, 0, 1}, 0.001, 0, 0};
  std::array<std::size_t, 4> seen{};
  for (std::size_t i = 0; i < count; ++i) {
    contact.point[0] += 2e-4 * normal(random);
    contact.point[1] += 2e-4 * normal(random);
    contact.depth = 1e-3 * (1 + normal(random));
    contact.twist += 0.05 * normal(random);
    const double twist = i % 1000 == 999 ? limitcurve::test::nan : contact.twist;  // a device's fault now and then
    limitcurve_contact given = contact;
    given.twist = twist;
    given.landed = i % 64 == 63;
    limitcurve_finger_output output;
    const Eigen::Vector3d point(contact.point);
    const Eigen::Vector3d upward(contact.normal);
    FingerOutput expected;
    if (i % 1024 >=
        896) {  // by the orientation, in place of the twist; the preview is that of a second finger in the same state
      const Orientation held(Eigen::AngleAxisd(twist, Eigen::Vector3d(0.6, 0, 0.8)));
      const double orientation[4] = {held.w(), held.x(), held.y(), held.z()};
      const Contact touched{point, upward, contact.depth, {}, i % 64 == 63};
      ASSERT_EQ(limitcurve_finger_copy_state(finger, second), LIMITCURVE_OK);
      ASSERT_EQ(limitcurve_finger_preview(second, &given, 1e-3, &output), LIMITCURVE_OK);
      ASSERT_EQ(bits(output.moment), bits(expected_finger.preview(touched, twist, 1e-3).moment));
      ASSERT_EQ(limitcurve_finger_preview_pose(second, &given, orientation, 1e-3, &output), LIMITCURVE_OK);
      ASSERT_EQ(bits(output.moment), bits(expected_finger.preview(touched, held, 1e-3).moment));
      ASSERT_EQ(limitcurve_finger_update_pose(finger, &given, orientation, 1e-3, &output), LIMITCURVE_OK);
      expected = expected_finger.update(touched, held, 1e-3);
      parameters.mu = same.mu = i % 2 == 0 ? 0.7 : 0.6;
      parameters.radius_law = nullptr;  // the finger's own
      ASSERT_EQ(limitcurve_finger_change(finger, &parameters), LIMITCURVE_OK);
      ASSERT_EQ(limitcurve_finger_change(second, &parameters), LIMITCURVE_OK);
      ASSERT_TRUE(expected_finger.change(same));
      double energy = 0;
      ASSERT_EQ(limitcurve_finger_spring_energy(finger, &energy), LIMITCURVE_OK);
      ASSERT_EQ(bits(energy), bits(expected_finger.spring_energy()));
      if (i % 4 == 0) {
        ASSERT_EQ(limitcurve_finger_update_under_load_pose(finger, &given, 2, orientation, 1e-3, &output),
                  LIMITCURVE_OK);
        expected = expected_finger.update_under_load(point, upward, 2, held, 1e-3, touched.landed);
      }
    } else if (i % 128 < 64) {
      ASSERT_EQ(limitcurve_finger_update(finger, &given, 1e-3, &output), LIMITCURVE_OK);
      expected = expected_finger.update({point, upward, contact.depth, {}, i % 64 == 63}, twist, 1e-3);
    } else {  // by the load, in place of the depth
      ASSERT_EQ(limitcurve_finger_update_under_load(finger, &given, 1e3 * contact.depth, 1e-3, &output), LIMITCURVE_OK);
      expected = expected_finger.update_under_load(point, upward, 1e3 * contact.depth, twist, 1e-3, i % 64 == 63);
    }
    ASSERT_EQ(static_cast<int>(output.state), static_cast<int>(expected.state));
    ++seen[static_cast<std::size_t>(output.state)];
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(bits(output.proxy[axis]), bits(expected.proxy[axis]));
      ASSERT_EQ(bits(output.force[axis]), bits(expected.force[axis]));
      ASSERT_EQ(bits(output.normal[axis]), bits(expected.normal[axis]));
    }
    for (const auto& [one, other] :
         {std::pair(output.angle, expected.angle), std::pair(output.depth, expected.depth),
          std::pair(output.load, expected.load), std::pair(output.moment, expected.moment),
          std::pair(output.cor, expected.cor), std::pair(output.slip_work, expected.slip_work)})
      ASSERT_EQ(bits(one), bits(other));
    double margin = 0;
    double hold = 0;
    ASSERT_EQ(limitcurve_finger_margin(finger, &margin, &hold), LIMITCURVE_OK);
    ASSERT_EQ(bits(margin), bits(expected_finger.margin()));
    if (i % 16 == 0) {
      ASSERT_EQ(bits(hold), bits(expected_finger.load_to_hold()));
    }
  }
  for (const std::size_t times : seen) EXPECT_GE(times, 100U);  // every state is among them
  parameters.mu_dynamic = 0.8;
  EXPECT_EQ(limitcurve_finger_change(finger, &parameters), LIMITCURVE_INVALID);
  EXPECT_STREQ(limitcurve_error(), "mu_dynamic: got 0.8, expected 0 <= mu_dynamic <= mu");
}

/// The contacts of a batch by both interfaces, stepped ten times.
template <class Real, class Contacts, class Step>
void compare_batches(const BasicBatch<Real>& same, const Step& step) {
  BasicContactArrays<Real> mine(count);
  BasicContactArrays<Real> other(count);
  const BasicContactBatch<Real> of = mine.batch();
  const BasicContactBatch<Real> expected = other.batch();
  const Contacts contacts{of.x.data(),
                          of.y.data(),
                          of.twist.data(),
                          of.depth.data(),
                          of.proxy_x.data(),
                          of.proxy_y.data(),
                          of.proxy_angle.data(),
                          reinterpret_cast<std::uint8_t*>(of.state.data()),
                          reinterpret_cast<std::uint8_t*>(of.force_slides.data()),
                          reinterpret_cast<std::uint8_t*>(of.moment_slides.data()),
                          of.search_start.data(),
                          of.search_rate.data(),
                          of.fx.data(),
                          of.fy.data(),
                          of.moment.data()};
  godobject::test::Random random(4);
  for (int round = 0; round < 10; ++round) {
    godobject::test::move_all(mine, random, 1e-2);
    godobject::test::copy_places(mine, other);
    ASSERT_EQ(step(&contacts), LIMITCURVE_OK);
    same.step(expected);
    ASSERT_EQ(godobject::test::written(of), godobject::test::written(expected));
    ASSERT_TRUE(std::ranges::equal(of.force_slides, expected.force_slides) &&
                std::ranges::equal(of.moment_slides, expected.moment_slides));
  }
  EXPECT_GT(std::ranges::count(of.state, ContactState::slip), count / 10);
}

TEST(SameBits, StepsOfABatch) {
  LawHandle law;
  TableHandle table;
  BatchHandle batch;
  BatchHandle float_batch;
  const limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  ASSERT_EQ(limitcurve_law_parse("hertz", law.made()), LIMITCURVE_OK);
  ASSERT_EQ(limitcurve_table_build(law, 1e-8, table.made()), LIMITCURVE_OK);
  ASSERT_EQ(limitcurve_batch_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, batch.made()), LIMITCURVE_OK);
  ASSERT_EQ(limitcurve_batch_new_float(law, 1e-6, &parameters, LIMITCURVE_CLOSEST_POINT, float_batch.made()),
            LIMITCURVE_OK);
  compare_batches<double, limitcurve_contacts>(Batch(Table::build(hertz(), 1e-8), {}), [&](const auto* contacts) {
    return limitcurve_batch_step(batch, contacts, count);
  });
  compare_batches<float, limitcurve_contacts_float>(
      FloatBatch(FloatTable::build(hertz(), 1e-6), {}),
      [&](const auto* contacts) { return limitcurve_batch_step_float(float_batch, contacts, count); });
  EXPECT_EQ(limitcurve_batch_step_float(batch, nullptr, 1), LIMITCURVE_INVALID);
  EXPECT_STREQ(limitcurve_error(), "batch: made for the other precision");
}

#if defined(__x86_64__) && defined(__GNUC__)
// Mono and Visual C++ set the x87 unit to 53 bits: stated errors and tables are those of this library all the same, and
// the host's setting stays.
TEST(SameBits, AHostMayLetLongDoubleBeDouble) {
  const auto all = [] {
    LawHandle law;
    TableHandle table;
    const double cor = 0.01;
    double numbers[3]{};
    limitcurve_law_parse("power:n=0.3", law.made());
    limitcurve_law_evaluate(law, &cor, 1, &numbers[0], &numbers[1], nullptr, &numbers[2]);
    EXPECT_EQ(limitcurve_table_build(law, 1e-13, table.made()), LIMITCURVE_OK);
    std::string text = limitcurve_table_csv(table);
    for (const double number : numbers) text += std::to_string(bits(number)) + ' ';
    return text;
  };
  const std::string expected = all();
  std::uint16_t own = 0, after = 0;
  const std::uint16_t host = 0x27f;
  asm volatile("fnstcw %0" : "=m"(own));
  asm volatile("fldcw %0" : : "m"(host));
  const std::string found = all();
  asm volatile("fnstcw %0" : "=m"(after));
  asm volatile("fldcw %0" : : "m"(own));
  EXPECT_EQ(found, expected);
  EXPECT_EQ(after, host);
}
#endif

}  // namespace
}  // namespace limitcurve
