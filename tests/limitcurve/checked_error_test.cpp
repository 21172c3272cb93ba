// SPDX-License-Identifier: MIT
// Tables of laws of all kinds, with parameters from their whole range and tolerances that are not powers of ten: none
// is off by more than it certifies, nor by more than its tolerance.
#include "limitcurve/quadrature/evaluators.hpp"
#if __has_include("limitcurve/measured/samples.hpp")
#include "limitcurve/measured/samples.hpp"
#endif
#include "tests/limitcurve/shared.hpp"
#include "tests/superellipse.hpp"

namespace limitcurve {
namespace {

using Exact = std::function<UnitWrench(SlipTwist)>;

class Draw {
 public:
  explicit Draw(int seed) : generator_(static_cast<std::uint64_t>(seed)) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }

  Law law(bool simple = false) {
    static constexpr std::array<const char*, 5> names{"hertz", "uniform", "parabolic", "flat-punch", "cone"};
    switch (static_cast<int>(uniform(0.0, simple ? 5.0 : 7.0))) {
      case 0:
        return power(decades(-3.5, 0.0) - 1.0);
      case 1:
        return power(decades(-1.0, 3.0) - 1.0);
      case 2:
        return xydas_kao(decades(-1.7, 6.0));
      case 3:
        return gaussian(decades(-4.0, 2.0));
      case 4:
        return parse_law(names.at(static_cast<std::size_t>(uniform(0.0, 5.0))));
      case 5: {
        const double share = uniform(0.05, 0.95);
        const std::vector<std::pair<double, Law>> parts{{share, law(true)}, {1.0 - share, law(true)}};
        return mixture(parts);
      }
      default:
        return profile();
    }
  }

 private:
  /// Samples, some with a jump.
  Law profile() {
#if __has_include("limitcurve/measured/samples.hpp")
    std::vector<PressureSample> taken;
    const int count = static_cast<int>(uniform(3.0, 18.0));
    double pressure = 1.0;
    for (int i = 0; i <= count; ++i) {
      const double rho = static_cast<double>(i) / count;
      taken.push_back({rho, pressure *= uniform(0.6, 1.2)});
      if (i > 0 && i < count && uniform(0.0, 1.0) < 0.15) taken.push_back({rho, pressure *= uniform(0.2, 2.0)});
    }
    return samples(taken, "profile.csv");
#else
    return law(true);
#endif
  }

  std::mt19937_64 generator_;
};

/// The largest error at places that crowd to 0, to ∞ and to the rim from both sides: a scan, then ever finer around the
/// worst of it, which finds more than a scan of a hundred times as many.
template <class Real>
double largest_error(const BasicTable<Real>& table, const Exact& exact, int places) {
  struct Place {
    double error;
    int run;
    double decades;
  };
  const auto look = [&](int run, double decades) {
    const double tiny = std::pow(10.0, -decades);
    const SlipTwist twist = run == 0   ? SlipTwist{tiny, 1.0}
                            : run == 1 ? SlipTwist{1.0, tiny}
                            : run == 2 ? SlipTwist{1.0 - tiny, 1.0}
                                       : SlipTwist{1.0, 1.0 - tiny};
    return Place{test::apart(table.wrench(twist), exact(twist)), run, decades};
  };
  std::vector<Place> found;
  for (int i = 0; i < places; ++i) {
    const double part = (i / 4 + 0.5) / (places / 4);
    found.push_back(look(i % 4, (i % 4 < 2 ? 30.0 : 16.0) * part * part));
  }
  std::sort(found.begin(), found.end(), [](const Place& a, const Place& b) { return a.error > b.error; });
  double worst = 0.0;
  for (Place best : std::vector<Place>(found.begin(), found.begin() + 12)) {
    for (double step = 0.02 * (1.0 + best.decades); step > 1e-6; step /= 2.0) {
      for (const double move : {-step, -0.5 * step, 0.5 * step, step}) {
        const Place next = look(best.run, std::max(best.decades + move, 0.0));
        if (next.error > best.error) best = next;
      }
    }
    worst = std::max(worst, best.error);
  }
  return worst;
}

template <class Real>
void expect_checked(double finest) {
  const int places = studies_are_whole() ? 4000 : 1000;
  int tables = 0;
  for (int seed = 0; seed < repetitions(studies_are_whole() ? 400 : 20, 10); ++seed) {
    Draw draw(seed);
    const double tolerance = draw.decades(finest, -1.0);
    const bool own = draw.uniform(0.0, 1.0) < 0.1;
    const test::Superellipse curve{draw.uniform(0.5, 2.0), draw.uniform(0.3, 1.0), draw.uniform(1.5, 3.5)};
    const Law law = draw.law();
    const Exact exact = [&](SlipTwist twist) {
      if (own) return curve.wrench(twist);
      if (tolerance > 1e-10 || twist.spin == 0.0) return law->evaluate(twist.cor(), Method::automatic).wrench;
      const auto forces = law->unrounded(Extended(twist.slide) / twist.spin, Slope::unwanted).forces;
      return UnitWrench{static_cast<double>(forces.force), static_cast<double>(forces.moment)};
    };
    try {
      const auto table =
          own ? BasicTable<Real>::build(curve, tolerance, {.name = "own"}) : BasicTable<Real>::build(law, tolerance);
      const double error = largest_error(table, exact, places);
      EXPECT_LE(error, table.checked_error()) << seed << ' ' << table.law_name() << ' ' << tolerance;
      EXPECT_LE(table.checked_error(),
                tolerance * std::max(exact({1.0, 0.0}).force, exact({0.0, 1.0}).moment) * (1.0 + 1e-15));
      ++tables;
    } catch (const std::runtime_error&) {
      // Not possible; the error says so.
    }
  }
  EXPECT_GT(tables, 0);
}

TEST(CheckedError, HoldsForLawsOfAllKinds) {
  expect_checked<double>(-14.0);
}

TEST(CheckedError, HoldsInSinglePrecision) {
  expect_checked<float>(-6.3);
}

}  // namespace
}  // namespace limitcurve
