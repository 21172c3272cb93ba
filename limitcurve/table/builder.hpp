// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/law.hpp"
#include "limitcurve/table.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limitcurve::table {

/// A point of an exact curve at x, in components of its side: the leading one is the force inside the rim, the moment
/// outside.
struct Sample {
  double x;
  Extended leading;
  Extended trailing;
  double error;  ///< of either, absolute

  static Sample of(bool outside, double x, Extended force, Extended moment, double error) {
    return outside ? Sample{x, moment, force, error} : Sample{x, force, moment, error};
  }
};

/// The curve from which a table is built.
struct Source {
  std::string name;
  std::function<Sample(bool outside, double x)> sample;
  std::vector<double> breaks;  ///< s where the curve is not smooth, if known; without the rim and the ends
  double profile_error = 0.0;  ///< the table's profile_error

  [[nodiscard]] Sample at(bool outside, double x) const {
    let_interrupt();
    return sample(outside, x);
  }
};

/// The table of a curve with |error| ≤ tolerance·max(force_max, m_max), checked in the arithmetic of the table; nothing
/// if that is not possible within BasicTable::max_bytes. The fastest with at most so many `bytes`, or of degree 6
/// (TableOptions::preferred_bytes).
///
/// Each side is built from x = 0 to the rim. In a cell D′ interpolates the curve at Chebyshev–Lobatto nodes, in
/// extended precision; D is its running integral. So the curve and its normal are continuous by construction. (Hermite
/// interpolation of D would lose digits in narrow cells.) The error of the integral at the rim is corrected in one
/// cell. A cell covers as many buckets as tolerance and convexity allow; where the curve is singular inside a side it
/// may be part of a bucket. The Bernstein coefficients of D″ prove convexity.
template <class Real>
[[nodiscard]] std::optional<BasicTable<Real>> build(const Source& source, double tolerance, std::size_t bytes);

extern template std::optional<BasicTable<double>> build(const Source&, double, std::size_t);
extern template std::optional<BasicTable<float>> build(const Source&, double, std::size_t);

}  // namespace limitcurve::table
