// SPDX-License-Identifier: MIT
#include "limitcurve/table.hpp"

#include "limitcurve/accuracy.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/quadrature/evaluators.hpp"
#include "limitcurve/table/buckets.hpp"
#include "limitcurve/table/builder.hpp"
#include "limitcurve/table/check.hpp"
#include "limitcurve/table/user_curve.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace limitcurve {

#ifdef LIMITCURVE_PACKS
namespace kernel {
// Defined in limitcurve/kernel/.
std::size_t gauges(const CurveView<double>& curve, const UnitWrench* wrenches, double* gauges,
                   std::size_t count) noexcept;
}  // namespace kernel
#endif

namespace {

/// Error of `forces`, relative to max(1, m₀).
constexpr double quick_error = 1e-13;

/// A law by its `forces`, in double: fast.
table::Source quick_source(const Law& law, const std::string& name) {
  const double moment_ratio = law->moment_ratio();
  const double error = quick_error * std::max(1.0, moment_ratio);
  return {name,
          [=](bool outside, double x) -> table::Sample {
            if (x == 0.0) return {x, 0, outside ? 1 : moment_ratio, 0.0};
            const UnitForces<double> forces = law->forces(outside ? 1.0 / x : x, Slope::unwanted);
            return table::Sample::of(outside, x, forces.force, forces.moment, error);
          },
          {}};
}

/// A law in extended precision, whose rounding counts only where it is that of a double.
table::Source fine_source(const Law& law, const std::string& name) {
  const double moment_ratio = law->moment_ratio();
  const double rounding =
      accuracy::has_extended ? 0.0 : 64 * std::numeric_limits<double>::epsilon() * std::max(1.0, moment_ratio);
  return {name,
          [=](bool outside, double x) -> table::Sample {
            if (x == 0.0) return {x, 0, outside ? 1 : moment_ratio, 0.0};
            const auto [forces, bound] = law->unrounded(outside ? 1 / Extended(x) : Extended(x), Slope::unwanted);
            const double error = rounding + static_cast<double>(std::max(bound.force, bound.moment));
            return table::Sample::of(outside, x, forces.force, forces.moment, error);
          },
          {}};
}

/// The largest error of `unrounded` at some CORs: roundings, if the law keeps its promises.
double own_error(const PressureLaw& law) {
  Extended worst = 0;
  const auto look = [&](Extended s) {
    const UnitForces<Extended> error = law.unrounded(s, Slope::unwanted).error;
    worst = std::max({worst, error.force, error.moment});
  };
  for (const Extended s : {0.0L, 0.03L, 0.1L, 0.3L, 0.5L, 0.7L, 0.9L, 1.0L, 1.1L, 1.5L, 3.0L, 10.0L}) look(s);
  // A pressure that is concentrated at the centre.
  for (Extended s = 1e-28L; s < 0.01L; s *= 100) look(s);
  return static_cast<double>(worst);
}

/// Adds the radii at which the law's pressure is not smooth, between centre and rim, and its profile error.
table::Source with_profile(table::Source source, const PressureLaw& law) {
  source.profile_error = law.profile_error();
  for (const Extended s : law.breaks()) {
    if (s > 0 && s != 1) source.breaks.push_back(static_cast<double>(s));
  }
  return source;
}

/// The result of `attempt()`; if it returns nothing, throws an error. A search for what is possible may take longer
/// than all its attempts.
template <class Real, class Attempt>
BasicTable<Real> built(const std::string& name, double tolerance, const Attempt& attempt) {
  using Result = BasicTable<Real>;
  if (!(tolerance >= Result::finest_tolerance && tolerance <= Result::coarsest_tolerance)) {
    throw out_of_range(
        "tolerance", tolerance, "1",
        format_number(Result::finest_tolerance) + " <= tolerance <= " + format_number(Result::coarsest_tolerance));
  }
  if (auto table = attempt()) return std::move(*table);
  throw std::runtime_error("table of " + name + ": a tolerance of " + format_number(tolerance) +
                           " is not possible in " + std::to_string(Result::max_bytes / 1024) +
                           " KiB, or is finer than the curve's own error; expected a coarser one");
}

}  // namespace

namespace table {

/// Tables of a law at any tolerance.
template <class Real>
class Attempts {
 public:
  Attempts(const Law& law, TableOptions options)
      : preferred_bytes_(options.preferred_bytes), name_(options.name.empty() ? law->name() : std::move(options.name)) {
    quick_ = with_profile(quick_source(law, name_), *law);
    fine_ = with_profile(fine_source(law, name_), *law);
    scale_ = std::max(1.0, law->moment_ratio());
    known_error_ = own_error(*law);
  }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  [[nodiscard]] std::optional<BasicTable<Real>> table(double tolerance) const {
    // Down to this tolerance the error of `forces` is small enough.
    constexpr double quick_tolerance = 1e-12;
    if (tolerance >= quick_tolerance && known_error_ <= std::max(quick_error, 0.01 * tolerance) * scale_) {
      if (auto built = table::build<Real>(quick_, tolerance, preferred_bytes_)) return built;
    }
    return tolerance * scale_ > known_error_ ? table::build<Real>(fine_, tolerance, preferred_bytes_) : std::nullopt;
  }

