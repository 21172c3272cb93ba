// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// Friction of a material under a fingertip.
struct Material {
  std::string name;
  double mu;    ///< μ_l [1]
  double mu_r;  ///< largest moment over load [m]
};

/// Reads the materials of the paper's Table 1 from materials.csv in the folder `data`.
std::vector<Material> read_materials(const std::filesystem::path& data);

/// Finds a material by its name in the shipped data; throws std::invalid_argument with the list of names.
Material find_material(const std::string& name);

}  // namespace limitcurve::cli
