// SPDX-License-Identifier: MIT
#pragma once

#include "../../limitcurve/pressure_law.hpp"
#include "../finger.hpp"
#include "../finger_curve.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace limitcurve::godobject {

/// The friction model in the paper's experiment (§6).
enum class PivotCase {
  coupled,    ///< the paper's case A: ellipse and radial projection
  uncoupled,  ///< the paper's case B: separate limits of force and moment (box and closest point)
  exact,      ///< the exact limit curve (as a table) and the closest point
};

/// "coupled", "uncoupled", "exact".
std::span<const std::string_view> pivot_case_names() noexcept;
std::string_view to_string(PivotCase kind) noexcept;
/// The inverse of `to_string`; throws `std::invalid_argument` with the names that were expected.
PivotCase parse_pivot_case(std::string_view text);

/// The load of each finger at a time. Linear between samples, constant before the first and after the last.
struct GripSample {
  double time = 0.0;  ///< [s]
  double load = 0.0;  ///< [N], ≥ 0
};

/// A scripted operator. It reduces the load at a constant rate until the block turns, then keeps the block turning at a
/// constant speed by changing the load. It regrips, for good, at the target angle, or if the block slides out more than
/// it turns: by more than `slide_limit`, and by more than `slide_per_turn` times its angle. All rates > 0.
struct GripOperator {
  static constexpr double slide_limit = 0.002;  ///< [m]
  static constexpr double slide_per_turn =
      0.02;  ///< [m/rad]; on its way to 30° the coupled block slides 10 (sandpaper) to 14 mm (rayon) per radian

  double target = 0.5235987755982988;  ///< angle at which to regrip [rad], > 0; the default is 30°
  std::optional<double> start_load =
      {};  ///< load of each finger at the beginning, and after regripping [N]; absent: twice `default_load`
  std::optional<double> rate = {};         ///< rate of change of the load [N/s]; absent: `default_load` in a second
  std::optional<double> regrip_rate = {};  ///< in regripping [N/s]; absent: ten times `default_load` in a second
  double speed = 0.3;                      ///< desired speed of the block's turn [rad/s]
  bool regrips_on_slide = true;            ///< false: does not regrip if the block slides out
};

/// Options of the paper's experiment: a rectangular block in the vertical plane between two opposite soft fingers,
/// which do not move while their load changes. x points right, y up, and the origin is the grip point. At the start the
/// block is level, and its centre of mass is at (−offset, 0). Its weight turns it counter-clockwise, to positive
/// angles, until the centre of mass hangs below the grip (90° without slip). The block moves in the plane only. The
/// paper does not give block, offset, springs, dampers, rate of release and time step, so these defaults are our choice
/// (docs/paper.md, §6).
struct PivotOptions {
  PivotCase kind = PivotCase::coupled;
  std::optional<CurveKind> curve = {};        ///< absent: the case's
  std::optional<Projection> projection = {};  ///< absent: the case's
  double mu = 1.67;                           ///< μ_l ≥ 0: sandpaper (Kinoshita et al. 1997)
  std::optional<double> mu_r = 0.01011;  ///< μ_r [m] ≥ 0: sandpaper; absent: Γ = m₀ μ P a(P) by `radius_law`
  RadiusLaw radius_law = RadiusLaw::constant(0.005);  ///< a(P); used without a moment coefficient
  std::optional<double> mu_dynamic = {};              ///< μ_d during slip, 0 ≤ μ_d ≤ μ_l; absent: μ_l
  std::optional<double> mu_r_dynamic = {};            ///< μ_r during slip [m]; absent: μ_r μ_d/μ_l
  double length = 0.12;   ///< of the block, along x at the start [m] > 0; the grip is `offset` right of its middle
  double height = 0.04;   ///< of the block, along y at the start [m] > 0
  double mass = 0.1;      ///< [kg] > 0, of even density
  double offset = 0.005;  ///< of the centre of mass from the grip point, along the block [m], 0 ≤ offset < length/2
  double gravity = 9.81;  ///< [m/s²] ≥ 0
  double stiffness = 1000.0;  ///< k_l of each finger [N/m] > 0
  /// k_r of each finger [N m/rad] > 0; absent: k_l (μ_r/μ_l)², μ_r = Γ(P)/P at the load that just holds the block
  std::optional<double> twist_stiffness = {};
  double damping = 5.0;                      ///< b_l of each finger [N s/m] ≥ 0
  std::optional<double> twist_damping = {};  ///< b_r of each finger [N m s/rad] ≥ 0; absent: b_l k_r/k_l
  double time_step = 1e-3;                   ///< [s] > 0, ≤ 1
  double duration = 10.0;                    ///< [s] ≥ 0
  Law law = {};                              ///< pressure law; absent: Hertz
  double tolerance = 1e-8;                   ///< of the table, if the curve is one
  /// Load of each finger over time, at increasing times. If empty and without an operator, the load falls from
  /// `default_load` to half of that in 10 s.
  std::vector<GripSample> grip = {};
  std::optional<GripOperator> grip_operator = {};  ///< instead of `grip`

