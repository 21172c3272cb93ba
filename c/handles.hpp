// SPDX-License-Identifier: MIT
#pragma once

#include "c/handle.hpp"

#include "godobject/batch/batch.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/patch/patch_table.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <optional>
#include <string>
#include <variant>

/// Contents of the handles of the C interface.
struct limitcurve_law {
  limitcurve::Law law;
  std::string name;
};

struct limitcurve_table {
  limitcurve::godobject::FingerCurve curve;
  std::optional<limitcurve::Table> table = {};  ///< empty for an ellipse or a box
  std::string csv = {};
};

struct limitcurve_finger {
  limitcurve::godobject::SoftFinger finger;
};

struct limitcurve_batch {
  std::variant<limitcurve::godobject::Batch, limitcurve::godobject::FloatBatch> batch;
};

struct limitcurve_patch {
  limitcurve::Patch patch;
  std::optional<limitcurve::PatchTable> table = {};  ///< if it is one
  std::string csv = {};
};

namespace limitcurve::c {

/// Converts the parameters to the library's type; throws if they are refused. `otherwise` stands in for a radius law
/// that is NULL beside no mu_r; if it is null too, one of both must be given.
godobject::FingerParameters parameters_of(const limitcurve_finger_parameters& given,
                                          const RadiusLaw* otherwise = nullptr);
godobject::Projection projection_of(limitcurve_projection projection);

}  // namespace limitcurve::c
