// SPDX-License-Identifier: MIT
#include "tests/fuzz/any_finger.hpp"

#include <algorithm>
#include <cmath>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

bool all_finite(const Eigen::Vector3d& vector) {
  return fuzz::is_finite(vector.x()) && fuzz::is_finite(vector.y()) && fuzz::is_finite(vector.z());
}

bool same(const FingerOutput& one, const FingerOutput& other) {
  return one.state == other.state && one.proxy == other.proxy && one.force == other.force && fuzz::same(one.angle, other.angle) &&
         fuzz::same(one.depth, other.depth) && fuzz::same(one.load, other.load) && fuzz::same(one.moment, other.moment) &&
         fuzz::same(one.cor, other.cor) && fuzz::same(one.slip_work, other.slip_work);
}

/// What the user feels, in the limit that may act: the static one unless it slips, on the box that part of it. A proxy that is only brought round
/// with the normal moves, but friction did not let it slip: static.
void require_within_limit(const SoftFinger& finger) {
  const FingerOutput output = finger.output();
  const FrictionLimits<double> limits =
      ContactLimits(finger.parameters(), finger.curve()->moment_max()).at<double>(finger.state().limit_load, 1.0);
  const bool slips = output.state == ContactState::slip;
  const bool is_box = finger.curve()->is_box();
  const FrictionMemory<double>& memory = finger.state().friction;
  const FrictionLimit<double>& limit = slips && memory.force_slides ? limits.sliding : limits.sticking;
  const FrictionLimit<double>& of_moment =
      slips && (is_box ? memory.moment_slides : memory.force_slides) ? limits.sliding : limits.sticking;
  const double moment_unit = of_moment.force * of_moment.radius;
  // Such a small limit counts as no friction: a trial above 1e60 times its limit is treated as that, and no trial here is above 1e21.
  constexpr double least = 1e-38;
  const double force = output.force.norm();
  const double moment = std::fabs(output.moment);
  constexpr double allowed = 1.0 + 1.01e-12;
  if (!limits.has_torsion) {
    fuzz::require(moment == 0.0, "a moment without torsional friction");
    fuzz::require(force <= std::max(least, limit.force * finger.curve()->force_max() * allowed), "a force above its limit");
  } else if (!(limit.force > least && moment_unit > least)) {
    fuzz::require(force <= least + 2.0 * limit.force && moment <= least + 2.0 * moment_unit, "a wrench without friction");
  } else {
    fuzz::require(finger.curve()->gauge({force / limit.force, moment / moment_unit}) <= allowed, "a wrench outside the limit");
  }
}

void require_sound(const SoftFinger& finger, const FingerOutput& before, bool usable) {
  const FingerOutput output = finger.output();
  if (!usable) fuzz::require(output.state == ContactState::invalid, "unusable input is used");
  fuzz::require(all_finite(output.proxy) && all_finite(output.force), "proxy or force are not finite");
  for (const double value : {output.angle, output.depth, output.load, output.moment, output.slip_work}) {
    fuzz::require(fuzz::is_finite(value), "an output is not finite");
  }
  fuzz::require(output.load >= 0.0, "a load that pulls");
  fuzz::require(output.slip_work >= 0.0, "slip work is negative");
  if (output.state == ContactState::invalid) {
    fuzz::require(output.proxy == before.proxy && output.angle == before.angle, "invalid input moves the proxy");
    fuzz::require(
        output.force.norm() <= before.force.norm() && std::fabs(output.moment) <= std::fabs(before.moment) && output.load <= before.load,
        "invalid input adds friction");
    return;
  }
  fuzz::require((output.cor >= 0.0) == (output.state == ContactState::slip), "a centre of rotation without slip, or the reverse");
  if (output.state == ContactState::free) {
    fuzz::require(output.force.isZero(0.0) && output.moment == 0.0 && output.load == 0.0, "friction in free space");
  } else {
    require_within_limit(finger);
  }
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

    const double squares = contact.point.squaredNorm() + contact.depth * contact.depth + twist * twist;
    const bool usable = fuzz::is_finite(squares) && std::fabs(contact.normal.norm() - 1.0) <= 1e-5;
    const FingerOutput before = finger.output();
    const FingerOutput preview = finger.preview(contact, twist, time_step);
    require_sound((finger.update(contact, twist, time_step), finger), before, usable);
    fuzz::require(same(preview, finger.output()), "a preview shows another step");
    const double margin = finger.margin();
    fuzz::require(margin >= 0.0 && margin <= 1.0, "a margin outside 0 to 1");
    fuzz::require(finger.load_to_hold() >= 0.0, "a load to hold that is none");
  }
}

}  // namespace

/// The step of the god-object, fed with any bits: finite output, wrench within the limit, slip work ≥ 0, no exception.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const auto& choice = fuzz::any_curve<double>(bytes);
  run(bytes, choice);
  return 0;
}
