// SPDX-License-Identifier: MIT
// Ten thousand calls that a careless or hostile program makes: each is an error with a line that says why, or a right
// answer.
#include "tests/c/handle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

class HostileCalls : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(limitcurve_law_parse("hertz", law.made()), LIMITCURVE_OK);
    ASSERT_EQ(limitcurve_table_build(law, 1e-4, table.made()), LIMITCURVE_OK);
    ASSERT_EQ(limitcurve_patch_rectangle(0.02, 0.01, patch.made()), LIMITCURVE_OK);
  }

  double number() {
    static constexpr std::array odd{0.0,   -0.0,   1.0,      -1.0,      0.5,  2.0,   1e-3,  1e-300, 5e-324,
                                    1e308, -1e308, infinity, -infinity, 1e60, 1e-60, 0.006, 1000.0, not_a_number};
    return odd[random() % odd.size()];
  }
  template <class Thing>
  Thing* or_null(Thing* thing) {
    return random() % 8 == 0 ? nullptr : thing;
  }
  template <class Thing, void (*free)(Thing*)>
  Thing* or_null(const Handle<Thing, free>& thing) {
    return or_null(static_cast<Thing*>(thing));
  }
  limitcurve_projection projection() {
    static constexpr std::array odd{
        0, 1, 2, 3, 4, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
    return odd[random() % odd.size()];
  }
  /// A status has one of three values, and a failure has its own message.
  void expect_told(limitcurve_status status) {
    ++calls;
    ASSERT_TRUE(status == LIMITCURVE_OK || status == LIMITCURVE_FAILED || status == LIMITCURVE_INVALID);
    if (status == LIMITCURVE_OK) return;
    ++refused;
    ASSERT_NE(std::string(limitcurve_error()), "");
    ASSERT_EQ(std::strchr(limitcurve_error(), '\n'), nullptr) << limitcurve_error();
  }

  std::mt19937 random{13};
  std::size_t calls = 0;
  std::size_t refused = 0;
  LawHandle law;
  TableHandle table;
  PatchHandle patch;
};

TEST_F(HostileCalls, AWrenchOfAPatchIsFinite) {
  const std::array wrenches{1.0, not_a_number, 0.0};
  std::array out{7.0, 7.0, 7.0};
  for (const limitcurve_status status : {limitcurve_patch_load_to_hold(patch, 0.5, wrenches.data(), 1, out.data()),
                                         limitcurve_patch_slip(patch, wrenches.data(), 1, out.data(), nullptr)}) {
    EXPECT_EQ(status, LIMITCURVE_INVALID);
    EXPECT_NE(std::string(limitcurve_error()).find("wrenches[1]: got nan"), std::string::npos) << limitcurve_error();
  }
  EXPECT_EQ(out[0], 7.0);
}

