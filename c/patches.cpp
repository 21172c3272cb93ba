// SPDX-License-Identifier: MIT
#include "c/handles.hpp"

#include <limits>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::c;

limitcurve_status limitcurve_patch_points(const double* x, const double* y, const double* loads, size_t count,
                                          limitcurve_patch** patch) {
  if (count > 0 && any_missing({{"x", x}, {"y", y}, {"loads", loads}})) return LIMITCURVE_INVALID;
  return make_handle(patch, [&] {
    std::vector<PatchLoad> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({x[i], y[i], loads[i]});
    return limitcurve_patch{Patch::points(points)};
  });
}

limitcurve_status limitcurve_patch_polygon(const double* x, const double* y, size_t count, limitcurve_patch** patch) {
  if (count > 0 && any_missing({{"x", x}, {"y", y}})) return LIMITCURVE_INVALID;
  return make_handle(patch, [&] {
    std::vector<PatchPoint> vertices;
    for (std::size_t i = 0; i < count; ++i) vertices.push_back({x[i], y[i]});
    return limitcurve_patch{Patch::polygon(vertices)};
  });
}

limitcurve_status limitcurve_patch_rectangle(double x, double y, limitcurve_patch** patch) {
  return make_handle(patch, [&] { return limitcurve_patch{Patch::rectangle(x, y)}; });
}

limitcurve_status limitcurve_patch_ellipse(const limitcurve_law* law, double a, double b, limitcurve_patch** patch) {
  if (is_no_handle("law", law)) return LIMITCURVE_INVALID;
  return make_handle(patch, [&] { return limitcurve_patch{Patch::ellipse(law->law, a, b)}; });
}

limitcurve_status limitcurve_patch_image(const double* pressures, size_t rows, size_t columns, double pixel,
                                         limitcurve_patch** patch) {
  return limitcurve_patch_image_spaced(pressures, rows, columns, pixel, pixel, patch);
}

limitcurve_status limitcurve_patch_image_spaced(const double* pressures, size_t rows, size_t columns, double width,
                                                double height, limitcurve_patch** patch) {
  if (rows > 0 && columns > std::numeric_limits<std::size_t>::max() / sizeof(double) / rows)
    return refuse("rows", "more pixels than there is memory");
  if (rows * columns > 0 && is_missing("pressures", pressures)) return LIMITCURVE_INVALID;
  return make_handle(patch, [&] {
    return limitcurve_patch{Patch::image(std::span(pressures, rows * columns), columns, width, height)};
  });
}

limitcurve_status limitcurve_patch_orthotropic(const limitcurve_patch* patch, double mx, double my,
                                               limitcurve_patch** result) {
  if (is_no_handle("patch", patch)) return LIMITCURVE_INVALID;
  return make_handle(result, [&] { return limitcurve_patch{patch->patch.orthotropic(mx, my)}; });
}

namespace {

limitcurve_patch handle_of(const PatchTable& table) {
  return {table, table, to_csv(table)};
}

}  // namespace

limitcurve_status limitcurve_patch_table(const limitcurve_patch* patch, double tolerance, limitcurve_patch** result) {
  if (is_no_handle("patch", patch)) return LIMITCURVE_INVALID;
  return make_handle(result, [&] { return handle_of(PatchTable::build(patch->patch, tolerance)); });
}

limitcurve_status limitcurve_patch_read_csv(const char* text, size_t length, const char* source,
                                            limitcurve_patch** patch) {
  if (any_missing({{"text", text}, {"source", source}})) return LIMITCURVE_INVALID;
  return make_handle(patch, [&] { return handle_of(read_patch_table_csv(std::string_view(text, length), source)); });
}

const char* limitcurve_patch_csv(const limitcurve_patch* patch) {
  if (is_no_handle("patch", patch)) return nullptr;
  if (patch->table) return patch->csv.c_str();
  refuse("patch", "not a table: make one with limitcurve_patch_table");
  return nullptr;
}

limitcurve_status limitcurve_patch_checked_error(const limitcurve_patch* patch, double* error) {
  if (is_no_handle("patch", patch) || is_missing("error", error)) return LIMITCURVE_INVALID;
  *error = patch->table ? patch->table->checked_error() : 0.0;
  return LIMITCURVE_OK;
}

void limitcurve_patch_free(limitcurve_patch* patch) {
  free_handle(patch);
}

limitcurve_status limitcurve_patch_wrench(const limitcurve_patch* patch, const double* twists, size_t count,
                                          double* wrenches, double* powers, double* errors) {
  if (is_no_handle("patch", patch)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"twists", twists}, {"wrenches", wrenches}})) return LIMITCURVE_INVALID;
  for (std::size_t i = 0; i < count; ++i) {
    const double* const twist = twists + 3 * i;
    const PatchFriction friction = patch->patch.about_origin({twist[0], twist[1], twist[2]});
    double* const wrench = wrenches + 3 * i;
    wrench[0] = friction.wrench.fx;
    wrench[1] = friction.wrench.fy;
    wrench[2] = friction.wrench.moment;
    if (powers != nullptr) powers[i] = friction.power;
    if (errors != nullptr) errors[i] = friction.error;
  }
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_patch_load_to_hold(const limitcurve_patch* patch, double mu, const double* wrenches,
                                                size_t count, double* loads) {
  if (is_no_handle("patch", patch)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"wrenches", wrenches}, {"loads", loads}})) return LIMITCURVE_INVALID;
  if (refuse_numbers("wrenches", wrenches, 3 * count)) return LIMITCURVE_INVALID;
  return guarded([&] {
    static_cast<void>(load_to_hold(patch->patch, mu, {}));  // what is wrong with mu, before anything is written
    for (std::size_t i = 0; i < count; ++i) {
      const double* const wrench = wrenches + 3 * i;
      loads[i] = load_to_hold(patch->patch, mu, {wrench[0], wrench[1], wrench[2]});
    }
  });
}

limitcurve_status limitcurve_patch_slip(const limitcurve_patch* patch, const double* wrenches, size_t count,
                                        double* twists, double* errors) {
  if (is_no_handle("patch", patch)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"wrenches", wrenches}, {"twists", twists}})) return LIMITCURVE_INVALID;
  if (refuse_numbers("wrenches", wrenches, 3 * count)) return LIMITCURVE_INVALID;
  return guarded([&] {
    for (std::size_t i = 0; i < count; ++i) {
      const double* const wrench = wrenches + 3 * i;
      const auto [twist, gauge, error] = patch->patch.slip({wrench[0], wrench[1], wrench[2]});
      twists[3 * i] = twist.vx;
      twists[3 * i + 1] = twist.vy;
      twists[3 * i + 2] = twist.omega;
      if (errors != nullptr) errors[i] = error;
    }
  });
}
