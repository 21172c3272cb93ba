// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch.hpp"
#include "limitcurve/pressure_law.hpp"

#include <span>

/// Friction of patches by brute force, in extended precision: code that shares nothing with what it tests but the
/// densities of the laws. Twists and moments refer to the point `about`; `error` is left at 0.
namespace limitcurve::test {

PatchFriction points_by_sum(std::span<const PatchLoad> loads, const PatchTwist& twist, PatchPoint about,
                            double mx = 1.0, double my = 1.0);

/// Signed triangles from the COR to each edge, along the edge by tanh–sinh; for a far COR Gauss points all over the
/// polygon. `about` must be the centre of pressure. For ω ≠ 0.
PatchFriction polygon_by_triangles(std::span<const PatchPoint> vertices, const PatchTwist& twist, PatchPoint about);

/// The pressure along rays from the COR, over all rays; the ellipse as a unit disc, twists about its centre. For ω ≠ 0.
PatchFriction ellipse_by_rays(const PressureLaw& law, double a, double b, const PatchTwist& twist);

/// Each pixel by `polygon_by_triangles` where the COR is near, else by 6 × 6 Gauss points; about the centre of
/// pressure.
PatchFriction image_by_squares(std::span<const double> pressures, std::size_t columns, double pixel,
                               const PatchTwist& twist);

/// The larger of |ΔF| and |ΔM|/m₀.
double difference(const PatchWrench& one, const PatchWrench& other, double moment_ratio);
/// The largest of the power's relative error, |ΔF| and |ΔM|/m₀.
double difference(const PatchFriction& one, const PatchFriction& other, double moment_ratio);

}  // namespace limitcurve::test
