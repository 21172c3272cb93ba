// SPDX-License-Identifier: MIT
#include "cli/law_argument.hpp"

#include "cli/csv_reader.hpp"

#include "limitcurve/laws.hpp"

#include <stdexcept>
#include <vector>

namespace limitcurve::cli {

Law read_law(const std::string& text) {
  const std::string prefix = "samples:";
  if (text.substr(0, prefix.size()) != prefix) return parse_law(text);
  const std::string file = text.substr(prefix.size());
  if (file.empty()) throw std::invalid_argument("law '" + text + "': no file, expected samples:FILE.csv");
  std::vector<PressureSample> profile;
  CsvReader reader(file, {"radius", "pressure"});
  while (reader.next()) profile.push_back({reader.number(0, non_negative), reader.number(1, finite)});
  try {
    return samples(profile, file);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file + ": " + error.what());
  }
}

}  // namespace limitcurve::cli
