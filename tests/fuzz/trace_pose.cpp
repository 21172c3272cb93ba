// SPDX-License-Identifier: MIT
#include "cli/io/trace_reader.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cmath>
#include <numbers>

using namespace limitcurve;

namespace {

void require_unit(const Eigen::Quaterniond& orientation) {
  fuzz::require(std::fabs(orientation.norm() - 1.0) <= 1e-12, "an orientation that is no rotation");
}

void read(const std::string& file, std::size_t fingers, bool body_moves) {
  cli::TraceReader reader(file, fingers, body_moves);
  while (reader.next()) {
    fuzz::require(fuzz::is_finite(reader.time()), "a time that is not finite");
    fuzz::require(reader.fingers().size() == fingers, "a finger too few or too many");
    for (const godobject::DevicePose& finger : reader.fingers()) {
      fuzz::require(finger.position.allFinite() && fuzz::is_finite(finger.twist), "a finger that is not finite");
      require_unit(finger.orientation);
    }
    fuzz::require(reader.body().position.allFinite(), "a body that is not finite");
    require_unit(reader.body().orientation);
  }
}

}  // namespace

/// A trace of one or two fingers and a body (the first byte chooses), by twists or quaternions: finite poses and rotations of unit
/// length, or a complaint that names the place.
static const fuzz::Target trace_pose_target("trace_pose", [](const std::uint8_t* data, std::size_t size) {
  static fuzz::TemporaryFile file;
  fuzz::Bytes bytes(data, size);
  const auto choice = bytes.take<std::uint8_t>();
  file.replace(size > 0 ? fuzz::as_text(data + 1, size - 1) : std::string_view());
  const auto complaint = fuzz::complaint_of([&] { read(file.path(), 1 + (choice & 1U), (choice & 2U) != 0); });
  if (complaint) fuzz::require(complaint->rfind(file.path() + ":", 0) == 0, "a complaint that does not name the place");
});
