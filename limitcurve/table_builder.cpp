// SPDX-License-Identifier: MIT
#include "limitcurve/table_builder.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace limitcurve {

namespace {

/// A stretch of a side and the node density (per unit of the coordinate) that its error asks for.
struct Stretch {
  double left;
  double right;
  double density;
};

class SideBuilder {
 public:
  SideBuilder(const PressureLaw& law, Side side, double tolerance) : law_(law), side_(side), tolerance_(tolerance) {}

  CertifiedSide build() {
    learn(exact(0.0), exact(1.0), 0);
    double surplus = 1.03;
    std::optional<CertifiedSide> best;
    for (int attempt = 0; attempt < most_attempts && !best; ++attempt) {
      best = certify(cells_wanted(surplus));
      surplus *= 1.03;
    }
    if (!best) throw std::runtime_error("table of " + law_.name() + ": the tolerance is not reached");
    // A few wide cells do not yet follow the asymptotic law that says how many are needed: see if fewer will do.
    for (std::size_t cells = best->side.nodes().size() - 2; cells >= 1 && cells < few_cells; --cells) {
      std::optional<CertifiedSide> fewer;
      for (int attempt = 0; attempt < settling_attempts && !fewer; ++attempt) fewer = certify(cells);
      if (!fewer) break;
      best = std::move(fewer);
    }
    return std::move(*best);
  }

 private:
  static constexpr int most_attempts = 40;
  static constexpr std::size_t few_cells = 12;
  static constexpr int settling_attempts = 6;
  static constexpr int few_points = 3;
  /// No stretch narrower than this: below it the curve's last digits are noise.
  static constexpr int deepest = 44;

  /// What is left of the tolerance for interpolation.
  [[nodiscard]] double target() const { return 0.9 * tolerance_ / (1.0 + certificate_margin); }

  /// What a table holds and is compared with.
  [[nodiscard]] TableNode exact(double x) const {
    if (side_ == Side::inside) {
      const UnitForces<double> forces = law_.forces(x);
      return {x, forces.force, forces.moment, forces.force_slope};
    }
    if (x == 0.0) {
      // dm/dq = s³ df/ds has a limit, ⟨ρ²⟩/2, which the law shows at any s that is large enough.
      constexpr double far = 1e80;
      return {0.0, 0.0, 1.0, law_.forces(far).force_slope * far * far * far};
    }
    const UnitForces<double> forces = law_.forces(1.0 / x);
    return {x, forces.moment, forces.force, forces.force_slope / (x * x * x)};
  }

  /// The slope of the rim node that makes the middle of the cell before it exact. The curve's own slope there may be
  /// reached only within 1e-20 of the rim (n → −1), so that a cubic with it overshoots; the *direction* of the curve
  /// at the rim, dm/df = −1, does not depend on it.
  [[nodiscard]] TableNode fitted_rim(const TableNode& left, TableNode right) const {
    const double width = right.coordinate - left.coordinate;
    const TableNode middle = exact(left.coordinate + 0.5 * width);
    const double fitted = left.slope + 8.0 * (0.5 * (left.primary + right.primary) - middle.primary) / width;
    if (fitted > 0.0) right.slope = fitted;
    return right;
  }

  [[nodiscard]] double error_at(const TableNode& left, const TableNode& right, double t) const {
    const TableNode truth = exact(left.coordinate + t * (right.coordinate - left.coordinate));
    const Pair value = TableSide::Cell(left, right).value(truth.coordinate);
    return std::max(std::fabs(value[0] - truth.primary), std::fabs(value[1] - truth.secondary));
  }

  /// Bisects until the cells' errors tell the density: they are near the tolerance, within a factor of 16.
  void learn(const TableNode& left, const TableNode& from_right, int depth) {
    const TableNode right = from_right.coordinate == 1.0 ? fitted_rim(left, from_right) : from_right;
    const double error = std::max({error_at(left, right, 0.25), error_at(left, right, 0.5), error_at(left, right, 0.75)});
    if (depth < deepest && (depth < 1 || error > 16.0 * tolerance_)) {
      const TableNode middle = exact(0.5 * (left.coordinate + right.coordinate));
      learn(left, middle, depth + 1);
      learn(middle, right, depth + 1);
      return;
    }
    const double width = right.coordinate - left.coordinate;
    stretches_.push_back({left.coordinate, right.coordinate, std::pow(error / target(), 0.25) / width});
  }

