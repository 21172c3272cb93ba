// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"
#include "limitcurve/table.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limitcurve::table {

/// A point of an exact curve at x, in components of its side: the leading one is the force inside, the moment outside.
struct Sample {
  double x;
  Extended leading;
  Extended trailing;
  double error;  ///< of either, absolute
};

/// A curve that a table is built of.
struct Source {
  std::string name;
  std::function<Sample(bool outside, double x)> at;
  std::vector<double> breaks;  ///< s where it is not smooth, if known; the rim and the ends need no mention
  double profile_error = 0.0;  ///< as the table is to state it
};

/// The table of a curve with |error| ≤ tolerance·max(force_max, m_max), certified in the arithmetic of the table; nothing if it is
/// not to be had within BasicTable::most_bytes.
///
/// Each side is laid from x = 0 to the rim. D′ is interpolated within a cell at six Chebyshev–Lobatto nodes, in extended precision; D is
/// its running integral. So the curve is continuous with its normal by construction, where Hermite data of D would lose their digits in
/// narrow cells. What the integral misses at the rim is made up for in one cell. A cell is any run of buckets (or, where the curve is singular
/// inside a side, a part of one): as many as the tolerance and convexity allow, which is proved by the Bernstein coefficients of D″.
template <class Real>
[[nodiscard]] std::optional<BasicTable<Real>> build(const Source& source, double tolerance);

extern template std::optional<BasicTable<double>> build(const Source&, double);
extern template std::optional<BasicTable<float>> build(const Source&, double);

}  // namespace limitcurve::table
