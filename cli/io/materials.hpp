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

/// The materials of the paper's Table 1, from materials.csv in the folder `data`.
std::vector<Material> read_materials(const std::filesystem::path& data);

/// The material of that name in the data that come with the program; throws std::invalid_argument that lists those there are.
Material find_material(const std::string& name);

}  // namespace limitcurve::cli
