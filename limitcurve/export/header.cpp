// SPDX-License-Identifier: MIT
#include "limitcurve/export/header.hpp"

#include "limitcurve/export/single_precision.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/table_file.hpp"
#include "limitcurve/version.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <regex>
#include <sstream>
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

/// The reserved words of C23 and C++23, and `main`.
constexpr std::string_view reserved =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class "
    "co_await co_return "
    "co_yield compl concept const consteval constexpr constinit const_cast continue decltype default delete do double "
    "dynamic_cast else "
    "enum explicit export extern false float for friend goto if inline int long main mutable namespace new noexcept "
    "not not_eq nullptr "
    "operator or or_eq private protected public register reinterpret_cast requires restrict return short signed sizeof "
    "static "
    "static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename typeof "
    "typeof_unqual union "
    "unsigned using virtual void volatile wchar_t while xor xor_eq ";

void check_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto fits = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  if (!name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), fits) &&
      name.find("__") == std::string_view::npos &&
      reserved.find(" " + std::string(name) + " ") == std::string_view::npos) {
    return;
  }
  throw std::invalid_argument(
      "name: got '" + std::string(name) +
      "', expected a C identifier: a letter, then letters, digits and single underscores, and no word of C or C++");
}

/// C in double precision as C in single precision: types and literals, but in comments.
std::string in_float(const std::string& code) {
  std::string text;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (line.starts_with("//")) continue;
    line = std::regex_replace(line, std::regex("\\bdouble\\b"), "float");
    line = std::regex_replace(line, std::regex("\\b[0-9]+\\.[0-9]+\\b"), "$&f");
  }
  return text;
}

}  // namespace

double single_precision_error(const Table& table) {
  return table.checked_error() + table::rounding_in_single_precision(table::in_single_precision(table.cells()));
}

