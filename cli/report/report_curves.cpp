// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"
#include "cli/report/report_files.hpp"

#include "limitcurve/contact_radius.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <array>

namespace limitcurve::cli {

void GatheredRows::add(const std::vector<std::string>& arguments, std::vector<std::pair<std::string, std::string>> leading) {
  run_command_line(arguments, {.output = file_.output(), .leading = std::move(leading), .header = first_, .messages = &silent_});
  first_ = false;
}

namespace {

constexpr std::string_view friction = "0.6";
constexpr std::string_view loads = "0.5,1,1.5,2,2.5";
constexpr double middle_load = 1.5;

/// A finger whose contact grows with the load, and one that does not, equal at the middle load.
std::array<std::string, 2> radius_laws() {
  const std::string growing = "power:c=0.00207,gamma=0.259";
  return {"constant:a=" + format_number(RadiusLaw::parse(growing).radius(middle_load)), growing};
}

/// From 0 to somewhat more than the largest of the loads, finely, so that bent curves look bent.
std::string fine_loads() {
  std::string list = "0";
  for (int i = 1; i <= 60; ++i) list += ',' + format_number(0.05 * i);
  return list;
}

}  // namespace

void write_curve_files(const std::filesystem::path& output) {
  GatheredRows laws(output / "laws.csv");
  laws.add({"laws"});
  laws.finish();

  GatheredRows curves(output / "curves.csv");
  for (const std::string_view name : law_examples()) {
    const std::string law(name);
    curves.add({"curve", "--law", law, "--points", "181"}, {{"law", law}});
  }
  curves.finish();

  GatheredRows p_curves(output / "p_curves.csv");
  GatheredRows c_curves(output / "c_curves.csv");
  for (const std::string& radius_law : radius_laws()) {
    const std::vector<std::pair<std::string, std::string>> leading{
        {"law", "hertz"}, {"radius_law", radius_law}, {"mu", std::string(friction)}};
    const std::vector<std::string> common{"--law", "hertz", "--radius-law", radius_law, "--mu", std::string(friction)};
    std::vector<std::string> call{"p-curves", "--loads", std::string(loads)};
    call.insert(call.end(), common.begin(), common.end());
    p_curves.add(call, leading);
    call = {"c-curves", "--loads", fine_loads(), "--cors", "0,0.0005,0.001,0.002,0.004,inf"};
    call.insert(call.end(), common.begin(), common.end());
    c_curves.add(call, leading);
  }
  p_curves.finish();
  c_curves.finish();
}

}  // namespace limitcurve::cli
