// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "godobject/projection.hpp"
#include "limitcurve/load_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::godobject {

/// Where the last slips point to: the centre of rotation seldom jumps.
inline double ahead_of(double start, double trend) noexcept {
  const bool small = std::fabs(trend) <= 0.1 * std::min(start, 2.0 - start);
  return small ? start + trend : start;
}

/// Steps b and c of the paper (eqs. 8, 19–23) for one contact, in its own two coordinates: how far the proxy is from the
/// finger along the surface, r, and about the normal, ρ. Immutable: one may serve any number of fingers and threads.
///
/// The rule of sticking: a contact at rest holds while the trial wrench lies within the static limit. Once it slips the
/// dynamic limit acts, and it comes to rest again in the first step whose trial lies within the dynamic limit.
template <LimitBoundary Boundary, class Projection>
requires ProjectionOnto<Projection, Boundary>
class Friction {
 public:
  /// Trials beyond this many limits are scaled back to it, which changes no direction and keeps squares finite.
  static constexpr double farthest_trial = 1e100;

  /// What the contact does, all magnitudes.
  struct Result {
    bool slips = false;
    double force = 0.0;                                     ///< |F| = k_l r′ [N]
    double moment = 0.0;                                    ///< |M| = k_r ρ′ [N m]
    double offset = 0.0;                                    ///< r′ [m], ≤ r; equal to it bit for bit where there was no sliding
    double twist = 0.0;                                     ///< ρ′ [rad], likewise
    double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip [m], ∞ for pure sliding; NaN where it sticks
    double slip_work = 0.0;                                 ///< |F|(r − r′) + |M|(ρ − ρ′) [J], ≥ 0
    double start = -1.0;                                    ///< for the next step: place of the slip, or 0; < 0 where it sticks
  };

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  Friction(Boundary boundary, const FingerParameters& parameters, Projection projection = {})
      : boundary_(std::move(boundary)),
        projection_(projection),
        law_(parameters, boundary_.moment_ratio()),
        force_max_(boundary_.wrench({1.0, 0.0}).force),
        moment_max_(boundary_.wrench({0.0, 1.0}).moment),
        per_force_max_(1.0 / force_max_),
        per_moment_max_(1.0 / moment_max_) {}

  [[nodiscard]] const Boundary& boundary() const noexcept { return boundary_; }
  [[nodiscard]] const ContactLaw& law() const noexcept { return law_; }
  [[nodiscard]] double per_force_max() const noexcept { return per_force_max_; }    ///< one over the curve's force intercept
  [[nodiscard]] double per_moment_max() const noexcept { return per_moment_max_; }  ///< one over its moment intercept

  /// The contact under load P [N] > 0 with the proxy r [m] ≥ 0 and ρ [rad] ≥ 0 away, all finite. `start` is the last result's,
  /// which also tells whether the contact slips already.
  [[nodiscard]] Result resolve(double r, double rho, double load, double start) const noexcept {
    return resolve(r, rho, load, start, law_.springs());
  }

  /// The same with other springs than the law's: damping stiffens them for a step.
  [[gnu::always_inline]] [[nodiscard]] Result resolve(double r, double rho, double load, double start,
                                                      const Springs& springs) const noexcept {
    const bool slipping = start >= 0.0;
    const Limits limits = make_limits(slipping ? law_.dynamic_scale(load) : law_.static_scale(load));
    if (!limits.twists) return resolve_untwisted(limits, r, load, springs);
    // Within the chord of the intercepts it holds, without a division.
    const double pull = springs.stiffness * r;
    const double turn = springs.twist_stiffness * rho;
    if (pull * limits.radius * moment_max_ + turn * force_max_ <= limits.moment_unit * force_max_ * moment_max_)
      return stuck(r, rho, springs);
    const Trial trial = make_trial(limits, r, rho, load, start, springs);
    const Projected projected = projection_(boundary_, trial);
    if (!projected.outside) return stuck(r, rho, springs);
    if (slipping || law_.has_one_limit()) return slid(limits, trial, projected, r, rho, springs);
    const Limits dynamic = make_limits(law_.dynamic_scale(load));
    if (!dynamic.twists) return slid_untwisted(dynamic, r, springs);
    const Trial beyond = make_trial(dynamic, r, rho, load, start, springs);
    return slid(dynamic, beyond, projection_(boundary_, beyond), r, rho, springs);
  }

  /// The projection needs only squares, and shrinks r and ρ by one factor.
  static constexpr bool shrinks = [] {
    if constexpr (requires { Projection::template needs_squares_only<Boundary>; }) {
      return Projection::template needs_squares_only<Boundary>;
    } else {
      return false;
    }
  }();

  /// What a step shrinks r and ρ by.
  struct Shrinking {
    bool known;    ///< if not, `resolve` must tell
    double share;  ///< r′/r = ρ′/ρ; 1 where it sticks
  };

  /// The step from r² and ρ², where the projection allows it: one root and one division, none where it sticks.
  [[nodiscard]] Shrinking shrink(double r_square, double rho_square, double load, bool slipping, const Springs& springs) const noexcept {
    const Limits limits = make_limits(slipping ? law_.dynamic_scale(load) : law_.static_scale(load));
    const double force = springs.stiffness * limits.radius * per_force_max_;
    const double moment = springs.twist_stiffness * per_moment_max_;
    const double square = force * force * r_square + moment * moment * rho_square;  // (gauge · μPa)²
    const double limit = limits.moment_unit * (1.0 + slip_guard);
    if (!limits.twists) return {false, 1.0};
    if (square <= limit * limit) return {true, 1.0};
    return {(slipping || law_.has_one_limit()) && square <= farthest_trial, limits.moment_unit / std::sqrt(square)};
  }

