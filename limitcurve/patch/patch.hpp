// SPDX-License-Identifier: MIT
#pragma once

#include "../law.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Contacts that are not round: the friction wrench (F_x, F_y, M) of a pressure patch of any shape. docs/theory.md has
/// the mathematics.
namespace limitcurve {

/// A point of the patch [m].
struct PatchPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A point contact: its position [m] and its load [any unit].
struct PatchLoad {
  double x = 0.0;
  double y = 0.0;
  double load = 0.0;
};

/// The twist of the patch over the ground: velocity [m/s] of the reference point of moments, and angular velocity
/// [rad/s].
struct PatchTwist {
  double vx = 0.0;
  double vy = 0.0;
  double omega = 0.0;
};

/// The wrench that must be applied to keep the patch sliding, in units of μP: force [1], and moment [m] about the
/// reference point of the twist.
struct PatchWrench {
  double fx = 0.0;
  double fy = 0.0;
  double moment = 0.0;
};

/// Power H(v_x, v_y, ω) in units of μP [m/s] and its gradient, the wrench.
struct PatchFriction {
  double power = 0.0;
  PatchWrench wrench;
  double error =
      0.0;  ///< bound on the largest of: the power's relative error, |ΔF|, |ΔM|/m₀; set by `about_origin` only
};

/// How a patch slips under a wrench.
struct PatchSlip {
  PatchTwist twist;  ///< about the origin, of power 1 against the wrench, or of less if that overflows; NaN for wrench
                     ///< 0 and for a wrench that no load holds
  double gauge = 0.0;  ///< of the wrench: 1 on the limit surface
  double error = 0.0;  ///< bound on |ΔF| and |ΔM|/m₀, Δ from wrench/gauge to the twist's wrench and what a point under
                       ///< the COR bears
};

namespace patch {
struct Shape;
}

/// A contact that is not round: a pressure patch, for load 1 and friction coefficient 1 (or `orthotropic`). The power H
/// of a twist is a convex function of degree one, and its gradient is the wrench. Twists and moments refer to the
/// centre of pressure unless stated otherwise. Immutable: copies share the data, and so may threads.
///
/// Costs are those of `evaluate`; `about_origin` takes two to four times as long. Errors, as `PatchFriction::error`
/// defines them: points and polygons 1e-13 (for polygons of area A, perimeter L and
/// radius R the error grows with L R²/(A m₀)); ellipses of an aspect up to 20: 1e-12 for smooth laws, else 1e-10 plus
/// the law's own error; images: see `image`.
///
/// A zero twist gives wrench 0, although many wrenches hold. A point exactly under the centre of rotation (COR)
/// carries no force. NaN gives NaN. The factories throw std::invalid_argument, with the vertex, point or pixel (counted
/// from 1), its value and what is expected. Lengths are in metres, between 1e-100 and 1e100.
class Patch {
 public:
  /// Point contacts with loads ≥ 0, not all 0. A wrench of three points costs 15 ns.
  static Patch points(std::span<const PatchLoad> loads);
  /// Uniform pressure on a simple polygon, convex or not; vertices in either sense, and the first may be repeated at
  /// the end. Cost for each edge: 15 ns with the COR within three radii, 30 ns beyond.
  static Patch polygon(std::span<const PatchPoint> vertices);
  /// Uniform pressure on a rectangle of full sides x and y about the origin.
  static Patch rectangle(double x, double y);
  /// A pressure law stretched to the ellipse with semi-axes a (along x) and b (along y) about the origin, aspect up to
  /// 1e4. Throws for a law whose mean distance from a diameter is below 1e-4 of its radius: xydas-kao of k < 0.05.
  /// Cost: Hertz and flat punch 20 ns with the COR inside, 1 to 2 µs outside; other laws 3 to 10 µs, samples with many
  /// breaks more.
  static Patch ellipse(const Law& law, double a, double b);
  /// A pressure image: rows of equal length, the first at the largest y. A pixel is a square of side `pixel` under
  /// constant pressure. Negative pressures are noise and show how large the noise is, as in `samples` (laws.hpp). The
  /// origin is the centre of pressure. Pixels next to the COR are integrated as squares; other pixels are points with
  /// the square's radius of gyration. The error comes from fourth moments: 1e-5 for a dense image of 64 × 64, 1e-2 for
  /// a single pixel. Cost: 1 ns a pixel with AVX2, 3 ns without.
  static Patch image(std::span<const double> pressures, std::size_t columns, double pixel) {
    return image(pressures, columns, pixel, pixel);
  }
  /// The same with pixels that are rectangles, `width` along x and `height` along y [m]; pressures up to `floor` count
  /// as 0.
  static Patch image(std::span<const double> pressures, std::size_t columns, double width, double height,
                     std::optional<double> floor = {});

