// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Contacts that are not round: the friction of a pressure patch of any shape, in its three numbers F_x, F_y, M.
/// README, "Patches", has the mathematics.
namespace limitcurve {

/// A place on the patch [m].
struct PatchPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A point contact: its place [m] and its load, in any unit.
struct PatchLoad {
  double x = 0.0;
  double y = 0.0;
  double load = 0.0;
};

/// How the patch slides over the ground: the velocity [m/s] of the point to which moments refer, and the rate of turn [rad/s].
struct PatchTwist {
  double vx = 0.0;
  double vy = 0.0;
  double omega = 0.0;
};

/// The wrench that keeps the patch sliding: a force, and a moment [m] about the point of the twist, both in units of μP.
struct PatchWrench {
  double fx = 0.0;
  double fy = 0.0;
  double moment = 0.0;
};

/// Power H(v_x, v_y, ω) in units of μP [m/s] and its gradient, the wrench.
struct PatchFriction {
  double power = 0.0;
  PatchWrench wrench;
  double error = 0.0;  ///< bound of the largest of: the power's relative error, |ΔF|, |ΔM|/m₀. Only `about_origin` fills it in.
};

namespace patch {
struct Shape;
}

/// A pressure patch of load 1 under friction of coefficient 1 (or `orthotropic`): a function H of the twist, convex and of degree one, whose
/// gradient is the wrench. Twists and moments refer to the centre of pressure. Immutable; a copy shares its data; threads may share it.
///
/// A zero twist has wrench 0, which is one of the many that hold; a point exactly under the centre of rotation (COR) bears no force; NaN gives NaN.
/// The factories throw std::invalid_argument that names the vertex, the point or the pixel (counted from 1), its value and what is expected.
/// Lengths are in metres, and between 1e-100 and 1e100.
///
/// Errors, measured as `PatchFriction::error`: points and polygons 1e-13 (polygons of area A, perimeter L and radius R lose as L R²/(A m₀) grows);
/// ellipses of an aspect up to 20 1e-12 for smooth laws, else 1e-10 and the law's own error; images see `image`.
class Patch {
 public:
  /// Points with loads >= 0, not all 0. 15 ns for three.
  static Patch points(std::span<const PatchLoad> loads);
  /// Uniform pressure on a simple polygon, convex or not, its vertices in either sense; the first may be repeated as the last.
  /// Per edge 15 ns with the COR within three radii, 30 ns beyond.
  static Patch polygon(std::span<const PatchPoint> vertices);
  /// Uniform pressure on a rectangle of full sides x and y about the origin.
  static Patch rectangle(double x, double y);
  /// A pressure law stretched on to the ellipse with semi-axes a (along x) and b (along y) about the origin, up to 1e4 : 1.
  /// Hertz and flat punch 20 ns with the COR inside; 1 to 2 µs outside; other laws 3 to 10 µs, samples with many breaks more.
  static Patch ellipse(const Law& law, double a, double b);
  /// A pressure image: rows of equal length, the first at the largest y; a pixel is a square of side `pixel` under constant pressure >= 0.
  /// The origin is the centre of pressure. Pixels next to the COR are exact squares, others points with a radius of gyration: the error is
  /// that of fourth moments, 1e-5 for a dense image of 64 × 64, 1e-2 for a lone pixel. 1 ns a pixel with AVX2, 3 ns without.
  static Patch image(std::span<const double> pressures, std::size_t columns, double pixel);
  /// Σ wᵢ patchᵢ with positive weights, scaled to sum 1: H is linear in the pressure.
  static Patch sum(std::span<const std::pair<double, Patch>> parts);

  /// The same patch elsewhere: all its points moved by (x, y).
  [[nodiscard]] Patch moved(double x, double y) const;
  /// Friction mx along x and my along y, as multiples of that of this patch; positive, with associated flow: H = ⟨|diag(mx, my) u|⟩.
  [[nodiscard]] Patch orthotropic(double mx, double my) const;
  /// A patch that can be driven: twice differentiable for ω ≠ 0. Points get the radius ε > 0 [m], |u| becomes √(|u|² + ε²ω²); the pixels of an
  /// image all become such points; other kinds are smooth as they are.
  [[nodiscard]] Patch smoothed(double radius) const;

  /// H and its gradient at a twist of the centre of pressure.
  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept;
  /// The same at a twist of the origin of the coordinates, with moments about it; and the error, whose |ΔM| is that about the origin too.
  [[nodiscard]] PatchFriction about_origin(const PatchTwist& twist) const noexcept;

  [[nodiscard]] double power(const PatchTwist& twist) const noexcept { return evaluate(twist).power; }
  [[nodiscard]] PatchWrench wrench(const PatchTwist& twist) const noexcept { return evaluate(twist).wrench; }

  /// Centre of pressure [m].
  [[nodiscard]] PatchPoint centre() const noexcept;
  /// m₀ = H(0, 0, 1): the moment of a pure spin about the centre of pressure, the largest there is [m].
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }
  /// Largest distance of a point from the centre of pressure, for a law without rim that of its last break [m].
  [[nodiscard]] double radius() const noexcept { return radius_; }
  /// The friction factors along x and y, 1 unless `orthotropic`.
  [[nodiscard]] PatchPoint factors() const noexcept { return {mx_, my_}; }

  /// Cost of a wrench with the COR near, as measured on one machine [ns]: read it as a ratio.
  [[nodiscard]] double nanoseconds() const noexcept;

  /// What a round model of the patch takes from it. Zero where it has none: points have no area.
  struct RoundMeasures {
    double area = 0.0;       ///< under pressure [m²]
    double geometric = 0.0;  ///< √(ab), a and b the semi-axes of the ellipse of equal law and second moments [m]
    Law law;                 ///< under which the disc has that radius: the ellipse's own, else uniform
  };
  [[nodiscard]] RoundMeasures round_measures() const;

 private:
  Patch(std::shared_ptr<const patch::Shape> shape, double mx, double my);

  std::shared_ptr<const patch::Shape> shape_;  ///< of isotropic friction: that of the patch, x times my and y times mx
  double mx_ = 1.0;
  double my_ = 1.0;
  double moment_ratio_ = 0.0;
  double radius_ = 0.0;
};

}  // namespace limitcurve