TEST_F(HostileCalls, OddNumbersAndNullAreErrorsOrRightAnswers) {
  const std::array texts{"hertz",
                         "",
                         "power:n=2",
                         "power:n=",
                         "mix:",
                         "mix:1*hertz",
                         "samples:x.csv",
                         "power:n=1e999",
                         "constant:a=0.005",
                         "power:c=0.002,gamma=2",
                         "\xff\xfe",
                         "gaussian:sigma=0"};
  while (calls < 10000) {
    const auto text = [&] { return or_null(texts[random() % texts.size()]); };
    std::array<double, 4> numbers{number(), number(), number(), number()};
    std::array<double, 12> out{};
    switch (random() % 13) {
      case 0: {
        LawHandle made;
        expect_told(limitcurve_law_parse(text(), or_null(made.made())));
        break;
      }
      case 1:
        expect_told(limitcurve_law_evaluate(or_null(law), or_null(numbers.data()), random() % 5, or_null(out.data()),
                                            or_null(out.data() + 4), or_null(out.data() + 8), nullptr));
        break;
      case 2: {
        const limitcurve_status status = limitcurve_table_evaluate(or_null(table), or_null(numbers.data()), 4,
                                                                   or_null(out.data()), or_null(out.data() + 4));
        expect_told(status);
        for (std::size_t cell = 0; cell < 4 && status == LIMITCURVE_OK; ++cell) {
          EXPECT_EQ(std::isnan(out[cell]), std::isnan(numbers[cell]));
          if (!std::isnan(out[cell])) {
            EXPECT_TRUE(out[cell] >= 0 && out[cell] <= 1 && out[cell + 4] >= 0 && out[cell + 4] < 0.6);
          }
        }
        break;
      }
      case 3:
        expect_told(limitcurve_table_gauge(or_null(table), numbers.data(), numbers.data() + 2, 2, or_null(out.data())));
        break;
      case 4: {
        TableHandle made;
        expect_told(random() % 2 == 0 ? limitcurve_table_ellipse(number(), number(), made.made())
                                      : limitcurve_table_box(number(), number(), made.made()));
        break;
      }
      case 5: {
        const limitcurve_limits limits{number(), number(), number(), number(), number(), number(), number()};
        limitcurve_memory memory{number(), number(), static_cast<int>(random() % 3), static_cast<int>(random() % 3)};
        limitcurve_friction friction{};
        const limitcurve_status status = limitcurve_apply_friction(or_null(table), projection(), &limits, number(),
                                                                   number(), or_null(&memory), or_null(&friction));
        expect_told(status);
        if (status == LIMITCURVE_OK) {
          EXPECT_TRUE(friction.force_fraction >= 0 && friction.force_fraction <= 1 && friction.moment_fraction >= 0 &&
                      friction.moment_fraction <= 1);
        }
        break;
      }
      case 6: {
        limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
        if (random() % 2 == 0) parameters.mu = number();
        if (random() % 2 == 0) parameters.stiffness = number();
        if (random() % 4 == 0) parameters.mu_r = number();
        if (random() % 4 == 0) parameters.radius_law = text();
        FingerHandle finger;
        expect_told(random() % 2 == 0
                        ? limitcurve_finger_new(or_null(table), or_null(&parameters), projection(), finger.made())
                        : limitcurve_finger_new_patch(or_null(patch), &parameters, number(), finger.made()));
        for (int i = 0; finger != nullptr && i < 10; ++i) {
          const limitcurve_contact contact{{number(), number(), 0},
                                           {0, 0, random() % 4 == 0 ? number() : 1},
                                           number(),
                                           number(),
                                           static_cast<int>(random())};
          limitcurve_finger_output output{};
          const double orientation[4] = {random() % 4 == 0 ? number() : 1, 0, 0, 0};
          if (random() % 4 == 0) {
            parameters.mu = number();
            parameters.mu_dynamic = number();
            expect_told(limitcurve_finger_change(or_null(finger), or_null(&parameters)));
          }
          double energy = 0;
          expect_told(limitcurve_finger_copy_state(or_null(finger), or_null(finger)));
          expect_told(limitcurve_finger_spring_energy(or_null(finger), or_null(&energy)));
          EXPECT_GE(energy, 0);
          expect_told(limitcurve_finger_preview(or_null(finger), or_null(&contact), number(), or_null(&output)));
          expect_told(limitcurve_finger_preview_pose(finger, or_null(&contact), or_null(orientation), number(),
                                                     or_null(&output)));
          limitcurve_status status = LIMITCURVE_OK;
          switch (random() % 4) {
            case 0:
              status = limitcurve_finger_update(finger, or_null(&contact), number(), or_null(&output));
              break;
            case 1:
              status = limitcurve_finger_update_pose(finger, or_null(&contact), or_null(orientation), number(),
                                                     or_null(&output));
              break;
            case 2:
              status = limitcurve_finger_update_under_load_pose(finger, or_null(&contact), number(),
                                                                or_null(orientation), number(), or_null(&output));
              break;
            default:
              status =
                  limitcurve_finger_update_under_load(finger, or_null(&contact), number(), number(), or_null(&output));
          }
          expect_told(status);
          if (status != LIMITCURVE_OK) continue;
          EXPECT_TRUE(std::isfinite(output.load) && std::isfinite(output.force[0]) && std::isfinite(output.moment) &&
                      output.slip_work >= 0);
        }
        break;
      }
      case 7: {
        BatchHandle batch;
        const limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
        expect_told(limitcurve_batch_new(or_null(table), &parameters, LIMITCURVE_CLOSEST_POINT, batch.made()));
        std::array<std::array<double, 4>, 11> arrays{};
        for (std::array<double, 4>& array : arrays) array = {number(), number(), number(), number()};
        std::array<std::uint8_t, 4> state{static_cast<std::uint8_t>(random()), 1, 2, 3};
        std::array<std::uint8_t, 4> sliding{static_cast<std::uint8_t>(random()), 1, 2, 3}, turning = sliding;
        const limitcurve_contacts contacts{
            arrays[0].data(), arrays[1].data(),  arrays[2].data(), or_null(arrays[3].data()),
            arrays[4].data(), arrays[5].data(),  arrays[6].data(), state.data(),
            sliding.data(),   turning.data(),    arrays[7].data(), arrays[8].data(),
            arrays[9].data(), arrays[10].data(), arrays[10].data()};
        expect_told(limitcurve_batch_step(batch, or_null(&contacts), 4));
        break;
      }
      case 8: {
        PatchHandle made;
        expect_told(random() % 2 == 0
                        ? limitcurve_patch_points(numbers.data(), numbers.data(), or_null(numbers.data()), random() % 5,
                                                  made.made())
                        : limitcurve_patch_polygon(numbers.data(), or_null(numbers.data()), random() % 5, made.made()));
        break;
      }
      case 9: {
        PatchHandle made;
        expect_told(random() % 2 == 0
                        ? limitcurve_patch_image(or_null(numbers.data()), 2, 2, number(), made.made())
                        : limitcurve_patch_image(numbers.data(), std::size_t(-1), std::size_t(-1), 1, made.made()));
        break;
      }
      case 10:
        expect_told(limitcurve_patch_wrench(or_null(patch), or_null(numbers.data()), 1, or_null(out.data()), nullptr,
                                            out.data() + 4));
        expect_told(
            limitcurve_patch_slip(or_null(patch), or_null(numbers.data()), 1, or_null(out.data()), out.data() + 4));
        break;
      case 11: {
        limitcurve_finger_parameters contact = limitcurve_finger_defaults();
        contact.mu = number();
        contact.mu_r = random() % 2 == 0 ? number() : std::nan("");
        if (!std::isnan(contact.mu_r)) contact.radius_law = nullptr;
        contact.radius_law = or_null(contact.radius_law);
        expect_told(random() % 2 == 0
                        ? limitcurve_patch_load_to_hold(or_null(patch), number(), or_null(numbers.data()), 1,
                                                        or_null(out.data()))
                        : limitcurve_table_load_to_hold(or_null(table), or_null(&contact), or_null(numbers.data()),
                                                        numbers.data(), 1, or_null(out.data())));
        break;
      }
      default: {
        TableHandle made;
        std::string csv = limitcurve_table_csv(table);
        csv[random() % csv.size()] = static_cast<char>(random());
        expect_told(limitcurve_table_read_csv(or_null(csv.data()), csv.size() - random() % 3, "memory", made.made()));
      }
    }
  }
  EXPECT_GT(refused, 2000U);
  EXPECT_LT(refused, 9000U);
}

