// SPDX-License-Identifier: MIT
#include "limitcurve/accuracy.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/line_profile.hpp"
#include "limitcurve/patch/shape.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace limitcurve::patch {

namespace {

constexpr double pi = std::numbers::pi;

/// Quadrature on [−1, 1], its positive half: Gauss–Legendre after the substitution x → (3x − x³)/2, which makes square
/// roots at both ends analytic.
constexpr std::size_t most_nodes = 20;
struct PanelRule {
  std::vector<double> place;
  std::vector<double> weight;
};

template <unsigned count>
PanelRule make_rule() {
  using Rule = boost::math::quadrature::gauss<double, count>;
  PanelRule rule;
  for (std::size_t i = 0; i < count / 2; ++i) {
    const double x = Rule::abscissa()[i];
    rule.place.push_back(0.5 * x * (3.0 - x * x));
    rule.weight.push_back(Rule::weights()[i] * 1.5 * (1.0 - x) * (1.0 + x));
  }
  return rule;
}

void check_aspect(double a, double b) {
  constexpr double most = 1e4;
  const double aspect = std::max(a, b) / std::min(a, b);
  if (!(aspect <= most)) throw out_of_range("aspect a/b or b/a", aspect, "1", "up to 1e4, friction factors included");
}

/// With D(c) = ¼ ∮ h G(c·u/h) dθ over unit vectors u(θ), h² = a²cos²θ + b²sin²θ the ellipse's half width along u:
///   ∇D = ½ ∫ u G′ dθ,  M = ½ ∫ h N dθ  over half a turn, N = G − tG′, t = c·u/h.
/// In the angle ψ of (a cos θ, b sin θ)/h, t = τ cos(ψ − ψ_c), with (c_x/a, c_y/b) = τ (cos ψ_c, sin ψ_c). So the half
/// turn from ψ_c on has t from τ down to −τ, and |t| > 1 only within acos(1/τ) of its ends, where G′ = ±1, N = 0 and
/// the integral has a closed form. The remainder is divided at the axes and at the law's kinks. The variable is the
/// angle χ between θ and ψ, tan θ = √(a/b) tan χ, in which neither u nor h turns fast.
struct Ellipse final : Shape {
  std::shared_ptr<const LineProfile> profile;
  double a;
  double b;
  double root_a;
  double root_b;
  PanelRule rule;
  std::vector<double> cuts;  ///< in χ ∈ [0, π): the axes, and for slim ellipses angles in between
  /// D = k + kx cx² + ky cy² + q4 cx⁴ + q22 cx²cy² + q04 cy⁴ with the COR inside, where G is a polynomial.
  struct Inside {
    double k = 0.0, kx = 0.0, ky = 0.0, q40 = 0.0, q22 = 0.0, q04 = 0.0;
  } inside;

  Ellipse(std::shared_ptr<const LineProfile> of, double along_x, double along_y)
      : profile(std::move(of)),
        a(along_x),
        b(along_y),
        root_a(std::sqrt(a / std::max(a, b))),
        root_b(std::sqrt(b / std::max(a, b))),
        rule(make_rule<40>()) {
    radius = std::max(a, b) * profile->outer();
    cut();
    if (profile->is_polynomial()) expand();
    measure_moment_ratio();
    // 24 nodes are enough for 1e-12 where G is a polynomial, at half the cost.
    if (profile->is_polynomial() && aspect() <= 3.0) rule = make_rule<24>();
  }

  [[nodiscard]] double aspect() const { return std::max(a, b) / std::min(a, b); }

  void cut() {
    cuts = {0.0, 0.5 * pi};
    // u turns within √(b/a) of one axis, h within √(b/a) of the other: beyond an aspect of 20 divide each quarter in
    // between.
    const double narrow = std::min(root_a, root_b) / std::max(root_a, root_b);
    for (double width = 2.0 * narrow; width < 0.5; width *= 4.0) {
      if (aspect() <= 20.0) break;
      for (const double axis : {0.0, 0.5 * pi, pi}) {
        if (axis > 0.0) cuts.push_back(axis - width);
        if (axis < pi) cuts.push_back(axis + width);
      }
    }
    std::sort(cuts.begin(), cuts.end());
  }

