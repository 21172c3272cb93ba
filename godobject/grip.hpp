// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"

#include <cstdint>
#include <limits>

namespace limitcurve::godobject {

/// What a step knows of a contact.
struct Pull {
  double r_square;          ///< r² [m²]
  double rho;               ///< ρ [rad] ≥ 0
  double load;              ///< P [N] > 0
  double start;             ///< Grip::start of the last step
  double trend;             ///< how far that had moved
  std::uint32_t piece = 0;  ///< Grip::piece of the last step, or any number
};

/// What the contact does to springs that are drawn by r [m] along the surface and ρ [rad] about the normal.
struct Grip {
  bool slips = false;
  Pair share{1.0, 1.0};      ///< r′/r and ρ′/ρ ≤ 1, what is felt of the springs; stays drawn, if it slips
  bool clamps_both = false;  ///< neither share is 1
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip [m], ∞ for pure sliding; NaN where it sticks
  double slip_work = 0.0;                                 ///< |F|(r − r′) + |M|(ρ − ρ′) [J], ≥ 0
  double start = -1.0;                                    ///< for the next step: place of the slip, or 0; < 0 where it sticks
  std::uint32_t piece = 0;                                ///< for the next step: Projected::piece
};

}  // namespace limitcurve::godobject
