// SPDX-License-Identifier: MIT
#include "cli/io/csv_reader.hpp"
#include "godobject/scene/replay.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <array>
#include <vector>

using namespace limitcurve;

namespace {

using Row = std::array<double, 5>;

std::vector<Row> read(const std::string& file) {
  std::vector<Row> rows;
  cli::CsvReader reader(file, {"time", "x", "y", "z"}, {"twist"});
  while (reader.next()) {
    Row row{};
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (reader.has(column)) row[column] = reader.number(column, cli::finite);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

/// A trace: rows of finite numbers, or an error with its place; the rows survive a round trip when written again; and the god-object
/// replays it in finite numbers.
static const fuzz::Target trace_target("trace", [](const std::uint8_t* data, std::size_t size) {
  static fuzz::TemporaryFile file;
  file.replace(fuzz::as_text(data, size));
  std::vector<Row> rows;
  if (const auto complaint = fuzz::complaint_of([&] { rows = read(file.path()); })) {
    fuzz::require(complaint->substr(0, file.path().size() + 1) == file.path() + ":", "a complaint that does not name the place");
    return;
  }
  fuzz::require(!rows.empty(), "a file of no rows is accepted");

  std::string written = "twist,z,y,x,time\n";
  for (const Row& row : rows) {
    for (std::size_t column = row.size(); column-- > 0;) written += format_number(row[column]) + (column > 0 ? "," : "\r\n");
  }
  file.replace(written);
  fuzz::require(read(file.path()) == rows, "rows do not come back");

  static const godobject::ReplayOptions options = [] {
    godobject::ReplayOptions result;
    result.law = hertz();
    result.finger.stiffness = 1000.0;
    result.finger.twist_stiffness = 0.04;
    result.curve = godobject::CurveKind::ellipse;
    return result;
  }();
  godobject::Replay replay(options);
  for (const auto& [time, x, y, z, twist] : rows) {
    replay.step(time, std::array{godobject::DevicePose{{x, y, z}, Eigen::Quaterniond::Identity(), twist}});
    const godobject::SceneContact& contact = replay.contacts().front();
    fuzz::require(contact.proxy.allFinite() && contact.force.allFinite(), "the replay of finite numbers is not finite");
    for (const double value : {contact.angle, contact.depth, contact.load, contact.moment}) {
      fuzz::require(fuzz::is_finite(value), "the replay of finite numbers is not finite");
    }
    if (contact.state == godobject::ContactState::invalid) continue;  // holds what was
    fuzz::require((contact.cor >= 0.0) == (contact.state == godobject::ContactState::slip),
                  "a centre of rotation without slip, or the reverse");
  }
});