 private:
  std::size_t preferred_bytes_;
  std::string name_;
  table::Source quick_;
  table::Source fine_;
  double scale_;
  double known_error_;
};

}  // namespace table

template <class Real>
BasicTable<Real> BasicTable<Real>::build(const Law& law, double tolerance, TableOptions options) {
  checked(law);
  const table::Attempts<Real> attempts(law, std::move(options));
  return built<Real>(attempts.name(), tolerance, [&] { return attempts.table(tolerance); });
}

template <class Real>
void BasicTable<Real>::refuse_corners(const std::string& name) {
  throw std::invalid_argument("table of " + name + ": a curve with corners and faces (box, diamond) has no table");
}

template <class Real>
BasicTable<Real> BasicTable<Real>::build_from(const std::function<UnitWrench(SlipTwist)>& curve, double tolerance,
                                              TableOptions options) {
  constexpr double relative = 1e-15;
  if (options.name.empty()) options.name = "your curve";
  table::require_limit_curve(curve, options.name);
  const table::Source source{options.name,
                             [&](bool outside, double x) -> table::Sample {
                               const UnitWrench wrench = curve(outside ? SlipTwist{1.0, x} : SlipTwist{x, 1.0});
                               const double error = relative * std::max(wrench.force, wrench.moment);
                               return table::Sample::of(outside, x, wrench.force, wrench.moment, error);
                             },
                             {}};
  return built<Real>(options.name, tolerance,
                     [&] { return table::build<Real>(source, tolerance, options.preferred_bytes); });
}

int TableCells::degree() const noexcept {
  const auto reaches = [](const std::vector<TableCell>& side, std::size_t i) {
    return std::any_of(side.begin(), side.end(), [i](const TableCell& cell) { return cell.coefficients[i] != 0.0; });
  };
  int degree = 6;
  while (degree > 3 && !reaches(inside, static_cast<std::size_t>(degree)) &&
         !reaches(outside, static_cast<std::size_t>(degree)))
    --degree;
  return degree;
}

template <class Real>
BasicTable<Real>::BasicTable(TableFacts facts, const TableCells& cells) {
  table::check<Real>(facts, cells);
  using View = TableView<Real>;
  const int degree = cells.degree();
  const auto pairs_per_cell = static_cast<std::size_t>(View::pairs_per_cell(degree));
  const table::Buckets buckets{cells.index_bits, cells.octaves};
  auto data = std::make_shared<Data>(Data{std::move(facts), cells, {}, {}, {}});
  std::size_t most_in_bucket = 0;
  for (const bool outside : {false, true}) {
    const std::vector<TableCell>& side = outside ? cells.outside : cells.inside;
    const std::size_t side_begin = data->numbers.size();
    for (const TableCell& cell : side) {
      const std::size_t place = data->numbers.size();
      data->numbers.resize(place + pairs_per_cell);
      View::write_cell(outside, cell.x, cell.coefficients, degree, data->numbers[place].pair.data());
    }
    const auto last_before = [&](double end) {
      const auto begins_before = [](const TableCell& cell, double x) { return cell.x < x; };
      return static_cast<std::size_t>(std::lower_bound(side.begin() + 1, side.end(), end, begins_before) -
                                      side.begin()) -
             1;
    };
    for (std::size_t i = 0; i < buckets.per_side(); ++i) {
      // x next to 0 counts as 0, by the rounding of 1 − x.
      const std::size_t last = last_before(std::max<double>(buckets.edge(i), std::numeric_limits<Real>::epsilon()));
      data->cell_of_bucket.push_back(static_cast<std::uint16_t>(side_begin + last * pairs_per_cell));
      // A bucket that begins with a cell needs no search for those before.
      most_in_bucket = std::max(most_in_bucket, last - last_before(std::nextafter(buckets.edge(i + 1), 1.0)));
    }
  }
  data->numbers.resize(data->numbers.size() + View::padding);
  const auto offset = std::ldexp(Real(1), -cells.octaves);
  const int dropped_bits = std::numeric_limits<Real>::digits - 1 - cells.index_bits;
  const auto first_bucket = static_cast<int>(arithmetic::leading_bits(offset, dropped_bits));
  view_.table = {.cells = data->numbers.front().pair.data(),
                 .cell_of_bucket = data->cell_of_bucket.data(),
                 .offset = offset,
                 .dropped_bits = dropped_bits,
                 .runs = {-first_bucket, static_cast<int>(buckets.per_side()) - first_bucket},
                 .first_cells = {0, static_cast<int>(cells.inside.size() * pairs_per_cell)},
                 .degree = degree,
                 .halvings = static_cast<int>(std::bit_width(most_in_bucket))};
  view_.set_scale(view_.table.jet(true, Real(0)).trailing, view_.table.jet(false, Real(0)).trailing,
                  view_.table.jet(false, Real(1)).leading, view_.table.jet(false, Real(1)).trailing);
  // In each part of the rays the parabola through the curve's parameters at its ends and its middle.
  constexpr int parts = 1 << CurveView<Real>::ray_bits;
  Real last = 0;
  const auto parameter = [&](Real share) {
    Real gauge{};
    last = point_on_ray(view_, (1 - share) * view_.force_max, share * view_.moment_max, last, gauge).parameter;
    return last;
  };
  data->ray_starts.resize(3 * (parts + 1));  // pure spin: 0
  Real begin = parameter(0);
  for (int i = 0; i < parts; ++i) {
    constexpr Real half = Real(0.5) / parts;
    const Real middle = static_cast<Real>(2 * i + 1) * half;
    const Real at_middle = parameter(middle);
    const Real end = parameter(middle + half);
    const Real curvature = (begin - 2 * at_middle + end) / (2 * half * half);
    const Real slope = (end - begin) / (2 * half);
    Real* const part = &data->ray_starts[static_cast<std::size_t>(3 * i)];
    part[0] = at_middle - middle * (slope - middle * curvature);
    part[1] = slope - 2 * middle * curvature;
    part[2] = curvature;
    begin = end;
  }
  view_.ray_starts = data->ray_starts.data();
  data_ = std::move(data);
}

