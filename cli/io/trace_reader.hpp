// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/csv_reader.hpp"
#include "cli/io/unit_checks.hpp"

#include "godobject/scene/replay.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// Reads a recorded motion of fingers, and of the touched body if that is recorded, too.
///
/// Columns: time [s]; x,y,z [m] of the first finger, x2,y2,z2 of the second and so on; twist [rad] about the contact
/// normal, or qw,qx,qy,qz (a unit quaternion, finger to world), both followed by the finger's number (a finger without
/// either does not twist); bx,by,bz [m] of the body, and bqw,bqx,bqy,bqz (body to world), optional if it does not turn.
class TraceReader {
 public:
  TraceReader(const std::string& file, std::size_t fingers, bool body_moves, const FileColumns& columns = {});

  /// Moves to the next sample; false after the last. Throws std::invalid_argument with the place of an error.
  bool next();

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const std::vector<godobject::DevicePose>& fingers() const { return fingers_; }
  [[nodiscard]] const godobject::BodyPose& body() const { return body_; }
  /// Names "twist", "twist2", … of the fingers for which the trace has neither twist nor orientation.
  [[nodiscard]] const std::vector<std::string>& missing_twists() const { return missing_twists_; }
  /// The columns that the trace has in vain, with the reason, as in "bx,by,bz (without --body trace)"; empty if none.
  [[nodiscard]] std::string unread() const;
  /// What is to be asked of the twists so far.
  [[nodiscard]] const UnitChecks& questions() const { return questions_; }
  /// The fraction of the file that has been read, 0 to 1, if its size is known.
  [[nodiscard]] std::optional<double> share() const { return reader_.share(); }
  /// An error at the time of this sample.
  [[nodiscard]] std::invalid_argument complaint(const std::string& what) const;

 private:
  [[nodiscard]] Eigen::Vector3d position(std::size_t column) const;
  [[nodiscard]] godobject::Orientation orientation(std::size_t column) const;
  [[nodiscard]] bool has_all(std::size_t column, std::size_t count) const;

  std::size_t body_column_;
  std::size_t first_optional_;
  bool body_moves_;
  CsvReader reader_;
  double time_ = 0.0;
  bool seen_ = false;  ///< whether there was a sample
  std::vector<godobject::DevicePose> fingers_;
  std::vector<std::string> missing_twists_;
  std::vector<double> last_twists_;  ///< NaN before the first sample
  UnitChecks questions_;
  godobject::BodyPose body_;
};

}  // namespace limitcurve::cli
