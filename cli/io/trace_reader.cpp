// SPDX-License-Identifier: MIT
#include "cli/io/trace_reader.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve::cli {

namespace {

constexpr std::size_t time_column = 0;
constexpr std::size_t optional_per_finger = 5;  // twist, qw, qx, qy, qz

std::string suffix(std::size_t finger) {
  return finger == 0 ? "" : std::to_string(finger + 1);
}

std::vector<std::string> required_columns(std::size_t fingers, bool body_moves) {
  std::vector<std::string> names{"time"};
  for (std::size_t i = 0; i < fingers; ++i) {
    for (const char* name : {"x", "y", "z"}) names.push_back(name + suffix(i));
  }
  if (body_moves) names.insert(names.end(), {"bx", "by", "bz"});
  return names;
}

std::vector<std::string> optional_columns(std::size_t fingers, bool body_moves) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < fingers; ++i) {
    for (const char* name : {"twist", "qw", "qx", "qy", "qz"}) names.push_back(name + suffix(i));
  }
  if (body_moves) names.insert(names.end(), {"bqw", "bqx", "bqy", "bqz"});
  return names;
}

std::size_t column_of_finger(std::size_t finger) {
  return 1 + 3 * finger;
}

}  // namespace

TraceReader::TraceReader(const std::string& file, std::size_t fingers, bool body_moves, const FileColumns& columns)
    : body_column_(column_of_finger(fingers)),
      first_optional_(body_column_ + (body_moves ? 3 : 0)),
      body_moves_(body_moves),
      reader_(file, required_columns(fingers, body_moves), optional_columns(fingers, body_moves), columns),
      fingers_(fingers),
      last_twists_(fingers, std::numeric_limits<double>::quiet_NaN()) {
  for (std::size_t i = 0; i < fingers; ++i) {
    const std::size_t twist = first_optional_ + optional_per_finger * i;
    if (reader_.has(twist) || has_all(twist + 1, 4)) continue;
    const std::string number = suffix(i);
    if (reader_.has(twist + 1) || reader_.has(twist + 2) || reader_.has(twist + 3) || reader_.has(twist + 4)) {
      throw reader_.no_column("'twist" + number + "', nor all of qw" + number + ",qx" + number + ",qy" + number +
                              ",qz" + number);
    }
    missing_twists_.push_back("twist" + number);
  }
  if (!body_moves) return;
  const std::size_t turn = first_optional_ + optional_per_finger * fingers;
  for (std::size_t i = 0; i < 4; ++i) {
    if (reader_.has(turn + i) && !has_all(turn, 4)) throw reader_.no_column("one of bqw,bqx,bqy,bqz");
  }
}

bool TraceReader::next() {
  if (!reader_.next()) return false;
  const double before = std::exchange(time_, reader_.number(time_column, finite));
  if (seen_) questions_.time_step(time_ - before);
  seen_ = true;
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    const std::size_t twist = first_optional_ + optional_per_finger * i;
    fingers_[i].position = position(column_of_finger(i));
    if (reader_.has(twist)) {
      fingers_[i].twist = reader_.number(twist, finite);
      questions_.twist(last_twists_[i], fingers_[i].twist, time_);
      last_twists_[i] = fingers_[i].twist;
    } else if (reader_.has(twist + 1)) {
      fingers_[i].orientation = orientation(twist + 1);
    }
  }
  if (!body_moves_) return true;
  const std::size_t turn = first_optional_ + optional_per_finger * fingers_.size();
  body_.position = position(body_column_);
  if (reader_.has(turn)) body_.orientation = orientation(turn);
  return true;
}

std::string TraceReader::unread() const {
  std::string text;
  const auto tell = [&](const std::vector<std::string>& names, const std::string& reason) {
    for (const std::string& name : names) text += (&name != names.data() ? "," : text.empty() ? "" : "; ") + name;
    text += " (" + reason + ")";
  };
  const std::vector<std::string> others = reader_.others();
  const auto tell_others = [&](const std::vector<std::string>& names, const std::string& reason) {
    const bool has_all = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::find(others.begin(), others.end(), name) != others.end();
    });
    if (has_all) tell(names, reason);
  };
  for (std::size_t i = 0; i < godobject::Replay::most_fingers; ++i) {
    const std::string number = suffix(i);
    const std::size_t twist = first_optional_ + optional_per_finger * i;
    if (i >= fingers_.size()) {
      tell_others({"x" + number, "y" + number, "z" + number}, "without --fingers " + number);
    } else if (reader_.has(twist) && has_all(twist + 1, 4)) {
      tell({"qw" + number, "qx" + number, "qy" + number, "qz" + number}, "twist" + number + " is read instead");
    }
  }
  if (!body_moves_) tell_others({"bx", "by", "bz"}, "without --body trace");
  return text;
}

std::invalid_argument TraceReader::complaint(const std::string& what) const {
  return reader_.complaint(time_column, what);
}

bool TraceReader::has_all(std::size_t column, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    if (!reader_.has(column + i)) return false;
  }
  return true;
}

Eigen::Vector3d TraceReader::position(std::size_t column) const {
  return {reader_.number(column, finite), reader_.number(column + 1, finite), reader_.number(column + 2, finite)};
}

godobject::Orientation TraceReader::orientation(std::size_t column) const {
  godobject::Orientation result(reader_.number(column, finite), reader_.number(column + 1, finite),
                                reader_.number(column + 2, finite), reader_.number(column + 3, finite));
  if (!godobject::make_unit(result))
    throw reader_.complaint(column, "the quaternion has length " + format_number(result.norm()) + ", expected 1");
  return result.normalized();
}

}  // namespace limitcurve::cli
