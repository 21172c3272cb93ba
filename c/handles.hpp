// SPDX-License-Identifier: MIT
#pragma once

#include "c/handle.hpp"

#include "godobject/batch.hpp"
#include "godobject/patch_finger.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/patch.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>

/// What the handles of the C interface hold.
struct limitcurve_law {
  limitcurve::Law law;
  std::string name;
};

struct limitcurve_table {
  limitcurve::godobject::FingerCurve curve;
  std::optional<limitcurve::Table> table = {};  ///< of an ellipse or a box nothing
  std::string csv = {};
};

struct limitcurve_finger {
  std::variant<limitcurve::godobject::SoftFinger, limitcurve::godobject::PatchFinger> finger;
};

struct limitcurve_batch {
  std::variant<limitcurve::godobject::Batch, limitcurve::godobject::FloatBatch> batch;
};

struct limitcurve_patch {
  limitcurve::Patch patch;
};

namespace limitcurve::c {

/// The parameters in the library's own type; throws what they are refused for.
godobject::FingerParameters parameters_of(const limitcurve_finger_parameters& given);
godobject::Projection projection_of(limitcurve_projection projection);

}  // namespace limitcurve::c
