// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"
#include "limitcurve/pressure_law.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace limitcurve::godobject {

/// How friction is modelled in the paper's experiment (§6).
enum class PivotCase {
  coupled,    ///< the paper's case A: ellipse and radial projection
  uncoupled,  ///< the paper's case B: force and moment limited each on its own (box and closest point)
  exact,      ///< the exact limit curve (as a table) and the closest point
};

/// "coupled", "uncoupled", "exact".
std::string_view to_string(PivotCase kind) noexcept;
/// The inverse; throws `std::invalid_argument` that names what was expected.
PivotCase parse_pivot_case(std::string_view text);

/// The load of each finger at a time; in between it is linear, before the first and after the last constant.
struct GripSample {
  double time = 0.0;  ///< [s]
  double load = 0.0;  ///< [N], ≥ 0
};

/// A scripted operator: lets go at a steady rate until the block turns, keeps it turning at a steady speed by easing and
/// tightening the grip, and regrips, for good, at the target angle, or where the block slides out more than it turns: when it has slid by more
/// than `slide_limit` and by more than `slide_per_turn` times the angle it has turned by. All rates > 0.
struct GripOperator {
  static constexpr double slide_limit = 0.002;    ///< [m]
  static constexpr double slide_per_turn = 0.02;  ///< [m/rad]; on its way to 30° the coupled block slides 10 (sandpaper) to 14 mm (rayon)

  double target = 0.5235987755982988;      ///< angle at which to regrip [rad], > 0; the default is 30°
  std::optional<double> start_load = {};   ///< load of each finger at the beginning, and after regripping [N]; absent: twice `default_load`
  std::optional<double> rate = {};         ///< of easing and tightening [N/s]; absent: `default_load` in a second
  std::optional<double> regrip_rate = {};  ///< of regripping [N/s]; absent: ten times that
  double speed = 0.3;                      ///< at which the block should turn [rad/s]
  bool regrips_on_slide = true;            ///< false: lets it slide
};

/// The paper's experiment: a rectangular block in the vertical plane between two opposite soft fingers that stay where
/// they are while their load changes. x points right and y up; the grip point is the origin. At the start the block lies
/// level and its centre of mass at (−offset, 0), so that its weight turns it counter-clockwise, to positive angles, until
/// the centre of mass hangs below the grip (90° without slip). The block moves in the plane only.
/// From the paper are μ_l, μ_r (its Table 1), the two cases and the level start. The block, its offset, springs, dampers and time step are ours: it
/// gives none of them, not even k_r, which decides what its own projection does (godobject/README.md).
struct PivotOptions {
  PivotCase kind = PivotCase::coupled;
  std::optional<CurveKind> curve = {};                    ///< in place of the case's
  std::optional<Projection> projection = {};              ///< in place of the case's
  double mu = 1.67;                                       ///< μ_l ≥ 0: sandpaper (Kinoshita et al. 1997)
  std::optional<double> moment_coefficient = 0.01011;     ///< μ_r [m] ≥ 0: sandpaper; absent: Γ = m₀ μ P a(P) by `radius_law`
  RadiusLaw radius_law = RadiusLaw::constant(0.005);      ///< a(P), where no moment coefficient is given
  std::optional<double> mu_dynamic = {};                  ///< while slipping, 0 ≤ μ_d ≤ μ_l; absent: μ_l
  std::optional<double> moment_coefficient_dynamic = {};  ///< μ_r while slipping [m]; absent: μ_r μ_d/μ_l
  double length = 0.12;       ///< of the block, along x at the start [m] > 0; the grip is `offset` right of its middle
  double height = 0.04;       ///< of the block, along y at the start [m] > 0
  double mass = 0.1;          ///< [kg] > 0, spread evenly
  double offset = 0.005;      ///< of the centre of mass from the grip point, along the block [m], 0 ≤ offset < length/2
  double gravity = 9.81;      ///< [m/s²] ≥ 0
  double stiffness = 1000.0;  ///< k_l of each finger [N/m] > 0
  /// k_r of each finger [N m/rad] > 0; absent: k_l (μ_r/μ_l)², μ_r = Γ(P)/P at the load that just holds the block
  std::optional<double> twist_stiffness = {};
  double damping = 5.0;                      ///< b_l of each finger [N s/m] ≥ 0
  std::optional<double> twist_damping = {};  ///< b_r of each finger [N m s/rad] ≥ 0; absent: b_l k_r/k_l
  double time_step = 1e-3;                   ///< [s] > 0
  double duration = 10.0;                    ///< [s] ≥ 0
  Law law = {};                              ///< pressure law; absent: Hertz
  double tolerance = 1e-8;                   ///< of the table, where the curve is one
  /// Load of each finger over time: increasing times, at least one. Absent and no operator: from `default_load` to half of it in 10 s.
  std::vector<GripSample> grip = {};
  std::optional<GripOperator> grip_operator = {};  ///< instead of `grip`
};

