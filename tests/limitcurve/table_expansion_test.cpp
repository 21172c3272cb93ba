// SPDX-License-Identifier: MIT
// Tables of laws by quadrature are compared with the law's expansion in polynomials: what that may and may not change.
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace limitcurve {
namespace {

/// A law that counts what it is asked.
class Counting final : public PressureLaw {
 public:
  explicit Counting(Law law) : law_(std::move(law)) {}
  [[nodiscard]] std::string name() const override { return law_->name(); }
  [[nodiscard]] Extended density(RadialPosition<Extended> at) const noexcept override { return law_->density(at); }
  [[nodiscard]] double density(RadialPosition<double> at) const noexcept override { return law_->density(at); }
  [[nodiscard]] UnitForces<double> forces(double s) const noexcept override {
    ++asked;
    return law_->forces(s);
  }
  mutable int asked = 0;

 private:
  Law law_;
};

// The certificate is the suite's business (TableSuite.ErrorIsCertifiedBetweenTheNodes): the nodes are the law's own, to the bit.
TEST(TableOfAnExpansion, HoldsTheLawsOwnValues) {
  for (const char* name : {"xydas-kao:k=3", "power:n=2.3"}) {
    const Law law = parse_law(name);
    ASSERT_FALSE(law->has_quick_forces());
    const Table table = Table::build(law, 1e-8);
    for (const TableNode& node : table.inside().nodes()) {
      const UnitForces<double> forces = law->forces(node.coordinate);
      EXPECT_EQ(node.primary, forces.force) << name;
      EXPECT_EQ(node.secondary, forces.moment) << name;
    }
    for (const TableNode& node : table.outside().nodes().subspan(1)) {
      const UnitForces<double> forces = law->forces(1.0 / node.coordinate);
      EXPECT_EQ(node.primary, forces.moment) << name;
      EXPECT_EQ(node.secondary, forces.force) << name;
    }
  }
}

// To compare 83 nodes' cells takes some 2900 evaluations; its quadrature is asked for less than half of that.
TEST(TableOfAnExpansion, AsksTheQuadratureSeldom) {
  const auto counting = std::make_shared<Counting>(parse_law("xydas-kao:k=3"));
  const Table table = Table::build(counting, 1e-8);
  EXPECT_LE(counting->asked, 16 * static_cast<int>(table.node_count()));
}

TEST(TableOfAnExpansion, IsTheSameEveryTime) {
  const Law law = parse_law("xydas-kao:k=1.8");
  const Table one = Table::build(law, 1e-6);
  const Table other = Table::build(law, 1e-6);
  EXPECT_EQ(one.certified_error(), other.certified_error());
  ASSERT_EQ(one.node_count(), other.node_count());
  for (std::size_t i = 0; i < one.inside().nodes().size(); ++i) EXPECT_EQ(one.inside().nodes()[i], other.inside().nodes()[i]);
}

}  // namespace
}  // namespace limitcurve
