// SPDX-License-Identifier: MIT
#include "atlas.hpp"

#include <stdexcept>

namespace limitcurve::stability {

std::vector<Finding> findings_of(const Entry& entry, const std::string& test) {
  std::vector<Finding> found;
  for (const Finding& finding : entry.findings) {
    if (finding.test == test) found.push_back(finding);
  }
  if (found.empty()) throw std::logic_error("entry '" + entry.name + "' has no finding for " + test);
  return found;
}

}  // namespace limitcurve::stability
