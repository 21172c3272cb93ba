// SPDX-License-Identifier: MIT
// A finger in C++11, 14 or 17, which slides, turns, touches another material and is pushed by an engine.
#include "limitcurve11.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

int main() {
  using namespace limitcurve11;
  limitcurve_finger_parameters skin = limitcurve_finger_defaults();
  skin.mu = 0.6;
  skin.radius_law = "constant:a=0.006";
  skin.stiffness = 1000;
  skin.twist_stiffness = 0.036;
  Finger made(Table("hertz"), skin);
  Finger finger = std::move(made);
  limitcurve_contact contact = {{0, 0, 0}, {0, 0, 1}, 0.002, 0, 0};
  limitcurve_finger_output felt{};
  int wrong = 0;
  const auto expect = [&](const char* what, double found, double expected) {
    if (!(std::fabs(found - expected) < 1e-7))
      wrong += std::printf("%ld: %s: %.9g, expected %.9g\n", __cplusplus, what, found, expected);
  };
  // A slide, and a turn about the normal: mu P, and 3 pi/16 of mu P a.
  for (int i = 0; i < 1000; ++i, contact.point[0] += 1e-5) felt = finger.update(contact, 1e-3);
  expect("force", whole_force(felt)[0], -1.2);
  expect("load", whole_force(felt)[2], 2);
  finger.reset();
  for (int i = 0; i < 1000; ++i)
    felt = finger.update(contact, Quaternion{{std::cos(5e-4 * i), 0, 0, std::sin(5e-4 * i)}}, 1e-3);
  expect("moment in N mm", 1e3 * moment_vector(felt)[2], -7.2 * 3 * std::acos(-1.0) / 16);
  skin.radius_law = nullptr;  // the finger's own
  skin.mu = 0.3;
  finger.change(skin);
  felt = finger.update_under_load(contact, 4);
  expect("load", felt.load, 4);
  bool thrown = false;
  try {
    skin.mu_dynamic = 0.4;
    finger.change(skin);
  } catch (const std::invalid_argument&) {
    thrown = true;
  }
  expect("thrown", thrown, 1);
  return wrong == 0 ? 0 : 1;
}
