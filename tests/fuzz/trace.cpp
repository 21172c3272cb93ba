// SPDX-License-Identifier: MIT
#include "cli/io/trace_reader.hpp"
#include "godobject/scene/replay.hpp"
#include "limitcurve/laws.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cmath>

using namespace limitcurve;

namespace {

godobject::Replay replay_of(std::size_t fingers, bool body_moves) {
  godobject::ReplayOptions options;
  options.law = hertz();
  options.finger.stiffness = 1000.0;
  options.finger.twist_stiffness = 0.04;
  options.curve = godobject::CurveKind::ellipse;
  options.fingers = fingers;
  options.motion = body_moves ? godobject::BodyMotion::prescribed : godobject::BodyMotion::fixed;
  return godobject::Replay(options);
}

void require_pose(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  fuzz::require(position.allFinite(), "a position that is not finite");
  fuzz::require(std::fabs(orientation.norm() - 1.0) <= 1e-12, "an orientation that is not a rotation");
}

void read(const std::string& file, std::size_t fingers, bool body_moves) {
  cli::TraceReader reader(file, fingers, body_moves);
  godobject::Replay replay = replay_of(fingers, body_moves);
  std::size_t rows = 0;
  for (; reader.next(); ++rows) {
    fuzz::require(fuzz::is_finite(reader.time()), "a time that is not finite");
    fuzz::require(reader.fingers().size() == fingers, "a finger too few or too many");
    for (const godobject::DevicePose& finger : reader.fingers()) {
      fuzz::require(fuzz::is_finite(finger.twist), "a twist that is not finite");
      require_pose(finger.position, finger.orientation);
    }
    require_pose(reader.body().position, reader.body().orientation);

    replay.step(reader.time(), reader.fingers(), reader.body());
    for (const godobject::SceneContact& contact : replay.contacts()) {
      fuzz::require(contact.proxy.allFinite() && contact.force.allFinite(),
                    "the replay of finite numbers is not finite");
      for (const double value : {contact.angle, contact.depth, contact.load, contact.moment}) {
        fuzz::require(fuzz::is_finite(value), "the replay of finite numbers is not finite");
      }
      if (contact.state == godobject::ContactState::invalid) continue;  // holds what was
      fuzz::require((contact.cor >= 0.0) == (contact.state == godobject::ContactState::slip),
                    "a centre of rotation without slip, or the reverse");
    }
  }
  fuzz::require(rows > 0, "a file of no rows is accepted");
}

}  // namespace

/// A trace of one or two fingers and a body (the first byte chooses), by twists or quaternions: finite poses and
/// rotations of unit length, or a complaint that names the place; and the god-object replays it in finite numbers.
static const fuzz::Target trace_target("trace", [](std::string_view input) {
  static fuzz::TemporaryFile file;
  const auto choice = fuzz::Bytes(input).take<std::uint8_t>();
  file.replace(input.substr(input.empty() ? 0 : 1));
  const auto complaint = fuzz::complaint_of([&] { read(file.path(), 1 + (choice & 1U), (choice & 2U) != 0); });
  if (complaint) fuzz::require(complaint->rfind(file.path() + ":", 0) == 0, "a complaint that does not name the place");
});
