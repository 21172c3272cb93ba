// SPDX-License-Identifier: MIT
#pragma once

#include "elliptic.hpp"
#include "limitcurve/pressure_law.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace limitcurve::bench {

/// Eq. (17) by `ring` kernels and one Gauss–Legendre rule on either side of ρ = s, in θ of ρ = left + (right − left) sin²θ,
/// which smooths the logarithm at ρ = s and the rim's square root.
class FixedGauss {
 public:
  template <class Rule>
  FixedGauss(const PressureLaw& law, Rule) : law_(&law) {
    constexpr double quarter_pi = 0.78539816339744830962;
    const auto add = [&](double x, double weight) {
      const double angle = quarter_pi * (1.0 + x);
      const double sine = std::sin(angle);
      const double cosine = std::cos(angle);
      nodes_.push_back({sine * sine, cosine * cosine, 2.0 * sine * cosine * quarter_pi * weight});
    };
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double x = Rule::abscissa()[i];
      add(x, Rule::weights()[i]);
      if (x != 0.0) add(-x, Rule::weights()[i]);
    }
    exponent_ = static_cast<double>(law.rim_exponent());
  }

  [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(Node); }

  UnitWrench operator()(double s) const {
    UnitWrench sum;
    const double split = std::min(s, 1.0);
    add_piece(s, 0.0, split, sum);
    add_piece(s, split, 1.0, sum);
    return sum;
  }

 private:
  struct Node {
    double from_left, from_right, weight;  // in units of the piece
  };

  void add_piece(double s, double left, double right, UnitWrench& sum) const {
    constexpr double per_pi = 4.0 / 3.14159265358979323846;
    const double length = right - left;
    if (!(length > 0.0)) return;
    for (const auto& [from_left, from_right, node_weight] : nodes_) {
      const double radius = from_left < from_right ? left + length * from_left : right - length * from_right;
      const double rim = (1.0 - right) + length * from_right;
      const double from_cor = right <= s ? (s - right) + length * from_right : (left - s) + length * from_left;
      double pressure = law_->density(RadialPosition<double>{radius, rim});
      if (exponent_ != 0.0) pressure *= std::pow(rim, exponent_);
      const double weight = per_pi * length * node_weight * radius * pressure;
      const double larger = std::max(radius, s);
      const double q = std::min(radius, s) / larger;
      const double complement = from_cor / larger * ((radius + s) / larger);
      const auto [b, d] = study::elliptic_pair(q, complement);
      const double e = b + complement * d;
      const bool within = radius <= s;
      sum.force += weight * (within ? e : q * b);
      sum.moment += weight * radius * (within ? q * b : e);
    }
  }

  const PressureLaw* law_;
  double exponent_ = 0.0;
  std::vector<Node> nodes_;
};

}  // namespace limitcurve::bench