  [[nodiscard]] double total_demand() const {
    double total = 0.0;
    for (const Stretch& stretch : stretches_) total += demand(stretch);
    return total;
  }

  [[nodiscard]] std::size_t cells_wanted(double surplus) const {
    const auto cells = static_cast<std::size_t>(std::ceil(total_demand() * surplus));
    if (cells + 1 > TableSide::most_nodes) throw std::runtime_error("table of " + law_.name() + ": too many nodes for the tolerance");
    return std::max<std::size_t>(cells, 1);
  }

  /// Lays so many cells and compares them with the exact curve; nothing if they fail. Either way the density is learnt
  /// anew from what was found, so that a next call lays them better.
  [[nodiscard]] std::optional<CertifiedSide> certify(std::size_t cells) {
    std::vector<TableNode> nodes = lay_nodes(cells);
    // Most failures show at a few places a cell; the certificate's many are for what passes those.
    for (const int points : {few_points, certificate_points}) {
      const double worst = survey(nodes, points) * (1.0 + certificate_margin);
      if (worst > tolerance_) return std::nullopt;
      if (points == certificate_points) return CertifiedSide{TableSide(std::move(nodes)), worst};
    }
    return std::nullopt;
  }

  /// The largest error found at so many places a cell, infinite where a cell is not convex; learns the density from them.
  [[nodiscard]] double survey(const std::vector<TableNode>& nodes, int points) {
    stretches_.clear();
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const TableNode& left = nodes[i];
      const TableNode& right = nodes[i + 1];
      const double error = largest_error(left, right, points);
      const bool convex = is_convex(left, right);
      worst = std::max(worst, convex ? error : std::numeric_limits<double>::infinity());
      // A cell that is not convex is too wide whatever its error.
      const double wanted = std::max(std::pow(error / target(), 0.25), convex ? 0.0 : 1.5);
      stretches_.push_back({left.coordinate, right.coordinate, wanted / (right.coordinate - left.coordinate)});
    }
    return worst;
  }

  /// Lays nodes so that each of `cells` holds the same integral of the density.
  [[nodiscard]] std::vector<TableNode> lay_nodes(std::size_t cells) const {
    const double share = total_demand() / static_cast<double>(cells);
    std::vector<TableNode> nodes{exact(0.0)};
    double filled = 0.0;
    for (const Stretch& stretch : stretches_) {
      const double here = demand(stretch);
      const double width = stretch.right - stretch.left;
      while (filled + here > share * (static_cast<double>(nodes.size()) - 1e-9) && nodes.size() < cells) {
        const double part = (share * static_cast<double>(nodes.size()) - filled) / here;
        nodes.push_back(exact(stretch.left + part * width));
      }
      filled += here;
    }
    nodes.push_back(fitted_rim(nodes.back(), exact(1.0)));
    return nodes;
  }

  /// Cells that a stretch asks for. Never none, or the laying could not pass it.
  static double demand(const Stretch& stretch) { return std::max(stretch.density * (stretch.right - stretch.left), 1e-3); }

  [[nodiscard]] double largest_error(const TableNode& left, const TableNode& right, int points) const {
    double error = 0.0;
    for (int i = 1; i <= points; ++i) error = std::max(error, error_at(left, right, i / (points + 1.0)));
    if (right.coordinate == 1.0) {
      // The singularity of the rim pulls the largest error towards it.
      for (double from_rim = 0.5; from_rim > 1e-6; from_rim *= 0.75) error = std::max(error, error_at(left, right, 1.0 - from_rim));
    }
    return error;
  }

  const PressureLaw& law_;
  Side side_;
  double tolerance_;
  std::vector<Stretch> stretches_;
};

}  // namespace

CertifiedSide build_side(const PressureLaw& law, Side side, double tolerance) {
  return SideBuilder(law, side, tolerance).build();
}

}  // namespace limitcurve
