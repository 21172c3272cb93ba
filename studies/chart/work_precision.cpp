// SPDX-License-Identifier: MIT
// Error against time of every method to compute a friction wrench, ours and others'. studies/chart/measure runs it and
// draws the chart; by hand it is a Google Benchmark.
#include "by_ring.hpp"
#include "number_text.hpp"
#include "peers.hpp"
#include "way.hpp"
#include "work_precision_step.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <benchmark/benchmark.h>

#include <deque>
#include <string>
#include <vector>

namespace limitcurve::bench {
namespace {

// The other methods are not called beyond this COR, because they do not accept s = ∞; the wrench no longer changes
// there.
constexpr double farthest = 1e17;

template <class Curve>
void add_curve(const WrenchStudy& study, const char* family, const std::string& parameter, const Curve& curve) {
  study.add("ours", family, parameter, 0, [curve](SlipTwist twist) { return curve.wrench(twist); });
}

/// A look-up whose copies have memory of their own; those of a table share it.
struct LookUp {
  explicit LookUp(const Table& built) : table(built) {}
  LookUp(const LookUp& other)
      : table({other.table.law_name(), other.table.tolerance(), other.table.checked_error()}, other.table.cells()) {}
  UnitWrench operator()(SlipTwist twist) const { return table.wrench(twist); }
  Table table;
};

template <class Rule>
void add_of_cor(const WrenchStudy& study, const char* family, const std::string& parameter, Rule rule) {
  std::size_t bytes = 0;
  if constexpr (requires { rule.bytes(); }) bytes = rule.bytes();
  study.add("others", family, parameter, bytes,
            [rule](SlipTwist twist) { return rule(std::min(twist.cor(), farthest)); });
}

void add_evaluators(const WrenchStudy& study) {
  const Law law = study.law();
  study.add("ours", law->allows(limitcurve::Method::closed) ? "closed" : "forces", "double", 0, [law](SlipTwist twist) {
    const UnitForces<double> forces = law->forces(twist.cor(), Slope::unwanted);
    return UnitWrench{forces.force, forces.moment};
  });
  study.add("ours", "ring", "double", 0, [law, rule = study::ByRing(*law)](SlipTwist twist) {
    const UnitForces<double> forces = rule.forces(twist.cor(), Slope::unwanted);
    return UnitWrench{forces.force, forces.moment};
  });
  const auto add_method = [&](const char* family, limitcurve::Method method) {
    if (law->allows(method))
      study.add("ours", family, "80 bit", 0,
                [law, method](SlipTwist twist) { return law->evaluate(twist.cor(), method).wrench; });
  };
  add_method("ring", limitcurve::Method::ring);
  add_method("punch", limitcurve::Method::punch);
  add_method("direct", limitcurve::Method::direct);
}

void add_curves(const WrenchStudy& study) {
  const ExactCurve exact(study.law());
  for (const int digits : {2, 4, 6, 8, 10, 12, 14}) {
    const LookUp look_up(Table::build(study.law(), std::pow(10.0, -digits)));
    study.add("ours", "table", "1e-" + std::to_string(digits), look_up.table.bytes(), look_up);
    const LookUp large(Table::build(study.law(), std::pow(10.0, -digits), {.preferred_bytes = Table::max_bytes}));
    if (large.table.bytes() != look_up.table.bytes())
      study.add("ours", "large table", "1e-" + std::to_string(digits), large.table.bytes(), large);
  }
  add_curve(study, "diamond", "", diamond(1.0, exact.moment_ratio()));
  add_curve(study, "box", "", box(1.0, exact.moment_ratio()));
  add_curve(study, "ellipse", "", Ellipse::through_intercepts(exact.moment_ratio()));
}

void add_peers(const WrenchStudy& study) {
  const PressureLaw& law = *study.law();
  for (const std::size_t entries : {16, 64, 256, 1024, 4096, 16384}) {
    const EqualHermite table(ExactCurve(study.law()), entries);
    study.add("others", "Hermite", std::to_string(entries), table.bytes(), table);
  }
  for (const int cells : {20, 50, 100, 200, 500, 1000}) {
    add_of_cor(study, "grid", std::to_string(cells), Grid(law, cells));
  }
  for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12}) {
    add_of_cor(study, "Boost split", study::number_text(tolerance), BoostSplit(law, tolerance));
  }
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    add_of_cor(study, "Boost nested", study::number_text(tolerance), BoostNested(law, tolerance));
  }
}

}  // namespace
}  // namespace limitcurve::bench

int main(int argc, char** argv) {
  using namespace limitcurve;
  using namespace limitcurve::bench;
  std::deque<WrenchStudy> studies;  // methods refer to them
  for (const char* name : {"hertz", "uniform", "flat-punch", "xydas-kao:k=3", "power:n=2.3"}) {
    const WrenchStudy& study = studies.emplace_back(name, parse_law(name));
    add_evaluators(study);
    add_curves(study);
    add_peers(study);
  }
  for (const Way& way : ways()) {
    const auto benchmark = benchmark::RegisterBenchmark(way.name.c_str(), way.time);
    if (way.nanoseconds > 1e5) {
      benchmark->Iterations(1);
    } else {
      benchmark->MinTime(0.01)->Repetitions(15);
    }
  }
  register_steps();
  register_patches();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
