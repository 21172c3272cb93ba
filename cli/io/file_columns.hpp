// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve::cli {

/// The names and units of what was measured, where they are not the reader's own and SI.
struct FileColumns {
  /// From --columns, `load=-Fz,force=Fx:Fy,moment=Fx:Fy:Fz:Tx:Ty:Tz` (a sign, the length of a vector of two or three
  /// columns, and F·T/Fz; a name with `:` or `,` is in double quotes), and from --units,
  /// `length=mm,force=lbf,moment=lbfin,angle=deg,time=ms`; the unit of a moment is one of force and one of length in a
  /// row. Throw std::invalid_argument with the wrong item and the expected ones.
  void read_names(std::string_view list);
  void read_units(std::string_view list);
  /// The value in SI units of a unit of --units, which may be in brackets.
  [[nodiscard]] static std::optional<double> unit(std::string_view text);

  /// The quantity of one of a reader's columns, such as "length" of x2; "" if it has no unit.
  [[nodiscard]] static std::string_view quantity_of(std::string_view column);
  /// The file's unit of a quantity, in SI.
  [[nodiscard]] double scale(std::string_view quantity) const;
  /// Warns of the units of quantities other than those that are `used`: they are without effect on `what`.
  void warn_idle_units(const std::vector<std::string_view>& used, const std::string& what) const;

  /// What stands after the equals sign of an item of --columns.
  struct Parts {
    bool turned = false;
    bool is_plain = false;  ///< a single name, without sign and quotes
    std::vector<std::string> names = {};
  };
  [[nodiscard]] static Parts parts_of(std::string_view text);

  /// Throws std::invalid_argument if --zero is given without --least-load.
  void check_zero() const;
  /// Whether anything was read.
  [[nodiscard]] bool given() const { return !names.empty() || !scales.empty(); }
  /// --columns and --units as they were typed, for a command that knows only these columns.
  [[nodiscard]] std::string options_of(const std::vector<std::string_view>& columns) const;

  std::vector<std::pair<std::string, std::string>> names = {};  ///< the reader's name of a column, the file's
  std::map<std::string, double, std::less<>> scales = {};       ///< of --units: a quantity's unit in the file, in SI
  std::string units = {};                                       ///< as they were typed
  std::optional<double> least_load = {};  ///< in the file's unit: rows with a smaller load are left out
  bool zero = false;                      ///< subtract the sensor's zero, from the pauses below the least load
  bool is_offered = false;                ///< the command has these options
  bool is_log = false;                    ///< rows with a blank are left out, and so is a second line of units
  Messages* messages = nullptr;           ///< for notes; with it the header may follow other lines
};

/// What --units takes, for help and messages.
inline constexpr const char* units_text =
    "length=m|cm|mm|um|in, force=N|mN|uN|kN|kgf|lbf, moment=force and length joined (Nmm, lbfin), "
    "angle=rad|deg, time=s|ms, or the size of the unit in SI";

}  // namespace limitcurve::cli
