// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/table_file.hpp"
#include "limitcurve/version.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

namespace limitcurve {

namespace {

/// `limitcurve_table_<law>_<first digits of the checksum>`: two tables never share it.
std::string own_name(const Table& table, std::string_view digits) {
  std::string text = "limitcurve_table_";
  for (const char c : table.law_name()) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      text += c;
    } else if (text.back() != '_') {
      text += '_';
    }
  }
  if (text.back() != '_') text += '_';
  return text.append(digits.substr(0, 8));
}

void check_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto fits = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  if (!name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), fits) &&
      name.find("__") == std::string_view::npos) {
    return;
  }
  throw std::invalid_argument("name: got '" + std::string(name) +
                              "', expected a C identifier: a letter, then letters, digits and single underscores");
}

}  // namespace

std::string to_header(const Table& table, std::string_view chosen_name) {
  const TableCells pieces = table.cells();
  const auto literal = [](double value) {
    const std::string text = format_number(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  };
  const auto list = [&](const std::vector<TableCell>& side) {
    std::string text = "{\n";
    for (const TableCell& cell : side) {
      text.append("    {").append(literal(cell.x));
      for (const double coefficient : cell.coefficients) text.append(", ").append(literal(coefficient));
      text += "},\n";
    }
    return text + "}";
  };
  // Words between @ are replaced below.
  std::string text = R"(// Friction limit curve of the pressure law @LAW@, written by limitcurve @VERSION@.
// |error| of force and moment <= certified_error, compared with the exact curve. Add profile_error if the pressure is known at samples
// only (0 for a law given by a formula). Checksum @CHECKSUM@
// C99 and C++17; needs no other header. All names begin with the table's, and are local to the file that includes this one.
#ifndef @GUARD@
#define @GUARD@

#ifdef __cplusplus
#define LIMITCURVE_TABLE_DATA static constexpr
#define LIMITCURVE_TABLE_FUNCTION static constexpr
#else
#define LIMITCURVE_TABLE_DATA static const
#define LIMITCURVE_TABLE_FUNCTION static inline
#endif

/// force = F/(mu P), moment = M/(mu P a): friction force and moment without units.
typedef struct @NAME@_unit_wrench {
  double force;
  double moment;
} @NAME@_unit_wrench;

LIMITCURVE_TABLE_DATA double @NAME@_tolerance = @TOLERANCE@;
LIMITCURVE_TABLE_DATA double @NAME@_certified_error = @CERTIFIED@;
LIMITCURVE_TABLE_DATA double @NAME@_profile_error = @PROFILE@;
/// Moment of a pure twist, mu_r / (mu a).
LIMITCURVE_TABLE_DATA double @NAME@_moment_ratio = @RATIO@;

/// The support function D(x) in pieces. A row is the x at which a piece begins, then the coefficients of D in powers of the distance from
/// it. Inside the rim x = c/a, force = D', moment = D - x D'. Outside x = a/c, moment = D', force = D - x D'.
LIMITCURVE_TABLE_DATA double @NAME@_inside[@INSIDE_COUNT@][8] = @INSIDE@;
LIMITCURVE_TABLE_DATA double @NAME@_outside[@OUTSIDE_COUNT@][8] = @OUTSIDE@;

/// D' (leading) and D - x D' (trailing) at x in [0, 1]. A bisection finds the piece.
LIMITCURVE_TABLE_FUNCTION void @NAME@_evaluate(const double (*pieces)[8], int count, double x, double *leading, double *trailing) {
  int low = 0;
  int high = count;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (pieces[middle][0] <= x) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const double *const piece = pieces[low];
  const double t = x - piece[0];
  double value = piece[7];
  double slope = 0.0;
  for (int i = 6; i >= 1; --i) {
    slope = slope * t + value;
    value = value * t + piece[i];
  }
  *leading = slope;
  *trailing = value - x * slope;
}

/// The unit wrench of a contact that slides with speed `slide` and turns with rim speed `spin` (a times the angular velocity): magnitudes,
/// whatever the signs. Only the ratio matters, |slide|/|spin| = c/a; without slip both are 0.
LIMITCURVE_TABLE_FUNCTION @NAME@_unit_wrench @NAME@_wrench(double slide, double spin) {
  @NAME@_unit_wrench found = {0.0, 0.0};
  if (slide < 0.0) slide = -slide;
  if (spin < 0.0) spin = -spin;
  if (slide == 0.0 && spin == 0.0) return found;
  if (slide <= spin) {
    @NAME@_evaluate(@NAME@_inside, @INSIDE_COUNT@, slide / spin, &found.force, &found.moment);
  } else {
    @NAME@_evaluate(@NAME@_outside, @OUTSIDE_COUNT@, spin / slide, &found.moment, &found.force);
  }
  return found;
}

#ifdef __cplusplus
namespace @NAME@ {

using unit_wrench = @NAME@_unit_wrench;
static constexpr double tolerance = @NAME@_tolerance;
static constexpr double certified_error = @NAME@_certified_error;
static constexpr double profile_error = @NAME@_profile_error;
static constexpr double moment_ratio = @NAME@_moment_ratio;

static constexpr unit_wrench wrench(double slide, double spin) { return @NAME@_wrench(slide, spin); }

}  // namespace @NAME@
#endif

#undef LIMITCURVE_TABLE_DATA
#undef LIMITCURVE_TABLE_FUNCTION

#endif
)";
  const auto put = [&](std::string_view word, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += value.size()) text.replace(at, word.size(), value);
  };
  const std::string sum = checksum(table);
  const std::string_view digits = std::string_view(sum).substr(6);
  if (!chosen_name.empty()) check_name(chosen_name);
  const std::string name = chosen_name.empty() ? own_name(table, digits) : std::string(chosen_name);
  put("@GUARD@", name + "_" + std::string(digits));
  put("@NAME@", name);
  put("@VERSION@", std::string(version));
  put("@CHECKSUM@", sum);
  put("@TOLERANCE@", literal(table.tolerance()));
  put("@CERTIFIED@", literal(table.certified_error()));
  put("@PROFILE@", literal(table.profile_error()));
  put("@RATIO@", literal(table.moment_ratio()));
  put("@INSIDE@", list(pieces.inside));
  put("@OUTSIDE@", list(pieces.outside));
  put("@INSIDE_COUNT@", std::to_string(pieces.inside.size()));
  put("@OUTSIDE_COUNT@", std::to_string(pieces.outside.size()));
  // Last, because a file name may hold anything.
  put("@LAW@", table.law_name());
  return text;
}

}  // namespace limitcurve