  // Moves are cheap copies; a moved-from patch stays valid.
  Patch(const Patch&) = default;
  Patch& operator=(const Patch&) = default;

  /// The patch with orthotropic friction: coefficients mx along x and my along y, in [1e-6, 1e6], as multiples of the
  /// coefficient of this patch. Associated flow: H = ⟨|diag(mx, my) u|⟩.
  [[nodiscard]] Patch orthotropic(double mx, double my) const;
  /// The patch with H twice differentiable for ω ≠ 0, as a finger needs it. Points get a radius ε > 0 [m]: |u| becomes
  /// √(|u|² + ε²ω²). All pixels of an image become such points. Other kinds are smooth already.
  [[nodiscard]] Patch smoothed(double radius) const;

  /// H and its gradient at a twist of the centre of pressure.
  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept;
  /// H, its gradient and the error bound, for a twist and moments that refer to the origin of the coordinates.
  [[nodiscard]] PatchFriction about_origin(const PatchTwist& twist) const noexcept;

  [[nodiscard]] double power(const PatchTwist& twist) const noexcept { return evaluate(twist).power; }
  [[nodiscard]] PatchWrench wrench(const PatchTwist& twist) const noexcept { return evaluate(twist).wrench; }

  /// The gauge of a wrench in units of μP about the centre of pressure: 0 for wrench 0, 1 on the limit surface, more
  /// where the patch slips; inf for a moment if all load is on a point. Relative error 1e-12 plus the patch's error.
  /// Cost: about 10 wrenches, 20 for points, seldom 200: where H has a kink close by.
  [[nodiscard]] double gauge(const PatchWrench& wrench) const noexcept;
  /// The slip that begins when a wrench [N, N m], about the origin of the coordinates, overcomes friction: the inverse
  /// of `about_origin`. If the limit surface is flat there, the slip is about a point, which can carry any force up to
  /// its share; the result is exact but for rounding. Points on a line, and a single point, can slip in several ways,
  /// of which you get any. Cost: that of `gauge`, and 5 wrenches.
  [[nodiscard]] PatchSlip slip(const PatchWrench& wrench) const;

  /// Centre of pressure [m].
  [[nodiscard]] PatchPoint centre() const noexcept { return centre_; }
  /// m₀ = H(0, 0, 1) [m]: the moment of a pure spin about the centre of pressure. It is the largest moment.
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }
  /// Largest distance of a point of the patch from the centre of pressure [m]; for a law without rim, of its last
  /// break.
  [[nodiscard]] double radius() const noexcept { return radius_; }
  /// The friction factors along x and y, 1 unless `orthotropic`.
  [[nodiscard]] PatchPoint factors() const noexcept { return {mx_, my_}; }
  /// The remarks on the law of an ellipse, or how much of an image counts as 0. Lines that begin with "note: " or
  /// "warning: ".
  [[nodiscard]] std::vector<std::string> remarks() const;

  /// Cost of a wrench with the COR near the patch [ns], measured where a table's costs 9 ns. Compare it with other
  /// costs; do not rely on it.
  [[nodiscard]] double nanoseconds() const noexcept;

  /// Measures from which round models of the patch are made. Zero if the patch has none: points have no area.
  struct RoundMeasures {
    double area = 0.0;  ///< under pressure [m²]
    Law law;            ///< the law of an ellipse, otherwise uniform
    std::vector<PatchLoad>
        concentrations;  ///< where H may have a sharp minimum with the COR there: points; pixels, with load 0
  };
  [[nodiscard]] RoundMeasures round_measures() const;

 private:
  friend class PatchTable;

  explicit Patch(const std::shared_ptr<const patch::Shape>& isotropic);
  Patch(std::shared_ptr<const patch::Shape> shape, double mx, double my, PatchPoint centre, double radius);

  std::shared_ptr<const patch::Shape> shape_;  ///< under isotropic friction: the patch with x times my and y times mx
  PatchPoint centre_{};                        ///< of the patch itself: of one point it is that point to the last bit
  double mx_ = 1.0;
  double my_ = 1.0;
  double moment_ratio_ = 0.0;
  double radius_ = 0.0;
};

/// The smallest load [N], of all points together, under which the patch carries a wrench [N, N m] about the origin of
/// its coordinates without slip, with friction `mu` ≥ 0 and the patch's shape of pressure at every load. 0 for wrench
/// 0; inf if no load holds. Throws std::invalid_argument for arguments out of range. Error and cost are those of
/// `Patch::gauge`.
double load_to_hold(const Patch& patch, double mu, const PatchWrench& wrench);

}  // namespace limitcurve
