// SPDX-License-Identifier: MIT
#pragma once

/// Fits friction parameters, with their uncertainty, to curves and measurements.
#include "contact_fit.hpp"
#include "curve_fit.hpp"
#include "estimate.hpp"
#include "friction_fit.hpp"
#include "load_fit.hpp"
#include "measurements.hpp"
#include "model_fit.hpp"
#include "ratio_fit.hpp"
