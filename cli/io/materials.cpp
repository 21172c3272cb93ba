// SPDX-License-Identifier: MIT
#include "cli/io/materials.hpp"

#include "cli/io/csv_reader.hpp"
#include "cli/report/share.hpp"

#include <stdexcept>

namespace limitcurve::cli {

std::vector<Material> read_materials(const std::filesystem::path& data) {
  CsvReader reader((data / "materials.csv").string(), {"material", "mu", "mu_r"});
  std::vector<Material> materials;
  while (reader.next()) materials.push_back({std::string(reader.text(0)), reader.number(1, positive), reader.number(2, positive)});
  return materials;
}

Material find_material(const std::string& name) {
  std::string names;
  for (Material& material : read_materials(find_share() / "data")) {
    if (material.name == name) return material;
    names += (names.empty() ? "" : ", ") + material.name;
  }
  throw std::invalid_argument("--material: got '" + name + "', expected " + names);
}

}  // namespace limitcurve::cli
