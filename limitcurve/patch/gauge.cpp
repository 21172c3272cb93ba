// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/patch/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <tuple>

// Notation. The units are such that the unit vectors are wrenches of pure slides along x and y and of a pure spin.
//   W      the wrench, of length 1
//   T      a twist of power T·W = 1
//   H(T)   the power that friction takes
//   p(T)   = ∇H, the wrench that T needs; T·p(T) = H(T)
//   K      all wrenches that friction can bear: T·p ≤ H(T) for all T. K is convex; p(T) and the unit vectors are in it
//   gauge  the smallest g with W in g K. For every T it is at least 1/H(T). For every sum W = Σ λᵢ pᵢ + R with λᵢ ≥ 0
//          and pᵢ in K it is at most Σ λᵢ + |R|, where |R| adds up the parts of R along the unit vectors.
// Where both bounds meet, T is the slip.

namespace limitcurve {

namespace {

struct Vector {
  double x;
  double y;
  double z;

  friend Vector operator+(const Vector& a, const Vector& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Vector& a, double scale) noexcept { return {a.x * scale, a.y * scale, a.z * scale}; }
  friend double dot(const Vector& a, const Vector& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vector cross(const Vector& a, const Vector& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// Three points of K, and the twist whose power is 1 against each. Differences of the points keep their digits when the
/// points come close to each other.
struct Facet {
  std::array<Vector, 3> points;
  Vector first = points[1] - points[0];
  Vector second = points[2] - points[0];
  Vector normal = cross(first, second);
  Vector twist = normal * (1.0 / dot(normal, points[0]));

  /// λ of p = Σ λᵢ pᵢ.
  std::array<double, 3> shares(const Vector& p) const noexcept {
    const double sum = dot(twist, p);
    const Vector inside = p * (1.0 / sum) - points[0];
    const double b = dot(cross(inside, second), normal) / dot(normal, normal);
    const double c = dot(cross(first, inside), normal) / dot(normal, normal);
    return {sum * (1.0 - b - c), sum * b, sum * c};
  }
};

/// The search for the slip under a wrench about the centre of pressure.
class Search {
 public:
  double gauge = std::numeric_limits<double>::quiet_NaN();  ///< of the wrench
  PatchTwist slip{gauge, gauge, gauge};  ///< of power 1 against the wrench; NaN unless the gauge is finite, not 0
  PatchTwist closest = slip;             ///< the same, of all that were looked at the one that misses W least

  /// Until W is missed by no more than `enough`, or until the bounds meet and no step comes closer.
  Search(const Patch& patch, const PatchWrench& wrench, double enough) noexcept : patch_(patch) {
    constexpr double met = 1e-13;
    if (std::isnan(wrench.fx) || std::isnan(wrench.fy) || std::isnan(wrench.moment)) return;
    const auto [mx, my] = patch.factors();
    // A single point bears no moment.
    const double moment = wrench.moment == 0.0 ? 0.0
                          : m0_ > 0.0          ? wrench.moment / m0_
                                               : std::copysign(std::numeric_limits<double>::infinity(), wrench.moment);
    gauge = std::hypot(std::hypot(wrench.fx / mx, wrench.fy / my), moment);
    if (!(gauge > 0.0 && std::isfinite(gauge))) return;
    w_ = {wrench.fx / mx / gauge, wrench.fy / my / gauge, moment / gauge};
    closest = slip = {w_.x / mx / gauge, w_.y / my / gauge, 0.0};
    if (!(m0_ > 0.0)) return;  // a single point bears no moment, and its spin is free: it does not spin
    spin_ = needed({0.0, 0.0, 1.0});
    w_ = w_ - spin_ * w_.z + Vector{0.0, 0.0, w_.z};
    const double size = gauge * std::sqrt(dot(w_, w_));
    w_ = w_ * (gauge / size);
    here_ = look(w_ + Vector{0.0, 0.0, spin_.x * w_.x + spin_.y * w_.y});  // a push through the centre slides
    descend(enough, 2);
    if (upper_ - 1.0 / here_.power > met) {
      add_columns(met);
      for (double before = 4.0; enough < met && here_.missed < 0.5 * before; descend(enough, 8)) before = here_.missed;
    }
    gauge = size / here_.power;
    slip = twist_of(here_.twist * (1.0 / size));
    closest = twist_of(closest_.twist * (1.0 / size));
  }

 private:
  struct Place {
    Vector twist;
    double power;
    Vector wrench;
    double missed;  ///< |R| of W = p/H + R
  };

  PatchTwist twist_of(const Vector& twist) const noexcept {
    const auto [mx, my] = patch_.factors();
    return {twist.x / mx, twist.y / my, (twist.z - spin_.x * twist.x - spin_.y * twist.y) / m0_};
  }
  /// p of a twist.
  Vector needed(const Vector& twist) const noexcept {
    const auto [mx, my] = patch_.factors();
    const PatchWrench wrench = patch_.wrench(twist_of(twist));
    const double moment = wrench.moment / m0_;
    return {wrench.fx / mx - spin_.x * moment, wrench.fy / my - spin_.y * moment, moment};
  }
  Place look(const Vector& direction) noexcept {
    const Vector twist = direction * (1.0 / dot(direction, w_));
    const Vector wrench = needed(twist);
    const double power = dot(twist, wrench);
    const double missed = parts(w_ - wrench * (1.0 / power));
    upper_ = std::min(upper_, 1.0 / power + missed);
    if (missed < closest_.missed) closest_ = {twist, power, wrench, missed};
    return {twist, power, wrench, missed};
  }
  static double parts(const Vector& rest) noexcept { return std::hypot(rest.x, rest.y) + std::fabs(rest.z); }

  /// Minimises H by quasi-Newton steps (BFGS) across W. Each step that is tried, taken or not, corrects the curvature.
  /// Gives up, as near a kink of H, after as many failures in a row as are `allowed`.
  void descend(double enough, int allowed) noexcept {
    constexpr int most_steps = 40;
    Vector one = cross(w_, std::fabs(w_.z) < 0.5 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0});
    one = one * (1.0 / std::sqrt(dot(one, one)));
    const Vector other = cross(w_, one);
    const auto across = [&](const Vector& p) { return std::complex(dot(p, one), dot(p, other)); };
    // The inverse of the second derivative takes z to even z + odd conj(z).
    double even = 1.0;
    std::complex<double> odd = 0.0;
    for (int i = 0, failed = 0; i < most_steps && failed < allowed && here_.missed > enough; ++i) {
      const std::complex slope = across(here_.wrench);
      std::complex step = -even * slope - odd * std::conj(slope);
      step /= std::max(1.0, std::abs(step));
      const Place next = look(here_.twist + one * step.real() + other * step.imag());
      const std::complex change = across(next.wrench) - slope;
      const double before = (std::conj(step) * slope).real();
      const double rise = (std::conj(step) * change).real();
      if (rise > 0.0) {
        const std::complex there = even * change + odd * std::conj(change);
        const double half = 0.5 + 0.5 * (std::conj(change) * there).real() / rise;
        even += (half * std::norm(step) - (std::conj(step) * there).real()) / rise;
        odd += step * (half * step - there) / rise;
      }
      // Within the rounding of H the slope along the step decides.
      const double fall = here_.power - next.power;
      const bool is_better = fall > 1e-14 || (fall > -1e-13 && before + rise < -0.9 * before);
      failed = is_better ? 0 : failed + 1;
      if (is_better) here_ = next;
    }
  }

  /// Minimises Σ λᵢ, a linear programme whose columns are wrenches p(T) of its facets' twists; it needs no derivative.
  /// So that no pivot is of length 0, and none comes back, W is shifted into the first facet, by less than `enough`.
  void add_columns(double enough) noexcept {
    constexpr int most_columns = 400;
    constexpr double shift = 3e-14;
    constexpr double least_pivot = 1e-12;
    Facet facet{{{{std::copysign(1.0, w_.x), 0.0, 0.0},
                  {0.0, std::copysign(1.0, w_.y), 0.0},
                  {0.0, 0.0, std::copysign(1.0, w_.z)}}}};
    const Vector inside = w_ + (facet.points[0] * 0.7 + facet.points[1] + facet.points[2] * 0.4) * shift;
    Vector column = here_.wrench;
    for (int i = 0; i < most_columns && upper_ - 1.0 / here_.power > enough; ++i) {
      const std::array<double, 3> now = facet.shares(inside);
      const std::array<double, 3> change = facet.shares(column);
      std::size_t leaves = 3;
      double step = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < 3; ++k) {
        if (!(change[k] > least_pivot)) continue;
        const double length = std::max(now[k], 0.0) / change[k];
        if (length < step) step = length, leaves = k;
      }
      if (leaves == 3) return;
      facet.points[leaves] = column;
      facet = Facet{facet.points};
      if (!(dot(facet.twist, w_) > 0.0)) return;  // three points of one line
      double sum = 0.0;
      Vector rest = w_;
      const std::array<double, 3> shares = facet.shares(w_);
      for (std::size_t k = 0; k < 3; ++k) {
        sum += std::max(shares[k], 0.0);
        rest = rest - facet.points[k] * std::max(shares[k], 0.0);
      }
      upper_ = std::min(upper_, sum + parts(rest));
      const Place next = look(facet.twist);
      if (next.power < here_.power) here_ = next;
      column = next.wrench;
    }
  }

  const Patch& patch_;
  double m0_ = patch_.moment_ratio();
  Vector spin_{};  ///< the forces of a pure spin, in the units
  Vector w_{};
  Place here_{};                                                         ///< with the least H so far
  Place closest_{{}, 0.0, {}, std::numeric_limits<double>::infinity()};  ///< with the least R so far
  double upper_ = std::numeric_limits<double>::infinity();
};

/// The wrench about `centre` of one about the origin. A moment within its rounding is 0: a single point bears no other.
PatchWrench about(const PatchPoint& centre, const PatchWrench& wrench) noexcept {
  const double x = centre.x * wrench.fy;
  const double y = centre.y * wrench.fx;
  const double moment = wrench.moment - (x - y);
  const bool is_rounding = std::fabs(moment) <= 2.0 * patch::epsilon * (std::fabs(x) + std::fabs(y));
  return {wrench.fx, wrench.fy, is_rounding ? 0.0 : moment};
}

}  // namespace

double Patch::gauge(const PatchWrench& wrench) const noexcept {
  return Search(*this, wrench, 1e-13).gauge;
}

PatchSlip Patch::slip(const PatchWrench& wrench) const {
  constexpr double kink = 1e-9;  // more than the search leaves where H is smooth
  constexpr double near = 1e-6;  // of the radius: beside a point, whose own force has no direction
  const PatchPoint middle = centre();
  const PatchWrench there = about(middle, wrench);
  const Search search(*this, there, 1e-15);
  const PatchTwist& slip = search.slip;
  const PatchPoint velocity = patch::velocity_at(slip, -middle.x, -middle.y);
  PatchSlip found{{velocity.x, velocity.y, slip.omega}, search.gauge, std::numeric_limits<double>::quiet_NaN()};
  const auto [vx, vy, omega] = found.twist;
  const bool is_held = std::isfinite(found.gauge) && (wrench.fx != 0.0 || wrench.fy != 0.0 || wrench.moment != 0.0);
  if (is_held && !(std::isfinite(vx) && std::isfinite(vy) && std::isfinite(omega))) {
    constexpr int larger = 256;  // the twist of power 1 overflows
    const double fx = std::ldexp(wrench.fx, larger);
    const double fy = std::ldexp(wrench.fy, larger);
    PatchSlip scaled = this->slip({fx, fy, std::ldexp(there.moment, larger) + (middle.x * fy - middle.y * fx)});
    scaled.gauge = found.gauge;
    return scaled;
  }
  if (std::isnan(slip.vx)) return found;
  const bool spins = moment_ratio_ > 0.0;
  /// A twist's error, but for the force, up to its load, of the point that `bears` under the COR.
  const auto error_of = [&](const PatchTwist& at, const PatchLoad* bears) {
    const PatchFriction needed = about_origin(at);
    const double fx = needed.wrench.fx - wrench.fx / found.gauge;
    const double fy = needed.wrench.fy - wrench.fy / found.gauge;
    const double moment = needed.wrench.moment - wrench.moment / found.gauge;
    if (bears == nullptr)
      return needed.error + std::max(std::hypot(fx, fy), spins ? std::fabs(moment) / moment_ratio_ : 0.0);
    const double more = std::max(mx_, my_) * std::max(std::hypot(fx / mx_, fy / my_) - bears->load, 0.0);
    return about_origin({at.vx + near * radius_ * at.omega, at.vy, at.omega}).error + more +
           (std::fabs(moment - (bears->x * fy - bears->y * fx)) + more * std::hypot(bears->x, bears->y)) /
               moment_ratio_;
  };
  found.error = error_of(found.twist, nullptr);
  if (found.error > kink) {
    // Where H is nearly flat, the least H is not the least miss.
    const PatchPoint at_origin = patch::velocity_at(search.closest, -middle.x, -middle.y);
    const PatchTwist closest{at_origin.x, at_origin.y, search.closest.omega};
    const double error = error_of(closest, nullptr);
    if (error < found.error) found = {closest, found.gauge, error};
  }
  if (found.error > kink && slip.omega != 0.0) {
    // With the COR on a point H has a kink: a whole face of wrenches slips about that very point, and beside it the
    // point's force is lost.
    const PatchPoint cor{middle.x - slip.vy / slip.omega, middle.y + slip.vx / slip.omega};
    PatchLoad nearest{};
    double distance = std::numeric_limits<double>::infinity();
    for (const auto& [x, y, load] : round_measures().concentrations) {
      const double far = std::hypot(x - cor.x, y - cor.y);
      if (far == distance) nearest.load += load;
      if (far < distance) nearest = {x, y, load}, distance = far;
    }
    const double moment = about({nearest.x, nearest.y}, wrench).moment;
    if (std::isinf(distance) || moment == 0.0) return found;  // no point, or none about which the wrench has power
    const double rate = 1.0 / moment;
    const PatchTwist about_nearest{rate * nearest.y, -rate * nearest.x, rate};
    const double error = error_of(about_nearest, &nearest);
    if (error < found.error) found = {about_nearest, found.gauge, error};
  }
  return found;
}

double load_to_hold(const Patch& patch, double mu, const PatchWrench& wrench) {
  if (!(mu >= 0.0 && std::isfinite(mu))) throw out_of_range("mu", mu, "1", "a finite number >= 0");
  for (const auto& [name, value, unit] :
       {std::tuple{"fx", wrench.fx, "N"}, {"fy", wrench.fy, "N"}, {"moment", wrench.moment, "N m"}})
    if (!std::isfinite(value)) throw out_of_range(name, value, unit, "a finite number");
  const double gauge = patch.gauge(about(patch.centre(), wrench));
  if (!(gauge > 0.0)) return 0.0;
  return mu > 0.0 ? gauge / mu : std::numeric_limits<double>::infinity();
}

}  // namespace limitcurve