  /// How far the contact is from slipping: 1 − gauge of the trial in the limit that acts, 1 unloaded by friction, ≤ 0 slipping.
  [[nodiscard]] double margin(double r, double rho, double load, bool slipping) const noexcept {
    const Limits limits = make_limits(slipping ? law_.dynamic_scale(load) : law_.static_scale(load));
    if (r == 0.0 && rho == 0.0) return 1.0;
    if (!limits.twists) return limits.slides ? 1.0 - law_.stiffness() * r / (force_max_ * limits.force_unit) : r > 0.0 ? 0.0 : 1.0;
    return 1.0 - boundary_.gauge(make_trial(limits, r, rho, load, -1.0, law_.springs()).wrench);
  }

  /// The least load [N] under which a contact at rest bears the friction force [N] and moment [N m], both ≥ 0 and finite: the
  /// grip needed to hold. ∞ where no load does.
  [[nodiscard]] double load_to_hold(double force, double moment) const noexcept {
    if (law_.radius_law() != nullptr) return limitcurve::load_to_hold(boundary_, *law_.radius_law(), law_.mu(), force, moment);
    constexpr double never = std::numeric_limits<double>::infinity();
    const double radius = law_.constant_radius();
    if ((law_.mu() == 0.0 && force > 0.0) || (law_.mu() * radius == 0.0 && moment > 0.0)) return never;
    if (law_.mu() == 0.0) return 0.0;
    return boundary_.gauge({force / law_.mu(), moment > 0.0 ? moment / (law_.mu() * radius) : 0.0});
  }

 private:
  struct Limits {
    double force_unit;   ///< μP [N]
    double moment_unit;  ///< μPa [N m]
    double radius;       ///< a [m]
    bool slides;         ///< there is friction at all
    bool twists;         ///< there is torsional friction
  };

  [[nodiscard]] static Limits make_limits(ContactLaw::Scale scale) noexcept {
    const double moment_unit = scale.force * scale.radius;
    // So near zero the unit's square vanishes, and a quotient by it may overflow: the limit of no friction.
    constexpr double least = 1e-150;
    return {scale.force, moment_unit, scale.radius, scale.force > least, scale.force > least && moment_unit > least};
  }

  [[gnu::always_inline]] [[nodiscard]] Trial make_trial(const Limits& limits, double r, double rho, double load, double start,
                                                        const Springs& springs) const noexcept {
    const double per_unit = 1.0 / limits.moment_unit;
    double force = springs.stiffness * r * limits.radius * per_unit;
    double moment = springs.twist_stiffness * rho * per_unit;
    const double larger = std::max(force, moment);
    if (larger > farthest_trial) {
      force *= farthest_trial / larger;
      moment *= farthest_trial / larger;
    }
    return {{force, moment}, limits.radius * limits.radius * springs.ratio, start, law_.radius_law(), load};
  }

  [[nodiscard]] Result stuck(double r, double rho, const Springs& springs) const noexcept {
    Result result;
    result.force = springs.stiffness * r;
    result.moment = springs.twist_stiffness * rho;
    result.offset = r;
    result.twist = rho;
    return result;
  }

  [[gnu::always_inline]] [[nodiscard]] Result slid(const Limits& limits, const Trial& trial, const Projected& projected, double r,
                                                   double rho, const Springs& springs) const noexcept {
    const auto& [outside, wrench, slip, next_start] = projected;
    Result result;
    result.slips = true;
    // A search may leave a small component a rounding above the trial's; the spring cannot.
    result.force = std::min(wrench.force * limits.force_unit, springs.stiffness * r);
    result.moment = std::min(wrench.moment * limits.moment_unit, springs.twist_stiffness * rho);
    // What was not clamped did not slide, bit for bit.
    result.offset = wrench.force == trial.wrench.force ? r : std::min(result.force * springs.compliance, r);
    result.twist = wrench.moment == trial.wrench.moment ? rho : std::min(result.moment * springs.twist_compliance, rho);
    result.cor = limits.radius * slip.cor();
    result.start = next_start;
    result.slip_work = result.force * (r - result.offset) + result.moment * (rho - result.twist);
    return result;
  }

  /// Γ = 0 takes the twist out of the contact: the proxy's angle is the finger's, and the force is limited by itself.
  [[nodiscard]] Result resolve_untwisted(const Limits& limits, double r, double load, const Springs& springs) const noexcept {
    if (springs.stiffness * r <= force_max_ * limits.force_unit * (1.0 + slip_guard)) return stuck(r, 0.0, springs);
    return slid_untwisted(make_limits(law_.dynamic_scale(load)), r, springs);
  }

  [[nodiscard]] Result slid_untwisted(const Limits& limits, double r, const Springs& springs) const noexcept {
    Result result;
    result.slips = true;
    result.force = limits.slides ? std::min(force_max_ * limits.force_unit, springs.stiffness * r) : 0.0;
    result.offset = std::min(result.force * springs.compliance, r);
    result.cor = std::numeric_limits<double>::infinity();
    result.start = 0.0;
    result.slip_work = result.force * (r - result.offset);
    return result;
  }

  Boundary boundary_;
  [[no_unique_address]] Projection projection_;
  ContactLaw law_;
  double force_max_;
  double moment_max_;
  double per_force_max_;
  double per_moment_max_;
};

}  // namespace limitcurve::godobject
