// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

/// Error bounds as constants. docs/accuracy.md cites them, and tests check the code against them.
/// They are relative errors, unless stated otherwise, at every COR distance from 0 to ∞.
namespace limitcurve::accuracy {

/// Whether long double, in which references are computed, has more digits than double. It does not on 32-bit ARM, on
/// macOS for arm64, and with MSVC and clang-cl.
inline constexpr bool has_extended = std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

/// `PressureLaw::evaluate`, by closed form and by quadrature. The error that it returns is never below the true error.
inline constexpr double evaluate_closed = has_extended ? 1e-15 : 1.5e-14;
inline constexpr double evaluate_by_quadrature = has_extended ? 1e-14 : 2e-14;

/// `PressureLaw::forces`: elementary, elliptic and Gaussian closed forms; all other laws.
inline constexpr double forces_closed = 1e-14;
inline constexpr double forces_by_quadrature = 1e-13;

/// `Patch`: the largest of the power's relative error, |ΔF| and |ΔM|/m₀, for unit load. In order: points, and polygons
/// of an aspect up to 10; ellipses under Hertz, the flat punch, and laws in closed form with one smooth piece whose rim
/// is no steeper than rim^(−0.3); ellipses under other laws, without the law's profile_error.
inline constexpr double patch_points = 1e-13;
inline constexpr double patch_ellipse = 1e-12;
inline constexpr double patch_ellipse_other = 1e-10;

/// `CurveError`: absolute error of its largest and smallest values.
inline constexpr double curve_error = 1e-9;

/// `SoftFinger` with Projection::closest_point and a table of tolerance 1e-8, under a constant twist whose slide keeps
/// its direction: distance of the steady wrench from eq. (17)'s, in the plane of unit wrenches. About a centre fixed in
/// space: docs/theory.md.
inline constexpr double steady_wrench = 1e-7;

}  // namespace limitcurve::accuracy
