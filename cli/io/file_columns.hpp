// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve::cli {

/// The names and units of what was measured, where they are not the reader's own and SI.
struct FileColumns {
  /// From --columns, `load=-Fz,force=Fx:Fy` (a sign, and the length of a vector of two or three columns), and from
  /// --units, `length=mm,force=lbf,moment=lbfin,angle=deg,time=ms`; the unit of a moment is one of force and one of
  /// length in a row. Throw std::invalid_argument with the wrong item and the expected ones.
  void read_names(std::string_view list);
  void read_units(std::string_view list);
  /// Whether anything was read.
  [[nodiscard]] bool given() const { return !options.empty(); }

  std::vector<std::pair<std::string, std::string>> names = {};  ///< the reader's name of a column, the file's
  double length = 1.0;                                          ///< the file's unit in m
  double force = 1.0;                                           ///< in N
  double moment = 1.0;                                          ///< in N m
  double angle = 1.0;                                           ///< in rad
  double time = 1.0;                                            ///< in s
  std::string options = {};                                     ///< as they were typed
  std::optional<double> least_load = {};  ///< in the file's unit: rows with a smaller load are left out
  Messages* messages = nullptr;           ///< for notes; with it the header may follow other lines
};

/// What --units takes, for help and messages.
inline constexpr const char* units_text =
    "length=m|cm|mm|um|in, force=N|mN|uN|kN|kgf|lbf, moment=a force and a length in a row, such as Nmm or lbfin, "
    "angle=rad|deg, time=s|ms; "
    "or a number, the unit in SI";

}  // namespace limitcurve::cli
