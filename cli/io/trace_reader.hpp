// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/csv_reader.hpp"

#include "godobject/replay.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// Reads a recorded motion of fingers, and of the body they touch where that is recorded too.
///
/// Columns: time [s]; x,y,z [m] of the first finger, x2,y2,z2 of the second and so on; twist [rad] about the contact normal, or
/// qw,qx,qy,qz (a unit quaternion, finger to world) in its place, with the finger's number behind: a finger that has neither does not twist;
/// bx,by,bz [m] of the body, and bqw,bqx,bqy,bqz (body to world), which may be left out where it does not turn.
class TraceReader {
 public:
  TraceReader(const std::string& file, std::size_t fingers, bool body_moves);

  /// Moves to the next sample; false after the last. Throws std::invalid_argument with the place of what is wrong.
  bool next();

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const std::vector<godobject::DevicePose>& fingers() const { return fingers_; }
  [[nodiscard]] const godobject::BodyPose& body() const { return body_; }
  /// The columns of twist that the trace lacks, of fingers that have no orientation either: "twist", "twist2", …
  [[nodiscard]] const std::vector<std::string>& missing_twists() const { return missing_twists_; }
  /// The complaint about the time of this sample.
  [[nodiscard]] std::invalid_argument complaint(const std::string& what) const;

 private:
  [[nodiscard]] Eigen::Vector3d position(std::size_t column) const;
  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t column) const;
  [[nodiscard]] bool has_all(std::size_t column, std::size_t count) const;

  std::size_t body_column_;
  std::size_t first_optional_;
  bool body_moves_;
  CsvReader reader_;
  double time_ = 0.0;
  std::vector<godobject::DevicePose> fingers_;
  std::vector<std::string> missing_twists_;
  godobject::BodyPose body_;
};

}  // namespace limitcurve::cli