/// A line of the result; the first is at time 0.
struct PivotRow {
  double time = 0.0;  ///< [s]
  double x = 0.0;     ///< centre of mass [m]
  double y = 0.0;
  double angle = 0.0;            ///< of the block [rad], counter-clockwise
  double grip_slip = 0.0;        ///< how far the block's material has slid past the fingers: distance of the proxies from where they
                                 ///< touched down, in the block [m]
  double load = 0.0;             ///< of each finger [N]
  double friction_force = 0.0;   ///< |F| of both fingers together on the block [N]
  double friction_moment = 0.0;  ///< |M| of both together about the grip's axis [N m]
  ContactState state = ContactState::stick;  ///< of the fingers; free when the block has left them
  double cor = 0.0;                          ///< of the slip, from the grip point [m]; NaN unless it slips
  // The paper's [r, ρ] plane: of one finger, springs and dampers together; equal where it sticks, 0 while free.
  double spring_force = 0.0;   ///< k_l r after step b [N]
  double spring_moment = 0.0;  ///< k_r ρ [N m]
  double trial_force = 0.0;    ///< and before it: what the proxy would have borne had it stayed [N]
  double trial_moment = 0.0;   ///< [N m]
};

/// The experiment, step by step. Deterministic.
class Pivot {
 public:
  class Scene;  // known to pivot.cpp only

  /// Throws `std::invalid_argument` that names the parameter, its value, unit and range.
  explicit Pivot(const PivotOptions& options);
  ~Pivot();
  Pivot(Pivot&&) noexcept;
  Pivot& operator=(Pivot&&) noexcept;

  /// The row at the present time.
  [[nodiscard]] const PivotRow& row() const noexcept;
  /// The least load of each finger that holds the block level [N]; ∞ where none does. A grip that begins below drops it.
  [[nodiscard]] double holding_load() const noexcept;
  /// How far the limit curve is from the one that its kind names, in unit wrenches: 0 in closed form, else its table's certified error.
  [[nodiscard]] double curve_error() const noexcept;
  /// One time step on; false, and nothing done, at the end of the duration or when the block has fallen out of the grip
  /// by more than its length.
  bool step() noexcept;

 private:
  std::unique_ptr<Scene> scene_;
};

/// The whole experiment: the row at time 0 and one a time step.
std::vector<PivotRow> run_pivot(const PivotOptions& options);

/// The least load of each finger that holds the block level at rest in this case: its gauge is 1 there. [N]; ∞ where none does.
double holding_load(const PivotOptions& options);

/// Where a grip begins that is left open [N]: 0.5 N, or where that is less, 1.3 times the load by which an ellipse holds the block (eq. 19), rounded
/// up to two digits. So every case of a block begins alike, and held: an ellipse asks for at most a tenth less than the exact curve.
double default_load(const PivotOptions& options);

}  // namespace limitcurve::godobject