// The parameters of a patch's finger have no radius law.
TEST_F(HostileCalls, ADevicesDampingNeedsNoRadiusLaw) {
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.radius_law = nullptr;
  double sliding = 0.0;
  ASSERT_EQ(limitcurve_device_damping_needed(&parameters, 1e-3, 0, &sliding, nullptr), LIMITCURVE_OK);
  EXPECT_EQ(sliding, 0.5);  // kT/2
  EXPECT_EQ(limitcurve_require_passive(&parameters, 1e-3, 0, 0.6, infinity), LIMITCURVE_OK);
}

// By the name that it has in the header.
TEST_F(HostileCalls, AnArrayThatIsMissingIsNamed) {
  const limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  BatchHandle batch;
  ASSERT_EQ(limitcurve_batch_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, batch.made()), LIMITCURVE_OK);
  double number = 0.0;
  std::uint8_t state = 0;
  const auto told = [&](auto member, const std::string& name) {
    limitcurve_contacts contacts{&number, &number, &number, &number, &number, &number, &number, &state,
                                 &state,  &state,  &number, &number, &number, &number, &number};
    contacts.*member = nullptr;
    EXPECT_EQ(limitcurve_batch_step(batch, &contacts, 1), LIMITCURVE_INVALID) << name;
    EXPECT_EQ(std::string(limitcurve_error()).find(name + ": "), 0U) << limitcurve_error();
  };