  /// sin z and cos z by their series, for |z| ≤ π/4 (half a panel is not wider). Truncation error below 1e-17.
  static void turn(double z, double& sine, double& cosine) noexcept {
    const double x = z * z;
    sine =
        z * (1.0 -
             x / 6.0 *
                 (1.0 -
                  x / 20.0 *
                      (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0 * (1.0 - x / 156.0 * (1.0 - x / 210.0)))))));
    cosine =
        1.0 -
        x / 2.0 *
            (1.0 -
             x / 12.0 *
                 (1.0 -
                  x / 30.0 *
                      (1.0 - x / 56.0 * (1.0 - x / 90.0 * (1.0 - x / 132.0 * (1.0 - x / 182.0 * (1.0 - x / 240.0)))))));
  }

  /// Calls `add(weight dθ, u_x, u_y, h)` at the nodes of χ from `begin` to `end`.
  template <class Add>
  void integrate(double begin, double end, const Add& add) const noexcept {
    const double middle = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    const double cm = std::cos(middle);
    const double sm = std::sin(middle);
    const double wide = std::max(a, b);
    // Arrays hold the nodes left of the middle first, then those right of it.
    std::array<double, 2 * most_nodes> c;
    std::array<double, 2 * most_nodes> n;
    std::array<double, 2 * most_nodes> s;
    std::array<double, 2 * most_nodes> k;
    const std::size_t count = rule.place.size();
    for (std::size_t i = 0; i < count; ++i) {
      double sine = 0.0;
      double cosine = 0.0;
      turn(half * rule.place[i], sine, cosine);
      c[i] = cm * cosine + sm * sine;
      s[i] = sm * cosine - cm * sine;
      c[count + i] = cm * cosine - sm * sine;
      s[count + i] = sm * cosine + cm * sine;
    }
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const double cc = c[i] * c[i];
      const double ss = s[i] * s[i];
      n[i] = 1.0 / std::sqrt(root_b * root_b * cc + root_a * root_a * ss);
      k[i] = std::sqrt(root_a * root_a * cc + root_b * root_b * ss);
    }
    const double both = root_a * root_b;
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const double weight = rule.weight[i < count ? i : i - count] * half;
      add(weight * both * n[i] * n[i], root_b * c[i] * n[i], root_a * s[i] * n[i], wide * both * k[i] * n[i]);
    }
  }

  void expand() {
    const auto& [g0, g2, g4] = profile->polynomial();
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      integrate(cuts[i], i + 1 < cuts.size() ? cuts[i + 1] : pi,
                [&, g0 = g0, g2 = g2, g4 = g4](double w, double ux, double uy, double h) {
                  inside.k += 0.5 * w * g0 * h;
                  inside.kx += 0.5 * w * g2 * ux * ux / h;
                  inside.ky += 0.5 * w * g2 * uy * uy / h;
                  const double quartic = 0.5 * w * g4 / (h * h * h);
                  inside.q40 += quartic * ux * ux * ux * ux;
                  inside.q22 += 6.0 * quartic * ux * ux * uy * uy;
                  inside.q04 += quartic * uy * uy * uy * uy;
                });
    }
  }

  [[nodiscard]] PatchFriction from_polynomial(double omega, PatchPoint c) const noexcept {
    const double x2 = c.x * c.x;
    const double y2 = c.y * c.y;
    const double quadratic = inside.kx * x2 + inside.ky * y2;
    const double quartic = inside.q40 * x2 * x2 + inside.q22 * x2 * y2 + inside.q04 * y2 * y2;
    const PatchPoint gradient{2.0 * c.x * (inside.kx + 2.0 * inside.q40 * x2 + inside.q22 * y2),
                              2.0 * c.y * (inside.ky + 2.0 * inside.q04 * y2 + inside.q22 * x2)};
    return from_distance(omega, inside.k + quadratic + quartic, {-gradient.x, -gradient.y},
                         inside.k - quadratic - 3.0 * quartic);
  }

  /// χ of an angle ψ; both are equal on the axes.
  [[nodiscard]] double chi(double psi) const noexcept {
    const double angle = std::atan2(root_a * std::sin(psi), root_b * std::cos(psi));
    return angle + 2.0 * pi * std::round((psi - angle) / (2.0 * pi));
  }

  /// sin θ and −cos θ of the direction at ψ: the integral of u over θ.
  [[nodiscard]] PatchPoint turned_direction(double psi) const noexcept {
    const double x = root_b * root_b * std::cos(psi);
    const double y = root_a * root_a * std::sin(psi);
    const double length = std::hypot(x, y);
    return {y / length, -x / length};
  }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    if (only_slides(twist, radius)) return sliding(twist);
    const PatchPoint c{-twist.vy / twist.omega, twist.vx / twist.omega};
    const double outer = profile->outer();
    const double tau = std::hypot(c.x / a, c.y / b);
    if (profile->is_polynomial() && tau <= 1.0) return from_polynomial(twist.omega, c);
    const double psi = std::atan2(c.y / b, c.x / a);
    double gx = 0.0;
    double gy = 0.0;
    double moment = 0.0;
    double rim = 0.0;  // acos(1/τ)
    if (tau > outer) {
      rim = std::atan2(std::sqrt((tau - outer) * (tau + outer)), outer);
      const PatchPoint begin = turned_direction(psi - rim);
      const PatchPoint end = turned_direction(psi + rim);
      gx = 0.5 * (end.x - begin.x);
      gy = 0.5 * (end.y - begin.y);
    }
    // From one cut to the next, without a list of cuts, because a step must not allocate.
    double from = psi + rim;
    const double to = psi + (pi - rim);
    double chi_from = chi(from);
    while (from < to) {
      double next = to;
      const auto meet = [&](double angle) {
        if (angle > from && angle < next) next = angle;
      };
      for (const double kink : profile->kinks()) {
        if (kink >= tau) break;
        const double angle = std::acos(kink / tau);
        meet(psi + angle);
        meet(psi + (pi - angle));
      }
      double chi_next = chi(next);
      // The cuts of the quarters, in χ.
      const double turn = pi * std::floor(chi_from / pi);
      for (const double more : {0.0, pi}) {
        for (const double at : cuts) {
          const double place = turn + more + at;
          if (place > chi_from + 1e-15 * std::fabs(place) && place < chi_next) chi_next = place;
        }
      }
      if (chi_next < chi(next)) next = std::max(psi_of(chi_next), std::nextafter(from, 10.0));
      integrate(chi_from, chi_next, [&](double weight, double ux, double uy, double h) {
        const auto [slope, remainder] = (*profile)((c.x * ux + c.y * uy) / h);
        gx += 0.5 * weight * slope * ux;
        gy += 0.5 * weight * slope * uy;
        moment += 0.5 * weight * h * remainder;
      });
      from = next;
      chi_from = chi_next;
    }
    return from_distance(twist.omega, moment + c.x * gx + c.y * gy, {-gx, -gy}, moment);
  }

  [[nodiscard]] double psi_of(double angle) const noexcept {
    const double psi = std::atan2(root_b * std::sin(angle), root_a * std::cos(angle));
    return psi + 2.0 * pi * std::round((angle - psi) / (2.0 * pi));
  }

  [[nodiscard]] double error(const PatchTwist&) const noexcept override {
    return profile->error() + (profile->is_smooth() ? accuracy::patch_ellipse : accuracy::patch_ellipse_other);
  }

  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    check_aspect(sx * a, sy * b);
    return std::make_shared<Ellipse>(profile, sx * a, sy * b);
  }
  [[nodiscard]] double area() const override { return pi * a * b; }
  [[nodiscard]] double nanoseconds() const noexcept override {
    return !profile->is_polynomial() ? 6000.0 : aspect() <= 3.0 ? 220.0 : 460.0;
  }
  [[nodiscard]] Law law() const override { return profile->law(); }
};

}  // namespace

std::shared_ptr<Shape> make_ellipse(const Law& law, double a, double b) {
  check_aspect(a, b);
  return std::make_shared<Ellipse>(std::make_shared<LineProfile>(law), a, b);
}

}  // namespace limitcurve::patch
