// SPDX-License-Identifier: MIT
#include "limitcurve/validate/choose.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/validate/remembering_law.hpp"
#include "limitcurve/validate/shipped_costs.hpp"
#include "limitcurve/validate/validate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

/// The coarsest table whose radial error is within `tolerance`.
Candidate sufficient_table(const Law& law, const ExactCurve& exact, double tolerance) {
  // An error ε of f and m is a radial error of at most ε(1 + 1/m₀)/0.9; the error of a table is at most its tolerance
  // times max(1, m₀).
  const double m0 = exact.moment_ratio();
  const double needed = 0.9 * tolerance / ((1.0 + 1.0 / m0) * std::max(1.0, m0));
  const double bound = std::clamp(needed, Table::finest_tolerance, Table::coarsest_tolerance);
  const double cost = shipped_costs::of("table").wrench;
  // A sharply peaked pressure: its moment is less than any table's error. Do not try.
  if (needed < 1e-2 * Table::finest_tolerance) {
    return {"table", bound, std::numeric_limits<double>::infinity(),
            cost,    false, "would need a tolerance of " + format_number(needed)};
  }
  try {
    const Table table = Table::build(law, bound);
    return {"table", bound, curve_error(table, exact).max_error, cost};
  } catch (const std::runtime_error& error) {
    return {"table", bound, std::numeric_limits<double>::infinity(), cost, false, error.what()};
  }
}

std::string reason(const Candidate& candidate, double cost_of_chosen, double tolerance) {
  if (!candidate.reason.empty()) return candidate.reason;
  if (candidate.error > tolerance) {
    // As many digits as tell one from the other. Neighbours may be the same in per cent, but not as they are.
    constexpr int most_digits = std::numeric_limits<double>::max_digits10;
    const auto said = [](double error, int digits) {
      return digits == 2             ? in_percent(error)
             : digits <= most_digits ? format_number(100.0 * error, digits) + " %"
                                     : format_number(error);
    };
    int digits = 2;
    while (said(candidate.error, digits) == said(tolerance, digits)) ++digits;
    return said(candidate.error, digits) + " > " + said(tolerance, digits);
  }
  if (candidate.chosen) return in_percent(candidate.error) + ": chosen";
  return in_percent(candidate.error) + ", " + format_number(candidate.nanoseconds / cost_of_chosen, 2) +
         " times the cost";
}

}  // namespace

std::string in_percent(double fraction) {
  if (fraction == 0.0) return "0";
  if (!(fraction >= 1e-4)) {
    std::array<char, 32> text{};
    return {text.data(),
            std::to_chars(text.data(), text.data() + text.size(), fraction, std::chars_format::scientific, 1).ptr};
  }
  return (fraction < 0.1 ? format_number(100.0 * fraction, 2) : format_number(std::round(100.0 * fraction))) + " %";
}

void choose_cheapest(std::vector<Candidate>& candidates, double tolerance) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& one, const Candidate& other) { return one.nanoseconds < other.nanoseconds; });
  const auto less_error = [](const Candidate& one, const Candidate& other) { return one.error < other.error; };
  auto best = std::find_if(candidates.begin(), candidates.end(),
                           [&](const Candidate& candidate) { return candidate.error <= tolerance; });
  if (best != candidates.end()) {
    const double least = best->nanoseconds;
    const auto tied = std::find_if(best, candidates.end(),
                                   [&](const Candidate& one) { return one.nanoseconds > (1.0 + cost_tie) * least; });
    best = std::min_element(best, tied, less_error);
    best->chosen = true;
  }
  const double cost =
      best == candidates.end() ? 0.0 : best->nanoseconds;  // none is chosen: each has an error that is too large
  for (Candidate& candidate : candidates) candidate.reason = reason(candidate, cost, tolerance);
}

std::vector<Candidate> choose(const Law& law, double tolerance) {
  if (!(tolerance >= 1e-10 && tolerance <= 1.0))
    throw out_of_range("tolerance", tolerance, "1", "1e-10 <= tolerance <= 1");
  const ExactCurve exact(std::make_shared<RememberingLaw>(checked(law)));
  const double m0 = exact.moment_ratio();
  const auto error_of = [&](const auto& curve) { return curve_error(curve, exact).max_error; };
  const auto cost_of = [](const char* model) { return shipped_costs::of(model).wrench; };
  std::vector<Candidate> candidates{
      {"diamond", 1.0, error_of(diamond(1.0, m0)), cost_of("diamond")},
      {"box", std::numeric_limits<double>::infinity(), error_of(box(1.0, m0)), cost_of("box")},
      {"ellipse", 1.0, error_of(Ellipse::through_intercepts(m0)), cost_of("ellipse")},
      sufficient_table(law, exact, tolerance),
      {"exact", std::numeric_limits<double>::quiet_NaN(), 0.0,
       cost_of(law->allows(Method::closed) ? "exact" : "exact by quadrature")},
  };
  choose_cheapest(candidates, tolerance);
  return candidates;
}

}  // namespace limitcurve
