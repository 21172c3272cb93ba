// SPDX-License-Identifier: MIT
#include "tests/fuzz/any_finger.hpp"
#include "tests/soak/step_check.hpp"

#include <algorithm>
#include <cmath>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

bool same(const FingerOutput& one, const FingerOutput& other) {
  return one.state == other.state && one.proxy == other.proxy && one.force == other.force && fuzz::same(one.angle, other.angle) &&
         fuzz::same(one.depth, other.depth) && fuzz::same(one.load, other.load) && fuzz::same(one.moment, other.moment) &&
         fuzz::same(one.cor, other.cor) && fuzz::same(one.slip_work, other.slip_work);
}

void run(fuzz::Bytes bytes, const fuzz::CurveAndProjection<double>& choice) {
  std::optional<SoftFinger> made;
  if (fuzz::complaint_of([&] { made.emplace(choice.curve, fuzz::any_parameters(bytes), choice.projection); })) return;
  SoftFinger& finger = *made;
  while (bytes.left() > 0) {
    const auto flags = bytes.take<std::uint8_t>();
    const auto raw = [&](unsigned bit) { return ((flags >> bit) & 1U) != 0; };
    Contact contact;
    for (Eigen::Index i = 0; i < 2; ++i) contact.point[i] = fuzz::any_double(bytes, raw(0), 0.02);
    if (raw(1)) contact.point.z() = fuzz::any_double(bytes, raw(0), 0.02);
    contact.depth = fuzz::any_double(bytes, raw(2), 0.004);
    if (raw(3)) {
      for (Eigen::Index i = 0; i < 3; ++i) contact.normal[i] = fuzz::any_double(bytes, raw(4), 1.0);
      // As handed over, or made a unit normal.
      if (raw(5)) contact.normal.normalize();
    }
    const double twist = fuzz::any_double(bytes, raw(6), 4.0);
    const double time_step = raw(7) ? fuzz::any_double(bytes, raw(6), 0.01) : 0.0;

    const FingerState before = finger.state();
    const FingerOutput preview = finger.preview(contact, twist, time_step);
    finger.update(contact, twist, time_step);
    const soak::StepCheck check = soak::check_step(finger, before, {contact, twist, time_step});
    fuzz::require(check.fault.empty(), check.fault.c_str());
    fuzz::require(check.excess <= 1.01e-12, "a wrench outside the limit");
    fuzz::require(same(preview, finger.output()), "a preview shows another step");
    const double margin = finger.margin();
    fuzz::require(margin >= 0.0 && margin <= 1.0, "a margin outside 0 to 1");
    fuzz::require(finger.load_to_hold() >= 0.0, "a load to hold below 0 or NaN");
  }
}

}  // namespace

/// The step of the god-object, fed with any bits: finite output, wrench within the limit, slip work ≥ 0, no exception.
static const fuzz::Target step_target("step", [](const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const auto& choice = fuzz::any_curve<double>(bytes);
  run(bytes, choice);
});
