// SPDX-License-Identifier: MIT
#include "fit/estimate.hpp"

#include <algorithm>
#include <stdexcept>

namespace limitcurve::fit {

namespace {

std::size_t index_of(const FitReport& report, std::string_view name) {
  for (std::size_t i = 0; i < report.estimates.size(); ++i) {
    if (report.estimates[i].name == name) return i;
  }
  throw std::out_of_range("the fit has no estimate called '" + std::string(name) + "'");
}

}  // namespace

const Estimate& FitReport::at(std::string_view name) const {
  return estimates[index_of(*this, name)];
}

const Estimate* FitReport::find(Estimate::Role role) const noexcept {
  const auto found = std::ranges::find(estimates, role, &Estimate::role);
  return found == estimates.end() ? nullptr : &*found;
}

double FitReport::correlation_of(std::string_view first, std::string_view second) const {
  return correlation[index_of(*this, first) * estimates.size() + index_of(*this, second)];
}

}  // namespace limitcurve::fit
