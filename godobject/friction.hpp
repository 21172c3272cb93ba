// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "godobject/drawn.hpp"
#include "godobject/elliptic_pull.hpp"
#include "godobject/grip.hpp"
#include "godobject/home.hpp"
#include "godobject/known.hpp"
#include "godobject/limits.hpp"
#include "godobject/projection.hpp"
#include "limitcurve/foot_guesses.hpp"
#include "limitcurve/load_curves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>

namespace limitcurve::godobject {

/// Where the last slips point to: the centre of rotation seldom jumps.
[[gnu::always_inline]] inline double ahead_of(double start, double trend) noexcept {
  // What is usual is small without more arithmetic.
  if (is_between(std::fabs(trend), 0.0, 1e-3) && is_between(start, 0.01, 1.99)) [[likely]]
    return start + trend;
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
  /// A component of a trial beyond this many limits is cut back to it, so that squares stay finite.
  static constexpr double farthest_trial = 1e100;

  /// What the contact does to the springs, all magnitudes.
  struct Result {
    bool slips;
    double force;      ///< |F| = k_l r′ [N]
    double moment;     ///< |M| = k_r ρ′ [N m]
    double offset;     ///< r′ [m], ≤ r; equal to it bit for bit where there was no sliding
    double twist;      ///< ρ′ [rad], likewise
    double cor;        ///< as Grip
    double slip_work;  ///< as Grip
    double start;      ///< as Grip
  };

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  Friction(Boundary boundary, const FingerParameters& parameters, Projection projection = {})
      : boundary_(std::move(boundary)),
        projection_(projection),
        law_(parameters, boundary_.moment_ratio()),
        guesses_(make_guesses(boundary_, law_)),
        force_max_(boundary_.wrench({1.0, 0.0}).force),
        moment_max_(boundary_.wrench({0.0, 1.0}).moment),
        per_intercepts_(1.0 / Pair{force_max_, moment_max_}),
        // Rounded once each, the reach inwards: a slip ends within a few roundings of the boundary, and rather inside.
        reach_per_unit_(std::nextafter(static_cast<double>(static_cast<long double>(force_max_) / law_.stiffness()), 0.0)),
        arm_times_radius_(static_cast<double>(static_cast<long double>(law_.twist_stiffness()) * force_max_ /
                                              (static_cast<long double>(law_.stiffness()) * moment_max_))),
        arm_(arm_times_radius_ * law_.dynamic_scale(1.0).per_radius),
        square_scale_(square_scale(law_.dynamic_scale(1.0))),
        home_(law_, parameters.jump_limit, reach_per_unit_, arm_times_radius_) {}

  [[nodiscard]] const Boundary& boundary() const noexcept { return boundary_; }
  [[nodiscard]] const ContactLaw& law() const noexcept { return law_; }
  [[nodiscard]] const Home& home() const noexcept { return home_; }                     ///< of contacts of which little is asked
  [[nodiscard]] double per_force_max() const noexcept { return per_intercepts_[0]; }    ///< one over the curve's force intercept
  [[nodiscard]] double per_moment_max() const noexcept { return per_intercepts_[1]; }   ///< one over the moment intercept
  [[nodiscard]] double reach_per_unit() const noexcept { return reach_per_unit_; }      ///< r on the boundary without twist, over μP [m/N]
  [[nodiscard]] double arm_times_radius() const noexcept { return arm_times_radius_; }  ///< arm by which ρ is a length, times a [m²]

  /// The contact under load P [N] > 0 with the proxy r [m] ≥ 0 and ρ [rad] ≥ 0 away, all finite. `start` is the last result's,
  /// which also tells whether the contact slips already.
  [[nodiscard]] Result resolve(double r, double rho, double load, double start) const noexcept {
    const Pull pull{r * r, rho, load, start, 0.0};
    Grip found;
    grip(
        pull, [] {}, [&](const Grip& grip) { found = grip; }, [&] { found = grip_rarely(pull, law_.springs()); });
    const Pair felt = found.share * Pair{r, rho};
    const Pair wrench = felt * law_.springs().stiffness;
    return {found.slips, wrench[0],       wrench[1],  found.slips ? felt[0] : r, found.slips ? felt[1] : rho,
            found.cor,   found.slip_work, found.start};
  }

  /// What knows nothing beforehand is not lost.
  struct NeverLost {
    void operator()() const noexcept {}
  };

  /// The same of a pull. Calls `holds()` where the springs bear the pull, `yields(grip)` where they do not, or `otherwise()` for the caller to
  /// ask grip_rarely. Calls instead of a value returned, which would go through memory. What is `known` is not asked: a contact at home is neither
  /// too lightly pressed nor pulled too far, and its radius is one. Knowing where to begin a search, or that there is nowhere to begin, it calls
  /// `lost()` where one step does not lead to the foot, and for the caller to ask as one that is lost.
  template <Known known = Known::nothing, class Holds, class Yields, class Otherwise, class Lost = NeverLost>
  [[gnu::always_inline]] void grip(const Pull& pull, Holds&& holds, Yields&& yields, Otherwise&& otherwise,
                                   [[maybe_unused]] Lost&& lost = {}) const noexcept {
    constexpr bool is_at_home = known != Known::nothing;
    constexpr bool may_rest = known != Known::slipping && known != Known::lost;
    const Springs& springs = law_.springs();
    // By its sign, as below, in a register for whole numbers.
    if (may_rest && !law_.has_one_limit() && std::bit_cast<std::int64_t>(pull.start) < 0) {
      const Limits limits = Limits::of(law_.template static_scale<is_at_home>(pull.load));
      if (limits.twists && holds_for_sure(limits, pull)) return holds();
      return otherwise();
    }
    const Limits limits = Limits::of(law_.template dynamic_scale<is_at_home>(pull.load));
    if (!is_at_home && !limits.twists) return otherwise();
    if constexpr (needs_squares_only) {
      const EllipticPull elliptic = measure(pull, limits, is_at_home ? arm_ : arm_times_radius_ * limits.per_radius);
      if (elliptic.holds()) return holds();
      if (!is_at_home && !elliptic.is_usual()) return otherwise();
      yields(elliptic.shrink(pull, springs));
    } else {
      const Drawn drawn = draw<is_at_home>(limits, pull, springs);
      // What slipped seldom holds. If it does its foot is farther out, or it is lost.
      if (known != Known::slipping && !(known == Known::resting && drawn.exceeds_chord()) && drawn.holds()) return holds();
      if constexpr (goes_off_axes) {
        const Foot foot = find_foot<known>(drawn, limits);
        if constexpr (known == Known::slipping || known == Known::resting) {
          if (foot.piece == TableSide::none) [[unlikely]]
            return lost();
        }
        Projected projected{true,       true,      {foot.wrench.force, foot.wrench.moment}, {foot.normal.slide, foot.normal.spin},
                            foot.place, foot.piece};
        Pair share = share_of(projected.wrench, limits, drawn, springs);
        // Where both components are so much smaller the trial is beyond the tangent by more than the guard, and on neither axis.
        if (!(is_between(share[0], 0.0, clear_slip) && is_between(share[1], 0.0, clear_slip))) [[unlikely]] {
          if (!(std::min(drawn.trial.wrench.force, drawn.trial.wrench.moment) > 0.0)) return otherwise();
          projected = projection_.onto(foot, drawn.trial);
          if (!projected.outside) return holds();
          share = cut_to_unit(share);
        }
        yields(let_slip(limits, drawn, projected, springs, share, true));
      } else {
        const Projected projected = projection_(boundary_, drawn.trial);
        if (!projected.outside) return holds();
        yields(let_slip(limits, drawn, projected, springs));
      }
    }
  }

  /// What is too rare for the registers of `grip`: no torsional friction; from rest beyond a static limit of its own; squares that
  /// overflow; other springs than the law's, which damping stiffens for a step.
  [[gnu::noinline]] [[nodiscard]] Grip grip_rarely(const Pull& pull, const Springs& springs) const noexcept {
    const bool slipping = !std::signbit(pull.start);
    const Limits limits = Limits::of(slipping ? law_.dynamic_scale(pull.load) : law_.static_scale(pull.load), springs);
    if (!limits.twists) return grip_untwisted(limits.unit[0], pull, springs);
    const Drawn drawn = draw(limits, pull, springs);
    const Projected projected = projection_(boundary_, drawn.trial);
    if (!projected.outside) return {};
    if (slipping || law_.has_one_limit() || !projected.slips) return let_slip(limits, drawn, projected, springs);
    const Limits dynamic = Limits::of(law_.dynamic_scale(pull.load), springs);
    if (!dynamic.twists) return slide_untwisted(pull, springs);
    const Drawn beyond = draw(dynamic, pull, springs);
    return let_slip(dynamic, beyond, projection_(boundary_, beyond.trial), springs);
  }

  /// The projection needs only squares, and shrinks r and ρ by one factor.
  static constexpr bool needs_squares_only = [] {
    if constexpr (requires { Projection::template needs_squares_only<Boundary>; }) {
      return Projection::template needs_squares_only<Boundary>;
    } else {
      return false;
    }
  }();
  /// The projection has a way of its own for what lies on neither axis, which keeps neither component.
  static constexpr bool goes_off_axes = requires(const Projection& projection, const Boundary& boundary, const Trial& trial) {
    projection.foot(boundary, trial, 1.0);
  };

  /// Its searches that have no last slip to begin from may begin from guesses, which are for one metric.
  static constexpr bool has_guesses = goes_off_axes && std::same_as<Boundary, Table>;

  /// A trial both of whose components are cut by more than this is outside by more than slip_guard, whatever is rounded.
  static constexpr double clear_slip = 1.0 - 2.0 * slip_guard;

  /// How far the contact is from slipping: 1 − gauge of the trial in the limit that acts, 1 unloaded by friction, ≤ 0 slipping.
  [[nodiscard]] double margin(double r, double rho, double load, bool slipping) const noexcept {
    const Limits limits = Limits::of(slipping ? law_.dynamic_scale(load) : law_.static_scale(load));
    if (r == 0.0 && rho == 0.0) return 1.0;
    if (!limits.twists)
      return limits.unit[0] > ContactLaw::least_unit ? 1.0 - law_.stiffness() * r / (force_max_ * limits.unit[0]) : r > 0.0 ? 0.0 : 1.0;
    return 1.0 - boundary_.gauge(draw(limits, {r * r, rho, load, -1.0, 0.0}, law_.springs()).trial.wrench);
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
  static std::shared_ptr<const FootGuesses> make_guesses(const Boundary& boundary, const ContactLaw& law) {
    if constexpr (has_guesses) {
      const double chi = law.static_scale(1.0).compliance_ratio;
      const bool is_one = law.radius_law() == nullptr && law.dynamic_scale(1.0).compliance_ratio == chi;
      if (is_one && chi > 1e-100 && chi < 1e100) return std::make_shared<const FootGuesses>(boundary, chi);
    }
    return nullptr;
  }

  /// Of (r², ρ²) over the load's square to make them those of x̂/f_max and ŷ/m_max, where the radius is one.
  [[nodiscard]] Pair square_scale(const ContactLaw::Scale& of_one_newton) const noexcept {
    const Pair root = law_.springs().stiffness * per_intercepts_ / Limits::of(of_one_newton).unit;
    return root * root;
  }

  [[gnu::always_inline]] [[nodiscard]] EllipticPull measure(const Pull& pull, const Limits& limits, double arm) const noexcept {
    const double turn = arm * pull.rho;
    return {pull.r_square + turn * turn, limits.unit[0] * reach_per_unit_};
  }

  /// Without a search.
  [[gnu::always_inline]] [[nodiscard]] bool holds_for_sure(const Limits& limits, const Pull& pull) const noexcept {
    if constexpr (needs_squares_only) {
      return measure(pull, limits, arm_times_radius_ * limits.per_radius).holds();
    } else {
      return draw(limits, pull, law_.springs()).holds();
    }
  }

  /// Where the trial's projection leads, if it is outside. Its piece is TableSide::none where one step was to lead there, and does not.
  template <Known known>
  [[gnu::always_inline]] [[nodiscard]] Foot find_foot(const Drawn& drawn, const Limits& limits) const noexcept {
    if constexpr (known == Known::slipping) return projection_.near_foot(boundary_, drawn.trial, limits.per_compliance_ratio);
    if constexpr (has_guesses && known != Known::home) {
      const Pair trial{drawn.trial.wrench.force, drawn.trial.wrench.moment};
      if constexpr (known == Known::resting) {
        if (!guesses_) return {{}, {}, 0.0, TableSide::none};
        return guesses_->closest_in_one_step(boundary_, trial, drawn.squares);
      }
      if (std::bit_cast<std::int64_t>(drawn.trial.start) <= 0 && guesses_) return guesses_->closest(boundary_, trial, drawn.squares);
    }
    if constexpr (has_guesses && known == Known::lost) return projection_.far_foot(boundary_, drawn.trial, limits.per_compliance_ratio);
    return projection_.foot(boundary_, drawn.trial, limits.per_compliance_ratio);
  }

  template <bool is_at_home = false>
  [[gnu::always_inline]] [[nodiscard]] Drawn draw(const Limits& limits, const Pull& pull, const Springs& springs) const noexcept {
    const Pair stretch{square_roots(Pair{pull.r_square, pull.r_square})[0], pull.rho};
    const Pair per_stretch = springs.stiffness * (paired.one / limits.unit);
    Pair wrench = stretch * per_stretch;
    const Pair of_intercepts = stretch * (per_stretch * per_intercepts_);
    // Not both by one factor: limits that do not know of each other would see a small component become none.
    if (!is_at_home && of_intercepts[0] + of_intercepts[1] > farthest_trial) [[unlikely]]
      wrench = lesser(wrench, Pair{farthest_trial, farthest_trial});
    return {stretch,
            {{wrench[0], wrench[1]}, limits.compliance_ratio, ahead_of(pull.start, pull.trend), law_.radius_law(), pull.load, pull.piece},
            of_intercepts,
            Pair{pull.r_square, pull.rho * pull.rho} * (square_scale_ / Pair{pull.load * pull.load, pull.load * pull.load})};
  }

  /// A search may leave a small component a rounding above the trial's, or below nothing; the spring cannot.
  [[gnu::always_inline]] [[nodiscard]] static Pair cut_to_unit(Pair share) noexcept {
    return greater(lesser(share, Pair{1.0, 1.0}), Pair{0.0, 0.0});
  }

  /// What is felt of the springs, r′/r and ρ′/ρ, at a wrench of the boundary; not cut. (Where nothing is drawn it is 0/0 or infinite.)
  [[gnu::always_inline]] [[nodiscard]] static Pair share_of(UnitWrench wrench, const Limits& limits, const Drawn& drawn,
                                                            const Springs& springs) noexcept {
    return Pair{wrench.force, wrench.moment} * (limits.unit / drawn.stretch * springs.compliance);
  }

  [[gnu::always_inline]] [[nodiscard]] static Grip let_slip(const Limits& limits, const Drawn& drawn, const Projected& projected,
                                                            const Springs& springs, Pair share, bool clamps_both) noexcept {
    Grip grip;
    grip.share = share;
    if (!projected.slips) return grip;
    grip.slips = true;
    grip.clamps_both = clamps_both;
    // A spin that is 0 off the axes has no sign: the quotient is ∞ without asking.
    grip.cor = limits.radius * (clamps_both ? projected.slip.slide / projected.slip.spin : projected.slip.cor());
    grip.start = projected.start;
    grip.piece = projected.piece;
    const Pair work = (drawn.stretch * drawn.stretch * springs.stiffness) * (share * (paired.one - share));
    grip.slip_work = work[0] + work[1];
    return grip;
  }

  [[nodiscard]] static Grip let_slip(const Limits& limits, const Drawn& drawn, const Projected& projected,
                                     const Springs& springs) noexcept {
    const Pair share = cut_to_unit(share_of(projected.wrench, limits, drawn, springs));
    const UnitWrench& trial = drawn.trial.wrench;
    const bool off_axes = goes_off_axes && std::min(trial.force, trial.moment) > 0.0;
    if (off_axes) return let_slip(limits, drawn, projected, springs, share, true);
    // What was not clamped did not slide, bit for bit.
    const PairMask clamped = Pair{projected.wrench.force, projected.wrench.moment} != Pair{trial.force, trial.moment};
    return let_slip(limits, drawn, projected, springs, clamped ? share : Pair{1.0, 1.0}, false);
  }

  /// Γ = 0 takes the twist out of the contact: the proxy's angle is the finger's, and the force is limited by itself.
  [[nodiscard]] Grip grip_untwisted(double force_unit, const Pull& pull, const Springs& springs) const noexcept {
    const double r = std::sqrt(pull.r_square);
    const double reach = force_max_ * force_unit;
    const double force = springs.stiffness[0] * r;
    if (force > reach * (1.0 + slip_guard)) return slide_untwisted(pull, springs);
    // Without friction nothing is felt of a pull whose square vanishes either.
    if (!(force_unit > ContactLaw::least_unit)) return {.share = Pair{0.0, 0.0}};
    return {.share = Pair{force > reach ? reach / force : 1.0, 0.0}};
  }

  [[nodiscard]] Grip slide_untwisted(const Pull& pull, const Springs& springs) const noexcept {
    const double unit = law_.dynamic_scale(pull.load).force;
    // As share_of, bit for bit.
    const double share =
        unit > ContactLaw::least_unit ? std::min(force_max_ * (unit / std::sqrt(pull.r_square) * springs.compliance[0]), 1.0) : 0.0;
    Grip grip;
    grip.slips = true;
    grip.share = Pair{share, 0.0};
    grip.cor = std::numeric_limits<double>::infinity();
    grip.start = 0.0;
    grip.slip_work = springs.stiffness[0] * pull.r_square * share * (1.0 - share);
    return grip;
  }

  Boundary boundary_;
  [[no_unique_address]] Projection projection_;
  ContactLaw law_;
  std::shared_ptr<const FootGuesses> guesses_;  // where the radius, and with it the metric, is one
  double force_max_;
  double moment_max_;
  Pair per_intercepts_;
  double reach_per_unit_;
  double arm_times_radius_;
  double arm_;         // by which ρ is a length in the dynamic limit, where the radius is one
  Pair square_scale_;  // in the dynamic limit
  Home home_;
};

}  // namespace limitcurve::godobject
