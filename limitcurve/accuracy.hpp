// SPDX-License-Identifier: MIT
#pragma once

/// What the library promises, as constants: the README's accuracy table cites them, the tests hold the code to them.
/// Relative errors unless they say otherwise, at every COR distance from 0 to ∞.
namespace limitcurve::accuracy {

/// `PressureLaw::evaluate` where the law has a closed form, and by quadrature; the error it returns is never below the true one.
inline constexpr double evaluate_closed = 1e-15;
inline constexpr double evaluate_by_quadrature = 1e-14;

/// `PressureLaw::forces`, for loops: elementary, elliptic and Gaussian forms, and all other laws.
inline constexpr double forces_closed = 1e-14;
inline constexpr double forces_by_quadrature = 1e-13;

/// `Patch`: the largest of the power's relative error, |ΔF| and |ΔM|/m₀, for unit load. Points and polygons to an aspect of 10; ellipses under
/// hertz, flat-punch, uniform, parabolic, cone, power:n ≥ −0.3; ellipses under other laws, but for what the law does not know of its own pressure.
inline constexpr double patch_points = 1e-13;
inline constexpr double patch_ellipse = 1e-12;
inline constexpr double patch_ellipse_other = 1e-10;

/// `CurveError`: absolute error of its extremes, which are relative errors themselves.
inline constexpr double curve_error = 1e-9;

/// Between the wrench at which a finger begins to slip and its limit curve, relative.
inline constexpr double slip_onset = 1e-12;

/// Of the wrench that a finger settles at under a constant twist by the closest point on a table of tolerance 1e-8: distance
/// in the plane of unit wrenches.
inline constexpr double steady_wrench = 1e-7;

}  // namespace limitcurve::accuracy