std::string to_header(const Table& table, std::string_view chosen_name, bool is_single) {
  const TableCells cells = is_single ? table::in_single_precision(table.cells()) : table.cells();
  const auto degree = static_cast<std::size_t>(table.degree());
  const auto literal = [&](double value) {
    std::array<char, 32> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(value)).ptr;
    std::string text =
        is_single ? std::string(digits.data(), static_cast<std::size_t>(end - digits.data())) : format_number(value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return is_single ? text + "f" : text;
  };
  const auto list = [&](const std::vector<TableCell>& side) {
    std::string text = "{\n";
    for (const TableCell& cell : side) {
      text.append("    {").append(literal(cell.x));
      for (std::size_t i = 0; i <= degree; ++i) text.append(", ").append(literal(cell.coefficients[i]));
      text += "},\n";
    }
    return text + "}";
  };
  // Words between @ are replaced below.
  std::string text = R"(// Friction limit curve of the pressure law @LAW@, written by limitcurve @VERSION@.
// |error| of force and moment <= checked_error, compared with the exact curve. Add profile_error if the
// pressure is known at samples only (0 for a law given by a formula). Checksum @CHECKSUM@
// C99, C++17 and CUDA; needs no other header. All names begin with the table's, and are local to the file
// that includes this one.
#ifndef @GUARD@
#define @GUARD@

#if defined(__CUDA_ARCH__)
#define LIMITCURVE_TABLE_DATA static __device__ constexpr
#elif defined(__cplusplus)
#define LIMITCURVE_TABLE_DATA static constexpr
#else
#define LIMITCURVE_TABLE_DATA static const
#endif
#if defined(__CUDACC__)
#define LIMITCURVE_TABLE_FUNCTION static __host__ __device__ constexpr
#elif defined(__cplusplus)
#define LIMITCURVE_TABLE_FUNCTION static constexpr
#else
#define LIMITCURVE_TABLE_FUNCTION static inline
#endif

/// force = F/(mu P), moment = M/(mu P a): friction force and moment without units.
typedef struct @NAME@_friction {
  double force;
  double moment;
} @NAME@_friction;

LIMITCURVE_TABLE_DATA double @NAME@_tolerance = @TOLERANCE@;
LIMITCURVE_TABLE_DATA double @NAME@_checked_error = @CHECKED@;
LIMITCURVE_TABLE_DATA double @NAME@_profile_error = @PROFILE@;
/// Moment of a pure twist, mu_r / (mu a).
LIMITCURVE_TABLE_DATA double @NAME@_moment_ratio = @RATIO@;

/// The wrench at c = a, the centre of rotation on the rim.
LIMITCURVE_TABLE_DATA @NAME@_friction @NAME@_rim = {@RIM@};

/// The support function D(x) in cells. A row is the x at which a cell begins, then the coefficients of D
/// in powers of the distance from it. Inside the rim x = c/a, force = D', moment = D - x D'. Outside x =
/// a/c, moment = D', force = D - x D'.
LIMITCURVE_TABLE_DATA double @NAME@_inside[@INSIDE_COUNT@][@COLUMNS@] = @INSIDE@;
LIMITCURVE_TABLE_DATA double @NAME@_outside[@OUTSIDE_COUNT@][@COLUMNS@] = @OUTSIDE@;

typedef struct @NAME@_jet {
  double leading;   /* D' */
  double trailing;  /* D - x D' */
  double second;    /* D'' */
} @NAME@_jet;

/// The curve at x in [0, 1], on one side of the rim. A bisection finds the cell.
LIMITCURVE_TABLE_FUNCTION @NAME@_jet @NAME@_evaluate(int outside, double x) {
  const double (*const cells)[@COLUMNS@] = outside ? @NAME@_outside : @NAME@_inside;
  int low = 0;
  int high = outside ? @OUTSIDE_COUNT@ : @INSIDE_COUNT@;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (cells[middle][0] <= x) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const double t = x - cells[low][0];
  double value = 0.0;
  double slope = 0.0;
  double half_second = 0.0;
  for (int i = @DEGREE@ + 1; i >= 1; --i) {
    half_second = half_second * t + slope;
    slope = slope * t + value;
    value = value * t + cells[low][i];
  }
  const @NAME@_jet jet = {slope, value - x * slope, 2.0 * half_second};
  return jet;
}

/// The unit wrench of a contact that slides with speed `slide` and turns with rim speed `spin` (a times
/// the angular velocity): magnitudes, whatever the signs. Only the ratio matters, |slide|/|spin| = c/a;
/// without slip both are 0.
LIMITCURVE_TABLE_FUNCTION @NAME@_friction @NAME@_wrench(double slide, double spin) {
  @NAME@_friction found = {0.0, 0.0};
  if (slide < 0.0) slide = -slide;
  if (spin < 0.0) spin = -spin;
  if (slide == 0.0 && spin == 0.0) return found;
  const int outside = slide > spin;
  const @NAME@_jet jet = @NAME@_evaluate(outside, outside ? spin / slide : slide / spin);
  found.force = outside ? jet.trailing : jet.leading;
  found.moment = outside ? jet.leading : jet.trailing;
  return found;
}

/// The curve's point nearest to a trial, if chi > 0 (closest_point), or on the ray through it, if chi =
/// 0. `gauge` is how many times farther the trial reaches in the direction of the normal there. Newton's
/// method in a bracket.
LIMITCURVE_TABLE_FUNCTION @NAME@_friction @NAME@_project(double force, double moment, double chi, double *gauge) {
  const int on_ray = !(chi > 0.0);
  const double scale = @FAR@ * (force > moment ? force : moment); /* from afar only the direction counts */
  if (scale > 1.0) {
    force /= scale;
    moment /= scale;
  }
  const int outside = on_ray ? force * @NAME@_rim.moment > moment * @NAME@_rim.force
                             : force - @NAME@_rim.force > chi * (moment - @NAME@_rim.moment);
  const double leading = outside ? moment : force;
  const double trailing = outside ? force : moment;
  const double kappa = outside && !on_ray ? 1.0 / chi : chi;
  double low = 0.0;
  double high = 1.0;
  double x = leading > 0.0 ? 0.5 : 0.0; /* a trial on an axis has its root at the end */
  @NAME@_jet jet = @NAME@_evaluate(outside, x);
  for (int step = 1; step <= 64; ++step) {
    const double over = kappa * (trailing - jet.trailing);
    const double up = on_ray ? jet.trailing * leading : leading - jet.leading;
    const double down = on_ray ? jet.leading * trailing : x * over;
    const double slope = on_ray ? jet.second * (trailing + x * leading) : jet.second * (1.0 + kappa * x * x) + over;
    const double rounding = @ROUNDING@ * (on_ray ? up + down : leading + x * kappa * trailing);
    /* Below its rounding the sign of the residual is chance. A trial below a point of the curve in both
       components is inside. */
    if ((up - down <= rounding && down - up <= rounding) || (!on_ray && up <= 0.0 && over <= 0.0)) break;
    if (up > down) {
      low = x;
    } else {
      high = x;
    }
    const double next = slope > 0.0 && step % 8 != 0 ? x + (up - down) / slope : high;
    x = next > low && next < high ? next : 0.5 * (low + high);
    jet = @NAME@_evaluate(outside, x);
  }
  *gauge = (trailing + x * leading) / (jet.trailing + x * jet.leading) * (scale > 1.0 ? scale : 1.0);
  const @NAME@_friction found = {outside ? jet.trailing : jet.leading, outside ? jet.leading : jet.trailing};
  return found;
}

/// Distance of a unit wrench from the origin divided by that of the curve on the same ray: < 1 holds, >
/// 1 slips. Signs are ignored.
LIMITCURVE_TABLE_FUNCTION double @NAME@_gauge(double force, double moment) {
  double gauge = (force < 0.0 ? -force : force) + (moment < 0.0 ? -moment : moment);
  if (gauge - gauge == 0.0) @NAME@_project(force < 0.0 ? -force : force, moment < 0.0 ? -moment : moment, 0.0, &gauge);
  return gauge; /* of infinity and NaN they themselves */
}

/// What a trial, the unit wrench of springs that would stick, becomes: the nearest point of the curve if
/// it slips, else itself. A change of the moment costs chi = a^2 k_l/k_r, in [1e-3, 1e3], times one of
/// the force. Signs are kept.
LIMITCURVE_TABLE_FUNCTION @NAME@_friction @NAME@_closest_point(double force, double moment, double chi) {
  double gauge = 0.0;
  @NAME@_friction found = @NAME@_project(force < 0.0 ? -force : force, moment < 0.0 ? -moment : moment, chi, &gauge);
  const int slips = gauge > @ONSET@;
  const double nan = 0.0 * (force - force + moment - moment + chi - chi); /* else 0 */
  found.force = nan + (!slips ? force : force < 0.0 ? -found.force : found.force);
  found.moment = nan + (!slips ? moment : moment < 0.0 ? -found.moment : found.moment);
  return found;
}

#undef LIMITCURVE_TABLE_DATA
#undef LIMITCURVE_TABLE_FUNCTION

#endif
)";
  if (is_single) text = in_float(text);
  const auto put = [&](std::string_view word, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += value.size())
      text.replace(at, word.size(), value);
  };
  const std::string sum = checksum(table);
  const std::string_view digits = std::string_view(sum).substr(6);
  if (!chosen_name.empty()) check_name(chosen_name);
  const std::string name = chosen_name.empty() ? own_name(table, digits) : std::string(chosen_name);
  put("@GUARD@", name + "_" + std::string(digits));
  put("@NAME@", name);
  put("@VERSION@", std::string(version));
  put("@CHECKSUM@", sum);
  put("@ROUNDING@", is_single ? "5e-7f" : "1e-15");
  put("@FAR@", is_single ? "1e-14f" : "1e-32");
  put("@ONSET@", is_single ? "1.0000038f" : "1.0 + 1e-12");
  // In float a little more, so that its rounding is above the error.
  const double error = is_single ? single_precision_error(table) * (1 + 1e-7) : table.checked_error();
  put("@TOLERANCE@", literal(is_single ? std::max(table.tolerance(), error / std::max(1.0, table.moment_ratio()))
                                       : table.tolerance()));
  put("@CHECKED@", literal(error));
  put("@PROFILE@", literal(table.profile_error()));
  put("@RATIO@", literal(table.moment_ratio()));
  put("@RIM@", literal(table.rim().force) + ", " + literal(table.rim().moment));
  put("@DEGREE@", std::to_string(degree));
  put("@COLUMNS@", std::to_string(degree + 2));
  put("@INSIDE@", list(cells.inside));
  put("@OUTSIDE@", list(cells.outside));
  put("@INSIDE_COUNT@", std::to_string(cells.inside.size()));
  put("@OUTSIDE_COUNT@", std::to_string(cells.outside.size()));
  // Last, because a file name may hold anything.
  put("@LAW@", table.law_name());
  return text;
}

}  // namespace limitcurve
