// SPDX-License-Identifier: MIT
#pragma once

/// Fits: from curves and measurements to friction parameters with their uncertainty.
#include "fit/contact_fit.hpp"
#include "fit/curve_fit.hpp"
#include "fit/engine_coefficients.hpp"
#include "fit/estimate.hpp"
#include "fit/load_fit.hpp"
#include "fit/measurements.hpp"
#include "fit/model_fit.hpp"
#include "fit/ratio_fit.hpp"