  /// `curve`, or the case's.
  [[nodiscard]] CurveKind limit_curve() const noexcept;
};

/// One row of the result; the first is at time 0.
struct PivotRow {
  double time = 0.0;  ///< [s]
  double x = 0.0;     ///< centre of mass [m]
  double y = 0.0;
  double angle = 0.0;  ///< of the block [rad], counter-clockwise
  double grip_slip =
      0.0;  ///< slip past the fingers: distance of the proxies from their touch-down, in the block's frame [m]
  double load = 0.0;                         ///< of each finger [N]
  double friction_force = 0.0;               ///< |F| of both fingers together on the block [N]
  double friction_moment = 0.0;              ///< |M| of both together about the grip's axis [N m]
  ContactState state = ContactState::stick;  ///< of the fingers; free when the block has left them
  Fault fault = Fault::none;  ///< the reason for `invalid`, where a time step would carry the block beyond `farthest`
  double cor = 0.0;           ///< distance of the slip's COR from the grip point [m]; NaN without slip
  // The paper's [r, ρ] plane, for one finger: distances between god-object and goal (eq. 7). Both pairs are equal if it
  // sticks, 0 while free.
  double r = 0.0;          ///< |x_p − x_g| after step b [m]
  double rho = 0.0;        ///< |α_p − α_g| after step b [rad]
  double trial_r = 0.0;    ///< |x_p − x_g| before step b [m]
  double trial_rho = 0.0;  ///< |α_p − α_g| before step b [rad]
};

/// Runs the experiment. Call `step` until it returns false, and read each `row`. Deterministic.
class Pivot {
 public:
  class Scene;  // defined in pivot.cpp

  /// Throws `std::invalid_argument` with the parameter, its value, unit and range.
  explicit Pivot(const PivotOptions& options);
  ~Pivot();
  Pivot(Pivot&&) noexcept;
  Pivot& operator=(Pivot&&) noexcept;

  /// The row at the current time.
  [[nodiscard]] const PivotRow& row() const noexcept;
  /// The smallest load of each finger that holds the level block at rest [N]; ∞ if none does. With less at the start
  /// the block falls.
  [[nodiscard]] double holding_load() const noexcept;
  /// Error of the limit curve against the one of its kind [unit wrenches]: 0 for a closed form, else that of its table.
  [[nodiscard]] double curve_error() const noexcept;
  /// Advances by one time step. Returns false, and does nothing, at the end of the duration or if the block has fallen
  /// out of the grip by more than its length.
  bool step() noexcept;

 private:
  std::unique_ptr<Scene> scene_;
};

/// The default load at the start of a grip [N] is 1.3 times the load that holds the block on an ellipse (eq. 19),
/// rounded up to two digits, and at least 0.5 N. All cases of a block begin with this load, and hold, because the
/// ellipse needs at most a tenth less load than the exact curve.
double default_load(const PivotOptions& options);

}  // namespace limitcurve::godobject
