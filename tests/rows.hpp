// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::test {

/// The fields of a data file's rows, header and comments left out. Throws if a row has not so many, or there is none.
inline std::vector<std::vector<std::string>> rows_of(const std::string& path, std::size_t columns) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    if (rows.back().size() != columns) throw std::runtime_error(path + ": a torn row: " + line);
  }
  if (rows.size() < 2) throw std::runtime_error(path + ": no rows");
  rows.erase(rows.begin());
  return rows;
}

}  // namespace limitcurve::test
