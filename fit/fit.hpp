// SPDX-License-Identifier: MIT
#pragma once

/// Fits: from curves and measurements to friction parameters with their uncertainty.
#include "fit/ellipse_fit.hpp"
#include "fit/estimate.hpp"
#include "fit/loss.hpp"
