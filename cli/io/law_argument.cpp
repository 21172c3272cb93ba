// SPDX-License-Identifier: MIT
#include "cli/io/law_argument.hpp"

#include "cli/io/csv_reader.hpp"

#include "limitcurve/laws.hpp"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

namespace {

constexpr std::string_view measured = "samples:";

/// The file that `samples:FILE` names; nothing if the text is not of that kind.
std::optional<std::string> measured_file(const std::string& text) {
  if (text == measured || text == measured.substr(0, measured.size() - 1)) {
    throw std::invalid_argument("'" + text + "': no file, expected samples:FILE.csv");
  }
  if (text.substr(0, measured.size()) != measured) return std::nullopt;
  return text.substr(measured.size());
}

}  // namespace

Law read_law(const std::string& text) {
  const auto file = measured_file(text);
  if (!file) return parse_law(text);
  std::vector<PressureSample> profile;
  CsvReader reader(*file, {"radius", "pressure"});
  while (reader.next()) profile.push_back({reader.number(0, non_negative), reader.number(1, finite)});
  try {
    return samples(profile, *file);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(*file + ": " + error.what());
  }
}

RadiusLaw read_radius_law(const std::string& text) {
  const auto file = measured_file(text);
  if (!file) return RadiusLaw::parse(text);
  std::vector<LoadSample> radii;
  CsvReader reader(*file, {"load", "radius"});
  while (reader.next()) radii.push_back({reader.number(0, positive), reader.number(1, positive)});
  try {
    return RadiusLaw::sampled(radii);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(*file + ": " + error.what());
  }
}

}  // namespace limitcurve::cli
