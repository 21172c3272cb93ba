// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "godobject/contact_state.hpp"
#include "godobject/kinds.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/radius_law.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace limitcurve::godobject {

/// One sample of a recorded finger: time [s], position [m], and its twist about the surface normal [rad].
/// The surface is the plane z = 0 with its outward normal +z; the penetration depth is −z.
struct TraceSample {
  double time = 0.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double twist = 0.0;
};

/// What the god-object makes of a sample. Free rows have the proxy at the finger, angle = twist and no load.
struct ReplayRow {
  double time = 0.0;                        ///< [s], the sample's
  ContactState state = ContactState::free;  ///< invalid: all that follows is held from the last good row
  double px = 0.0;                          ///< proxy position [m]
  double py = 0.0;
  double angle = 0.0;  ///< proxy angle α_p [rad], in the frame of the sample's twist
  double depth = 0.0;  ///< penetration depth d = −z [m]
  double load = 0.0;   ///< P = k_l d [N]
  double fx = 0.0;     ///< friction force on the user k_l (x_p − x_g) [N]
  double fy = 0.0;
  double moment = 0.0;  ///< friction moment on the user k_r (α_p − α_g) [N m]
  double cor = 0.0;     ///< distance of the slip's centre of rotation from the contact centre [m]; NaN unless it slips
};

/// Everything that a replay needs to know. `Replay` validates it.
struct ReplayOptions {
  Law law = {};                                       ///< pressure law; must be set
  RadiusLaw radius_law = RadiusLaw::constant(0.005);  ///< a(P)
  double mu = 0.5;                                    ///< coefficient of (static) friction, ≥ 0
  std::optional<double> mu_dynamic = {};              ///< while slipping, 0 ≤ μ_d ≤ μ; absent: μ
  std::optional<double> moment_coefficient = {};      ///< μ_r [m] ≥ 0: Γ = μ_r P whatever the radius law; absent: Γ = m₀ μ P a(P)
  std::optional<double> moment_coefficient_dynamic = {};  ///< μ_r while slipping [m]; absent: μ_r μ_d/μ
  double stiffness = 0.0;                                 ///< k_l [N/m] > 0
  double twist_stiffness = 0.0;                           ///< k_r [N m/rad] > 0
  BoundaryKind boundary = BoundaryKind::table;            ///< limit curve
  ProjectionKind projection = ProjectionKind::closest_point;
  double tolerance = 1e-6;                            ///< of the table, in unit wrenches; used by `table` only
  double jump_limit = FingerParameters{}.jump_limit;  ///< [m] > 0: a sample farther than this from the last is refused once
  double hold_share = FingerParameters{}.hold_share;  ///< of load, force and moment kept from one invalid row to the next, ∈ [0, 1]
};

/// The part of the options that makes a finger.
[[nodiscard]] FingerParameters finger_parameters(const ReplayOptions& options);

/// The god-object over a trace, boundary and projection chosen at run time.
class Replay {
 public:
  class Runner;  // one a boundary and projection; known to replay.cpp only

  /// Throws `std::invalid_argument` that names the parameter, its value, unit and range.
  explicit Replay(const ReplayOptions& options);
  ~Replay();
  Replay(Replay&&) noexcept;
  Replay& operator=(Replay&&) noexcept;

  /// The next sample. A sample that is not finite, or earlier than the last, gives the state `invalid` and holds the rest.
  [[nodiscard]] ReplayRow step(const TraceSample& sample) noexcept;

  /// Samples to rows, as many as the shorter of the two has; the choice of boundary and projection is made once.
  void run(std::span<const TraceSample> samples, std::span<ReplayRow> rows) noexcept;

 private:
  std::unique_ptr<Runner> runner_;
};

}  // namespace limitcurve::godobject