#define TOLD(member) told(&limitcurve_contacts::member, #member)
  TOLD(x), TOLD(y), TOLD(twist), TOLD(depth), TOLD(proxy_x), TOLD(proxy_y), TOLD(proxy_angle), TOLD(state),
      TOLD(force_slides);
  TOLD(moment_slides), TOLD(search_start), TOLD(search_rate), TOLD(fx), TOLD(fy), TOLD(moment);
#undef TOLD
}

TEST_F(HostileCalls, ThreadsHaveErrorsOfTheirOwn) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i) {
    threads.emplace_back([this, i] {
      const std::string wrong = "nonsense" + std::to_string(i);
      for (int round = 0; round < 1000; ++round) {
        LawHandle made;
        ASSERT_EQ(limitcurve_law_parse(wrong.c_str(), made.made()), LIMITCURVE_INVALID);
        ASSERT_NE(std::string(limitcurve_error()).find(wrong), std::string::npos);
        const double cor = 0.5;
        double force = 0;
        double moment = 0;
        ASSERT_EQ(limitcurve_table_evaluate(table, &cor, 1, &force, &moment), LIMITCURVE_OK);  // a table is shared
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

#ifndef NDEBUG  // a release build does not keep account of handles
TEST_F(HostileCalls, AFreedHandleIsRefusedInADebugBuild) {
  limitcurve_law* freed = nullptr;
  ASSERT_EQ(limitcurve_law_parse("uniform", &freed), LIMITCURVE_OK);
  limitcurve_law_free(freed);
  double ratio = 0;
  EXPECT_EQ(limitcurve_law_moment_ratio(freed, &ratio), LIMITCURVE_INVALID);
  EXPECT_STREQ(limitcurve_error(), "law: the handle was freed");
  EXPECT_EQ(limitcurve_law_name(freed), nullptr);
  limitcurve_law_free(freed);  // twice
}
#endif

TEST_F(HostileCalls, ACorIsADistanceAndALawIsNamed) {
  const std::array<double, 2> cors{0.25, -0.25};
  std::array<double, 2> forces{};
  std::array<double, 2> moments{};
  const auto evaluate = [&](const limitcurve_law* of) {
    return limitcurve_law_evaluate(of, cors.data(), 2, forces.data(), moments.data(), nullptr, nullptr);
  };
  EXPECT_EQ(evaluate(law), LIMITCURVE_OK);
  EXPECT_EQ(forces[0], forces[1]);
  EXPECT_EQ(evaluate(nullptr), LIMITCURVE_INVALID);
  EXPECT_STREQ(limitcurve_error(), "law: got NULL");
}

}  // namespace
