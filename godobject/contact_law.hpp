// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"
#include "limitcurve/radius_law.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace limitcurve::godobject {

/// What a soft finger is made of, besides the shape of its limit curve. Every length in metres, every angle in radians.
struct FingerParameters {
  double mu = 0.5;                                        ///< coefficient of static friction μ, ≥ 0
  std::optional<double> mu_dynamic = {};                  ///< while slipping, 0 ≤ μ_d ≤ μ; absent: μ
  RadiusLaw radius_law = RadiusLaw::constant(0.005);      ///< contact radius a(P)
  std::optional<double> moment_coefficient = {};          ///< μ_r [m] ≥ 0: Γ = μ_r P whatever the radius law (eq. 2)
  std::optional<double> moment_coefficient_dynamic = {};  ///< μ_r while slipping, [m]; absent: μ_r μ_d/μ
  double stiffness = 1000.0;                              ///< k_l [N/m] > 0, normal and tangential
  double twist_stiffness = 0.04;                          ///< k_r [N m/rad] > 0
  double damping = 0.0;                                   ///< b_l [N s/m] ≥ 0, normal and tangential; acts in timed updates
  double twist_damping = 0.0;                             ///< b_r [N m s/rad] ≥ 0
  /// A finger that moves farther than this between two updates [m] > 0 is a fault of the device: refused once, as `invalid`. The
  /// default is 500 m/s at 1 kHz; ∞ believes everything.
  double jump_limit = 0.5;
  /// Share of load, force and moment that is kept from one step whose input is invalid to the next, ∈ [0, 1]; the first holds all.
  /// The default lets go of half in 70 steps; 1 holds for ever.
  double hold_share = 0.99;
};

/// The springs between proxy and finger, of sliding and of twist side by side.
struct Springs {
  Pair stiffness;   ///< k_l [N/m], k_r [N m/rad]
  Pair compliance;  ///< 1/k_l [m/N], 1/k_r [rad/(N m)]; a little less, by a rounding or two: what stays drawn is rather within the limit
  double ratio;     ///< k_l/k_r [1/m²]

  static Springs of(double stiffness, double twist_stiffness) noexcept {
    const Pair both{stiffness, twist_stiffness};
    const Pair inverse = 1.0 / both;
    return {both, Pair{std::nextafter(inverse[0], 0.0), std::nextafter(inverse[1], 0.0)}, stiffness / twist_stiffness};
  }
};

/// How a unit limit curve grows with the load: force in units of μP, moment in units of μPa. With a moment coefficient
/// the radius is the one that gives it, a = μ_r/(μ m₀), at every load. Immutable.
class ContactLaw {
 public:
  /// `moment_ratio` is the boundary's m₀. Throws std::invalid_argument naming parameter, value, unit and range.
  ContactLaw(const FingerParameters& parameters, double moment_ratio);

  /// The scales of the unit curve at a load.
  struct Scale {
    double force;             ///< μP [N]
    double radius;            ///< a(P) [m]; 0 where there is no torsional friction
    double per_radius;        ///< 1/a [1/m]
    double compliance_ratio;  ///< χ = a²k_l/k_r
    double per_compliance_ratio;
    bool twists;  ///< there is torsional friction: neither μP nor μPa is below least_unit
  };
  /// No friction [N, N m]. A pull whose square vanishes is less than 1.5e-154 long, and drawn by the stiffest spring, 1e15 and a damper of as
  /// much in the shortest time step, it is less than this: whatever limit there is bears it.
  static constexpr double least_unit = 1e-125;

  /// `has_one_radius` promises that the radius does not depend on the load, which is then not asked.
  template <bool has_one_radius = false>
  [[gnu::always_inline]] [[nodiscard]] Scale static_scale(double load) const noexcept {
    return scale<has_one_radius>(static_, load);
  }
  template <bool has_one_radius = false>
  [[gnu::always_inline]] [[nodiscard]] Scale dynamic_scale(double load) const noexcept {
    return scale<has_one_radius>(dynamic_, load);
  }
  /// Of the static limit where the radius does not depend on the load [N]: with no more load there is no torsional friction.
  [[nodiscard]] double least_load() const noexcept { return static_.least_load; }
  [[nodiscard]] bool has_one_limit() const noexcept { return has_one_limit_; }  ///< static and dynamic limits are the same

  [[nodiscard]] const Springs& springs() const noexcept { return springs_; }
  [[nodiscard]] double stiffness() const noexcept { return springs_.stiffness[0]; }        ///< k_l [N/m]
  [[nodiscard]] double twist_stiffness() const noexcept { return springs_.stiffness[1]; }  ///< k_r [N m/rad]
  [[nodiscard]] double damping() const noexcept { return damping_; }                       ///< b_l [N s/m]
  [[nodiscard]] double twist_damping() const noexcept { return twist_damping_; }           ///< b_r [N m s/rad]
  /// a(P) where it depends on the load; else null.
  [[nodiscard]] const RadiusLaw* radius_law() const noexcept { return radius_law_ ? &*radius_law_ : nullptr; }
  [[nodiscard]] double mu() const noexcept { return static_.mu; }  ///< static μ
  /// Static a [m] where it does not depend on the load.
  [[nodiscard]] double constant_radius() const noexcept { return static_.radius; }
  [[nodiscard]] double jump_limit_square() const noexcept { return jump_limit_square_; }  ///< [m²]
  [[nodiscard]] bool has_dampers() const noexcept { return has_dampers_; }
  [[nodiscard]] double hold_share() const noexcept { return hold_share_; }

 private:
  struct Limit {
    double mu = 0.0;
    double radius = 0.0;  ///< where it does not depend on the load
    double per_radius = 0.0;
    double compliance_ratio = 0.0;
    double per_compliance_ratio = 0.0;
    double least_load = 0.0;  ///< below it the units are less than least_unit
  };

  template <bool has_one_radius>
  [[gnu::always_inline]] [[nodiscard]] Scale scale(const Limit& limit, double load) const noexcept {
    if (has_one_radius || !radius_law_) {
      // By the bits, whose order is that of the numbers for those ≥ 0: the units that compare numbers have enough to do in a step.
      const bool twists = std::bit_cast<std::int64_t>(load) > std::bit_cast<std::int64_t>(limit.least_load);
      return {limit.mu * load, limit.radius, limit.per_radius, limit.compliance_ratio, limit.per_compliance_ratio, twists};
    }
    const double radius = radius_law_->radius(load);
    const double chi = radius * radius * springs_.ratio;
    const double force = limit.mu * load;
    return {force, radius, 1.0 / radius, chi, 1.0 / chi, std::min(force, force * radius) > least_unit};
  }

  Limit static_{};
  Limit dynamic_{};
  std::optional<RadiusLaw> radius_law_;  // only where the radius depends on the load
  Springs springs_;
  double damping_;
  double twist_damping_;
  double jump_limit_square_;
  double hold_share_;
  bool has_dampers_;
  bool has_one_limit_;
};

}  // namespace limitcurve::godobject