template <class Real>
std::size_t BasicTable<Real>::bytes() const noexcept {
  return (data_->numbers.size() - TableView<Real>::padding) * sizeof(Numbers) +
         data_->cell_of_bucket.size() * sizeof(std::uint16_t);
}

template <class Real>
RadialPoint along(const CurveView<Real>& curve, UnitWrench direction) noexcept {
  direction = direction.magnitudes();
  const double size = std::max(direction.force, direction.moment);
  const UnitWrench scaled{direction.force / size, direction.moment / size};
  const auto force = static_cast<Real>(scaled.force);
  const auto moment = static_cast<Real>(scaled.moment);
  const Real turn = moment * curve.inverse_moment_max;
  const Real start = curve.ray_start(turn / (force * curve.inverse_force_max + turn));
  Real gauge{};
  const CurvePoint<Real> point = point_on_ray(curve, force, moment, start, gauge);
  // Scale by the gauge: its error is the square of the search's. The gauge is that of the scaled wrench, so that it
  // does not overflow.
  const auto length = static_cast<double>(gauge);
  return {{scaled.force / length, scaled.moment / length},
          {static_cast<double>(point.slide), static_cast<double>(point.spin)}};
}

template <class Real>
double gauge(const CurveView<Real>& curve, UnitWrench wrench) noexcept {
  const auto [force, moment] = wrench.magnitudes();
  const double turn = moment * double{curve.inverse_moment_max};
  const double sum = force * double{curve.inverse_force_max} + turn;
  if (!(sum > 0.0 && sum <= std::numeric_limits<double>::max())) return sum;
  return sum * double{gauge_per_sum(curve, static_cast<Real>(turn / sum))};
}

template RadialPoint along(const CurveView<double>&, UnitWrench) noexcept;
template RadialPoint along(const CurveView<float>&, UnitWrench) noexcept;
template double gauge(const CurveView<double>&, UnitWrench) noexcept;
template double gauge(const CurveView<float>&, UnitWrench) noexcept;

template <class Real>
void BasicTable<Real>::wrench(std::span<const SlipTwist> twists, std::span<UnitWrench> wrenches) const noexcept {
  const std::size_t count = std::min(twists.size(), wrenches.size());
  for (std::size_t i = 0; i < count; ++i) wrenches[i] = wrench(twists[i]);
}

template <class Real>
void BasicTable<Real>::gauge(std::span<const UnitWrench> wrenches, std::span<double> gauges) const noexcept {
  const std::size_t count = std::min(wrenches.size(), gauges.size());
  std::size_t i = 0;
#ifdef LIMITCURVE_PACKS
  if constexpr (std::is_same_v<Real, double>) i = kernel::gauges(view_, wrenches.data(), gauges.data(), count);
#endif
  for (; i < count; ++i) gauges[i] = gauge(wrenches[i]);
}

template class BasicTable<double>;
template class BasicTable<float>;

Table finest_table(const Law& law, double tolerance) {
  checked(law);
  const table::Attempts<double> attempts(law, {});
  for (double wanted = tolerance; wanted < Table::coarsest_tolerance; wanted *= 10.0) {
    if (const auto table = attempts.table(wanted)) return *table;
  }
  return Table::build(law, Table::coarsest_tolerance);
}

}  // namespace limitcurve
